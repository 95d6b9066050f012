#include "files/document_file.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

#include "files/bytes.h"
#include "files/json.h"

namespace artisketch {
namespace {

// Limits that keep a hostile document affordable, far above what a character needs.
constexpr std::size_t kMostJoints = 1000, kMostFrames = 1000, kMostKeys = 10000;
constexpr std::size_t kMostPoints = 20000;  // of one contour

constexpr double kUnitSlack = 1e-3;    // a rotation further off unit length is a mistake
constexpr double kUnitAsGiven = 1e-6;  // one closer to it is left as it is
constexpr double kLeastArea = 0.01;    // pixels²; below, a closed contour encloses nothing to see

struct Range {
  double low, high;
  const char* words;
  bool above_low = false;  // low itself is outside
};
constexpr Range kLength{-1e9, 1e9, "a number from -1e9 to 1e9"};
constexpr Range kPositive{0, 1e9, "a number above 0, at most 1e9", true};
constexpr Range kNotNegative{0, 1e9, "a number from 0 to 1e9"};
constexpr Range kPixel{-1e6, 1e6, "a number of pixels from -1e6 to 1e6"};
constexpr Range kUnit{-1.001, 1.001, "a part of a unit quaternion, from -1 to 1"};
constexpr Range kAngle{0, 180, "a number of degrees from 0 to 180"};
constexpr Range kFatness{0, 10, "a number above 0, at most 10", true};
constexpr Range kSize{1, 16384, "a whole number of pixels from 1 to 16384"};
constexpr Range kGrid{16, 400, "a whole number of cells from 16 to 400"};
constexpr Range kTriangles{0, 1e7, "a whole number of triangles from 0 (as the grid gives) to 1e7"};

constexpr const char* kPoint = "two numbers [x, y]";
constexpr const char* kVector = "three numbers [x, y, z]";
constexpr const char* kQuaternion = "four numbers [x, y, z, w]";

// One object's fields: those that were asked for are known, the rest is kept.
class Fields {
 public:
  Fields(const Json& object, const JsonPath& path, Faults& faults)
      : object_(object), path_(path), faults_(faults) {
    if (!object.is_object() && !object.is_discarded())
      faults.add(path, "is " + in_words(object) + "; should be an object");
  }
  const Json* find(const char* name) {
    known_.push_back(name);
    if (!object_.is_object()) return nullptr;
    const auto found = object_.find(name);
    return found == object_.end() ? nullptr : &*found;
  }
  // A fault where there is none; `right` says what it should be.
  const Json* need(const char* name, const std::string& right) {
    const Json* found = find(name);
    if (!found && object_.is_object()) faults_.add(path_ / name, "is missing; should be " + right);
    return found;
  }
  // The fields that nobody asked for, as the text of a JSON object; empty where there are none.
  std::string unknown() const {
    if (!object_.is_object()) return "";
    Json rest = Json::object();
    for (const auto& [name, value] : object_.get_ref<const Json::object_t&>())
      if (std::find(known_.begin(), known_.end(), name) == known_.end())
        append_field(rest, name, value);
    return rest.empty() ? "" : rest.dump();
  }

 private:
  const Json& object_;
  const JsonPath& path_;
  Faults& faults_;
  std::vector<std::string_view> known_;
};

class Reader {
 public:
  explicit Reader(Faults& faults) : faults_(faults) {}
  Document read(const Json& json);

 private:
  void wrong(const JsonPath& at, const Json& value, const std::string& right) {
    if (!value.is_discarded()) faults_.add(at, "is " + in_words(value) + "; should be " + right);
  }

  // Each reads one value into `out` and is true, or reports a fault and leaves `out` alone.
  bool number(const Json& value, const JsonPath& at, const Range& range, double& out);
  bool whole(const Json& value, const JsonPath& at, const Range& range, int& out);
  bool boolean(const Json& value, const JsonPath& at, bool& out);
  bool text(const Json& value, const JsonPath& at, std::string& out, bool may_be_empty = false);
  template <class Vector>
  bool numbers(const Json& value, const JsonPath& at, const char* right, const Range& range,
               Vector& out);
  bool joint(const Json& value, const JsonPath& at, int& out);
  bool list(const Json* value, const JsonPath& at, std::size_t most);

