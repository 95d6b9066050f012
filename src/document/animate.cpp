#include "document/animate.h"

#include <algorithm>
#include <cmath>

#include "base/ensure.h"

namespace artisketch {

// ---------------------------------------------------------------- clips

namespace {

bool has_clip(const Document& document, const std::string& name) {
  return std::any_of(document.animations.begin(), document.animations.end(),
                     [&](const Animation& clip) { return clip.name == name; });
}

}  // namespace

Document with_animation(Document document, Animation animation) {
  const std::string name = animation.name;
  for (int number = 2; has_clip(document, animation.name); ++number)
    animation.name = name + " " + std::to_string(number);
  document.animations.push_back(std::move(animation));
  return document;
}

Document with_clip(Document document, Pose first) {
  int number = 1;
  while (has_clip(document, "clip " + std::to_string(number))) ++number;
  Animation clip;
  clip.name = "clip " + std::to_string(number);
  clip.keys.push_back({0, std::move(first), ""});
  document.animations.push_back(std::move(clip));
  return document;
}

Document without_clip(Document document, int clip) {
  ensure(clip >= 0 && clip < int(document.animations.size()), "a clip of the document");
  document.animations.erase(document.animations.begin() + clip);
  return document;
}

Document with_key(Document document, int clip, double time, Pose pose) {
  std::vector<Key>& keys = document.animations.at(clip).keys;
  time = std::max(0.0, time);
  for (Key& key : keys)
    if (std::abs(key.time - time) < kLeastStep) {
      key.pose = std::move(pose);
      return document;
    }
  const auto after =
      std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.time > time; });
  keys.insert(after, {time, std::move(pose), ""});
  return document;
}

Document without_key(Document document, int clip, int key) {
  std::vector<Key>& keys = document.animations.at(clip).keys;
  ensure(key >= 0 && key < int(keys.size()), "a key of the clip");
  keys.erase(keys.begin() + key);
  return keys.empty() ? without_clip(std::move(document), clip) : document;
}

Document with_key_moved(Document document, int clip, int key, double time) {
  std::vector<Key>& keys = document.animations.at(clip).keys;
  const double low = key > 0 ? keys[key - 1].time + kLeastStep : 0;
  time = std::max(time, low);
  if (key + 1 < int(keys.size())) time = std::min(time, keys[key + 1].time - kLeastStep);
  // Keys of a file may stand closer than people set them.
  if (time >= low) keys.at(key).time = time;
  return document;
}

// ---------------------------------------------------------------- parts

Document with_sphere(Document document, int joint, double radius, const Vec3& offset) {
  SphereTweak& sphere = document.spheres[joint];
  sphere.radius = std::max(0.0, radius);
  sphere.offset = offset;
  return document;
}

Document with_fatness(Document document, int joint, double fatness) {
  document.parts[joint].fatness = std::clamp(fatness, kThinnest, kFattest);
  return document;
}

double fatness_of(const Document& document, int joint) {
  const auto found = document.parts.find(joint);
  return found == document.parts.end() ? 1 : found->second.fatness;
}

namespace {

bool same(const Contour& a, const Contour& b) {
  return a.joint == b.joint && a.line.closed == b.line.closed && a.line.points == b.line.points;
}

bool same(const Joint& a, const Joint& b) {
  return a.name == b.name && a.parent == b.parent && a.offset == b.offset && a.mirror == b.mirror;
}

bool same(const Frame& a, const Frame& b) {
  return a.width == b.width && a.height == b.height && a.image == b.image &&
         a.principal_point == b.principal_point && a.scale == b.scale &&
         same_pose(a.pose, b.pose) &&
         std::equal(a.contours.begin(), a.contours.end(), b.contours.begin(), b.contours.end(),
                    [](const Contour& p, const Contour& q) { return same(p, q); });
}

bool same(const Camera& a, const Camera& b) {
  return a.type == b.type && a.pixels_per_unit == b.pixels_per_unit &&
         a.focal_length == b.focal_length && a.distance == b.distance;
}

bool same(const CalibrationLimits& a, const CalibrationLimits& b) {
  return a.max_rotation == b.max_rotation && a.max_translation == b.max_translation &&
         a.locked == b.locked && a.free_first_frame == b.free_first_frame && a.scale == b.scale;
}

bool same(const DocumentSettings& a, const DocumentSettings& b) {
  return a.grid == b.grid && a.method == b.method && a.mirror == b.mirror &&
         a.triangles == b.triangles && a.texture == b.texture;
}

// A sphere or a fatness that says nothing is as good as none.
bool same_tweaks(const Document& a, const Document& b, int joint) {
  const auto sphere = [joint](const Document& document) {
    const auto found = document.spheres.find(joint);
    return found == document.spheres.end() ? SphereTweak() : found->second;
  };
  const SphereTweak p = sphere(a), q = sphere(b);
  return p.radius == q.radius && p.offset == q.offset &&
         fatness_of(a, joint) == fatness_of(b, joint) && role_of(a, joint) == role_of(b, joint);
}

}  // namespace

bool same_model(const Document& a, const Document& b) {
  const std::vector<Joint>&p = a.skeleton.joints, &q = b.skeleton.joints;
  if (!same(a.camera, b.camera) || !same(a.calibration, b.calibration) ||
      !same(a.settings, b.settings) ||
      !std::equal(p.begin(), p.end(), q.begin(), q.end(),
                  [](const Joint& x, const Joint& y) { return same(x, y); }) ||
      !std::equal(a.frames.begin(), a.frames.end(), b.frames.begin(), b.frames.end(),
                  [](const Frame& x, const Frame& y) { return same(x, y); }))
    return false;
  for (int j = 0; j < a.skeleton.size(); ++j)
    if (!same_tweaks(a, b, j)) return false;
  return true;
}

}  // namespace artisketch
