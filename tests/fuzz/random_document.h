// Documents at random: a small chain of joints, frames that turn it, and contours on a coarse
// lattice, where degenerate shapes are frequent. `Bytes` chooses: libFuzzer's FuzzedDataProvider,
// or RandomBytes.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "document/document.h"

namespace artisketch::fuzz {

template <class Bytes>
Vec3 small_integers(Bytes& bytes) {
  const int x = bytes.ConsumeIntegralInRange(-5, 5);
  const int y = bytes.ConsumeIntegralInRange(-5, 5);
  const int z = bytes.ConsumeIntegralInRange(-5, 5);
  return Vec3(x, y, z);
}

template <class Bytes>
Quat rotation_from(Bytes& bytes) {
  const Vec3 turn = small_integers(bytes);
  if (turn.isZero()) return Quat::Identity();
  return Quat(Eigen::AngleAxisd(turn.norm() * std::numbers::pi / 6, turn.normalized()));
}

// Puts points in the order of their angles about their mean: most such outlines don't cross.
inline void go_round(std::vector<Vec2>& points) {
  Vec2 mean = Vec2::Zero();
  for (const Vec2& p : points) mean += p / double(points.size());
  std::stable_sort(points.begin(), points.end(), [&](const Vec2& a, const Vec2& b) {
    return std::atan2(a.y() - mean.y(), a.x() - mean.x()) <
           std::atan2(b.y() - mean.y(), b.x() - mean.x());
  });
}

// How large a document may be.
struct Most {
  int joints = 3, frames = 3, contours = 4, points = 12;  // contours of a frame, points of each
};

template <class Bytes>
Contour contour_from(Bytes& bytes, int joints, int points) {
  Contour contour;
  contour.joint = bytes.ConsumeIntegralInRange(0, joints - 1);
  contour.line.closed = bytes.ConsumeIntegralInRange(0, 7) != 0;
  const bool simple = bytes.ConsumeBool();
  const int count = bytes.ConsumeIntegralInRange(2, points);
  for (int i = 0; i < count; ++i) {
    const int x = bytes.ConsumeIntegralInRange(0, 32);
    const int y = bytes.ConsumeIntegralInRange(0, 32);
    contour.line.points.emplace_back(4 * x, 4 * y);
  }
  if (simple) go_round(contour.line.points);
  return contour;
}

template <class Bytes>
Document document_from(Bytes& bytes, const Most& most = {}) {
  Document document;
  document.name = "fuzz";
  document.camera.type =
      bytes.ConsumeBool() ? Camera::Type::orthographic : Camera::Type::perspective;
  document.camera.pixels_per_unit = 50;
  document.camera.focal_length = 200;
  document.camera.distance = 4;
  const int joints = bytes.ConsumeIntegralInRange(1, most.joints);
  for (int j = 0; j < joints; ++j) {
    Joint joint;
    joint.name = "joint" + std::to_string(j);
    joint.parent = j - 1;
    joint.offset = 0.1 * small_integers(bytes);
    document.skeleton.joints.push_back(joint);
  }
  const int frames = bytes.ConsumeIntegralInRange(1, most.frames);
  for (int f = 0; f < frames; ++f) {
    Frame frame;
    frame.name = "frame" + std::to_string(f);
    frame.width = frame.height = 128;
    frame.pose = rest_pose(document.skeleton);
    for (Quat& rotation : frame.pose.rotations) rotation = rotation_from(bytes);
    const int contours = bytes.ConsumeIntegralInRange(0, most.contours);
    for (int c = 0; c < contours; ++c)
      frame.contours.push_back(contour_from(bytes, joints, most.points));
    document.frames.push_back(frame);
  }
  return document;
}

}  // namespace artisketch::fuzz