  void version(Fields& fields, const JsonPath& root);
  void camera(const Json& value, const JsonPath& at);
  void skeleton(const Json& value, const JsonPath& at);
  void parent(const Json& value, const JsonPath& at, int index);
  void mirrors(const Json& joints, const JsonPath& at);
  void frame(const Json& value, const JsonPath& at, int index);
  void image(const Json& value, const JsonPath& at, std::string& out);
  void pose(const Json& value, const JsonPath& at, Pose& out);
  bool rotation(const Json& value, const JsonPath& at, Quat& out);
  void contour(const Json& value, const JsonPath& at, const std::string& frame, Contour& out);
  void check_line(const JsonPath& at, const std::string& whose, const Polyline& line);
  void calibration(const Json& value, const JsonPath& at);
  void spheres(const Json& value, const JsonPath& at);
  void parts(const Json& value, const JsonPath& at);
  void animation(const Json& value, const JsonPath& at, std::size_t& keys);
  void settings(const Json& value, const JsonPath& at);
  void check_depths(const JsonPath& frames);

  Faults& faults_;
  Document document_;
  std::unordered_map<std::string, int> joints_;  // index by name; the first of equal names
};

std::string frame_words(int index, const std::string& name) {
  return "frame " + std::to_string(index + 1) + (name.empty() ? "" : " " + in_quotes(name));
}

// The areas of all triangles between the first point and a side: nothing only where all points lie
// on one line.
double fan_area(const Polyline& line) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < line.points.size(); ++i) {
    const Vec2 u = line.points[i] - line.points[0], v = line.points[i + 1] - line.points[0];
    sum += std::abs(u.x() * v.y() - u.y() * v.x()) / 2;
  }
  return sum;
}

// ---------------------------------------------------------------- values

bool Reader::number(const Json& value, const JsonPath& at, const Range& range, double& out) {
  if (!value.is_number()) return wrong(at, value, range.words), false;
  const double x = value.get<double>();
  if (!(x >= range.low && x <= range.high) || (range.above_low && x == range.low))
    return wrong(at, value, range.words), false;
  out = x;
  return true;
}

bool Reader::whole(const Json& value, const JsonPath& at, const Range& range, int& out) {
  double x = 0;
  if (value.is_number() && value.get<double>() != std::trunc(value.get<double>()))
    return wrong(at, value, range.words), false;
  if (!number(value, at, range, x)) return false;
  out = int(x);
  return true;
}

bool Reader::boolean(const Json& value, const JsonPath& at, bool& out) {
  if (!value.is_boolean()) return wrong(at, value, "true or false"), false;
  out = value.get<bool>();
  return true;
}

bool Reader::text(const Json& value, const JsonPath& at, std::string& out, bool may_be_empty) {
  if (!value.is_string() || (!may_be_empty && value.get_ref<const std::string&>().empty()))
    return wrong(at, value, may_be_empty ? "a text" : "a text that is not empty"), false;
  out = value.get<std::string>();
  return true;
}

