#include "model/view_choice.h"

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

// One triangle's choices, with all that is known of them.
struct Choices {
  std::vector<int> view;
  std::vector<float> cost;
};

class Chooser {
 public:
  Chooser(const Mesh& mesh, const FaceNeighbours& neighbours, const DrawnSurface& surface)
      : neighbours_(neighbours), views_(surface.views.size()), choices_(mesh.F.rows()) {
    colour_.resize(std::size_t(mesh.F.rows()) * views_, Rgb::Constant(-1));
    for (int f = 0; f < mesh.F.rows(); ++f)
      for (std::size_t v = 0; v < views_; ++v) {
        const SurfaceView& view = surface.views[v];
        if (view.quality[f] <= 0) continue;
        const float worse = std::max(1 - view.quality[f], 0.0f);
        float cost = worse * worse + (view.mirrored ? kMirrorCost : 0);
        if (const auto c = view.colour(surface.sketches, mesh.F, f, Vec3::Constant(1 / 3.0)))
          colour_[std::size_t(f) * views_ + v] = *c;
        for (std::size_t u = 0; u < v && !view.mirrored; ++u) {
          const float sees = (surface.views[u].quality[f] - kSeesBadly) / (kSeesWell - kSeesBadly);
          if (sees > 0) cost += kDoubtCost * std::min(sees, 1.0f) * step(f, int(u), int(v));
        }
        choices_[f].view.push_back(int(v));
        choices_[f].cost.push_back(cost);
      }
    // Messages ask for the same steps again and again.
    steps_.resize(choices_.size() * views_ * views_);
    for (int f = 0; f < mesh.F.rows(); ++f)
      for (std::size_t v = 0; v < views_; ++v)
        for (std::size_t w = 0; w < v; ++w)
          steps_[index(f, int(v), int(w))] = steps_[index(f, int(w), int(v))] =
              step(f, int(v), int(w));
    messages_.resize(choices_.size());
    for (std::size_t f = 0; f < choices_.size(); ++f)
      for (auto& message : messages_[f]) message.assign(choices_[f].view.size(), 0.0f);
  }

  std::vector<int> choose() {
    const int n = int(choices_.size());
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
    const Rgb& a = colour_[std::size_t(f) * views_ + v];
    const Rgb& b = colour_[std::size_t(f) * views_ + w];
    return a.x() < 0 || b.x() < 0 ? kUnknownStep : (a - b).norm();
  }
  std::size_t index(int f, int v, int w) const {
    return (std::size_t(f) * views_ + std::size_t(v)) * views_ + std::size_t(w);
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
    const Choices& own = choices_[f];
    std::vector<float>& sum = sum_;
    sum = own.cost;
    int before = 0, after = 0;
    for (int k = 0; k < 3; ++k) {
      const int g = neighbours_[f][k];
      if (g < 0) continue;
      (g < f ? before : after) += 1;
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += messages_[f][k][i];
    }
    const float share = 1.0f / float(std::max({before, after, 1}));
    for (int k = 0; k < 3; ++k) {
      const int g = neighbours_[f][k];
      if (g < 0 || (g > f) != (direction > 0)) continue;
      std::vector<float>& out = messages_[g][side_of(g, f)];
      float least = std::numeric_limits<float>::max();
      for (std::size_t j = 0; j < out.size(); ++j) {
        out[j] = own.view.empty() ? 0 : std::numeric_limits<float>::max();
        for (std::size_t i = 0; i < own.view.size(); ++i)
          out[j] = std::min(out[j], share * sum[i] - messages_[f][k][i] +
                                        seam(f, own.view[i], g, choices_[g].view[j]));
        least = std::min(least, out[j]);
      }
      for (float& m : out) m -= least;
    }
  }

  // The best choice of f, its earlier neighbours' being made.
  int decide(int f, const std::vector<int>& chosen) const {
    const Choices& own = choices_[f];
    int best = -1;
    float least = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < own.view.size(); ++i) {
      float cost = own.cost[i];
      for (int k = 0; k < 3; ++k) {
        const int g = neighbours_[f][k];
        if (g < 0) continue;
        if (g > f)
          cost += messages_[f][k][i];
        else if (chosen[g] >= 0)
          cost += seam(f, own.view[i], g, chosen[g]);
      }
      if (cost < least) {
        least = cost;
        best = own.view[i];
      }
    }
    return best;
  }

  const FaceNeighbours& neighbours_;
  std::size_t views_;
  std::vector<Choices> choices_;
  std::vector<Rgb> colour_;                                  // #F×#views; −1 where not seen
  std::vector<float> steps_;                                 // #F×#views×#views
  std::vector<std::array<std::vector<float>, 3>> messages_;  // to each face, from each side
  std::vector<float> sum_;
};

}  // namespace

FaceNeighbours face_neighbours(const Triangles& F) {
  struct Side {
    int low, high, face, corner;
  };
  std::vector<Side> sides;
  sides.reserve(std::size_t(F.size()));
  for (int f = 0; f < F.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = F(f, k), b = F(f, (k + 1) % 3);
      sides.push_back({std::min(a, b), std::max(a, b), f, k});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.face, a.corner) < std::tie(b.low, b.high, b.face, b.corner);
  });
  FaceNeighbours neighbours(F.rows(), {-1, -1, -1});
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side &a = sides[i], &b = sides[i + 1];
    if (a.low != b.low || a.high != b.high || a.face == b.face) continue;
    neighbours[a.face][a.corner] = b.face;
    neighbours[b.face][b.corner] = a.face;
    ++i;
  }
  return neighbours;
}

std::vector<int> choose_views(const Mesh& mesh, const FaceNeighbours& neighbours,
                              const DrawnSurface& surface) {
  return Chooser(mesh, neighbours, surface).choose();
}

}  // namespace artisketch
