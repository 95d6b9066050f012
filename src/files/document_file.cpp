#include "files/document_file.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <unordered_map>

#include "base/words.h"
#include "document/animate.h"
#include "files/bytes.h"
#include "files/json_reader.h"
#include "model/stages.h"

namespace artisketch {
namespace {

constexpr std::size_t kMostPoints = 20000;  // of one contour

constexpr double kUnitSlack = 1e-3;    // a rotation further off unit length is a mistake
constexpr double kUnitAsGiven = 1e-6;  // one closer to it is left as it is

constexpr Range kLength{-1e9, 1e9, "a number from -1e9 to 1e9"};
constexpr Range kPositive{1e-9, 1e9, "a number from 1e-9 to 1e9"};
constexpr Range kNotNegative{0, 1e9, "a number from 0 to 1e9"};
constexpr Range kPixel{-1e6, 1e6, "a number of pixels from -1e6 to 1e6"};
constexpr Range kUnit{-1.001, 1.001, "a part of a unit quaternion, from -1 to 1"};
constexpr Range kAngle{0, 180, "a number of degrees from 0 to 180"};
constexpr Range kFatness{0, 10, "a number above 0, at most 10", true};
constexpr Range kSize{1, 16384, "a whole number of pixels from 1 to 16384"};
constexpr Range kGrid{kFewestCells, kMostCells, "a whole number of cells from 16 to 512"};
constexpr Range kTriangles{
    0, 1e7, "a whole number of triangles from 0 (as few as half a pixel allows) to 1e7"};

constexpr const char* kPoint = "two numbers [x, y]";
constexpr const char* kVector = "three numbers [x, y, z]";
constexpr const char* kQuaternion = "four numbers [x, y, z, w]";

class Reader : JsonReader {
 public:
  explicit Reader(Faults& faults) : JsonReader(faults) {}
  Document read(const Json& json);

 private:
  bool joint(const Json& value, const JsonPath& at, int& out);
  void joints(const Json& value, const JsonPath& at, std::vector<int>& out);
  // Calls read(joint, value, path) for each field of an object keyed by joints.
  template <class Read>
  void by_joint(const Json& value, const JsonPath& at, const char* right, const Read& read);

  void version(Fields& fields, const JsonPath& root);
  void camera(const Json& value, const JsonPath& at);
  void skeleton(const Json& value, const JsonPath& at);
  void parent(const Json& value, const JsonPath& at, int index);
  void mirrors(const Json& joints, const JsonPath& at);
  void frame(const Json& value, const JsonPath& at, int index);
  void image(const Json& value, const JsonPath& at, std::string& out);
  void pose(const Json& value, const JsonPath& at, Pose& out);
  void rotation(const Json& value, const JsonPath& at, Quat& out);
  void contour(const Json& value, const JsonPath& at, const std::string& frame, Contour& out);
  void check_length(const JsonPath& at, const std::string& whose, const Polyline& line);
  void calibration(const Json& value, const JsonPath& at);
  void spheres(const Json& value, const JsonPath& at);
  void parts(const Json& value, const JsonPath& at);
  void role(const Json& value, const JsonPath& at, Role& role);
  void animation(const Json& value, const JsonPath& at, std::size_t& keys);
  void motion(const Json& value, const JsonPath& at);
  void settings(const Json& value, const JsonPath& at);