template <class Vector>
bool Reader::numbers(const Json& value, const JsonPath& at, const char* right, const Range& range,
                     Vector& out) {
  if (!value.is_array() || value.size() != std::size_t(out.size()))
    return wrong(at, value, right), false;
  bool good = true;
  for (std::size_t i = 0; i < value.size(); ++i) good &= number(value[i], at / i, range, out[i]);
  return good;
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

// An array of at most `most` values.
bool Reader::list(const Json* value, const JsonPath& at, std::size_t most) {
  if (!value) return false;
  if (!value->is_array()) return wrong(at, *value, "an array"), false;
  if (value->size() <= most) return true;
  return wrong(at, *value, "one of at most " + std::to_string(most)), false;
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
  if (const Json* v = fields.need("frames", "an array of one frame or more");
      list(v, frames, kMostFrames)) {
    if (v->empty()) faults_.add(frames, "is empty; should have at least one frame");
    document_.frames.resize(v->size());
    for (std::size_t i = 0; i < v->size(); ++i) frame((*v)[i], frames / i, int(i));
  }
  if (const Json* v = fields.find("calibration")) calibration(*v, root / "calibration");
  if (const Json* v = fields.find("spheres")) spheres(*v, root / "spheres");
  if (const Json* v = fields.find("parts")) parts(*v, root / "parts");
  const JsonPath animations = root / "animations";
  if (const Json* v = fields.find("animations"); list(v, animations, kMostKeys)) {
    std::size_t keys = 0;
    for (std::size_t i = 0; i < v->size(); ++i) animation((*v)[i], animations / i, keys);
  }
  if (const Json* v = fields.find("settings")) settings(*v, root / "settings");
  document_.unknown = fields.unknown();
  if (faults_.none()) check_depths(frames);
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
  if (list(joints, joints_at, kMostJoints)) {
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
  if (index == 0) return wrong(at, value, "null: the first joint is the root");
  std::string name;
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
      list(v, contours, kMostPoints)) {
    frame.contours.resize(v->size());
    for (std::size_t i = 0; i < v->size(); ++i)
      contour((*v)[i], contours / i, frame_words(index, frame.name), frame.contours[i]);
  }
  frame.unknown = fields.unknown();
}

void Reader::image(const Json& value, const JsonPath& at, std::string& out) {
  const std::string right =
      "a path relative to the document, or a data:image/png;base64 or data:image/jpeg;base64 URI";
  if (!value.is_string()) return wrong(at, value, right);
  const std::string& uri = value.get_ref<const std::string&>();
  const bool data = uri.rfind("data:", 0) == 0;
  const bool good = data ? uri.rfind("data:image/png;base64,", 0) == 0 ||
                               uri.rfind("data:image/jpeg;base64,", 0) == 0
                         : !uri.empty() && uri[0] != '/' && uri.find('\0') == uri.npos;
  if (!good) return wrong(at, value, right);
  out = uri;
}

void Reader::pose(const Json& value, const JsonPath& at, Pose& out) {
  Fields fields(value, at, faults_);
  out.rotations.assign(document_.skeleton.size(), Quat::Identity());
  if (const Json* v = fields.need("root_position", kVector))
    numbers(*v, at / "root_position", kVector, kLength, out.root_position);
  if (const Json* v = fields.find("rotations")) {
    const JsonPath rotations = at / "rotations";
    if (!v->is_object()) {
      wrong(rotations, *v, "an object of rotations by joint name");
    } else {
      for (const auto& [name, given] : v->get_ref<const Json::object_t&>()) {
        const JsonPath one = rotations / name;
        const auto found = joints_.find(name);
        Quat read;
        if (found == joints_.end())
          faults_.add(one, "is no joint; should be a name in /skeleton/joints");
        else if (rotation(given, one, read))
          out.rotations[found->second] = read;
      }
    }
  }
  out.unknown = fields.unknown();
}

bool Reader::rotation(const Json& value, const JsonPath& at, Quat& out) {
  Eigen::Vector4d q;
  if (!numbers(value, at, kQuaternion, kUnit, q)) return false;
  const double norm = q.norm();
  if (std::abs(norm - 1) > kUnitSlack)
    return faults_.add(at, "has length " + in_words(json_number(norm)) +
                               "; should be a unit quaternion, of length 1"),
           false;
  if (std::abs(norm - 1) > kUnitAsGiven) q /= norm;
  out = Quat(q);  // Eigen keeps x, y, z, w too
  return true;
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
      list(v, points_at, kMostPoints)) {
    std::vector<Vec2>& points = out.line.points;
    for (std::size_t i = 0; i < v->size(); ++i) {
      Vec2 point;
      if (!numbers((*v)[i], points_at / i, kPoint, kPixel, point))
        good = false;
      else if (points.empty() || points.back() != point)
        points.push_back(point);
    }
    if (out.line.closed && points.size() > 1 && points.back() == points.front()) points.pop_back();
    if (good) check_line(points_at, whose, out.line);
  }
  out.unknown = fields.unknown();
}

void Reader::check_line(const JsonPath& at, const std::string& whose, const Polyline& line) {
  const std::size_t least = line.closed ? 3 : 2;
  if (line.points.size() < least)
    return faults_.add(at, whose + " has " + std::to_string(line.points.size()) +
                               (line.points.size() == 1 ? " point" : " different points") +
                               "; should have at least " + std::to_string(least) +
                               (line.closed ? ", as a closed line" : ", as an open line"));
  if (!line.closed) return;
  // A flat line crosses itself too, but those are not the words for it.
  const auto crossing = fan_area(line) < kLeastArea ? std::nullopt : self_crossing(line);
  if (crossing)
    faults_.add(at, whose + " crosses itself near (" + std::to_string(std::lround(crossing->x())) +
                        ", " + std::to_string(std::lround(crossing->y())) +
                        "); should go round once without crossing");
  else if (std::abs(signed_area(line)) < kLeastArea)
    faults_.add(at, whose +
                        " encloses nothing; should go round an area, or have "
                        "\"closed\": false");
}

