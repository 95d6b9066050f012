#include "document/figure_cells.h"

#include <algorithm>
#include <cmath>

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

int Shares::largest(int cell) const {
  int best = -1;
  for (int l = 0; l < labels; ++l)
    if (at(cell, l) > (best < 0 ? 0 : at(cell, best))) best = l;
  return best;
}

namespace {

// The walk's equations: what a cell is, its neighbours' are on the mean, by the steps' weights.
struct WalkRow {
  int cell = 0;
  double sum = 0;                  // of all weights
  int next[4] = {-1, -1, -1, -1};  // rows
  double weight[4] = {0, 0, 0, 0};
};

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// By conjugate gradients: a sparse factorisation would take the page three times the code of all
// this. The matrix is symmetric and positive definite, as something known borders on each piece.
std::vector<double> solved(const std::vector<WalkRow>& rows, std::vector<double> r) {
  constexpr int kMostSteps = 2000;
  constexpr double kLeft = 1e-3;  // of the right-hand side
  std::vector<double> x(rows.size(), 0), p(rows.size(), 0), z(rows.size()), Ap(rows.size());
  const double enough = kLeft * kLeft * dot(r, r);
  double before = 0;
  for (int step = 0; step < kMostSteps && dot(r, r) > enough; ++step) {
    for (std::size_t i = 0; i < rows.size(); ++i) z[i] = r[i] / rows[i].sum;
    const double now = dot(r, z), beta = step > 0 ? now / before : 0;
    before = now;
    for (std::size_t i = 0; i < rows.size(); ++i) p[i] = z[i] + beta * p[i];
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Ap[i] = rows[i].sum * p[i];
      for (int k = 0; k < 4; ++k)
        if (rows[i].next[k] >= 0) Ap[i] -= rows[i].weight[k] * p[rows[i].next[k]];
    }
    const double alpha = now / dot(p, Ap);
    for (std::size_t i = 0; i < rows.size(); ++i) x[i] += alpha * p[i], r[i] -= alpha * Ap[i];
  }
  return x;
}

}  // namespace

Shares meetings(const Cells& cells, const std::vector<int>& seeds, const Shares& pulls) {
  Shares likely(cells.count(), pulls.labels);
  // What hangs together with a seed.
  std::vector<int> index(std::size_t(cells.count()), -1), open;
  Flags reached(std::size_t(cells.count()), 0);
  std::vector<WalkRow> rows;
  for (int c = 0; c < cells.count(); ++c)
    if (seeds[c] >= 0) reached[c] = 1, open.push_back(c), likely.at(c, seeds[c]) = 1;
  while (!open.empty()) {
    const int c = open.back();
    open.pop_back();
    if (seeds[c] < 0) {
      index[c] = int(rows.size());
      rows.emplace_back().cell = c;
    }
    beside(cells, c, [&](int n) {
      if (cells.figure[n] && !reached[n]) reached[n] = 1, open.push_back(n);
    });
  }
  constexpr double kEdge = 0.07, kLeast = 0.03;
  std::vector<std::vector<double>> known(std::size_t(pulls.labels),
                                         std::vector<double>(rows.size(), 0));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    WalkRow& row = rows[i];
    for (int l = 0; l < pulls.labels; ++l) {
      row.sum += pulls.at(row.cell, l);
      known[l][i] = pulls.at(row.cell, l);
    }
    int k = 0;
    beside(cells, row.cell, [&](int n) {
      if (!cells.figure[n]) return;
      const double d = unlikeness(cells.tones[row.cell], cells.tones[n]) / kEdge;
      const double w = std::max(kLeast, std::exp(-d * d));
      row.sum += w;
      if (seeds[n] >= 0)
        known[seeds[n]][i] += w;
      else
        row.next[k] = index[n], row.weight[k] = w, ++k;
    });
  }
  for (int l = 0; l < pulls.labels; ++l) {
    const std::vector<double> x = solved(rows, std::move(known[l]));
    for (std::size_t i = 0; i < rows.size(); ++i) likely.at(rows[i].cell, l) = float(x[i]);
  }
  return likely;
}

}  // namespace artisketch
