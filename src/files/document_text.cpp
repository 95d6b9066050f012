#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>

#include "base/ensure.h"
#include "files/bytes.h"
#include "files/document_file.h"
#include "files/json.h"

namespace artisketch {
namespace {

template <class Vector>
Json numbers(const Vector& values) {
  Json all = Json::array();
  for (int i = 0; i < int(values.size()); ++i) all.push_back(json_number(values[i]));
  return all;
}

// The shortest number of degrees that reads as exactly these radians; the nearest where none does.
Json degrees_number(double given) {
  const double nearest = degrees(given);
  for (int digits = 1; digits <= 17; ++digits) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, nearest);
    const double candidate = std::strtod(text, nullptr);
    if (radians(candidate) == given) return json_number(candidate);
  }
  // Two roundings may have stepped over it.
  for (const double towards : {-HUGE_VAL, HUGE_VAL})
    if (const double next = std::nextafter(nearest, towards); radians(next) == given)
      return json_number(next);
  return json_number(nearest);
}

// The fields that a reader did not know follow those it did.
Json with_unknown(Json object, const std::string& unknown) {
  if (unknown.empty()) return object;
  Faults ours("unknown fields");
  const std::optional<Json> rest = parse_json(unknown, ours);
  ensure(rest && rest->is_object(), "fields that were read from an object");
  if (!rest || !rest->is_object()) return object;
  std::set<std::string> known;
  for (const auto& [name, value] : object.get_ref<const Json::object_t&>()) known.insert(name);
  for (const auto& [name, value] : rest->get_ref<const Json::object_t&>())
    if (known.count(name) == 0) append_field(object, name, value);
  return object;
}

bool is_exactly_identity(const Quat& q) {
  const auto zero = [](double x) { return x == 0 && !std::signbit(x); };
  return zero(q.x()) && zero(q.y()) && zero(q.z()) && q.w() == 1;
}

class Writer {
 public:
  explicit Writer(const Document& document) : document_(document) {}
  Json whole() const;

 private:
  const std::string& name(int joint) const { return document_.skeleton.joints[joint].name; }
  bool orthographic() const { return document_.camera.type == Camera::Type::orthographic; }
  Json camera() const;
  Json skeleton() const;
  Json frame(const Frame& frame) const;
  Json pose(const Pose& pose) const;
  Json calibration() const;
  Json spheres() const;
  Json parts() const;
  Json animation(const Animation& animation) const;
  Json motion() const;
  Json settings() const;

  const Document& document_;
};

Json Writer::whole() const {
  Json all = Json::object();
  all["artisketch"] = 1;
  if (!document_.name.empty()) all["name"] = document_.name;
  all["camera"] = camera();
  all["skeleton"] = skeleton();
  Json& frames = all["frames"] = Json::array();
  for (const Frame& f : document_.frames) frames.push_back(frame(f));
  if (Json limits = calibration(); !limits.empty()) all["calibration"] = std::move(limits);
  if (!document_.spheres.empty()) all["spheres"] = spheres();
  if (!document_.parts.empty()) all["parts"] = parts();
  if (!document_.animations.empty()) {
    Json& animations = all["animations"] = Json::array();
    for (const Animation& a : document_.animations) animations.push_back(animation(a));
  }
  if (Json map = motion(); !map.empty()) all["motion"] = std::move(map);
  if (Json defaults = settings(); !defaults.empty()) all["settings"] = std::move(defaults);
  return with_unknown(std::move(all), document_.unknown);
}

Json Writer::camera() const {
  Json camera = Json::object();
  camera["type"] = orthographic() ? "orthographic" : "perspective";
  if (orthographic()) {
    camera["pixels_per_unit"] = json_number(document_.camera.pixels_per_unit);
  } else {
    camera["focal_length"] = json_number(document_.camera.focal_length);
    camera["distance"] = json_number(document_.camera.distance);
  }
  return with_unknown(std::move(camera), document_.camera_unknown);
}

Json Writer::skeleton() const {
  Json skeleton = Json::object();
  Json& joints = skeleton["joints"] = Json::array();
  for (const Joint& joint : document_.skeleton.joints) {
    Json one = Json::object();
    one["name"] = joint.name;
    one["parent"] = joint.parent < 0 ? Json(nullptr) : Json(name(joint.parent));
    one["offset"] = numbers(joint.offset);
    if (joint.mirror >= 0) one["mirror"] = name(joint.mirror);
    joints.push_back(with_unknown(std::move(one), joint.unknown));
  }
  return with_unknown(std::move(skeleton), document_.skeleton_unknown);
}

