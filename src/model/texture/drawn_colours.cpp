#include "model/texture/drawn_colours.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace artisketch {
namespace {

constexpr double kStep = 4;          // pixels of depth between neighbours that make an edge
constexpr float kInkDarker = 0.08f;  // than what is beside it
constexpr int kBeyondInk = 3;        // pixels that a colour may spread beside its width

constexpr std::array<std::array<int, 2>, 4> kBeside = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

Pixel pixel_at(const Image& picture, std::size_t p) {
  Pixel pixel;
  std::copy_n(&picture.rgba[4 * p], 4, pixel.begin());
  return pixel;
}
bool opaque(const Pixel& pixel) {
  return pixel[3] >= 128;
}
bool alike(const Pixel& a, const Pixel& b) {
  constexpr int kAlike = 24;  // per channel
  for (int c = 0; c < 3; ++c)
    if (std::abs(a[c] - b[c]) > kAlike) return false;
  return true;
}
float lightness(const Pixel& pixel) {
  return float(pixel[0] + pixel[1] + pixel[2]) / (3 * 255);
}

struct Span {
  int begin = 0, end = 0;
  int size() const { return end - begin; }
};

// The model over one drawing, while its colours are made.
struct Overlay {
  const Image& picture;
  Mask figure;  // where the drawing shows what the model shows there
  const Triangles& F;
  Visible seen;
  double pixel = 0;  // units
  Span x, y;         // the pixels that the model lies in

