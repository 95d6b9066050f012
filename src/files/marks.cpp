#include "files/marks.h"

#include <limits>

namespace artisketch {
namespace {

constexpr unsigned kPalette[] = {0x4AA7C9, 0xF9834A, 0x008899, 0xC02346, 0x4E9CFB,
                                 0x39B804, 0x82530B, 0x857BBE, 0xE84E66, 0x933DF2,
                                 0xE8169A, 0x0C6944, 0xA3139E, 0xD15F22, 0x3056B7,
                                 0xD5869F, 0x99406F, 0x8DAE6A, 0xF260FC, 0x489164};
constexpr unsigned kWhite = 0xFFFFFF, kBone = 0x1C2025, kFormer = 0x8A9099;
constexpr double kCasing = 1.25, kCasingOpacity = 0.7;  // pixels on each side of a line

std::vector<Vec2> scaled(const std::vector<Vec2>& points, double scale) {
  std::vector<Vec2> all(points);
  for (Vec2& p : all) p *= scale;
  return all;
}

}  // namespace

unsigned joint_colour(int joint) {
  constexpr int kColours = int(std::size(kPalette));
  return kPalette[((joint % kColours) + kColours) % kColours];
}

void draw_contours(Image& image, const Frame& frame, double scale, double line_width, double fill) {
  for (const Contour& contour : frame.contours) {
    if (fill <= 0 || !contour.line.closed) continue;
    const std::vector<std::vector<Vec2>> inside{scaled(contour.line.points, scale)};
    fill_polygons(image, inside, colour(joint_colour(contour.joint), fill));
  }
  for (const Contour& contour : frame.contours) {
    const std::vector<Vec2> points = scaled(contour.line.points, scale);
    const bool closed = contour.line.closed;
    draw_line(image, points, closed, line_width + 2 * kCasing, colour(kWhite, kCasingOpacity));
    draw_line(image, points, closed, line_width, colour(joint_colour(contour.joint)));
  }
}

std::vector<Vec2> joint_pixels(const Skeleton& skeleton, const Pose& pose, const Transform& view,
                               const FrameCamera& camera) {
  std::vector<Vec2> pixels;
  for (const Transform& joint : posed_joints(skeleton, pose)) {
    const Vec3 X = view * joint.translation();
    pixels.push_back(camera.in_front(X)
                         ? camera.project(X)
                         : Vec2(Vec2::Constant(std::numeric_limits<double>::quiet_NaN())));
  }
  return pixels;
}

void draw_skeleton(Image& image, const Skeleton& skeleton, std::span<const Vec2> pixels) {
  constexpr double kBoneWidth = 1.75, kJoint = 2.6, kRing = 1.3;
  const auto bones = [&](double width, const Colour& colour) {
    for (int j = 0; j < skeleton.size(); ++j)
      if (const int parent = skeleton.joints[j].parent; parent >= 0) {
        const Vec2 ends[] = {pixels[parent], pixels[j]};
        draw_line(image, ends, false, width, colour);
      }
  };
  bones(kBoneWidth + 2 * kCasing, colour(kWhite, kCasingOpacity));
  bones(kBoneWidth, colour(kBone));
  for (int j = 0; j < skeleton.size(); ++j) {
    fill_disc(image, pixels[j], kJoint + 2 * kRing, colour(kWhite));
    fill_disc(image, pixels[j], kJoint + kRing, colour(kBone));
    fill_disc(image, pixels[j], kJoint, colour(kWhite));
    fill_disc(image, pixels[j], kJoint - 0.6, colour(joint_colour(j)));
  }
}

void draw_former_skeleton(Image& image, const Skeleton& skeleton, std::span<const Vec2> pixels) {
  constexpr double kDot = 2, kStep = 4.5, kJoint = 2.8;
  const auto dots = [&](double width, const Colour& colour) {
    for (int j = 0; j < skeleton.size(); ++j)
      if (const int parent = skeleton.joints[j].parent; parent >= 0)
        draw_dots(image, pixels[parent], pixels[j], width, kStep, colour);
  };
  dots(kDot + kCasing, colour(kWhite, kCasingOpacity));
  dots(kDot, colour(kFormer));
  for (const Vec2& p : pixels) {
    fill_disc(image, p, kJoint + kCasing, colour(kWhite));
    fill_disc(image, p, kJoint, colour(kFormer));
    fill_disc(image, p, kJoint - 1.3, colour(kWhite));
  }
}

}  // namespace artisketch
