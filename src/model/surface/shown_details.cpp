#include "model/surface/shown_details.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace artisketch {
namespace {

// A view's picture in coarse squares: which of them show a field's inside.
class Shown {
 public:
  Shown(const PartView& view, const Vec3& centre, double cell) : view_(&view) {
    constexpr double kSquare = 1.5;  // cells: no sample's neighbours leave one out
    constexpr int kMost = 2000;
    const Box2& box = view.outline.box();
    square_ = std::max(kSquare * cell * view.pixels_per_unit(centre),
                       box.sizes().maxCoeff() / double(kMost));
    corner_ = box.min();
    across_ = int(box.sizes().x() / square_) + 1;
    down_ = int(box.sizes().y() / square_) + 1;
    before_.assign(std::size_t(across_) * down_, 0);
    after_ = before_;
  }
  void add(const Vec3& p, bool after) {
    if (const int at = square_of(p); at >= 0) {
      before_[at] = 1;
      after_[at] |= std::uint8_t(after);
    }
  }
  // How much each square is of what was shown before and isn't after: 1 there and beside it, less
  // round about. False where nothing is lost.
  bool find_lost() {
    constexpr int kFade = 4;  // squares
    lost_.assign(before_.size(), 0.0f);
    bool any = false;
    for (int y = 0; y < down_; ++y)
      for (int x = 0; x < across_; ++x)
        if (before_[y * across_ + x] && !after_near(x, y)) lost_[y * across_ + x] = 1, any = true;
    for (int round = 0; any && round <= kFade; ++round) {
      const std::vector<float> now = lost_;
      const float step = round == 0 ? 0 : 1.0f / kFade;
      each_beside(
          [&](int here, int there) { lost_[here] = std::max(lost_[here], now[there] - step); });
    }
    return any;
  }
  float lost(const Vec3& p) const {
    const int at = square_of(p);
    return at < 0 ? 0 : lost_[at];
  }

 private:
  int square_of(const Vec3& p) const {
    if (!view_->camera.in_front(view_->to_world * p)) return -1;
    const Vec2 at = (view_->project(p) - corner_) / square_;
    if (!(at.minCoeff() >= 0 && at.x() < across_ && at.y() < down_)) return -1;
    return int(at.y()) * across_ + int(at.x());
  }
  bool after_near(int x, int y) const {
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, down_ - 1); ++v)
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, across_ - 1); ++u)
        if (after_[v * across_ + u]) return true;
    return false;
  }
  template <class Visit>
  void each_beside(const Visit& visit) const {
    for (int y = 0; y < down_; ++y)
      for (int x = 0; x < across_; ++x)
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, down_ - 1); ++v)
          for (int u = std::max(x - 1, 0); u <= std::min(x + 1, across_ - 1); ++u)
            visit(y * across_ + x, v * across_ + u);
  }

  const PartView* view_;
  double square_ = 1;  // pixels
  Vec2 corner_ = Vec2::Zero();
  int across_ = 0, down_ = 0;
  std::vector<std::uint8_t> before_, after_;
  std::vector<float> lost_;
};

// Marks the inside samples that hang together with the deepest one: the surface's largest piece,
// which alone is kept.
std::vector<std::uint8_t> body_of(const Grid3<float>& field) {
  const auto& values = field.values;
  std::vector<std::uint8_t> marked(values.size());
  std::vector<std::size_t> open{
      std::size_t(std::min_element(values.begin(), values.end()) - values.begin())};
  marked[open[0]] = 1;
  const std::size_t strides[3] = {1, std::size_t(field.size.x()),
                                  std::size_t(field.size.x()) * field.size.y()};
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    const auto visit = [&](std::size_t there) {
      if (marked[there] || !(values[there] < 0)) return;
      marked[there] = 1;
      open.push_back(there);
    };
    for (int axis = 0; axis < 3; ++axis) {
      const int i = int(at / strides[axis] % std::size_t(field.size[axis]));
      if (i > 0) visit(at - strides[axis]);
      if (i + 1 < field.size[axis]) visit(at + strides[axis]);
    }
  }
  return marked;
}

}  // namespace

void keep_what_is_shown(const Carving& carving, double agreed, const Grid3<float>& surface,
                        Grid3<float>& guess) {
  const auto each_inside = [&](const auto& visit) {
    std::size_t at = 0;
    for (int k = 0; k < surface.size.z(); ++k)
      for (int j = 0; j < surface.size.y(); ++j)
        for (int i = 0; i < surface.size.x(); ++i, ++at)
          if (surface.values[at] < 0) visit(at, surface.position(i, j, k));
  };
  std::vector<Shown> pictures;
  for (const Silhouette& silhouette : carving.views)
    if (!silhouette.view->mirrored)
      pictures.emplace_back(*silhouette.view, carving.centre, surface.cell);
  const std::vector<std::uint8_t> body = body_of(guess);
  each_inside([&](std::size_t at, const Vec3& p) {
    for (Shown& picture : pictures) picture.add(p, body[at]);
  });
  std::erase_if(pictures, [](Shown& picture) { return !picture.find_lost(); });
  if (pictures.empty()) return;
  each_inside([&](std::size_t at, const Vec3& p) {
    float lost = 0;
    for (const Shown& picture : pictures) lost = std::max(lost, picture.lost(p));
    const float by = surface.values[at] - guess.values[at];
    if (by < 0) guess.values[at] += float(agreed) * lost * by;
  });
}

}  // namespace artisketch