  std::size_t index(int x, int y) const { return std::size_t(y) * seen.width + x; }
  bool inside(int x, int y) const {
    return x >= 0 && y >= 0 && x < seen.width && y < seen.height && seen.face[index(x, y)] >= 0;
  }
  // Whether the surface runs on from one pixel to its neighbour.
  bool runs_on(std::size_t p, std::size_t q) const {
    const int f = seen.face[p], g = seen.face[q];
    if (f < 0 || g < 0) return false;
    if (f == g || std::abs(seen.depth[p] - seen.depth[q]) < kStep * pixel) return true;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (F(f, i) == F(g, j)) return true;
    return false;
  }
};

// The colour that most of what the mask doesn't hold has, if one prevails: none where the figure is
// cut out, and what is left outside the outlines is ink.
std::optional<Pixel> paper_colour(const Image& picture, const Mask& outlined) {
  std::vector<int> count(16 * 16 * 16, 0), last(count.size());
  int all = 0;
  for (std::size_t p = 0; p < outlined.in.size(); ++p) {
    const Pixel pixel = pixel_at(picture, p);
    if (outlined.in[p]) continue;
    ++all;
    if (!opaque(pixel)) continue;
    const int bin = (pixel[0] / 16 * 16 + pixel[1] / 16) * 16 + pixel[2] / 16;
    ++count[bin];
    last[bin] = int(p);
  }
  const auto most = std::max_element(count.begin(), count.end());
  if (2 * *most <= all) return std::nullopt;
  return pixel_at(picture, last[most - count.begin()]);
}

// The pixels that show the figure: opaque, in the frame's closed contours where it has any, and not
// paper. Outlines run beyond the figure where a part's end is hidden; what they hold there looks
// like paper and hangs together with it, along a short way: a white glove on white paper loses no
// more than that, and gets it back from its middle.
Mask figure_mask(const Frame& frame, const Image& picture) {
  constexpr double kWay = 0.04;  // of the drawing's larger side
  Mask figure(frame.width, frame.height);
  const std::vector<int> joints = outlined_joints(frame);
  if (joints.empty()) std::fill(figure.in.begin(), figure.in.end(), std::uint8_t(1));
  for (const int joint : joints) add_polygons(closed_contours(frame, joint), figure);
  const std::optional<Pixel> paper = paper_colour(picture, figure);
  std::vector<std::size_t> front;
  for (std::size_t p = 0; p < figure.in.size(); ++p) {
    const Pixel pixel = pixel_at(picture, p);
    if (paper && !figure.in[p] && opaque(pixel) && alike(pixel, *paper)) front.push_back(p);
    if (!opaque(pixel)) figure.in[p] = 0;
  }
  const int w = frame.width, h = frame.height;
  for (int way = int(kWay * std::max(w, h)); way > 0 && !front.empty(); --way) {
    std::vector<std::size_t> next;
    for (const std::size_t p : front) {
      const int x = int(p % w), y = int(p / w);
      for (const auto& [dx, dy] : kBeside) {
        if (x + dx < 0 || y + dy < 0 || x + dx >= w || y + dy >= h) continue;
        const std::size_t q = p + std::ptrdiff_t(dy) * w + dx;
        if (!figure.in[q] || !alike(pixel_at(picture, q), *paper)) continue;
        figure.in[q] = 0;
        next.push_back(q);
      }
    }
    front = std::move(next);
  }
  return figure;
}

Overlay overlay_of(const Image& picture, Mask figure, const Triangles& F, Visible seen,
                   double pixel) {
  Overlay o{picture, std::move(figure), F, std::move(seen), pixel, {}, {}};
  o.x = {o.seen.width, 0};
  o.y = {o.seen.height, 0};
  for (int y = 0; y < o.seen.height; ++y) {
    const auto row = o.seen.face.begin() + std::ptrdiff_t(o.index(0, y));
    const auto shown = [](int face) { return face >= 0; };
    const int first = int(std::find_if(row, row + o.seen.width, shown) - row);
    if (first == o.seen.width) continue;
    int last = o.seen.width;
    while (!shown(row[last - 1])) --last;
    o.x = {std::min(o.x.begin, first), std::max(o.x.end, last)};
    o.y = {std::min(o.y.begin, y), y + 1};
  }
  if (o.x.size() < 0) o.x = o.y = {};
  return o;
}

// Takes from the figure what the drawing shows of a part that the model has behind: the model's
// parts are a few pixels off where the outline of a part before them says how far that one reaches.
void take_before(const Overlay& o, const std::vector<Holders>& holders, int joint,
                 const PartMask& part, std::vector<std::uint8_t>& taken) {
  const auto is_part = [&](std::size_t p) {
    return o.seen.face[p] >= 0 && holders[o.seen.face[p]].has(joint);
  };
  std::vector<std::pair<std::size_t, float>> all;  // pixels, and how far the part before them is
  std::vector<std::array<int, 2>> places;
  const auto take = [&](int x, int y, float depth) {
    if (!o.inside(x, y)) return;
    const std::size_t q = o.index(x, y);
    if (taken[q] == 2 || !part.in(q) || is_part(q) || o.seen.depth[q] < depth + kStep * o.pixel)
      return;
    taken[q] = 2;
    all.emplace_back(q, depth);
    places.push_back({x, y});
  };
  for (int y = std::max(part.top(), o.y.begin); y < std::min(part.bottom(), o.y.end); ++y)
    for (int x = std::max(part.left(), o.x.begin); x < std::min(part.right(), o.x.end); ++x) {
      const std::size_t p = o.index(x, y);
      if (!is_part(p)) continue;
      for (const auto& [dx, dy] : kBeside) take(x + dx, y + dy, o.seen.depth[p]);
    }
  for (std::size_t head = 0; head < all.size(); ++head)
    for (const auto& [dx, dy] : kBeside)
      take(places[head][0] + dx, places[head][1] + dy, all[head].second);
  for (const auto& one : all) taken[one.first] = 1;
}

// Leaves of the figure what the outlines and colours give to the part that the model shows there.
void keep_own(const Frame& frame, const std::vector<Holders>& holders, const PartColours& colours,
              Overlay& o) {
  const std::vector<int> joints = outlined_joints(frame);
  if (joints.empty()) return;
  std::vector<std::uint8_t> own(o.figure.in.size(), 0), taken(own.size(), 0);
  PartMask part(frame.width, frame.height);
  for (const int joint : joints) {
    part.show(frame, joint);
    for (int y = part.top(); y < part.bottom(); ++y)
      for (int x = part.left(); x < part.right(); ++x) {
        const std::size_t p = o.index(x, y);
        if (!part.in(p) || o.seen.face[p] < 0) continue;
        const Holders& here = holders[o.seen.face[p]];
        if (here.has(joint))
          own[p] = 1;
        else if (colours.is_foreign(pixel_at(o.picture, p), here, joint))
          taken[p] = 1;
      }
    take_before(o, holders, joint, part, taken);
  }
  for (std::size_t p = 0; p < own.size(); ++p)
    if (!own[p] || taken[p]) o.figure.in[p] = 0;
}

// Things held before the body paint nothing but themselves, wherever the model has them.
void keep_what_isnt_held(const std::vector<Holders>& holders, std::span<const int> held,
                         Overlay& o) {
  for (std::size_t p = 0; p < held.size(); ++p)
    if (held[p] >= 0 && o.seen.face[p] >= 0 && !holders[o.seen.face[p]].has(held[p]))
      o.figure.in[p] = 0;
}

// Pixels from each pixel of the model to the nearest outline of what is drawn of it, 0 where
// nothing is: chamfer distances (Borgefors 1986).
std::vector<float> outline_distances(const Overlay& o) {
  const int w = o.seen.width, h = o.seen.height;
  constexpr float kDiagonal = 1.414f;
  std::vector<float> distance(o.seen.face.size(), 0.0f);
  const auto shows = [&](int x, int y) { return o.inside(x, y) && o.figure.at(x, y); };
  const auto mark = [&](std::size_t p) { distance[p] = std::min(distance[p], 0.5f); };
  for (int y = o.y.begin; y < o.y.end; ++y)
    for (int x = o.x.begin; x < o.x.end; ++x) {
      if (!shows(x, y)) continue;
      const std::size_t p = o.index(x, y);
      distance[p] = std::numeric_limits<float>::max();
      if (!shows(x - 1, y) || !shows(x + 1, y) || !shows(x, y - 1) || !shows(x, y + 1)) mark(p);
      if (shows(x - 1, y) && !o.runs_on(p, p - 1)) mark(p), mark(p - 1);
      if (shows(x, y - 1) && !o.runs_on(p, p - w)) mark(p), mark(p - w);
    }
  const auto relax = [&](int x, int y, int sign) {
    float& d = distance[o.index(x, y)];
    if (d <= 0.5f) return;  // an outline, or beside the model
    for (const auto& [dx, dy, step] : {std::tuple(-1, 0, 1.0f), std::tuple(0, -1, 1.0f),
                                       std::tuple(-1, -1, kDiagonal), std::tuple(1, -1, kDiagonal)})
      if (const int u = x + sign * dx, v = y + sign * dy; u >= 0 && v >= 0 && u < w && v < h)
        d = std::min(d, distance[o.index(u, v)] + step);
  };
  for (int y = o.y.begin; y < o.y.end; ++y)
    for (int x = o.x.begin; x < o.x.end; ++x) relax(x, y, 1);
  for (int y = o.y.end; y-- > o.y.begin;)
    for (int x = o.x.end; x-- > o.x.begin;) relax(x, y, -1);
  return distance;
}

// How far, in pixels, the ink along outlines reaches into the model: to where the drawing is, on
// average, nearly as bright as farther in.
float ink_width(const Overlay& o, const std::vector<float>& distance, int fine) {
  constexpr int kWidest = 24;  // times `fine`
  const int bins = kWidest * fine;
  constexpr double kAsBright = 0.85;
  std::vector<double> light(bins, 0.0), count(bins, 0.0);
  for (std::size_t p = 0; p < distance.size(); ++p) {
    if (o.seen.face[p] < 0 || !o.figure.in[p] || distance[p] >= float(bins)) continue;
    light[std::size_t(distance[p])] += lightness(pixel_at(o.picture, p));
    count[std::size_t(distance[p])] += 1;
  }
  double within = 0, pixels = 0;
  for (int b = bins / 3; b < bins; ++b) within += light[b], pixels += count[b];
  int b = 0;
  while (b < bins / 3 && light[b] * pixels < kAsBright * within * count[b]) ++b;
  // The drawn line and the model's outline are a pixel apart here and there.
  return float(b) + 1.5f * float(fine);
}

// Spreads colours to the pixels of the model that have none, without crossing an outline, so many
// steps far: what lies farther off isn't shown, and is no business of the nearest colour's.
void spread(const Overlay& o, int steps, std::vector<Pixel>& colour,
            std::vector<std::uint8_t>& state) {
  std::vector<std::array<int, 2>> front, next;  // coloured, beside what isn't yet
  for (int y = o.y.begin; y < o.y.end; ++y)
    for (int x = o.x.begin; x < o.x.end; ++x)
      if (state[o.index(x, y)] == Sketch::drawn &&
          std::any_of(kBeside.begin(), kBeside.end(), [&](const auto& to) {
            return o.inside(x + to[0], y + to[1]) &&
                   state[o.index(x + to[0], y + to[1])] == Sketch::nothing;
          }))
        front.push_back({x, y});
  for (int step = 0; step < steps && !front.empty(); ++step) {
    next.clear();
    for (const auto& [x, y] : front) {
      const std::size_t p = o.index(x, y);
      for (const auto& [dx, dy] : kBeside) {
        if (!o.inside(x + dx, y + dy)) continue;
        const std::size_t q = o.index(x + dx, y + dy);
        if (state[q] != Sketch::nothing || !o.runs_on(p, q)) continue;
        colour[q] = colour[p];
        state[q] = Sketch::pulled;
        next.push_back({x + dx, y + dy});
      }
    }
    std::swap(front, next);
  }
}

// Takes their colours from the pixels that lie within so many steps of the marked ones.
void take_beside(const Overlay& o, int steps, std::vector<std::uint8_t>& marked,
                 std::vector<std::uint8_t>& state) {
  for (int step = 0; step < steps; ++step) {
    const std::vector<std::uint8_t> before = marked;
    for (int y = o.y.begin; y < o.y.end; ++y)
      for (int x = o.x.begin; x < o.x.end; ++x) {
        if (!before[o.index(x, y)]) continue;
        for (const auto& [dx, dy] : kBeside)
          if (o.inside(x + dx, y + dy)) marked[o.index(x + dx, y + dy)] = 1;
      }
  }
  for (std::size_t p = 0; p < state.size(); ++p)
    if (marked[p]) state[p] = Sketch::nothing;
}

// The most (or least) of the columns within r of each, transposed. Two of the largest windows that
// doubling makes cover each; what is nearer than r to the first or last column is left undefined.
template <class Better>
Eigen::ArrayXXf columns_within(Eigen::ArrayXXf a, int r, const Better& better) {
  const Eigen::Index n = a.cols();
  Eigen::Index window = 1;  // of column i: the best of [i, i + window)
  for (; 2 * window <= 2 * r + 1; window *= 2)
    for (Eigen::Index i = 0; i + window < n; ++i) better(a.col(i), a.col(i + window), a.col(i));
  Eigen::ArrayXXf out(a.rows(), n);
  for (Eigen::Index i = 0; i < n; ++i)
    better(a.col(std::max<Eigen::Index>(i - r, 0)),
           a.col(std::clamp<Eigen::Index>(i + r + 1 - window, 0, n - 1)), out.col(i));
  return out.transpose();
}

// Morphological closing by a square of side 2 r + 1: what is dark and thinner than that is filled.
// The outermost r rows and columns have to be light.
Eigen::ArrayXXf without_thin_dark(Eigen::ArrayXXf light, int r) {
  const auto most = [](const auto& a, const auto& b, auto&& out) { out = a.max(b); };
  const auto least = [](const auto& a, const auto& b, auto&& out) { out = a.min(b); };
  for (int axis = 0; axis < 2; ++axis) light = columns_within(std::move(light), r, most);
  for (int axis = 0; axis < 2; ++axis) light = columns_within(std::move(light), r, least);
  return light;
}

// Whether both may be one colour, in shade and in light.
bool one_colour(const Rgb& a, const Rgb& b) {
  constexpr float kAlike = 0.1f, kDarkest = 0.6f, kTinted = 0.15f;
  if ((a - b).norm() < kAlike) return true;
  const float light = std::max(a.mean(), b.mean()), dark = std::min(a.mean(), b.mean());
  return dark > kDarkest * light && (a / a.mean() - b / b.mean()).norm() < kTinted;
}

// Stretches of one colour, in shade or not, without lines of ink.
struct Stretches {
  std::vector<int> of;  // each pixel; −1: ink, or nothing
  std::vector<Rgb> colour;
  std::vector<bool> large;  // ground, and no detail
};
Stretches stretches_of(const Overlay& o, const std::vector<Pixel>& colour,
                       const std::vector<std::uint8_t>& state) {
  constexpr double kLargest = 0.1;  // detail, of the figure's size in the drawing
  const double least = kLargest * std::hypot(o.x.size(), o.y.size());
  Stretches out;
  out.of.assign(state.size(), -1);
  std::vector<std::array<int, 2>> places;
  for (int y = o.y.begin; y < o.y.end; ++y)
    for (int x = o.x.begin; x < o.x.end; ++x) {
      if (state[o.index(x, y)] == Sketch::nothing || out.of[o.index(x, y)] >= 0) continue;
      const int id = int(out.colour.size());
      out.of[o.index(x, y)] = id;
      places = {{x, y}};
      Eigen::AlignedBox2i box;
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (std::size_t head = 0; head < places.size(); ++head) {
        const auto [u, v] = places[head];
        const std::size_t p = o.index(u, v);
        box.extend(Eigen::Vector2i(u, v));
        sum += rgb_of(colour[p]).cast<double>();
        for (const auto& [dx, dy] : kBeside) {
          if (!o.inside(u + dx, v + dy)) continue;
          const std::size_t q = o.index(u + dx, v + dy);
          if (state[q] == Sketch::nothing || out.of[q] >= 0) continue;
          // With the whole of it, too: soft edges would lead from colour to colour.
          if (!alike(colour[p], colour[q]) && !one_colour(rgb_of(colour[p]), rgb_of(colour[q])))
            continue;
          if (!one_colour(rgb_of(colour[q]), Rgb(sum.cast<float>() / float(head + 1)))) continue;
          out.of[q] = id;
          places.push_back({u + dx, v + dy});
        }
      }
      out.colour.push_back((sum / double(places.size())).cast<float>());
      out.large.push_back(box.sizes().cast<double>().norm() > least);
    }
  return out;
}

// How many pixels of each large stretch, and of all small ones, lie within `reach` of a pixel along
// each axis. Slides along rows: what a step leaves is taken away, what it comes to is added.
class Near {
 public:
  Near(const Overlay& o, const Stretches& stretches, int reach)
      : o_(o), stretches_(stretches), reach_(reach) {}
  void move_to(int x, int y) {
    if (y != y_ || x <= x_ || x > x_ + 2 * reach_) {
      counts_.clear();
      detail_ = all_ = 0;
      for (int u = x - reach_; u <= x + reach_; ++u) add_column(u, y, 1);
    } else {
      for (int u = x_ + 1; u <= x; ++u) {
        add_column(u - reach_ - 1, y, -1);
        add_column(u + reach_, y, 1);
      }
    }
    x_ = x;
    y_ = y;
  }
  int detail() const { return detail_; }
  int all() const { return all_; }
  struct Count {
    int stretch = 0, pixels = 0;
  };
  const std::vector<Count>& counts() const { return counts_; }

