#include "model/surface/hermite_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <Eigen/Dense>

#include "base/ensure.h"

namespace artisketch {
namespace {

using Matrix = Eigen::MatrixXd;

// f is smooth at a grid's scale: sampled at every fourth grid point and interpolated by cubics
// (Catmull–Rom) in between.
constexpr int kCoarse = 4;

// Weights of four neighbours for the fractions 0, 1/4, 1/2, 3/4.
struct CubicWeights {
  float w[kCoarse][4];
  CubicWeights() {
    for (int i = 0; i < kCoarse; ++i) {
      const float t = float(i) / kCoarse;
      w[i][0] = 0.5f * (-t + 2 * t * t - t * t * t);
      w[i][1] = 0.5f * (2 - 5 * t * t + 3 * t * t * t);
      w[i][2] = 0.5f * (t + 4 * t * t - 3 * t * t * t);
      w[i][3] = 0.5f * (-t * t + t * t * t);
    }
  }
};

// The 4³ fine values of one coarse cell from the 4³ coarse ones around it, x fastest in both.
void interpolate(const CubicWeights& cubic, const float* coarse, float* fine) {
  float in_z[kCoarse][16], in_y[kCoarse][kCoarse][4];
  for (int k = 0; k < kCoarse; ++k)
    for (int i = 0; i < 16; ++i) {
      const float* w = cubic.w[k];
      in_z[k][i] =
          w[0] * coarse[i] + w[1] * coarse[16 + i] + w[2] * coarse[32 + i] + w[3] * coarse[48 + i];
    }
  for (int k = 0; k < kCoarse; ++k)
    for (int j = 0; j < kCoarse; ++j)
      for (int i = 0; i < 4; ++i) {
        const float *w = cubic.w[j], *v = in_z[k];
        in_y[k][j][i] = w[0] * v[i] + w[1] * v[4 + i] + w[2] * v[8 + i] + w[3] * v[12 + i];
      }
  for (int k = 0; k < kCoarse; ++k)
    for (int j = 0; j < kCoarse; ++j)
      for (int i = 0; i < kCoarse; ++i) {
        const float *w = cubic.w[i], *v = in_y[k][j];
        *fine++ = w[0] * v[0] + w[1] * v[1] + w[2] * v[2] + w[3] * v[3];
      }
}

// K = Qᵀ K Q for symmetric K, of which the lower half is read and written. Q = I − V T Vᵀ as a
// product of few reflections (Schreiber and Van Loan 1989), so that
// Qᵀ K Q = K − V Zᵀ − Z Vᵀ with W = K V T and Z = W − V (Tᵀ Vᵀ W) / 2: one pass over K.
void project(const Eigen::HouseholderQR<Matrix>& qr, Matrix& K) {
  const Eigen::Index rank = qr.hCoeffs().size();
  const Matrix V = qr.matrixQR().leftCols(rank).triangularView<Eigen::UnitLower>();
  Matrix T = Matrix::Zero(rank, rank);
  for (Eigen::Index i = 0; i < rank; ++i) {
    T(i, i) = qr.hCoeffs()[i];
    T.col(i).head(i) = -T(i, i) * (T.topLeftCorner(i, i) * (V.leftCols(i).transpose() * V.col(i)));
  }
  const Matrix KV = K.selfadjointView<Eigen::Lower>() * V;
  const Matrix W = KV * T;
  const Matrix Z = W - V * (T.transpose() * (V.transpose() * W)) / 2;
  Matrix left(V.rows(), 2 * rank), right(V.rows(), 2 * rank);
  left << V, Z;
  right << Z, V;
  K.triangularView<Eigen::Lower>() -= left * right.transpose();
}

}  // namespace

HermiteSurface::HermiteSurface(std::span<const SurfacePoint> points, const HermiteOptions& options,
                               std::span<const Vec3> loose) {
  const int sloped = int(points.size()), n = sloped + int(loose.size());
  ensure(sloped >= kFewestSurfacePoints, "points enough for a surface");
  Box3 box;
  for (const SurfacePoint& point : points) box.extend(point.position);
  centre_ = box.center();
  const double extent = std::max(box.diagonal().norm() / 2, 1e-9);
  scale_ = std::clamp(options.length, extent / 8, extent);
  std::vector<Vec3> c;
  for (const SurfacePoint& point : points) c.push_back((point.position - centre_) / scale_);
  for (const Vec3& p : loose) c.push_back((p - centre_) / scale_);

  // Rows and columns: the n values, then the slopes of the points that have any, along the normal
  // and the sight. K is symmetric: its lower half alone is filled and read.
  const int size = n + 2 * sloped;
  Matrix K(size, size), P = Matrix::Zero(size, 4);
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(size);
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < sloped; ++i) {
      const Vec3 d = c[i] - c[j];
      const double r = d.norm(), per_r = r > 0 ? 1 / r : 0;
      const Vec3 way_i[2] = {points[i].normal, points[i].sight};
      for (int u = 0; u < 2; ++u) K(n + 2 * i + u, j) = 3 * r * d.dot(way_i[u]);
      if (i < j) continue;
      const Vec3 way_j[2] = {points[j].normal, points[j].sight};
      for (int v = 0; v < 2; ++v) {
        const double along_j = d.dot(way_j[v]);
        for (int u = 0; u < 2; ++u)
          K(n + 2 * i + u, n + 2 * j + v) =
              -3 * (r * way_i[u].dot(way_j[v]) + per_r * d.dot(way_i[u]) * along_j);
      }
    }
    for (int i = j; i < n; ++i) {
      const double r = (c[i] - c[j]).norm();
      K(i, j) = r * r * r;
    }
    const double weight = j < sloped ? points[j].weight : options.loose_weight;
    K(j, j) += options.value_ridge / weight;
    P(j, 0) = 1;
    P.block<1, 3>(j, 1) = c[j].transpose();
    if (j >= sloped) continue;
    const Vec3 way_j[2] = {points[j].normal, points[j].sight};
    for (int v = 0; v < 2; ++v) {
      K(n + 2 * j + v, n + 2 * j + v) += options.slope_ridge / weight;
      P.block<1, 3>(n + 2 * j + v, 1) = way_j[v].transpose();
    }
    rhs[n + 2 * j] = 1;
  }

  // K is positive definite for what no linear function sees: Cholesky in that subspace.
  const Eigen::HouseholderQR<Matrix> qr(P);
  const int m = size - 4;
  project(qr, K);
  const Eigen::VectorXd q_rhs = qr.householderQ().adjoint() * rhs;
  Eigen::Ref<Matrix> inner = K.bottomRightCorner(m, m);
  const Eigen::LLT<Eigen::Ref<Matrix>> llt(inner);  // in place
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(size);
  solution.tail(m) = llt.solve(q_rhs.tail(m));
  linear_ = qr.matrixQR().topLeftCorner<4, 4>().triangularView<Eigen::Upper>().solve(
                q_rhs.head<4>() - K.bottomLeftCorner(m, 4).transpose() * solution.tail(m)) *
            scale_;
  solution = qr.householderQ() * solution;

  terms_.setZero(7, n);
  for (int i = 0; i < n; ++i) {
    terms_.col(i).head<3>() = c[i].cast<float>();
    terms_(3, i) = float(solution[i] * scale_);
    if (i >= sloped) continue;
    const Vec3 b =
        solution[n + 2 * i] * points[i].normal + solution[n + 2 * i + 1] * points[i].sight;
    terms_.col(i).tail<3>() = (3 * scale_ * b).cast<float>();
  }
}

