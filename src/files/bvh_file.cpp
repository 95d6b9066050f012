#include "files/bvh_file.h"

#include <cmath>
#include <cstdlib>
#include <set>

#include "base/words.h"
#include "files/json.h"

namespace artisketch {
namespace {

constexpr int kMostMotionJoints = 1000, kDeepest = 200;
constexpr double kMostNumbers = 1e7;
constexpr double kLargest = 1e6;
constexpr double kShortestStep = 1e-4, kLongestStep = 60;  // seconds

// Thrown and caught in this file alone: every word may be wrong.
struct Wrong {
  int line;
  std::string what;
};

// The words of a text, and the lines that they stand in. Comments are no words.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
    skip();
  }
  int line() const { return line_; }
  bool done() const { return at_ == text_.size(); }
  std::string_view peek() const {
    std::size_t end = at_;
    while (end < text_.size() && !blank(text_[end])) ++end;
    return text_.substr(at_, end - at_);
  }
  std::string_view next(const char* wanted) {
    const std::string_view word = peek();
    if (word.empty()) throw Wrong{line_, std::string("ends where ") + wanted + " should be"};
    take(word.size());
    return word;
  }
  void expect(const char* word) {
    if (const std::string_view found = next(word); lower_case(found) != lower_case(word))
      throw Wrong{last_line_, "is " + in_quotes(found) + "; should be " + word};
  }
  // A word that ends in a colon, whatever stands before or after that: `Frames: 2`, `Frames :2`.
  void expect_with_colon(const std::string& word) {
    const std::string_view found = peek();
    if (lower_case(found.substr(0, word.size())) != lower_case(word) ||
        (found.size() > word.size() && found[word.size()] != ':')) {
      next(word.c_str());
      throw Wrong{last_line_, "is " + in_quotes(found) + "; should be " + word + ":"};
    }
    take(std::min(found.size(), word.size() + 1));
    if (found.size() == word.size() && peek().starts_with(":")) take(1);
  }
  double number(const char* wanted) {
    const std::string word(next(wanted));
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (end == word.c_str() || *end != 0 || !(std::abs(value) <= kLargest))
      throw Wrong{last_line_,
                  "is " + in_quotes(word) + "; should be " + wanted + ", from -1e6 to 1e6"};
    return value;
  }
  int whole(const char* wanted, int most) {
    const double value = number(wanted);
    if (value != std::floor(value) || value < 0 || value > most)
      throw Wrong{last_line_,
                  std::string("should be ") + wanted + " from 0 to " + std::to_string(most)};
    return int(value);
  }
  int last_line() const { return last_line_; }
  // The rest of the line, up to a brace at its end.
  std::string rest() {
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    std::string_view rest = text_.substr(at_, end - at_);
    const auto trim = [&] {
      while (!rest.empty() && blank(rest.back())) rest.remove_suffix(1);
    };
    trim();
    if (rest.ends_with("{")) rest.remove_suffix(1);
    at_ += rest.size();
    trim();
    skip();
    return std::string(rest);
  }

 private:
  static bool ends_line(char c) { return c == '\r' || c == '\n'; }
  static bool blank(char c) { return c == ' ' || c == '\t' || ends_line(c); }
  void take(std::size_t letters) {
    last_line_ = line_;
    at_ += letters;
    skip();
  }
  bool at_line_start() const {
    std::size_t before = at_;
    while (before > 0 && (text_[before - 1] == ' ' || text_[before - 1] == '\t')) --before;
    return before == 0 || ends_line(text_[before - 1]);
  }
  bool at_comment() const {
    return at_ < text_.size() && (text_[at_] == '#' || text_.substr(at_).starts_with("//")) &&
           at_line_start();
  }
  void skip() {
    const auto skip_blanks = [&] {
      for (; at_ < text_.size() && blank(text_[at_]); ++at_) {
        const bool of_a_pair = text_[at_] == '\n' && at_ > 0 && text_[at_ - 1] == '\r';
        line_ += ends_line(text_[at_]) && !of_a_pair;
      }
    };
    for (skip_blanks(); at_comment(); skip_blanks())
      while (at_ < text_.size() && !ends_line(text_[at_])) ++at_;
  }
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1, last_line_ = 1;
};

struct Channel {
  int joint = 0;
  bool rotation = false;
  int axis = 0;
};

class Reader {
 public:
  explicit Reader(std::string_view text) : words_(text) {}
  Motion read() {
    words_.expect("HIERARCHY");
    words_.expect("ROOT");
    joint(-1, 0);
    words_.expect("MOTION");
    frames();
    settle_places();
    return std::move(motion_);
  }

 private:
  Vec3 offset() {
    words_.expect("OFFSET");
    Vec3 offset;
    for (int c = 0; c < 3; ++c) offset[c] = words_.number("a number of an offset");
    return offset;
  }

  int add(const std::string& name, int parent) {
    std::vector<Joint>& joints = motion_.skeleton.joints;
    if (joints.size() >= std::size_t(kMostMotionJoints))
      throw Wrong{words_.last_line(), "has more than a thousand joints"};
    joints.push_back({name, parent, Vec3::Zero(), -1, ""});
    return int(joints.size()) - 1;
  }

  void channels(int joint) {
    words_.expect("CHANNELS");
    const int count = words_.whole("a number of channels", 6);
    for (int i = 0; i < count; ++i) {
      const std::string word = lower_case(words_.next("a channel"));
      const bool rotation = word.substr(1) == "rotation";
      const int axis = word[0] - 'x';
      if (!(rotation || word.substr(1) == "position") || axis < 0 || axis > 2)
        throw Wrong{words_.last_line(),
                    "is " + in_quotes(word) + "; should be a channel like Xrotation or Yposition"};
      channels_.push_back({joint, rotation, axis});
      std::vector<int>& moved = motion_.moved;
      if (!rotation && joint > 0 && (moved.empty() || moved.back() != joint))
        moved.push_back(joint);
    }
  }