// In perspective, what is drawn must stand before the camera.
void Reader::check_depths(const JsonPath& frames) {
  if (document_.camera.type != Camera::Type::perspective) return;
  for (std::size_t f = 0; f < document_.frames.size(); ++f) {
    const Frame& frame = document_.frames[f];
    const std::vector<Transform> posed = posed_joints(document_.skeleton, frame.pose);
    std::set<int> drawn;
    for (const Contour& contour : frame.contours) drawn.insert(contour.joint);
    const JsonPath at = frames / f;
    const auto behind = std::find_if(drawn.begin(), drawn.end(), [&](int j) {
      return posed[j].translation().z() >= document_.camera.distance;
    });
    if (behind != drawn.end())
      faults_.add(at / "pose", frame_words(int(f), frame.name) + ": " +
                                   in_quotes(document_.skeleton.joints[*behind].name) +
                                   " stands at or behind the camera; should have z below the "
                                   "camera's distance: move root_position away");
  }
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
  const JsonPath locked = at / "locked";
  if (const Json* v = fields.find("locked"); list(v, locked, kMostJoints))
    for (std::size_t i = 0; i < v->size(); ++i)
      if (int j = 0; joint((*v)[i], locked / i, j)) limits.locked.push_back(j);
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
  if (!value.is_object()) return wrong(at, value, "an object of spheres by joint name");
  for (const auto& [name, given] : value.get_ref<const Json::object_t&>()) {
    const JsonPath one = at / name;
    const auto found = joints_.find(name);
    if (found == joints_.end())
      faults_.add(one, "is no joint; should be a name in /skeleton/joints");
    SphereTweak sphere;
    Fields fields(given, one, faults_);
    double radius = 0;
    if (const Json* v = fields.find("radius"); v && number(*v, one / "radius", kPositive, radius))
      sphere.radius = radius;
    if (const Json* v = fields.find("offset"))
      numbers(*v, one / "offset", kVector, kLength, sphere.offset);
    sphere.unknown = fields.unknown();
    if (found != joints_.end()) document_.spheres[found->second] = std::move(sphere);
  }
}

void Reader::parts(const Json& value, const JsonPath& at) {
  if (!value.is_object()) return wrong(at, value, "an object of parts by joint name");
  for (const auto& [name, given] : value.get_ref<const Json::object_t&>()) {
    const JsonPath one = at / name;
    const auto found = joints_.find(name);
    if (found == joints_.end())
      faults_.add(one, "is no joint; should be a name in /skeleton/joints");
    PartSettings part;
    Fields fields(given, one, faults_);
    if (const Json* v = fields.find("fatness")) number(*v, one / "fatness", kFatness, part.fatness);
    part.unknown = fields.unknown();
    if (found != joints_.end()) document_.parts[found->second] = std::move(part);
  }
}

// `count`: the keys of all animations so far.
void Reader::animation(const Json& value, const JsonPath& at, std::size_t& count) {
  Animation& animation = document_.animations.emplace_back();
  Fields fields(value, at, faults_);
  if (const Json* v = fields.need("name", "a text that is not empty"))
    text(*v, at / "name", animation.name);
  const JsonPath keys = at / "keys";
  if (const Json* v = fields.need("keys", "an array of one key or more");
      list(v, keys, kMostKeys - count)) {
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

void Reader::settings(const Json& value, const JsonPath& at) {
  DocumentSettings& settings = document_.settings;
  Fields fields(value, at, faults_);
  int n = 0;
  bool yes = false;
  if (const Json* v = fields.find("grid"); v && whole(*v, at / "grid", kGrid, n)) settings.grid = n;
  if (const Json* v = fields.find("method")) {
    if (*v == "paper" || *v == "rays")
      settings.method = v->get<std::string>();
    else
      wrong(at / "method", *v, "'paper' or 'rays'");
  }
  if (const Json* v = fields.find("mirror"); v && boolean(*v, at / "mirror", yes))
    settings.mirror = yes;
  if (const Json* v = fields.find("triangles"); v && whole(*v, at / "triangles", kTriangles, n))
    settings.triangles = n;
  if (const Json* v = fields.find("texture"); v && boolean(*v, at / "texture", yes))
    settings.texture = yes;
  settings.unknown = fields.unknown();
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
  return parse_document(*bytes, path);
}

}  // namespace artisketch
