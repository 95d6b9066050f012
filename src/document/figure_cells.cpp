#include "document/figure_cells.h"

#include <algorithm>
#include <cmath>

#include "base/sparse.h"

namespace artisketch {

Cells cells_of(const SegmentedImage& image) {
  constexpr int kCells = 160;  // along the figure's longer side
  Cells cells;
  const Box2 box = figure_box(image);
  if (box.isEmpty()) return cells;
  cells.size = std::max(1, int(box.sizes().maxCoeff() / image.pixels / kCells));
  cells.width = (image.width + cells.size - 1) / cells.size;
  cells.height = (image.height + cells.size - 1) / cells.size;
  cells.figure.assign(std::size_t(cells.count()), 0);
  cells.tones.resize(std::size_t(cells.count()));
  std::vector<float> shown(std::size_t(cells.count()), 0);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::size_t pixel = std::size_t(y) * image.width + x;
      if (image.paper[pixel]) continue;
      const std::size_t c = std::size_t(y / cells.size) * cells.width + x / cells.size;
      const SegmentedImage::Tone& t = image.tones[pixel];
      SegmentedImage::Tone& sum = cells.tones[c];
      sum = {sum.l + t.l, sum.a + t.a, sum.b + t.b, sum.alpha + t.alpha};
      ++shown[c];
    }
  for (std::size_t c = 0; c < shown.size(); ++c) {
    if (shown[c] == 0) continue;
    SegmentedImage::Tone& t = cells.tones[c];
    t = {t.l / shown[c], t.a / shown[c], t.b / shown[c], t.alpha / shown[c]};
    cells.figure[c] = 2 * shown[c] >= float(cells.size * cells.size);
  }
  return cells;
}

std::vector<float> inset(const Cells& cells, const Flags& chosen) {
  const int w = cells.width, h = cells.height;
  std::vector<float> way(chosen.size());
  for (std::size_t c = 0; c < chosen.size(); ++c) way[c] = chosen[c] ? 1e6f : 0;
  const auto relax = [&](int c) {
    const int x = c % w, y = c / w;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        if (!dx && !dy) continue;
        const bool beyond = x + dx < 0 || y + dy < 0 || x + dx >= w || y + dy >= h;
        const float before = beyond ? 0 : way[c + dy * w + dx];
        way[c] = std::min(way[c], before + (dx && dy ? 1.41421356f : 1));
      }
  };
  for (int c = 0; c < w * h; ++c)
    if (chosen[c]) relax(c);
  for (int c = w * h - 1; c >= 0; --c)
    if (chosen[c]) relax(c);
  return way;
}

Eigen::MatrixXf meetings(const Cells& cells, const std::vector<int>& seeds,
                         const Eigen::MatrixXf& pulls) {
  const int labels = int(pulls.cols());
  Eigen::MatrixXf likely = Eigen::MatrixXf::Zero(cells.count(), labels);
  // What hangs together with a seed.
  std::vector<int> index(std::size_t(cells.count()), -1), open;
  Flags reached(std::size_t(cells.count()), 0);
  for (int c = 0; c < cells.count(); ++c)
    if (seeds[c] >= 0) reached[c] = 1, open.push_back(c), likely(c, seeds[c]) = 1;
  std::vector<int> unknown;
  while (!open.empty()) {
    const int c = open.back();
    open.pop_back();
    if (seeds[c] < 0) index[c] = int(unknown.size()), unknown.push_back(c);
    beside(cells, c, [&](int n) {
      if (cells.figure[n] && !reached[n]) reached[n] = 1, open.push_back(n);
    });
  }
  if (unknown.empty()) return likely;
  constexpr double kEdge = 0.07, kLeast = 0.03;
  const auto weight = [&](int a, int b) {
    const double d = unlikeness(cells.tones[a], cells.tones[b]) / kEdge;
    return std::max(kLeast, std::exp(-d * d));
  };
  std::vector<Eigen::Triplet<double>> entries;
  Columns known = Columns::Zero(Eigen::Index(unknown.size()), labels);
  for (const int c : unknown) {
    const int i = index[c];
    double sum = 0;
    for (int l = 0; l < labels; ++l) {
      sum += double(pulls(c, l));
      known(i, l) += double(pulls(c, l));
    }
    beside(cells, c, [&](int n) {
      if (!cells.figure[n]) return;
      const double w = weight(c, n);
      sum += w;
      if (seeds[n] >= 0)
        known(i, seeds[n]) += w;
      else
        entries.emplace_back(i, index[n], -w);
    });
    entries.emplace_back(i, i, sum);
  }
  SparseMatrix A(Eigen::Index(unknown.size()), Eigen::Index(unknown.size()));
  A.setFromTriplets(entries.begin(), entries.end());
  const Factors factors(A);
  if (factors.info() != Eigen::Success) return likely;
  const Columns found = solve(factors, known);
  for (const int c : unknown)
    for (int l = 0; l < labels; ++l) likely(c, l) = float(found(index[c], l));
  return likely;
}

}  // namespace artisketch