  Document document_;
  std::unordered_map<std::string, int> joints_;  // index by name; the first of equal names
};

std::string frame_words(int index, const std::string& name) {
  return "frame " + std::to_string(index + 1) + (name.empty() ? "" : " " + in_quotes(name));
}

bool Reader::joint(const Json& value, const JsonPath& at, int& out) {
  std::string name;
  if (!text(value, at, name)) return false;
  const auto found = joints_.find(name);
  if (found == joints_.end())
    return faults_.add(at, "names " + in_quotes(name) +
                               ", which is no joint; should be a name in /skeleton/joints"),
           false;
  out = found->second;
  return true;
}

void Reader::joints(const Json& value, const JsonPath& at, std::vector<int>& out) {
  if (!is_list(&value, at, kMostJoints)) return;
  for (std::size_t i = 0; i < value.size(); ++i)
    if (int j = 0; joint(value[i], at / i, j)) out.push_back(j);
}

template <class Read>
void Reader::by_joint(const Json& value, const JsonPath& at, const char* right, const Read& read) {
  if (!value.is_object()) {
    wrong(at, value, right);
    return;
  }
  for (const auto& [name, given] : value.get_ref<const Json::object_t&>()) {
    const JsonPath one = at / name;
    if (const auto found = joints_.find(name); found != joints_.end())
      read(found->second, given, one);
    else
      faults_.add(one, "is no joint; should be a name in /skeleton/joints");
  }
}

// ---------------------------------------------------------------- the document

Document Reader::read(const Json& json) {
  const JsonPath root;
  Fields fields(json, root, faults_);
  version(fields, root);
  if (const Json* v = fields.find("name")) text(*v, root / "name", document_.name, true);
  if (const Json* v = fields.need("camera", "an object with a type")) camera(*v, root / "camera");
  if (const Json* v = fields.need("skeleton", "an object with joints"))
    skeleton(*v, root / "skeleton");

  const JsonPath frames = root / "frames";
  if (const Json* v = fields.need("frames", "an array of frames");
      is_list(v, frames, kMostFrames)) {
    document_.frames.resize(v->size());
    for (std::size_t i = 0; i < v->size(); ++i) frame((*v)[i], frames / i, int(i));
  }
  if (const Json* v = fields.find("calibration")) calibration(*v, root / "calibration");
  if (const Json* v = fields.find("spheres")) spheres(*v, root / "spheres");
  if (const Json* v = fields.find("parts")) parts(*v, root / "parts");
  const JsonPath animations = root / "animations";
  if (const Json* v = fields.find("animations"); is_list(v, animations, kMostKeys)) {
    std::size_t keys = 0;
    for (std::size_t i = 0; i < v->size(); ++i) animation((*v)[i], animations / i, keys);
  }
  if (const Json* v = fields.find("motion")) motion(*v, root / "motion");
  if (const Json* v = fields.find("settings")) settings(*v, root / "settings");
  document_.unknown = fields.unknown();
  return std::move(document_);
}

void Reader::version(Fields& fields, const JsonPath& root) {
  const Json* v = fields.need("artisketch", "1, the version of the format");
  const JsonPath at = root / "artisketch";
  if (!v || *v == 1) return;
  if (v->is_number() && v->get<double>() > 1)
    faults_.add(at, "is version " + in_words(*v) +
                        ", which is newer than this program; should be 1, or get a newer program");
  else
    wrong(at, *v, "1, the version of the format");
}

void Reader::camera(const Json& value, const JsonPath& at) {
  Fields fields(value, at, faults_);
  const std::string right = "'orthographic' or 'perspective'";
  if (const Json* type = fields.need("type", right)) {
    const bool perspective = *type == "perspective";
    if (!perspective && *type != "orthographic") wrong(at / "type", *type, right);
    document_.camera.type = perspective ? Camera::Type::perspective : Camera::Type::orthographic;
    const auto read = [&](const char* name, double& out) {
      if (const Json* v = fields.need(name, kPositive.words)) number(*v, at / name, kPositive, out);
    };
    if (perspective) {
      read("focal_length", document_.camera.focal_length);
      read("distance", document_.camera.distance);
    } else if (*type == "orthographic") {
      read("pixels_per_unit", document_.camera.pixels_per_unit);
    }
  }
  document_.camera_unknown = fields.unknown();
}

void Reader::skeleton(const Json& value, const JsonPath& at) {
  Fields fields(value, at, faults_);
  const JsonPath joints_at = at / "joints";
  const Json* joints = fields.need("joints", "an array of one joint or more");
  if (is_list(joints, joints_at, kMostJoints)) {
    if (joints->empty()) faults_.add(joints_at, "is empty; should have at least one joint");
    document_.skeleton.joints.resize(joints->size());
    for (std::size_t i = 0; i < joints->size(); ++i) {
      const JsonPath joint_at = joints_at / i;
      Joint& joint = document_.skeleton.joints[i];
      Fields of_joint((*joints)[i], joint_at, faults_);
      const Json* name = of_joint.need("name", "a text that is not empty");
      // The parent first: a joint that is its own parent does not exist before itself.
      if (const Json* v = of_joint.need("parent", "the name of an earlier joint, or null"))
        parent(*v, joint_at / "parent", int(i));
      if (name && text(*name, joint_at / "name", joint.name) &&
          !joints_.emplace(joint.name, int(i)).second)
        faults_.add(joint_at / "name", "is " + in_quotes(joint.name) + " like that of joint " +
                                           std::to_string(joints_[joint.name]) +
                                           "; each name should stand once");
      if (const Json* v = of_joint.need("offset", kVector))
        numbers(*v, joint_at / "offset", kVector, kLength, joint.offset);
      of_joint.find("mirror");  // read below, when all names are known
      joint.unknown = of_joint.unknown();
    }
    mirrors(*joints, joints_at);
  }
  document_.skeleton_unknown = fields.unknown();
}

void Reader::parent(const Json& value, const JsonPath& at, int index) {
  int& parent = document_.skeleton.joints[index].parent;
  if (value.is_null()) {
    if (index > 0)
      faults_.add(at, "is null, a second root; should be the name of an earlier joint");
    return;
  }
  std::string name;
  if (index == 0) {
    wrong(at, value, "null: the first joint is the root");
    return;
  }
  if (!text(value, at, name)) return;
  const auto found = joints_.find(name);
  if (found == joints_.end())
    faults_.add(at, "names " + in_quotes(name) +
                        ", which is no earlier joint; parents should stand before their children");
  else
    parent = found->second;
}

void Reader::mirrors(const Json& joints, const JsonPath& at) {
  std::vector<Joint>& read = document_.skeleton.joints;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (!joints[i].is_object() || !joints[i].contains("mirror")) continue;
    const JsonPath joint_at = at / i;
    joint(joints[i]["mirror"], joint_at / "mirror", read[i].mirror);
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const int other = read[i].mirror;
    if (other < 0 || read[other].mirror == int(i)) continue;
    const JsonPath joint_at = at / i;
    const int third = read[other].mirror;
    faults_.add(joint_at / "mirror", "names " + in_quotes(read[other].name) + ", whose mirror is " +
                                         (third < 0 ? "not given" : in_quotes(read[third].name)) +
                                         "; should be mutual: give " + in_quotes(read[other].name) +
                                         " the mirror " + in_quotes(read[i].name));
  }
}

// ---------------------------------------------------------------- frames

void Reader::frame(const Json& value, const JsonPath& at, int index) {
  Frame& frame = document_.frames[index];
  Fields fields(value, at, faults_);
  if (const Json* v = fields.find("name")) text(*v, at / "name", frame.name, true);
  if (const Json* v = fields.need("size", "two numbers [width, height]")) {
    const JsonPath size_at = at / "size";
    if (!v->is_array() || v->size() != 2) {
      wrong(size_at, *v, "two numbers [width, height]");
    } else {
      whole((*v)[0], size_at / 0, kSize, frame.width);
      whole((*v)[1], size_at / 1, kSize, frame.height);
    }
  }
  if (const Json* v = fields.find("image")) image(*v, at / "image", frame.image);
  if (const Json* v = fields.find("principal_point")) {
    Vec2 point;
    if (numbers(*v, at / "principal_point", kPoint, kPixel, point)) frame.principal_point = point;
  }
  if (const Json* v = fields.find("scale")) {
    if (number(*v, at / "scale", kPositive, frame.scale) && frame.scale != 1 &&
        document_.camera.type == Camera::Type::perspective)
      faults_.add(at / "scale",
                  "is given for a perspective camera; should be left out: only "
                  "orthographic frames have a scale");
  }
  if (const Json* v = fields.need("pose", "an object with a root_position"))
    pose(*v, at / "pose", frame.pose);
  const JsonPath contours = at / "contours";
  if (const Json* v = fields.need("contours", "an array, empty where nothing is drawn");
      is_list(v, contours, kMostPoints)) {
    frame.contours.resize(v->size());
    for (std::size_t i = 0; i < v->size(); ++i)
      contour((*v)[i], contours / i, frame_words(index, frame.name), frame.contours[i]);
  }
  if (const Json* v = fields.find("hidden")) joints(*v, at / "hidden", frame.hidden);
  if (const Json* v = fields.find("posed")) boolean(*v, at / "posed", frame.posed);
  if (const Json* v = fields.find("set_joints")) {
    joints(*v, at / "set_joints", frame.set_joints);
    std::vector<int>& set = frame.set_joints;
    std::sort(set.begin(), set.end());
    set.erase(std::unique(set.begin(), set.end()), set.end());
  }
  frame.unknown = fields.unknown();
}

void Reader::image(const Json& value, const JsonPath& at, std::string& out) {
  const std::string uri = value.is_string() ? value.get<std::string>() : "";
  const auto starts = [&](const char* with) { return uri.rfind(with, 0) == 0; };
  const bool good = starts("data:")
                        ? starts("data:image/png;base64,") || starts("data:image/jpeg;base64,")
                        : !uri.empty() && uri[0] != '/' && uri.find('\0') == uri.npos;
  if (good)
    out = uri;
  else
    wrong(at, value,
          "a path relative to the document, or a data:image/png;base64 or "
          "data:image/jpeg;base64 URI");
}

void Reader::pose(const Json& value, const JsonPath& at, Pose& out) {
  Fields fields(value, at, faults_);
  out.rotations.assign(document_.skeleton.size(), Quat::Identity());
  if (const Json* v = fields.need("root_position", kVector))
    numbers(*v, at / "root_position", kVector, kLength, out.root_position);
  if (const Json* v = fields.find("rotations"))
    by_joint(*v, at / "rotations", "an object of rotations by joint name",
             [&](int joint, const Json& given, const JsonPath& one) {
               rotation(given, one, out.rotations[joint]);
             });
  out.unknown = fields.unknown();
}

void Reader::rotation(const Json& value, const JsonPath& at, Quat& out) {
  Eigen::Vector4d q;
  if (!numbers(value, at, kQuaternion, kUnit, q)) return;
  const double norm = q.norm();
  if (std::abs(norm - 1) > kUnitSlack)
    faults_.add(at, "has length " + in_words(json_number(norm)) +
                        "; should be a unit quaternion, of length 1");
  else
    out = Quat(std::abs(norm - 1) > kUnitAsGiven ? Eigen::Vector4d(q / norm) : q);  // x, y, z, w
}

void Reader::contour(const Json& value, const JsonPath& at, const std::string& frame,
                     Contour& out) {
  Fields fields(value, at, faults_);
  std::string whose = frame + ": the contour";
  if (const Json* v = fields.need("joint", "the name of a joint");
      v && joint(*v, at / "joint", out.joint))
    whose += " of " + in_quotes(document_.skeleton.joints[out.joint].name);
  bool good = true;
  if (const Json* v = fields.find("closed")) good = boolean(*v, at / "closed", out.line.closed);
  const JsonPath points_at = at / "points";
  if (const Json* v = fields.need("points", "an array of points [x, y]");
      is_list(v, points_at, kMostPoints)) {
    std::vector<Vec2>& points = out.line.points;
    for (std::size_t i = 0; i < v->size(); ++i) {
      Vec2 point;
      if (!numbers((*v)[i], points_at / i, kPoint, kPixel, point))
        good = false;
      else if (points.empty() || points.back() != point)
        points.push_back(point);
    }
    if (out.line.closed && points.size() > 1 && points.back() == points.front()) points.pop_back();
    if (good) check_length(points_at, whose, out.line);
  }
  out.unknown = fields.unknown();
}

void Reader::check_length(const JsonPath& at, const std::string& whose, const Polyline& line) {
  const std::size_t least = line.closed ? 3 : 2;
  if (line.points.size() < least)
    faults_.add(at, whose + " has " + counted(line.points.size(), "different point") +
                        "; should have at least " + std::to_string(least) +
                        (line.closed ? ", as a closed line" : ", as an open line"));
}

// ---------------------------------------------------------------- the rest

void Reader::calibration(const Json& value, const JsonPath& at) {
  CalibrationLimits& limits = document_.calibration;
  Fields fields(value, at, faults_);
  double x = 0;
  if (const Json* v = fields.find("max_rotation"); v && number(*v, at / "max_rotation", kAngle, x))
    limits.max_rotation = radians(x);
  if (const Json* v = fields.find("max_translation");
      v && number(*v, at / "max_translation", kNotNegative, x))
    limits.max_translation = x;
  if (const Json* v = fields.find("locked")) joints(*v, at / "locked", limits.locked);
  if (const Json* v = fields.find("free_first_frame"))
    boolean(*v, at / "free_first_frame", limits.free_first_frame);
  if (const Json* v = fields.find("scale"); v && boolean(*v, at / "scale", limits.scale))
    if (limits.scale && document_.camera.type == Camera::Type::perspective)
      faults_.add(at / "scale",
                  "is true for a perspective camera; should be left out: only "
                  "orthographic frames have a scale");
  limits.unknown = fields.unknown();
}

void Reader::spheres(const Json& value, const JsonPath& at) {
  by_joint(value, at, "an object of spheres by joint name",
           [&](int joint, const Json& given, const JsonPath& one) {
             SphereTweak& sphere = document_.spheres[joint];
             Fields fields(given, one, faults_);
             double radius = 0;
             if (const Json* v = fields.find("radius");
                 v && number(*v, one / "radius", kPositive, radius))
               sphere.radius = radius;
             if (const Json* v = fields.find("offset"))
               numbers(*v, one / "offset", kVector, kLength, sphere.offset);
             sphere.unknown = fields.unknown();
           });
}

void Reader::role(const Json& value, const JsonPath& at, Role& role) {
  for (std::size_t r = 0; r < std::size(kRoleNames); ++r)
    if (value.is_string() && value.get<std::string>() == kRoleNames[r]) {
      role = Role(r);
      return;
    }
  wrong(at, value, R"("body", "held" or "apart")");
}

void Reader::parts(const Json& value, const JsonPath& at) {
  by_joint(value, at, "an object of parts by joint name",
           [&](int joint, const Json& given, const JsonPath& one) {
             PartSettings& part = document_.parts[joint];
             Fields fields(given, one, faults_);
             if (const Json* v = fields.find("fatness"))
               number(*v, one / "fatness", kFatness, part.fatness);
             if (const Json* v = fields.find("role")) role(*v, one / "role", part.role);
             part.unknown = fields.unknown();
           });
}

// `count`: the keys of all animations so far.
void Reader::animation(const Json& value, const JsonPath& at, std::size_t& count) {
  Animation& animation = document_.animations.emplace_back();
  Fields fields(value, at, faults_);
  if (const Json* v = fields.need("name", "a text that is not empty"))
    text(*v, at / "name", animation.name);
  const JsonPath keys = at / "keys";
  if (const Json* v = fields.need("keys", "an array of one key or more");
      is_list(v, keys, kMostKeys - count)) {
    count += v->size();
    if (v->empty()) faults_.add(keys, "is empty; should have at least one key");
    animation.keys.resize(v->size());
    for (std::size_t i = 0; i < v->size(); ++i) {
      const JsonPath key_at = keys / i;
      Key& key = animation.keys[i];
      Fields of_key((*v)[i], key_at, faults_);
      if (const Json* time = of_key.need("time", "a number of seconds");
          time && number(*time, key_at / "time", kNotNegative, key.time) && i > 0 &&
          // As glTF will hold them, in single precision.
          float(key.time) <= float(animation.keys[i - 1].time))
        faults_.add(key_at / "time", "is " + in_words(*time) + ", not after the key before (" +
                                         in_words(json_number(animation.keys[i - 1].time)) +
                                         "); times should increase");
      if (const Json* v = of_key.need("pose", "an object with a root_position"))
        pose(*v, key_at / "pose", key.pose);
      key.unknown = of_key.unknown();
    }
  }
  animation.unknown = fields.unknown();
}

void Reader::motion(const Json& value, const JsonPath& at) {
  Fields fields(value, at, faults_);
  const JsonPath joints_at = at / "joints";
  const Json* joints = fields.find("joints");
  std::set<int> moved;
  if (joints && !joints->is_object())
    wrong(joints_at, *joints, "an object of joint names by the motion's joint names");
  else if (joints) {
    for (const auto& [name, given] : joints->get_ref<const Json::object_t&>()) {
      const JsonPath one = joints_at / name;
      int j = 0;
      if (!joint(given, one, j)) continue;
      if (!moved.insert(j).second)
        faults_.add(one, "names " + in_quotes(document_.skeleton.joints[j].name) +
                             ", which another joint of the motion moves; each should stand once");
      document_.motion.joints.emplace_back(name, j);
    }
  }
  std::vector<int> still;
  if (const Json* v = fields.find("still")) this->joints(*v, at / "still", still);
  for (const int j : still) {
    if (!moved.insert(j).second)
      faults_.add(at / "still", "names " + in_quotes(document_.skeleton.joints[j].name) +
                                    ", which stands in it twice or is moved in \"joints\"");
    document_.motion.joints.emplace_back("", j);
  }
  document_.motion.unknown = fields.unknown();
}

void Reader::settings(const Json& value, const JsonPath& at) {
  DocumentSettings& settings = document_.settings;
  Fields fields(value, at, faults_);
  int n = 0;
  bool yes = false;
  if (const Json* v = fields.find("grid"); v && whole(*v, at / "grid", kGrid, n)) settings.grid = n;
  if (const Json* v = fields.find("method")) {
    const auto named = [&](const char* name) { return *v == name; };
    if (std::any_of(std::begin(kMethodNames), std::end(kMethodNames), named)) {
      settings.method = v->get<std::string>();
    } else {
      std::string names;
      for (const char* name : kMethodNames)
        names += (names.empty() ? "" : " or ") + in_quotes(name);
      wrong(at / "method", *v, names.c_str());
    }
  }
  if (const Json* v = fields.find("mirror"); v && boolean(*v, at / "mirror", yes))
    settings.mirror = yes;
  if (const Json* v = fields.find("triangles"); v && whole(*v, at / "triangles", kTriangles, n))
    settings.triangles = n;
  if (const Json* v = fields.find("texture"); v && boolean(*v, at / "texture", yes))
    settings.texture = yes;
  settings.unknown = fields.unknown();
}

// What the first bytes of a file that is no text say it is; none where they say nothing.
const char* kind_of_bytes(std::string_view bytes) {
  using namespace std::string_view_literals;
  constexpr std::pair<std::string_view, const char*> kKinds[] = {
      {"\x89PNG"sv, "a PNG picture"}, {"\xff\xd8\xff"sv, "a JPEG picture"},
      {"GIF8"sv, "a GIF picture"},    {"glTF"sv, "a model"},
      {"PK\3\4"sv, "a ZIP archive"},  {"\x1f\x8b"sv, "a gzip archive"},
      {"HIERARCHY"sv, "a motion"},    {"%PDF"sv, "a PDF"},
  };
  for (const auto& [begins, kind] : kKinds)
    if (bytes.starts_with(begins)) return kind;
  return nullptr;
}

}  // namespace

Result<Document> parse_document(std::string_view json, const std::string& file) {
  Faults faults(file);
  const std::optional<Json> tree = parse_json(json, faults);
  if (!tree) return faults.error();
  Document document = Reader(faults).read(*tree);
  if (!faults.none()) return faults.error();
  return document;
}

Result<Document> read_document(const std::string& path) {
  const Result<std::string> bytes = read_file(path);
  if (!bytes) return bytes.error();
  if (const char* kind = kind_of_bytes(*bytes))
    return bad_input(path + ": is " + kind +
                     ", no sketch document; name the document (.artisketch) "
                     "that goes with it");
  return parse_document(*bytes, path);
}

}  // namespace artisketch
