#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "figures/solid.h"

namespace artisketch::figures {
namespace {

constexpr int kBlock = 8;

// Each cube falls into six tetrahedra around its main diagonal, so that neighbouring cubes share
// the diagonals of their faces. Corners are numbered x + 2 y + 4 z.
constexpr int kTetrahedra[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                   {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};

class Polygoniser {
 public:
  Polygoniser(const std::function<double(const Vec3&)>& distance, const Box3& box, double cell)
      : distance_(distance), cell_(cell) {
    for (int a = 0; a < 3; ++a)
      size_[a] = (int(std::ceil(box.sizes()[a] / cell)) / kBlock + 1) * kBlock + kBlock + 1;
    origin_ = box.center() - cell / 2 * (size_ - Index3::Ones()).cast<double>();
    values_.assign(std::size_t(size_[0]) * size_[1] * size_[2],
                   std::numeric_limits<float>::quiet_NaN());
  }

  Mesh mesh() {
    // The distance changes by at most twice the way, so blocks far from the surface have one sign.
    const double reach = 2 * cell_ * kBlock * std::sqrt(0.75);
    for (int z = 0; z + 1 < size_[2]; z += kBlock)
      for (int y = 0; y + 1 < size_[1]; y += kBlock)
        for (int x = 0; x + 1 < size_[0]; x += kBlock)
          if (std::abs(distance_(at(Index3(x, y, z)) + Vec3::Constant(cell_ * kBlock / 2.0))) <=
              reach)
            for (int k = 0; k < kBlock; ++k)
              for (int j = 0; j < kBlock; ++j)
                for (int i = 0; i < kBlock; ++i) cube(Index3(x + i, y + j, z + k));
    Mesh mesh;
    mesh.V.resize(points_.size(), 3);
    for (std::size_t i = 0; i < points_.size(); ++i) mesh.V.row(i) = points_[i].transpose();
    mesh.F.resize(triangles_.size(), 3);
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      mesh.F.row(i) = Eigen::RowVector3i(triangles_[i][0], triangles_[i][1], triangles_[i][2]);
    return mesh;
  }

 private:
  std::size_t index(const Index3& s) const {
    return s[0] + std::size_t(size_[0]) * (s[1] + std::size_t(size_[1]) * s[2]);
  }
  Vec3 at(const Index3& s) const { return origin_ + cell_ * s.cast<double>(); }
  double value(const Index3& s) {
    float& v = values_[index(s)];
    if (std::isnan(v)) {
      v = float(distance_(at(s)));
      // A sample on the surface would give triangles without area.
      if (std::abs(v) < 1e-4f * float(cell_)) v = 1e-4f * float(cell_);
    }
    return v;
  }

  void cube(const Index3& base) {
    Index3 corner[8];
    double f[8];
    int in = 0;
    for (int c = 0; c < 8; ++c) {
      corner[c] = base + Index3(c & 1, c >> 1 & 1, c >> 2);
      f[c] = value(corner[c]);
      in += f[c] < 0;
    }
    if (in == 0 || in == 8) return;
    for (const auto& t : kTetrahedra) tetrahedron(corner, f, t);
  }

  void tetrahedron(const Index3* corner, const double* f, const int (&t)[4]) {
    // Inside corners first, by an even permutation so that the orientation stays.
    std::array<int, 4> c{t[0], t[1], t[2], t[3]};
    int in = 0;
    bool odd = false;
    for (int i = 0; i < 4; ++i)
      if (f[c[i]] < 0) {
        if (i != in) {
          std::swap(c[i], c[in]);
          odd = !odd;
        }
        ++in;
      }
    const auto v = [&](int i, int j) {
      return vertex(corner[c[i]], f[c[i]], corner[c[j]], f[c[j]]);
    };
    if (in == 1) {
      add(v(0, 1), v(0, 2), v(0, 3), odd);
    } else if (in == 3) {
      add(v(0, 3), v(1, 3), v(2, 3), odd);
    } else if (in == 2) {
      const int a = v(0, 2), b = v(0, 3), d = v(1, 3), e = v(1, 2);
      add(a, b, d, odd);
      add(a, d, e, odd);
    }
  }

  void add(int a, int b, int c, bool flip) {
    triangles_.push_back(flip ? std::array<int, 3>{a, c, b} : std::array<int, 3>{a, b, c});
  }

  int vertex(const Index3& a, double fa, const Index3& b, double fb) {
    const std::uint64_t low = std::min(index(a), index(b)), high = std::max(index(a), index(b));
    const auto [found, fresh] =
        vertices_.try_emplace(low << 32 | (high - low), int(points_.size()));
    if (fresh) points_.push_back(at(a) + fa / (fa - fb) * (at(b) - at(a)));
    return found->second;
  }

  const std::function<double(const Vec3&)>& distance_;
  double cell_;
  Index3 size_;
  Vec3 origin_;
  std::vector<float> values_;
  std::vector<Vec3> points_;
  std::vector<std::array<int, 3>> triangles_;
  std::unordered_map<std::uint64_t, int> vertices_;
};

}  // namespace

Mesh polygonise(const std::function<double(const Vec3&)>& distance, const Box3& box, double cell) {
  return Polygoniser(distance, box, cell).mesh();
}

}  // namespace artisketch::figures