 private:
  void add_column(int u, int y, int sign) {
    if (u < o_.x.begin || u >= o_.x.end) return;
    const int end = std::min(y + reach_ + 1, o_.y.end);
    for (int v = std::max(y - reach_, o_.y.begin); v < end;) {
      const int id = stretches_.of[o_.index(u, v)], from = v;
      while (v < end && stretches_.of[o_.index(u, v)] == id) ++v;
      if (id >= 0) add(id, sign * (v - from));
    }
  }
  void add(int stretch, int pixels) {
    all_ += pixels;
    if (!stretches_.large[stretch]) {
      detail_ += pixels;
      return;
    }
    const auto same = std::find_if(counts_.begin(), counts_.end(),
                                   [&](const Count& one) { return one.stretch == stretch; });
    if (same == counts_.end())
      counts_.push_back({stretch, pixels});
    else if ((same->pixels += pixels) == 0)
      counts_.erase(same);
  }
  const Overlay& o_;
  const Stretches& stretches_;
  int reach_, x_ = 0, y_ = -1;
  std::vector<Count> counts_;
  int detail_ = 0, all_ = 0;
};

// How dark the darkest ink is of a pixel and those round it.
float darkest_ink(const Overlay& o, const std::vector<Pixel>& colour, const Stretches& stretches,
                  int x, int y) {
  float darkest = 1;
  for (int v = y - 1; v <= y + 1; ++v)
    for (int u = x - 1; u <= x + 1; ++u)
      if (o.inside(u, v) && stretches.of[o.index(u, v)] < 0)
        darkest = std::min(darkest, lightness(colour[o.index(u, v)]));
  return darkest;
}

// Whether a line of ink only parts two colours, as hair from a face: the surface has none there. A
// line on one colour draws something, and so do lines round what is small, as eyes.
//   ink  how dark the line is
bool only_parts_colours(const Stretches& stretches, const Near& near, float ink) {
  constexpr float kLeast = 0.15f, kMostDetail = 0.3f;
  constexpr float kInk = 0.6f;  // times as light as either side; what is lighter is a ribbon
  if (float(near.detail()) > kMostDetail * float(near.all())) return false;
  const std::vector<Near::Count>& counts = near.counts();
  for (std::size_t i = 0; i < counts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Rgb &a = stretches.colour[counts[i].stretch], &b = stretches.colour[counts[j].stretch];
      if (float(std::min(counts[i].pixels, counts[j].pixels)) >= kLeast * float(near.all()) &&
          !one_colour(a, b) && ink <= kInk * std::min(a.mean(), b.mean()))
        return true;
    }
  return false;
}

}  // namespace