  void joint(int parent, int depth) {
    const int named = words_.line();
    const std::string name = words_.rest();
    if (name.empty() || !names_.insert(name).second)
      throw Wrong{named, "has a joint " + in_quotes(name) + "; names should be given, each once"};
    if (depth > kDeepest) throw Wrong{named, "nests more than 200 joints"};
    const int self = add(name, parent);
    words_.expect("{");
    motion_.skeleton.joints[self].offset = offset();
    channels(self);
    while (words_.peek() != "}") {
      const std::string_view word = words_.next("JOINT, End Site or }");
      if (lower_case(word) == "joint") {
        joint(self, depth + 1);
      } else if (lower_case(word) == "end") {
        words_.rest();  // Site, or what else it is called
        words_.expect("{");
        const int end = add("", self);
        motion_.skeleton.joints[end].offset = offset();
        words_.expect("}");
      } else {
        throw Wrong{words_.last_line(),
                    "is " + in_quotes(word) + "; should be JOINT, End Site or }"};
      }
    }
    words_.expect("}");
  }

  // One row of the motion: every channel's number.
  void row() {
    Pose pose = rest_pose(motion_.skeleton);
    pose.root_position = motion_.skeleton.joints[0].offset;
    std::vector<Vec3> places;
    for (const int joint : motion_.moved) places.push_back(motion_.skeleton.joints[joint].offset);
    std::size_t next_place = 0;
    for (const Channel& channel : channels_) {
      const double value = words_.number("a number of a frame");
      if (channel.rotation) {
        pose.rotations[channel.joint] =
            pose.rotations[channel.joint] *
            Quat(Eigen::AngleAxisd(radians(value), Vec3::Unit(channel.axis)));
      } else if (channel.joint == 0) {
        pose.root_position[channel.axis] = value;
      } else {
        while (motion_.moved[next_place] != channel.joint) ++next_place;
        places[next_place][channel.axis] = value;
      }
    }
    for (Quat& q : pose.rotations) q.normalize();
    motion_.poses.push_back(std::move(pose));
    if (!places.empty()) motion_.places.push_back(std::move(places));
  }

  void frames() {
    words_.expect_with_colon("Frames");
    const int count = words_.whole("a number of frames", 1000000);
    if (count == 0) throw Wrong{words_.last_line(), "has no frames; should have one at least"};
    const double numbers = double(channels_.size() + motion_.skeleton.joints.size());
    const auto check_size = [&](double rows) {
      if (rows * numbers > kMostNumbers)
        throw Wrong{words_.last_line(), "has more than 10 million numbers"};
    };
    check_size(count);
    words_.expect("Frame");
    words_.expect_with_colon("Time");
    motion_.step = words_.number("a number of seconds");
    if (!(motion_.step >= kShortestStep && motion_.step <= kLongestStep))
      throw Wrong{words_.last_line(), "has a frame time that should be from 0.0001 to 60 seconds"};
    int rows = 0;
    // A file may have a row more than it says, or fewer; a row that isn't whole is none.
    const auto more = [&] {
      if (channels_.empty()) return rows < count;
      return rows == 0 || !words_.done();
    };
    for (; more(); ++rows) {
      check_size(rows + 1);
      const char first = words_.done() ? '0' : words_.peek()[0];
      const bool number =
          (first >= '0' && first <= '9') || first == '-' || first == '+' || first == '.';
      if (rows >= count && !number) break;
      const int began = words_.line();
      const bool beyond = rows >= count;
      try {
        row();
      } catch (const Wrong& wrong) {
        if (beyond) throw Wrong{began, "goes on after its frames, and not by a whole one"};
        throw wrong;
      }
    }
    if (!words_.done())
      throw Wrong{words_.line(), "goes on with " + in_quotes(words_.peek()) + " after its frames"};
    if (rows != count)
      motion_.warnings.push_back("says that it has " + counted(count, "frame") + ", and has " +
                                 std::to_string(rows) + ": all of these are used");
  }

  // Some programs write a joint's way from its offset, not its place: near zero where others have
  // what is near the offset. Most joints keep their place, so that the file as a whole shows it.
  void settle_places() {
    constexpr double kNear = 0.2;  // of the offset
    long as_places = 0, as_ways = 0;
    for (const std::vector<Vec3>& places : motion_.places)
      for (std::size_t i = 0; i < places.size(); ++i) {
        const Vec3& offset = motion_.skeleton.joints[motion_.moved[i]].offset;
        as_places += (places[i] - offset).norm() < kNear * offset.norm();
        as_ways += places[i].norm() < kNear * offset.norm();
      }
    if (as_ways <= as_places) return;
    for (std::vector<Vec3>& places : motion_.places)
      for (std::size_t i = 0; i < places.size(); ++i)
        places[i] += motion_.skeleton.joints[motion_.moved[i]].offset;
  }

  Words words_;
  Motion motion_;
  std::vector<Channel> channels_;
  std::set<std::string> names_;
};

}  // namespace

Result<Motion> parse_bvh(std::string_view text, const std::string& name, const std::string& file) {
  try {
    Motion motion = Reader(text).read();
    motion.name = name;
    return motion;
  } catch (const Wrong& wrong) {
    return bad_input(file + ": line " + std::to_string(wrong.line) + ": " + wrong.what);
  }
}

bool is_bvh(std::string_view bytes) {
  return lower_case(Words(bytes).peek()) == "hierarchy";
}

}  // namespace artisketch
