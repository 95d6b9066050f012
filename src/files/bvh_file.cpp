#include "files/bvh_file.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "files/bytes.h"
#include "files/json.h"

namespace artisketch {
namespace {

constexpr int kMostJoints = 1000, kDeepest = 200;
constexpr double kMostNumbers = 1e7;
constexpr double kLargest = 1e6;
constexpr double kShortestStep = 1e-4, kLongestStep = 60;  // seconds

// Thrown and caught in this file alone: every word may be wrong.
struct Wrong {
  int line;
  std::string what;
};

// The words of a text, and the lines that they stand in.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) { skip(); }
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
    last_line_ = line_;
    at_ += word.size();
    skip();
    return word;
  }
  void expect(const char* word) {
    if (const std::string_view found = next(word); found != word)
      throw Wrong{last_line_, "is " + in_quotes(found) + "; should be " + word};
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
  // The rest of the line.
  std::string rest() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view rest = text_.substr(at_, end - at_);
    while (!rest.empty() && blank(rest.back())) rest.remove_suffix(1);
    at_ = end;
    skip();
    return std::string(rest);
  }

 private:
  static bool blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
  void skip() {
    for (; at_ < text_.size() && blank(text_[at_]); ++at_) line_ += text_[at_] == '\n';
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
    if (!words_.done())
      throw Wrong{words_.line(), "goes on with " + in_quotes(words_.peek()) + " after its frames"};
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
    if (joints.size() >= std::size_t(kMostJoints))
      throw Wrong{words_.last_line(), "has more than a thousand joints"};
    joints.push_back({name, parent, Vec3::Zero(), -1, ""});
    return int(joints.size()) - 1;
  }

  void channels(int joint) {
    words_.expect("CHANNELS");
    const int count = words_.whole("a number of channels", 6);
    for (int i = 0; i < count; ++i) {
      const std::string_view word = words_.next("a channel");
      const bool rotation = word.size() > 1 && word.substr(1) == "rotation";
      const int axis = word[0] - 'X';
      if (!(rotation || word.substr(1) == "position") || axis < 0 || axis > 2)
        throw Wrong{words_.last_line(),
                    "is " + in_quotes(word) + "; should be a channel like Xrotation or Yposition"};
      channels_.push_back({joint, rotation, axis});
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
      if (word == "JOINT") {
        joint(self, depth + 1);
      } else if (word == "End") {
        words_.expect("Site");
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

  void frames() {
    words_.expect("Frames:");
    const int count = words_.whole("a number of frames", 1000000);
    if (count == 0) throw Wrong{words_.last_line(), "has no frames; should have one at least"};
    if (double(count) * double(channels_.size() + motion_.skeleton.joints.size()) > kMostNumbers)
      throw Wrong{words_.last_line(), "has more than 10 million numbers"};
    words_.expect("Frame");
    words_.expect("Time:");
    motion_.step = words_.number("a number of seconds");
    if (!(motion_.step >= kShortestStep && motion_.step <= kLongestStep))
      throw Wrong{words_.last_line(), "has a frame time that should be from 0.0001 to 60 seconds"};
    for (int k = 0; k < count; ++k) {
      Pose pose = rest_pose(motion_.skeleton);
      pose.root_position = motion_.skeleton.joints[0].offset;
      for (const Channel& channel : channels_) {
        const double value = words_.number("a number of a frame");
        if (channel.rotation)
          pose.rotations[channel.joint] =
              pose.rotations[channel.joint] *
              Quat(Eigen::AngleAxisd(radians(value), Vec3::Unit(channel.axis)));
        else if (channel.joint == 0)
          pose.root_position[channel.axis] += value;
      }
      for (Quat& q : pose.rotations) q.normalize();
      motion_.poses.push_back(std::move(pose));
    }
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

Result<Motion> read_bvh(const std::string& path) {
  const Result<std::string> text = read_file(path);
  if (!text) return bad_input(text.error().text());
  return parse_bvh(*text, std::filesystem::path(path).stem().string(), path);
}

}  // namespace artisketch
