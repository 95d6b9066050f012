#include "model/texture/view_choice.h"

#include <algorithm>
#include <limits>

namespace artisketch {
namespace {

constexpr int kRounds = 8;
// In shares of what the best possible view of a triangle is worth.
constexpr float kMirrorCost = 1.5f;   // of a mirror image in place of a drawing
constexpr float kSeamCost = 0.35f;    // of a change between neighbours
constexpr float kStepCost = 4;        // of the change's step in colour, times its size (0 … √3)
constexpr float kUnknownStep = 0.3f;  // where one of the views can't be seen
// Where two drawings disagree, an eye here and a cheek there, the earlier one is right, as in
// calibration, as far as it sees the place well; else the eye would be painted twice.
constexpr float kDoubtCost = 4;  // times the difference in colour
constexpr float kSeesBadly = 0.3f, kSeesWell = 0.6f;

class Chooser {
 public:
  Chooser(const Mesh& mesh, const FaceNeighbours& neighbours, const DrawnSurface& surface)
      : neighbours_(neighbours),
        views_(surface.views.size()),
        count_(mesh.F.rows(), 0),
        view_(count_.size() * views_),
        cost_(view_.size()),
        colour_(view_.size(), Rgb::Constant(-1)),
        steps_(view_.size() * views_),
        messages_(3 * view_.size(), 0.0f),
        sum_(views_) {
    for (int f = 0; f < mesh.F.rows(); ++f)
      for (std::size_t v = 0; v < views_; ++v) {
        const SurfaceView& view = surface.views[v];
        if (view.quality[f] <= 0) continue;
        const float worse = std::max(1 - view.quality[f], 0.0f);
        float cost = worse * worse + (view.mirrored ? kMirrorCost : 0);
        if (const auto c = view.colour(surface.sketches, mesh.F, f, Vec3::Constant(1 / 3.0)))
          colour_[place(f, int(v))] = *c;
        for (std::size_t u = 0; u < v && !view.mirrored; ++u) {
          const float sees = (surface.views[u].quality[f] - kSeesBadly) / (kSeesWell - kSeesBadly);
          if (sees > 0) cost += kDoubtCost * std::min(sees, 1.0f) * step(f, int(u), int(v));
        }
        view_[place(f, count_[f])] = int(v);
        cost_[place(f, count_[f])] = cost;
        ++count_[f];
      }
    // Messages ask for the same steps again and again.
    for (int f = 0; f < mesh.F.rows(); ++f)
      for (int v = 0; v < int(views_); ++v)
        for (int w = 0; w < v; ++w) steps_[index(f, v, w)] = steps_[index(f, w, v)] = step(f, v, w);
  }

  std::vector<int> choose() {
    const int n = int(count_.size());
    if (views_ == 0) return std::vector<int>(n, -1);
    for (int round = 0; round < kRounds; ++round) {
      for (int f = 0; f < n; ++f) pass(f, 1);
      for (int f = n - 1; f >= 0; --f) pass(f, -1);
    }
    std::vector<int> chosen(n, -1);
    for (int f = 0; f < n; ++f) chosen[f] = decide(f, chosen);
    return chosen;
  }

 private:
  // The step in colour on face f from view v to view w.
  float step(int f, int v, int w) const {
    const Rgb &a = colour_[place(f, v)], &b = colour_[place(f, w)];
    return a.x() < 0 || b.x() < 0 ? kUnknownStep : (a - b).norm();
  }
  std::size_t place(int f, int i) const { return std::size_t(f) * views_ + std::size_t(i); }
  std::size_t index(int f, int v, int w) const { return place(f, v) * views_ + std::size_t(w); }
  float* message(int f, int side) { return &messages_[(3 * std::size_t(f) + side) * views_]; }
  const float* message(int f, int side) const {
    return &messages_[(3 * std::size_t(f) + side) * views_];
  }
  float seam(int f, int v, int g, int w) const {
    if (v == w) return 0;
    return kSeamCost + kStepCost * (steps_[index(f, v, w)] + steps_[index(g, v, w)]) / 2;
  }
  int side_of(int f, int g) const {
    int k = 0;
    while (neighbours_[f][k] != g) ++k;
    return k;
  }

  // Messages of f to its neighbours that come after (direction 1) or before it (−1).
  void pass(int f, int direction) {
    const int choices = count_[f];
    std::copy_n(&cost_[place(f, 0)], choices, sum_.begin());
    int before = 0, after = 0;
    for (int k = 0; k < 3; ++k) {
      const int g = neighbours_[f][k];
      if (g < 0) continue;
      (g < f ? before : after) += 1;
      for (int i = 0; i < choices; ++i) sum_[i] += message(f, k)[i];
    }
    const float share = 1.0f / float(std::max({before, after, 1}));
    for (int k = 0; k < 3; ++k) {
      const int g = neighbours_[f][k];
      if (g < 0 || (g > f) != (direction > 0)) continue;
      float* out = message(g, side_of(g, f));
      float least = std::numeric_limits<float>::max();
      for (int j = 0; j < count_[g]; ++j) {
        out[j] = choices == 0 ? 0 : std::numeric_limits<float>::max();
        for (int i = 0; i < choices; ++i)
          out[j] = std::min(out[j], share * sum_[i] - message(f, k)[i] +
                                        seam(f, view_[place(f, i)], g, view_[place(g, j)]));
        least = std::min(least, out[j]);
      }
      for (int j = 0; j < count_[g]; ++j) out[j] -= least;
    }
  }

  // The best choice of f, its earlier neighbours' being made.
  int decide(int f, const std::vector<int>& chosen) const {
    int best = -1;
    float least = std::numeric_limits<float>::max();
    for (int i = 0; i < count_[f]; ++i) {
      const int view = view_[place(f, i)];
      float cost = cost_[place(f, i)];
      for (int k = 0; k < 3; ++k) {
        const int g = neighbours_[f][k];
        if (g < 0) continue;
        if (g > f)
          cost += message(f, k)[i];
        else if (chosen[g] >= 0)
          cost += seam(f, view, g, chosen[g]);
      }
      if (cost < least) {
        least = cost;
        best = view;
      }
    }
    return best;
  }

  const FaceNeighbours& neighbours_;
  std::size_t views_;
  std::vector<int> count_;       // #F: how many views a face can choose from,
  std::vector<int> view_;        // #F×#views: which,
  std::vector<float> cost_;      // #F×#views: and what each costs
  std::vector<Rgb> colour_;      // #F×#views; −1 where not seen
  std::vector<float> steps_;     // #F×#views×#views
  std::vector<float> messages_;  // #F×3×#views: to each face's choices, from each side
  std::vector<float> sum_;
};

}  // namespace

std::vector<int> choose_views(const Mesh& mesh, const FaceNeighbours& neighbours,
                              const DrawnSurface& surface) {
  return Chooser(mesh, neighbours, surface).choose();
}

}  // namespace artisketch
