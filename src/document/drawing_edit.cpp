#include "document/drawing_edit.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "base/ensure.h"

namespace artisketch {
namespace {

template <class Map>
void map_pixels(Frame& frame, const Map& map) {
  for (Contour& contour : frame.contours)
    for (Vec2& p : contour.line.points) p = map(p);
  if (frame.principal_point) frame.principal_point = map(*frame.principal_point);
}

int other_side(const Skeleton& skeleton, int joint) {
  const int mirror = skeleton.joints[joint].mirror;
  return mirror >= 0 ? mirror : joint;
}

void to_other_side(const Skeleton& skeleton, std::vector<int>& joints) {
  for (int& joint : joints) joint = other_side(skeleton, joint);
  std::sort(joints.begin(), joints.end());
}

// A pose reflected in the plane x = 0, for a skeleton that is its own mirror image.
Pose mirror_image(const Skeleton& skeleton, const Pose& pose) {
  Pose out = pose;
  out.root_position.x() *= -1;
  for (int j = 0; j < skeleton.size(); ++j) {
    const Quat& q = pose.rotations[other_side(skeleton, j)];
    out.rotations[j] = Quat(q.w(), q.x(), -q.y(), -q.z());
  }
  return out;
}

Frame& frame_of(Document& document, int frame) {
  ensure(frame >= 0 && frame < int(document.frames.size()), "a frame of the document");
  return document.frames[frame];
}

bool within(const PixelBox& box, int width, int height) {
  return box.x >= 0 && box.y >= 0 && box.width > 0 && box.height > 0 && box.right() <= width &&
         box.bottom() <= height;
}

}  // namespace

Image turned(const Image& picture, int quarters) {
  const int turns = ((quarters % 4) + 4) % 4;
  if (turns == 0) return picture;
  const int w = picture.width, h = picture.height;
  Image out(turns == 2 ? w : h, turns == 2 ? h : w);
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      const auto [u, v] = turns == 1   ? std::pair(h - 1 - y, x)
                          : turns == 2 ? std::pair(w - 1 - x, h - 1 - y)
                                       : std::pair(y, w - 1 - x);
      std::copy_n(picture.at(x, y), 4, out.at(u, v));
    }
  return out;
}

Document with_drawing_turned(Document document, int frame, int quarters) {
  Frame& turning = frame_of(document, frame);
  const Quat turn(Eigen::AngleAxisd(-std::numbers::pi / 2, Vec3::UnitZ()));
  for (int i = ((quarters % 4) + 4) % 4; i > 0; --i) {
    map_pixels(turning, [&](const Vec2& p) { return Vec2(turning.height - p.y(), p.x()); });
    std::swap(turning.width, turning.height);
    const Vec3 at = turning.pose.root_position;
    turning.pose.root_position = Vec3(at.y(), -at.x(), at.z());
    turning.pose.rotations[0] = (turn * turning.pose.rotations[0]).normalized();
  }
  return document;
}

Image flipped(const Image& picture) {
  Image out(picture.width, picture.height);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      std::copy_n(picture.at(picture.width - 1 - x, y), 4, out.at(x, y));
  return out;
}

Document with_drawing_flipped(Document document, int frame) {
  const Skeleton& skeleton = document.skeleton;
  Frame& flipping = frame_of(document, frame);
  map_pixels(flipping, [&](const Vec2& p) { return Vec2(flipping.width - p.x(), p.y()); });
  for (Contour& contour : flipping.contours) contour.joint = other_side(skeleton, contour.joint);
  to_other_side(skeleton, flipping.hidden);
  to_other_side(skeleton, flipping.set_joints);
  flipping.pose = mirror_image(skeleton, flipping.pose);
  return document;
}

Image cropped(const Image& picture, const PixelBox& box) {
  ensure(within(box, picture.width, picture.height), "a box within its picture");
  Image out(box.width, box.height);
  for (int y = 0; y < box.height; ++y)
    std::copy_n(picture.at(box.x, box.y + y), 4 * std::size_t(box.width), out.at(0, y));
  return out;
}

Document with_drawing_cropped(Document document, int frame, const PixelBox& box) {
  Frame& cut = frame_of(document, frame);
  ensure(within(box, cut.width, cut.height), "a box within its drawing");
  cut.principal_point = frame_camera(document, frame).principal_point;
  map_pixels(cut, [&](const Vec2& p) { return Vec2(p - Vec2(box.x, box.y)); });
  cut.width = box.width;
  cut.height = box.height;
  return document;
}

Document with_drawing_resized(Document document, int frame, int width, int height) {
  Frame& resized = frame_of(document, frame);
  ensure(document.camera.type == Camera::Type::orthographic && width > 0 && height > 0,
         "a size, and a camera that frames scale");
  const double times = double(width) / resized.width;
  map_pixels(resized, [&](const Vec2& p) { return Vec2(times * p); });
  resized.scale *= times;
  resized.width = width;
  resized.height = height;
  return document;
}

}  // namespace artisketch
