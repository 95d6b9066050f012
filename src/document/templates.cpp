#include "document/templates.h"

#include <algorithm>
#include <cmath>

#include "base/ensure.h"
#include "document/edit.h"
#include "document/skeleton_edit.h"

namespace artisketch {
namespace {

struct Entry {
  const char *name, *parent;  // .L stands for the pair
  double x, y, z;             // from the parent, units
};

constexpr Entry kHuman[] = {{"hips", "", 0, 0.9, 0},
                            {"chest", "hips", 0, 0.25, 0},
                            {"head", "chest", 0, 0.35, 0},
                            {"head_tip", "head", 0, 0.3, 0},
                            {"upper_arm.L", "chest", 0.19, 0.26, 0},
                            {"forearm.L", "upper_arm.L", 0.28, 0, 0},
                            {"hand.L", "forearm.L", 0.25, 0, 0},
                            {"hand_tip.L", "hand.L", 0.17, 0, 0},
                            {"thigh.L", "hips", 0.1, -0.06, 0},
                            {"shin.L", "thigh.L", 0, -0.4, 0},
                            {"foot.L", "shin.L", 0, -0.39, 0},
                            {"foot_tip.L", "foot.L", 0, -0.05, 0.18}};

constexpr Entry kQuadruped[] = {{"body", "", 0, 0.62, -0.42},
                                {"chest", "body", 0, 0.02, 0.5},
                                {"neck", "chest", 0, 0.12, 0.14},
                                {"head", "neck", 0, 0.17, 0.12},
                                {"head_tip", "head", 0, -0.02, 0.3},
                                {"tail", "body", 0, 0.05, -0.14},
                                {"tail_tip", "tail", 0, 0.02, -0.4},
                                {"fore_thigh.L", "chest", 0.1, -0.1, 0.04},
                                {"fore_shin.L", "fore_thigh.L", 0, -0.26, -0.02},
                                {"fore_paw.L", "fore_shin.L", 0, -0.24, 0.02},
                                {"fore_paw_tip.L", "fore_paw.L", 0, -0.04, 0.12},
                                {"hind_thigh.L", "body", 0.1, -0.07, -0.02},
                                {"hind_shin.L", "hind_thigh.L", 0, -0.25, 0.06},
                                {"hind_paw.L", "hind_shin.L", 0, -0.26, -0.1},
                                {"hind_paw_tip.L", "hind_paw.L", 0, -0.04, 0.13}};

constexpr Entry kBird[] = {{"body", "", 0, 0.5, -0.1},
                           {"chest", "body", 0, 0.1, 0.2},
                           {"head", "chest", 0, 0.22, 0.1},
                           {"beak", "head", 0, 0.04, 0.12},
                           {"beak_tip", "beak", 0, -0.02, 0.14},
                           {"tail", "body", 0, 0, -0.15},
                           {"tail_tip", "tail", 0, -0.05, -0.35},
                           {"upper_wing.L", "chest", 0.1, 0.04, -0.05},
                           {"lower_wing.L", "upper_wing.L", 0.26, 0, 0},
                           {"wing.L", "lower_wing.L", 0.26, 0, 0},
                           {"wing_tip.L", "wing.L", 0.3, 0, 0},
                           {"thigh.L", "body", 0.08, -0.05, 0.06},
                           {"shin.L", "thigh.L", 0, -0.18, 0.04},
                           {"foot.L", "shin.L", 0, -0.23, -0.04},
                           {"foot_tip.L", "foot.L", 0, -0.04, 0.14}};

constexpr Entry kSpider[] = {{"body", "", 0, 0.35, 0},
                             {"head", "body", 0, 0, 0.16},
                             {"head_tip", "head", 0, 0, 0.16},
                             {"abdomen", "body", 0, 0.05, -0.16},
                             {"abdomen_tip", "abdomen", 0, 0.02, -0.42},
                             {"thigh_1.L", "body", 0.1, 0, 0.12},
                             {"shin_1.L", "thigh_1.L", 0.26, 0.22, 0.24},
                             {"shin_1_tip.L", "shin_1.L", 0.2, -0.57, 0.2},
                             {"thigh_2.L", "body", 0.12, 0, 0.04},
                             {"shin_2.L", "thigh_2.L", 0.36, 0.24, 0.1},
                             {"shin_2_tip.L", "shin_2.L", 0.3, -0.59, 0.08},
                             {"thigh_3.L", "body", 0.12, 0, -0.04},
                             {"shin_3.L", "thigh_3.L", 0.36, 0.24, -0.1},
                             {"shin_3_tip.L", "shin_3.L", 0.3, -0.59, -0.08},
                             {"thigh_4.L", "body", 0.1, 0, -0.12},
                             {"shin_4.L", "thigh_4.L", 0.26, 0.22, -0.26},
                             {"shin_4_tip.L", "shin_4.L", 0.22, -0.57, -0.24}};

constexpr Entry kFish[] = {
    {"body", "", 0, 0.4, 0.1},           {"head", "body", 0, 0, 0.3},
    {"head_tip", "head", 0, 0, 0.3},     {"rear", "body", 0, 0, -0.3},
    {"tail", "rear", 0, 0, -0.3},        {"tail_tip", "tail", 0, 0, -0.3},
    {"back_fin", "body", 0, 0.2, -0.05}, {"back_fin_tip", "back_fin", 0, 0.2, -0.1},
    {"fin.L", "body", 0.1, -0.08, 0.16}, {"fin_tip.L", "fin.L", 0.22, -0.1, -0.12}};

constexpr Entry kHand[] = {{"wrist", "", 0, 0, 0},
                           {"palm", "wrist", 0, 0.25, 0},
                           {"thumb_1", "palm", 0.22, 0.1, 0.05},
                           {"thumb_2", "thumb_1", 0.16, 0.2, 0.02},
                           {"thumb_tip", "thumb_2", 0.1, 0.18, 0},
                           {"index_1", "palm", 0.19, 0.5, 0},
                           {"index_2", "index_1", 0.02, 0.26, 0},
                           {"index_3", "index_2", 0.01, 0.17, 0},
                           {"index_tip", "index_3", 0.01, 0.14, 0},
                           {"middle_1", "palm", 0.04, 0.53, 0},
                           {"middle_2", "middle_1", 0, 0.3, 0},
                           {"middle_3", "middle_2", 0, 0.19, 0},
                           {"middle_tip", "middle_3", 0, 0.15, 0},
                           {"ring_1", "palm", -0.11, 0.49, 0},
                           {"ring_2", "ring_1", -0.02, 0.27, 0},
                           {"ring_3", "ring_2", -0.01, 0.18, 0},
                           {"ring_tip", "ring_3", -0.01, 0.14, 0},
                           {"little_1", "palm", -0.24, 0.42, 0},
                           {"little_2", "little_1", -0.04, 0.2, 0},
                           {"little_3", "little_2", -0.02, 0.14, 0},
                           {"little_tip", "little_3", -0.02, 0.12, 0}};

constexpr Entry kBlank[] = {{"root", "", 0, 0.5, 0}};

struct About {
  TemplateWords words;
  std::span<const Entry> entries;
  bool long_bodied;  // usually drawn from the side
};

const About kTemplates[] = {
    {{Template::human, "Human", "two arms, two legs"}, kHuman, false},
    {{Template::quadruped, "Quadruped", "four legs and a tail"}, kQuadruped, true},
    {{Template::bird, "Bird", "wings and two legs"}, kBird, true},
    {{Template::spider, "Spider", "eight legs"}, kSpider, false},
    {{Template::fish, "Fish", "a spine and fins"}, kFish, true},
    {{Template::hand, "Hand", "five fingers"}, kHand, false},
    {{Template::blank, "Blank", "one joint to build on"}, kBlank, false},
};

const About& about(Template kind) {
  return kTemplates[std::size_t(kind)];
}

bool is_left(const std::string& name) {
  return name.size() > 2 && name.compare(name.size() - 2, 2, ".L") == 0;
}

std::string right_of(std::string name) {
  if (is_left(name)) name.back() = 'R';
  return name;
}

}  // namespace

std::span<const TemplateWords> all_templates() {
  static const std::vector<TemplateWords> words = [] {
    std::vector<TemplateWords> all;
    for (const About& each : kTemplates) all.push_back(each.words);
    return all;
  }();
  return words;
}

Skeleton template_skeleton(Template kind) {
  Skeleton skeleton;
  const auto add = [&](const std::string& name, const std::string& parent, const Vec3& offset) {
    skeleton.joints.push_back({name, skeleton.find(parent), offset, -1, ""});
  };
  // A limb's joints on the left, then the same on the right.
  std::vector<Entry> limb;
  const auto finish_limb = [&] {
    for (const Entry& e : limb) add(right_of(e.name), right_of(e.parent), {-e.x, e.y, e.z});
    limb.clear();
  };
  for (const Entry& e : about(kind).entries) {
    const bool goes_on = !limb.empty() && is_left(e.parent);
    if (!goes_on) finish_limb();
    add(e.name, e.parent, {e.x, e.y, e.z});
    if (is_left(e.name)) limb.push_back(e);
  }
  finish_limb();
  // A hand has no two sides.
  if (kind == Template::hand) return skeleton;
  for (int j = 0; j < skeleton.size(); ++j) {
    const int right = skeleton.find(right_of(skeleton.joints[j].name));
    if (skeleton.joints[j].mirror >= 0) continue;  // the right one of a pair
    skeleton.joints[j].mirror = right;
    skeleton.joints[right].mirror = j;
  }
  return skeleton;
}

namespace {

Pose turned_rest(const Skeleton& skeleton, double yaw) {
  Pose pose = rest_pose(skeleton);
  pose.root_position.setZero();
  pose.rotations[0] = Quat(Eigen::AngleAxisd(yaw, Vec3::UnitY()));
  return pose;
}

Box3 box_of(const Skeleton& skeleton, const Pose& pose) {
  Box3 box;
  for (const Transform& joint : posed_joints(skeleton, pose)) box.extend(joint.translation());
  return box;
}

double shape(const Vec2& size) {
  return std::log(std::max(size.x(), 1e-3) / std::max(size.y(), 1e-3));
}

constexpr double kOfSheet = 0.8;  // what a figure takes up of a sheet that shows none

Box2 middle_of(const Frame& frame) {
  const Vec2 size(frame.width, frame.height);
  return {(0.5 - kOfSheet / 2) * size, (0.5 + kOfSheet / 2) * size};
}

}  // namespace

Pose pose_over(const Document& document, const Frame& frame, Pose pose, const Box2& figure) {
  Document alone;
  alone.camera = document.camera;
  alone.frames = {frame};
  const FrameCamera camera = frame_camera(alone, 0);
  Box2 shown;
  double depth = 0;
  const std::vector<Transform> posed = posed_joints(document.skeleton, pose);
  for (const Transform& joint : posed) {
    if (!camera.in_front(joint.translation())) return pose;
    shown.extend(camera.project(joint.translation()));
    depth += joint.translation().z() / double(posed.size());
  }
  const Vec2 by = (figure.center() - shown.center()) / camera.pixels_per_unit(depth);
  pose.root_position += Vec3(by.x(), -by.y(), 0);
  return pose;
}

Document with_skeleton_fitted(Document document, int frame, const std::optional<Box2>& figure,
                              const FitOptions& options) {
  ensure(frame >= 0 && frame < int(document.frames.size()), "a frame of the document");
  Skeleton& skeleton = document.skeleton;
  const bool known = figure && !figure->isEmpty() && figure->sizes().minCoeff() > 1;
  const Box2 place = known ? *figure : middle_of(document.frames[frame]);
  const auto size_at = [&](double yaw) -> Vec2 {
    return box_of(skeleton, turned_rest(skeleton, yaw)).sizes().head<2>();
  };
  constexpr double kLeft = -kPi / 2;  // what faces the viewer faces left
  double yaw = 0;
  const auto unlike = [&](const Vec2& size) {
    return std::abs(shape(size) - shape(place.sizes()));
  };
  if (options.may_turn && known && unlike(size_at(kLeft)) < unlike(size_at(0))) yaw = kLeft;
  const Vec2 ratio = place.sizes().cwiseQuotient(size_at(yaw).cwiseMax(1e-3));
  const double pixels = skeleton.size() == 1 ? kOfSheet / 2 * place.sizes().y()
                        : options.by_height  ? ratio.y()
                                             : ratio.minCoeff();
  if (document.camera.type == Camera::Type::orthographic) {
    document.camera.pixels_per_unit = pixels / document.frames[frame].scale;
  } else {
    const double scale = pixels * document.camera.distance / document.camera.focal_length;
    for (Joint& joint : skeleton.joints) joint.offset *= scale;
  }
  for (int f = 0; f < int(document.frames.size()); ++f) {
    Frame& each = document.frames[f];
    each.pose =
        pose_over(document, each, turned_rest(skeleton, yaw), f == frame ? place : middle_of(each));
  }
  return document;
}

Document with_template(Document document, Template kind, int frame,
                       const std::optional<Box2>& figure) {
  document = with_skeleton(std::move(document), template_skeleton(kind));
  if (document.frames.empty()) return document;
  // A person is measured by height, as the arms may hang; whatever else by what fits.
  FitOptions options;
  options.by_height = kind == Template::human;
  options.may_turn = about(kind).long_bodied;
  return with_contours_at_bones(with_skeleton_fitted(std::move(document), frame, figure, options));
}

}  // namespace artisketch
