// The samples beside the zero set find their nearest point on a plane through its nearest crossing
// with the grid's lines. From there the nearest points are handed on, neighbour to neighbour,
// outward (Danielsson 1980, "Euclidean distance mapping").
#include "base/redistance.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace artisketch {
namespace {

using Vec3f = Eigen::Vector3f;

// What is asked of a sample most often, side by side.
struct Known {
  std::int32_t node = -1;  // its own; −1: none
  float distance2 = std::numeric_limits<float>::infinity();
};

struct Node {
  std::uint32_t sample;
  int at[3];
  Vec3f nearest;       // point of the zero set, in cells
  std::uint32_t seed;  // the node beside the zero set that this point came from
};

class Redistance {
 public:
  explicit Redistance(Grid3<float>& field)
      : g_(field), known_(field.values.size()), strides_{1, g_.stride_y(), g_.stride_z()} {}

  void run(double band) {
    find_crossings();
    nodes_.reserve(nodes_.size() * std::size_t(2 + 2 * band));
    for (Node& node : nodes_) on_plane(node);
    hand_on(float((band + 0.5) * (band + 0.5)));  // what lies aside may lie nearer
    for (float& v : g_.values) v = std::copysign(float(band * g_.cell), v);
    for (const Node& node : nodes_) {
      float& v = g_.values[node.sample];
      v = std::copysign(float(std::min(distance(node), band) * g_.cell), v);
    }
  }

 private:
  // A node's `nearest` first holds the signed way to its nearest crossing along each axis.
  void note(std::uint32_t sample, int i, int j, int k, int axis, float way) {
    std::int32_t& node = known_[sample].node;
    if (node < 0) {
      node = std::int32_t(nodes_.size());
      nodes_.push_back({sample, {i, j, k}, Vec3f::Constant(kNone), std::uint32_t(nodes_.size())});
    }
    float& least = nodes_[node].nearest[axis];
    if (std::abs(way) < std::abs(least)) least = way;
  }

  void find_crossings() {
    const auto inside = [](float v) { return std::signbit(v); };
    // Whether any of some pairs of neighbours lies on two sides.
    const auto any_crosses = [](const float* here, const float* there, int n) {
      bool crosses = false;
      for (int i = 0; i < n; ++i) crosses |= std::signbit(here[i]) != std::signbit(there[i]);
      return crosses;
    };
    constexpr int kAtOnce = 16;
    std::size_t row = 0;
    for (int k = 0; k < g_.size.z(); ++k)
      for (int j = 0; j < g_.size.y(); ++j, row += g_.size.x())
        for (int axis = 0; axis < 3; ++axis) {
          if ((axis == 1 && j + 1 == g_.size.y()) || (axis == 2 && k + 1 == g_.size.z())) continue;
          const float *here = &g_.values[row], *there = here + strides_[axis];
          const int n = g_.size.x() - (axis == 0);
          for (int from = 0; from < n; from += kAtOnce) {
            const int end = std::min(from + kAtOnce, n);
            if (!any_crosses(here + from, there + from, end - from)) continue;
            for (int i = from; i < end; ++i) {
              if (inside(here[i]) == inside(there[i])) continue;
              const float span = here[i] - there[i];
              const float t = span != 0 ? here[i] / span : 0.5f;
              note(std::uint32_t(row + i), i, j, k, axis, t);
              note(std::uint32_t(row + i + strides_[axis]), i + (axis == 0), j + (axis == 1),
                   k + (axis == 2), axis, t - 1);
            }
          }
        }
  }

  // The plane through the nearest crossing, upright on the field's gradient toward the crossings:
  // in the middle of a thin plate its two sides differ.
  void on_plane(Node& node) {
    int axis = 0;
    for (int a = 1; a < 3; ++a)
      if (std::abs(node.nearest[a]) < std::abs(node.nearest[axis])) axis = a;
    const float* v = &g_.values[node.sample];
    Vec3f normal;
    for (int a = 0; a < 3; ++a) {
      const bool crossed = node.nearest[a] != kNone;
      const bool up = node.at[a] + 1 < g_.size[a] && !(crossed && node.nearest[a] < 0);
      const bool down = node.at[a] > 0 && !(crossed && node.nearest[a] >= 0);
      normal[a] = (up ? v[strides_[a]] : *v) - (down ? v[-strides_[a]] : *v);
      if (up && down) normal[a] /= 2;
    }
    const float way = node.nearest[axis], length = normal.norm();
    normal = length > 0 ? Vec3f(normal / length) : Vec3f(Vec3f::Unit(axis));
    normals_.push_back(normal);
    const Vec3f to = way * normal[axis] * normal;
    node.nearest = Vec3f(float(node.at[0]), float(node.at[1]), float(node.at[2])) + to;
    known_[node.sample].distance2 = to.squaredNorm();
  }

  // Layer by layer; a layer's samples may still learn of nearer points from its own.
  void hand_on(float most) {
    for (std::size_t from = 0; from < nodes_.size(); ++from) {
      const Node node = nodes_[from];  // a copy: nodes_ grows
      const float from2 = known_[node.sample].distance2;
      for (int axis = 0; axis < 3; ++axis) {
        const float off = node.nearest[axis] - float(node.at[axis]);
        for (const int way : {-1, 1}) {
          if (float(way) * off > 0.5f) continue;  // back towards the point
          const float distance2 = std::max(0.f, from2 + 1 - 2 * float(way) * off);
          if (distance2 > most) continue;
          const int to = node.at[axis] + way;
          if (to < 0 || to >= g_.size[axis]) continue;
          const std::size_t sample = node.sample + way * strides_[axis];
          Known& known = known_[sample];
          if (distance2 >= known.distance2) continue;
          known.distance2 = distance2;
          if (known.node < 0) {
            known.node = std::int32_t(nodes_.size());
            nodes_.push_back(node);
            nodes_.back().sample = std::uint32_t(sample);
            nodes_.back().at[axis] = to;
          } else {
            nodes_[known.node].nearest = node.nearest;
            nodes_[known.node].seed = node.seed;
          }
        }
      }
    }
  }

  // A sample hardly aside of its point lies over the plane there, not over the point itself.
  double distance(const Node& node) const {
    constexpr float kAside = 0.75f;  // cells
    const Vec3f off = Vec3f(float(node.at[0]), float(node.at[1]), float(node.at[2])) - node.nearest;
    const float up = off.dot(normals_[node.seed]);
    const float aside = std::sqrt(std::max(0.f, off.squaredNorm() - up * up));
    const float far = std::max(0.f, aside - kAside);
    return std::sqrt(up * up + far * far);
  }

  static constexpr float kNone = std::numeric_limits<float>::infinity();
  Grid3<float>& g_;
  std::vector<Known> known_;  // of each sample
  std::ptrdiff_t strides_[3];
  std::vector<Node> nodes_;
  std::vector<Vec3f> normals_;  // of the seeds, which come first
};

}  // namespace

void redistance(double band, Grid3<float>& field) {
  Redistance(field).run(band);
}

}  // namespace artisketch