void fill_colours(const Frame& frame, const Image& picture, const Triangles& F,
                  const std::vector<Holders>& holders, const PartColours& colours, Visible seen,
                  std::span<const int> held, double pixel, int fine, Sketch& sketch) {
  Overlay o = overlay_of(picture, figure_mask(frame, picture), F, std::move(seen), pixel);
  keep_own(frame, holders, colours, o);
  keep_what_isnt_held(holders, held, o);
  sketch.width = frame.width;
  sketch.height = frame.height;
  const std::vector<float> distance = outline_distances(o);
  const float ink = ink_width(o, distance, fine);
  sketch.colour.assign(distance.size(), Pixel{});
  sketch.state.assign(distance.size(), Sketch::nothing);
  // The middle of what is thinner than two lines of ink is still its best colour.
  const auto in_the_middle = [&](int x, int y) {
    const float d = distance[o.index(x, y)];
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, sketch.height - 1); ++v)
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, sketch.width - 1); ++u)
        if (distance[o.index(u, v)] > d) return false;
    return d > 1;
  };
  for (int y = o.y.begin; y < o.y.end; ++y)
    for (int x = o.x.begin; x < o.x.end; ++x) {
      const std::size_t p = o.index(x, y);
      if (!o.inside(x, y) || !o.figure.in[p]) continue;
      if (distance[p] < ink && !in_the_middle(x, y)) continue;
      sketch.colour[p] = pixel_at(o.picture, p);
      sketch.state[p] = Sketch::drawn;
    }
  // Over the ink, on the slant, and what the model and the drawing differ by.
  const int reach = int(1.5f * ink) + kBeyondInk * fine;
  spread(o, reach, sketch.colour, sketch.state);
  sketch.plain = sketch.colour;
  std::vector<std::uint8_t> state = sketch.state;
  const int r = int(ink);
  const auto each = [&](Eigen::ArrayXXf& values, const auto& visit) {
    for (int y = o.y.begin; y < o.y.end; ++y)
      for (int x = o.x.begin; x < o.x.end; ++x)
        visit(o.index(x, y), values(x - o.x.begin + r, y - o.y.begin + r));
  };
  // All is light beside the model, so that a line along its edge is thin, too.
  Eigen::ArrayXXf light = Eigen::ArrayXXf::Ones(o.x.size() + 2 * r, o.y.size() + 2 * r);
  each(light, [&](std::size_t p, float& here) {
    if (state[p] != Sketch::nothing) here = lightness(sketch.colour[p]);
  });
  Eigen::ArrayXXf darker = without_thin_dark(light, r) - light;
  // A line's soft edge is a mixture of it and of what lies beside it, and no colour of that.
  std::vector<std::uint8_t> soft(state.size(), 0);
  each(darker, [&](std::size_t p, float by) {
    if (state[p] == Sketch::drawn && by > kInkDarker) soft[p] = std::uint8_t(1);
    if (state[p] == Sketch::pulled || by > kInkDarker) state[p] = Sketch::nothing;
  });
  take_beside(o, fine, soft, state);
  const Stretches stretches = stretches_of(o, sketch.colour, state);
  const std::vector<std::uint8_t> bare = state;
  spread(o, reach, sketch.plain, state);
  std::vector<std::size_t> between;
  Near near(o, stretches, r + 1);
  for (int y = o.y.begin; y < o.y.end; ++y)
    for (int x = o.x.begin; x < o.x.end; ++x) {
      const std::size_t p = o.index(x, y);
      if (bare[p] != Sketch::nothing || sketch.state[p] == Sketch::nothing) continue;
      near.move_to(x, y);
      if (only_parts_colours(stretches, near, darkest_ink(o, sketch.colour, stretches, x, y)))
        between.push_back(p);
    }
  for (const std::size_t p : between) sketch.colour[p] = sketch.plain[p];
  sketch.depth = o.seen.depth;
  sketch.joint.resize(distance.size());
  for (std::size_t p = 0; p < distance.size(); ++p)
    sketch.joint[p] = o.seen.face[p] < 0 ? -1 : holders[o.seen.face[p]].first();
}

}  // namespace artisketch