float HermiteSurface::value(const Vec3& p) const {
  float v;
  values(p, Vec3::Zero(), 1, &v);
  return v;
}

void HermiteSurface::values(const Vec3& start, const Vec3& step, int n, float* values) const {
  constexpr int kLanes = 8;
  for (int from = 0; from < n; from += kLanes) {
    float x[kLanes], y[kLanes], z[kLanes], sum[kLanes];
    for (int l = 0; l < kLanes; ++l) {
      const Vec3 p = (start + (from + l) * step - centre_) / scale_;
      sum[l] = float(linear_[0] + linear_.tail<3>().dot(p));
      x[l] = float(p.x());
      y[l] = float(p.y());
      z[l] = float(p.z());
    }
    for (int i = 0; i < int(terms_.cols()); ++i) {
      const float* t = &terms_(0, i);
      for (int l = 0; l < kLanes; ++l) {
        const float dx = x[l] - t[0], dy = y[l] - t[1], dz = z[l] - t[2];
        const float r2 = dx * dx + dy * dy + dz * dz;
        sum[l] += std::sqrt(r2) * (t[3] * r2 - (t[4] * dx + t[5] * dy + t[6] * dz));
      }
    }
    for (int l = 0; l < std::min(kLanes, n - from); ++l) values[from + l] = sum[l];
  }
}

