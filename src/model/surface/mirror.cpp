#include "model/surface/mirror.h"

#include <algorithm>

#include "model/surface/agreement.h"

namespace artisketch {
namespace {

constexpr double kTolerance = 1.5;   // pixels
constexpr double kAgreement = 0.99;  // share of rays
constexpr double kLikeness = 0.8;    // the same, where one side has what the other lacks
constexpr double kLooser = 1;        // pixels about what is alike only: no creases for so little

}  // namespace

void add_mirrored_views(const Document& document, std::vector<Part>& parts) {
  const Skeleton& skeleton = document.skeleton;
  if (skeleton.joints.empty()) return;
  Transform reflection = Transform::Identity();
  reflection.linear()(0, 0) = -1;
  reflection.translation().x() = 2 * rest_positions(skeleton)[0].x();
  for (Part& part : parts) {
    const int image = skeleton.joints[part.joint].mirror;
    if (image < 0) continue;
    const auto of_image = std::find_if(parts.begin(), parts.end(),
                                       [&](const Part& other) { return other.joint == image; });
    if (of_image == parts.end()) continue;
    part.mirrors.clear();
    for (const PartView& view : of_image->views) {
      if (!view.seen()) continue;
      part.mirrors.push_back(view);
      part.mirrors.back().mirrored = true;
      part.mirrors.back().to_world = view.to_world * reflection;
    }
  }
}

Result<Carving> carving_with_mirrors(const Part& part, int cells) {
  Result<Carving> own = carving_of(part, cells);
  if (!own || part.mirrors.empty() || own->one_direction()) return own;
  Carving all = *own;
  add_views(part, part.mirrors, cells, all);
  std::vector<const Silhouette*> own_views, all_views;
  for (const Silhouette& view : all.views) {
    all_views.push_back(&view);
    if (!view.view->mirrored) own_views.push_back(&view);
  }
  const auto covered = [&](const Silhouette* view, std::vector<const Silhouette*> others) {
    others.erase(std::remove(others.begin(), others.end(), view), others.end());
    return coverage(*view, others, all.room, kTolerance);
  };
  const auto keeps = [&](const Silhouette* view) {  // what is drawn
    return covered(view, own_views) - covered(view, all_views) <= 1 - kAgreement;
  };
  bool same = true, alike = true;
  for (const Silhouette* view : all_views) {
    if (!view->view->mirrored) {
      same = same && keeps(view);
      continue;
    }
    const double share = covered(view, own_views);
    alike = alike && share >= kLikeness;
    same = same && share >= kAgreement && covered(view, all_views) >= kAgreement;
  }
  if (same) return all;
  if (!alike) return own;
  swell_mirrored(all);
  for (Silhouette& view : all.views) {
    if (!view.view->mirrored && !keeps(&view)) return own;
    view.bounds_only = view.view->mirrored;
    if (view.bounds_only) view.grown += kLooser;
  }
  return all;
}

}  // namespace artisketch
