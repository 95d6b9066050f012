#include "base/narrow_band.h"

#include <cmath>

namespace artisketch {
namespace {

// Half-width of the piece of plane that a front cell stands for: pieces must overlap where the
// surface runs diagonally through the cells.
constexpr double kPiece = 0.75;

}  // namespace

NarrowBand::NarrowBand(Grid3<float> phi, double half_width)
    : phi_(std::move(phi)), half_width_(half_width), nearest_(phi_.values.size(), -1) {
  for (std::size_t i = 0; i < phi_.values.size(); ++i) {
    float& v = phi_.values[i];
    if (std::abs(v) < half_width_)
      cells_.push_back({int(i), 0});
    else
      v = std::copysign(float(half_width_), v);
  }
  lay();
}

void NarrowBand::lay() {
  travelled_ = 0;
  find_front();
  carry_distances();
}

// Central differences, one-sided at the border.
Vec3 NarrowBand::gradient(int index, const Index3& at) const {
  const std::ptrdiff_t strides[3] = {1, phi_.stride_y(), phi_.stride_z()};
  Vec3 g;
  for (int a = 0; a < 3; ++a) {
    const std::ptrdiff_t up = at[a] + 1 < phi_.size[a] ? strides[a] : 0;
    const std::ptrdiff_t down = at[a] > 0 ? strides[a] : 0;
    const double difference = phi_.values[index + up] - phi_.values[index - down];
    g[a] = up && down ? difference / 2 : difference;
  }
  return g;
}

void NarrowBand::find_front() {
  const std::ptrdiff_t strides[3] = {1, phi_.stride_y(), phi_.stride_z()};
  front_.clear();
  for (const Cell& cell : cells_) {
    const float here = phi_.values[cell.index];
    const int nx = phi_.size.x(), ny = phi_.size.y();
    Front f{cell.index,
            {cell.index % nx, cell.index / nx % ny, cell.index / nx / ny},
            Vec3::UnitY(),
            0,
            {-1, -1, -1}};
    double least = 2;  // to the crossings on the axes
    for (int a = 0; a < 3; ++a) {
      double nearest = 2;
      for (const int side : {-1, 1}) {
        if (f.at[a] + side < 0 || f.at[a] + side >= phi_.size[a]) continue;
        const int there = int(cell.index + side * strides[a]);
        const float value = phi_.values[there];
        if ((here < 0) == (value < 0)) continue;
        const double t = std::clamp(double(here) / (double(here) - value), 1e-3, 1.0);
        if (t >= nearest) continue;
        nearest = t;
        f.across[a] = there;
      }
      least = std::min(least, nearest);
    }
    if (least > 1) continue;
    // First order: exact on planes however they lie, where φ runs as a distance does but for its
    // scale. The plane through the axes' crossings would push the front to and fro: cells of one
    // side see more of them than their neighbours across.
    const Vec3 g = gradient(f.index, f.at);
    f.distance = least;
    if (g.norm() > 1e-6) {
      f.normal = g.normalized();
      f.distance = std::min(least, std::abs(here) / g.norm());
    }
    front_.push_back(f);
  }
  // From samples to front cells: what lies across the zero set is one too.
  for (const Cell& cell : cells_) nearest_[cell.index] = -1;
  for (int f = 0; f < int(front_.size()); ++f) nearest_[front_[f].index] = f;
  for (Front& f : front_)
    for (int& across : f.across)
      if (across >= 0) across = nearest_[across];
}

void NarrowBand::carry_distances() {
  for (const Cell& cell : cells_) {
    float& v = phi_.values[cell.index];
    v = std::copysign(float(half_width_), v);
    nearest_[cell.index] = -1;
  }
  // A front cell keeps the distance that its own crossings give, and moves with itself.
  std::vector<std::pair<int, Index3>> wave;
  for (int f = 0; f < int(front_.size()); ++f) {
    const Front& front = front_[f];
    nearest_[front.index] = f;
    phi_.values[front.index] = std::copysign(float(front.distance), phi_.values[front.index]);
    wave.emplace_back(front.index, front.at);
  }
  // From there a wave runs outward: each sample hands its front cell on to its neighbours.
  const std::ptrdiff_t strides[3] = {1, phi_.stride_y(), phi_.stride_z()};
  for (std::size_t w = 0; w < wave.size(); ++w) {
    const auto [index, at] = wave[w];
    const int f = nearest_[index];
    for (int a = 0; a < 3; ++a)
      for (const int side : {-1, 1}) {
        Index3 there = at;
        there[a] += side;
        if (there[a] < 0 || there[a] >= phi_.size[a]) continue;
        const int next = int(index + side * strides[a]);
        float& v = phi_.values[next];
        int& nearest = nearest_[next];
        if (nearest == f || (nearest >= 0 && front_[nearest].index == next)) continue;
        const float distance = distance_to_piece(f, there - front_[f].at);
        if (!(distance < std::abs(v))) continue;  // nor what is no number: the wave must end
        nearest = f;
        v = std::copysign(distance, v);
        wave.emplace_back(next, there);
      }
  }
  cells_.clear();
  for (int i = 0; i < int(nearest_.size()); ++i)
    if (nearest_[i] >= 0) cells_.push_back({i, nearest_[i]});
}

// From the sample `offset` away from a front cell to the piece of plane that the cell stands for;
// beyond it, to that piece's rim.
float NarrowBand::distance_to_piece(int f, const Index3& offset) const {
  const Front& front = front_[f];
  const double side = phi_.values[front.index] < 0 ? -1 : 1;
  const Vec3 way = offset.cast<double>() + side * front.distance * front.normal;
  const double along = front.normal.dot(way), across2 = way.squaredNorm() - along * along;
  return float(std::sqrt(along * along + std::max(across2 - kPiece * kPiece, 0.0)));
}

double NarrowBand::at_surface(int f, std::span<const float> at_front) const {
  const float here = phi_.values[front_[f].index];
  double sum = 0;
  int n = 0;
  for (const int across : front_[f].across) {
    if (across < 0) continue;
    const float there = phi_.values[front_[across].index];
    // Both may have come to one side since the band was laid: then the nearer one knows best.
    const double t = (here < 0) != (there < 0)          ? here / (double(here) - there)
                     : std::abs(here) < std::abs(there) ? 0.0
                                                        : 1.0;
    sum += (1 - t) * at_front[f] + t * at_front[across];
    ++n;
  }
  return n ? sum / n : at_front[f];
}

double NarrowBand::curvature(const Front& f) const {
  if ((f.at.array() < 1).any() || (f.at.array() + 1 >= phi_.size.array()).any()) return 0;
  const float* v = &phi_.values[f.index];
  const std::ptrdiff_t s[3] = {1, phi_.stride_y(), phi_.stride_z()};
  double first[3], second[3], sum = 0;
  for (int a = 0; a < 3; ++a) {
    first[a] = (v[s[a]] - v[-s[a]]) / 2;
    second[a] = v[s[a]] - 2 * v[0] + v[-s[a]];
  }
  const double length2 = first[0] * first[0] + first[1] * first[1] + first[2] * first[2];
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3;
    const double mixed = (v[s[a] + s[b]] - v[s[a] - s[b]] - v[s[b] - s[a]] + v[-s[a] - s[b]]) / 4;
    sum += second[a] * (length2 - first[a] * first[a]) - 2 * first[a] * first[b] * mixed;
  }
  const double length = std::sqrt(std::max(length2, 1e-4));
  return std::clamp(sum / (length * length * length), -1.0, 1.0);
}

}  // namespace artisketch
