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

struct Node {
  std::uint32_t sample;
  int at[3];
  Vec3f nearest;  // point of the zero set, in cells
  float distance2;
  std::uint32_t seed;  // the node beside the zero set that this point came from
};

class Redistance {
 public:
  explicit Redistance(Grid3<float>& field)
      : g_(field), node_of_(field.values.size(), -1), strides_{1, g_.stride_y(), g_.stride_z()} {}

  void run(double band) {
    find_crossings();
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
    if (node_of_[sample] < 0) {
      node_of_[sample] = std::int32_t(nodes_.size());
      nodes_.push_back(
          {sample, {i, j, k}, Vec3f::Constant(kNone), 0, std::uint32_t(nodes_.size())});
    }
    float& least = nodes_[node_of_[sample]].nearest[axis];
    if (std::abs(way) < std::abs(least)) least = way;
  }

  void find_crossings() {
    const auto inside = [](float v) { return std::signbit(v); };
    std::size_t row = 0;
    for (int k = 0; k < g_.size.z(); ++k)
      for (int j = 0; j < g_.size.y(); ++j, row += g_.size.x())
        for (int axis = 0; axis < 3; ++axis) {
          if ((axis == 1 && j + 1 == g_.size.y()) || (axis == 2 && k + 1 == g_.size.z())) continue;
          const float *here = &g_.values[row], *there = here + strides_[axis];
          const int n = g_.size.x() - (axis == 0);
          for (int i = 0; i < n; ++i) {
            if (inside(here[i]) == inside(there[i])) continue;
            const float span = here[i] - there[i];
            const float t = span != 0 ? here[i] / span : 0.5f;
            note(std::uint32_t(row + i), i, j, k, axis, t);
            note(std::uint32_t(row + i + strides_[axis]), i + (axis == 0), j + (axis == 1),
                 k + (axis == 2), axis, t - 1);
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
    node.distance2 = to.squaredNorm();
  }

  // Layer by layer; a layer's samples may still learn of nearer points from its own.
  void hand_on(float most) {
    for (std::size_t from = 0; from < nodes_.size(); ++from) {
      const Node node = nodes_[from];  // a copy: nodes_ grows
      for (int axis = 0; axis < 3; ++axis) {
        const float off = node.nearest[axis] - float(node.at[axis]);
        for (const int way : {-1, 1}) {
          const float distance2 = std::max(0.f, node.distance2 + 1 - 2 * float(way) * off);
          if (distance2 > most) continue;
          const int to = node.at[axis] + way;
          if (to < 0 || to >= g_.size[axis]) continue;
          const std::size_t sample = node.sample + way * strides_[axis];
          std::int32_t& known = node_of_[sample];
          if (known < 0) {
            known = std::int32_t(nodes_.size());
            nodes_.push_back(node);
            Node& next = nodes_.back();
            next.sample = std::uint32_t(sample);
            next.at[axis] = to;
            next.distance2 = distance2;
          } else if (distance2 < nodes_[known].distance2) {
            nodes_[known].nearest = node.nearest;
            nodes_[known].distance2 = distance2;
            nodes_[known].seed = node.seed;
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
    return std::hypot(up, std::max(0.f, aside - kAside));
  }

  static constexpr float kNone = std::numeric_limits<float>::infinity();
  Grid3<float>& g_;
  std::vector<std::int32_t> node_of_;  // of each sample; −1: none
  std::ptrdiff_t strides_[3];
  std::vector<Node> nodes_;
  std::vector<Vec3f> normals_;  // of the seeds, which come first
};

}  // namespace

void redistance(double band, Grid3<float>& field) {
  Redistance(field).run(band);
}

}  // namespace artisketch