void raise(const Rows& f, double above, Grid3<float>& field) {
  // Coarse cell (i, j, k) holds the fine samples 4 · (i, j, k) + 0 … 3; its corner is coarse sample
  // (i + 1, j + 1, k + 1), one more all round.
  const Index3 cells = (field.size.array() + kCoarse - 1) / kCoarse;
  Grid3<float> coarse(field.origin - Vec3::Constant(kCoarse * field.cell), kCoarse * field.cell,
                      cells.array() + 3);
  std::vector<std::uint8_t> needed(std::size_t(cells.x()) * cells.y() * cells.z(), 0);
  std::vector<std::uint8_t> read(coarse.values.size(), 0);
  const auto cell_index = [&](int i, int j, int k) {
    return std::size_t(i) + std::size_t(cells.x()) * (j + std::size_t(cells.y()) * k);
  };
  const auto fine_end = [&](int cell, int axis) {
    return std::min((cell + 1) * kCoarse, field.size[axis]);
  };
  for (int k = 0; k < cells.z(); ++k)
    for (int j = 0; j < cells.y(); ++j)
      for (int i = 0; i < cells.x(); ++i) {
        bool below = false;
        for (int z = k * kCoarse; z < fine_end(k, 2) && !below; ++z)
          for (int y = j * kCoarse; y < fine_end(j, 1) && !below; ++y)
            for (int x = i * kCoarse; x < fine_end(i, 0); ++x) below |= field(x, y, z) < above;
        if (!below) continue;
        needed[cell_index(i, j, k)] = 1;
        for (int z = 0; z < 4; ++z)
          for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x) read[coarse.index(i + x, j + y, k + z)] = 1;
      }
  for (int k = 0; k < coarse.size.z(); ++k)
    for (int j = 0; j < coarse.size.y(); ++j)
      for (int i = 0; i < coarse.size.x();) {
        int end = i;
        while (end < coarse.size.x() && read[coarse.index(end, j, k)]) ++end;
        if (end > i)
          f(coarse.position(i, j, k), Vec3(coarse.cell, 0, 0), end - i, &coarse(i, j, k));
        i = end + 1;
      }

  const CubicWeights cubic;
  for (int k = 0; k < cells.z(); ++k)
    for (int j = 0; j < cells.y(); ++j)
      for (int i = 0; i < cells.x(); ++i) {
        if (!needed[cell_index(i, j, k)]) continue;
        float around[64], fine[64];
        for (int z = 0; z < 4; ++z)
          for (int y = 0; y < 4; ++y)
            std::copy_n(&coarse(i, j + y, k + z), 4, around + 16 * z + 4 * y);
        interpolate(cubic, around, fine);
        // The gradient's length changes slowly: one for the cell's eight corners is enough.
        const float* c = around + 21;
        float gx = 0, gy = 0, gz = 0;
        for (int a = 0; a < 2; ++a)
          for (int b = 0; b < 2; ++b) {
            gx += c[1 + 4 * a + 16 * b] - c[4 * a + 16 * b];
            gy += c[4 + a + 16 * b] - c[a + 16 * b];
            gz += c[16 + a + 4 * b] - c[a + 4 * b];
          }
        const float length = std::sqrt(gx * gx + gy * gy + gz * gz) / float(4 * coarse.cell);
        const float per_length = 1 / std::clamp(length, 0.25f, 4.f);
        for (int z = k * kCoarse; z < fine_end(k, 2); ++z)
          for (int y = j * kCoarse; y < fine_end(j, 1); ++y)
            for (int x = i * kCoarse; x < fine_end(i, 0); ++x) {
              const float d =
                  fine[(x % kCoarse) + kCoarse * ((y % kCoarse) + kCoarse * (z % kCoarse))];
              field(x, y, z) = std::max(field(x, y, z), d * per_length);
            }
      }
}

}  // namespace artisketch