Json Writer::frame(const Frame& frame) const {
  Json out = Json::object();
  if (!frame.name.empty()) out["name"] = frame.name;
  out["size"] = {frame.width, frame.height};
  if (!frame.image.empty()) out["image"] = frame.image;
  if (frame.principal_point) out["principal_point"] = numbers(*frame.principal_point);
  if (frame.scale != 1 && orthographic()) out["scale"] = json_number(frame.scale);
  out["pose"] = pose(frame.pose);
  Json& contours = out["contours"] = Json::array();
  for (const Contour& contour : frame.contours) {
    Json one = Json::object();
    one["joint"] = name(contour.joint);
    if (!contour.line.closed) one["closed"] = false;
    Json& points = one["points"] = Json::array();
    // A reader drops points that repeat the one before: none are written, so that a text comes
    // back.
    const std::vector<Vec2>& all = contour.line.points;
    std::size_t count = all.size();
    while (contour.line.closed && count > 1 && all[count - 1] == all[0]) --count;
    for (std::size_t i = 0; i < count; ++i)
      if (i == 0 || all[i] != all[i - 1]) points.push_back(numbers(all[i]));
    contours.push_back(with_unknown(std::move(one), contour.unknown));
  }
  for (const int joint : frame.hidden) out["hidden"].push_back(name(joint));
  if (!frame.posed) out["posed"] = false;
  for (const int joint : frame.set_joints) out["set_joints"].push_back(name(joint));
  return with_unknown(std::move(out), frame.unknown);
}

Json Writer::pose(const Pose& pose) const {
  Json out = Json::object();
  out["root_position"] = numbers(pose.root_position);
  Json rotations = Json::object();
  for (int j = 0; j < int(pose.rotations.size()); ++j)
    if (!is_exactly_identity(pose.rotations[j]))
      rotations[name(j)] = numbers(pose.rotations[j].coeffs());  // x, y, z, w
  if (!rotations.empty()) out["rotations"] = std::move(rotations);
  return with_unknown(std::move(out), pose.unknown);
}

Json Writer::calibration() const {
  const CalibrationLimits& limits = document_.calibration;
  Json out = Json::object();
  if (limits.max_rotation) out["max_rotation"] = degrees_number(*limits.max_rotation);
  if (limits.max_translation) out["max_translation"] = json_number(*limits.max_translation);
  for (const int joint : limits.locked) out["locked"].push_back(name(joint));
  if (limits.free_first_frame) out["free_first_frame"] = true;
  if (limits.scale && orthographic()) out["scale"] = true;
  return with_unknown(std::move(out), limits.unknown);
}

Json Writer::spheres() const {
  Json out = Json::object();
  for (const auto& [joint, sphere] : document_.spheres) {
    Json one = Json::object();
    if (sphere.radius) one["radius"] = json_number(*sphere.radius);
    one["offset"] = numbers(sphere.offset);
    out[name(joint)] = with_unknown(std::move(one), sphere.unknown);
  }
  return out;
}

Json Writer::parts() const {
  Json out = Json::object();
  for (const auto& [joint, part] : document_.parts) {
    Json one = Json::object();
    one["fatness"] = json_number(part.fatness);
    if (part.role != Role::body) one["role"] = kRoleNames[int(part.role)];
    out[name(joint)] = with_unknown(std::move(one), part.unknown);
  }
  return out;
}

Json Writer::animation(const Animation& animation) const {
  Json out = Json::object();
  out["name"] = animation.name;
  Json& keys = out["keys"] = Json::array();
  for (const Key& key : animation.keys) {
    Json one = Json::object();
    one["time"] = json_number(key.time);
    one["pose"] = pose(key.pose);
    keys.push_back(with_unknown(std::move(one), key.unknown));
  }
  return with_unknown(std::move(out), animation.unknown);
}

Json Writer::motion() const {
  Json out = Json::object();
  for (const auto& [theirs, joint] : document_.motion.joints)
    if (!theirs.empty()) out["joints"][theirs] = name(joint);
  for (const auto& [theirs, joint] : document_.motion.joints)
    if (theirs.empty()) out["still"].push_back(name(joint));
  return with_unknown(std::move(out), document_.motion.unknown);
}

Json Writer::settings() const {
  const DocumentSettings& settings = document_.settings;
  Json out = Json::object();
  if (settings.grid) out["grid"] = *settings.grid;
  if (settings.method) out["method"] = *settings.method;
  if (settings.mirror) out["mirror"] = *settings.mirror;
  if (settings.triangles) out["triangles"] = *settings.triangles;
  if (settings.texture) out["texture"] = *settings.texture;
  return with_unknown(std::move(out), settings.unknown);
}

}  // namespace

std::string document_text(const Document& document) {
  return json_text(Writer(document).whole());
}

Result<Done> write_document(const std::string& path, const Document& document) {
  return write_file(path, document_text(document));
}

}  // namespace artisketch
