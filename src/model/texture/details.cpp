#include "model/texture/details.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "model/texture/drawn_details.h"
#include "model/texture/unlikeness.h"

namespace artisketch {
namespace {

// In shares of the figure's size.
constexpr double kLargest = 0.1;  // detail; what is larger is the ground that details lie on
constexpr double kAstray = 0.1;   // how far apart two drawings may lay the same detail
// Where the model's depth is off, the detail is where the drawings' rays meet: so near to each
// other, and so far from where the model has them.
constexpr double kMeet = 0.025, kDeep = 0.15;
constexpr double kTogether = 0.25;     // of its width: from there on a detail lies beside itself
constexpr int kPattern = 4;            // alike details so near each other, itself among them
constexpr double kDepthEdge = 0.02;    // of depth between neighbours that is an edge
constexpr double kAway = 0.015;        // how far a detail's line and blur reach
constexpr float kOneDetail = 0.2f;     // colours of one detail
constexpr double kMostRatio = 4;       // between the areas of one detail in two drawings,
constexpr double kLeastPart = 12;      // and where one has it cut off
constexpr float kMostSeen = 0.5f;      // of a place, to know that there is no such detail there
constexpr float kNearlyAsWell = 0.6f;  // of the best quality: good enough for the earlier drawing
constexpr double kPlain = 0.6;         // times as far as the next best: no mere look-alike
constexpr int kRound = 2;         // rings of triangles that belong to a detail: its line, its blur
constexpr int kSoften = 40;       // rounds that even out what is painted over
constexpr int kMostDetails = 10;  // of a drawing that can be the same as one: the nearest

// A detail of a drawing, where a view lays it on the model.
struct Detail {
  int view = 0;
  const DrawnDetail* drawn = nullptr;
  std::vector<int> faces;
  Vec3 middle = Vec3::Zero();  // on the model
  Ray ray;                     // that it lies on
  double area = 0;
  float quality = 0;
  bool pattern = false;  // one of several alike: which is which in another drawing can't be told
};

// What isn't whole may be any smaller part of the other.
bool may_be_part(const Detail& a, const Detail& b) {
  return a.area * (a.drawn->whole ? kMostRatio : kLeastPart) > b.area;
}
bool alike(const Detail& a, const Detail& b) {
  return unlikeness(a.drawn->colour, b.drawn->colour) < kOneDetail && may_be_part(a, b) &&
         may_be_part(b, a);
}

std::vector<Detail> details_in(const Mesh& mesh, const DrawnSurface& surface, int index,
                               const std::vector<DrawnDetail>& drawn, std::span<const int> label,
                               double size) {
  const SurfaceView& view = surface.views[index];
  const Sketch& sketch = surface.sketches[view.sketch];
  std::vector<Detail> all(drawn.size());
  for (int f = 0; f < mesh.F.rows(); ++f) {
    if (view.quality[f] <= 0) continue;
    Vec2 pixel = Vec2::Zero();
    Vec3 middle = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      pixel += view.pixels[mesh.F(f, k)] / 3;
      middle += mesh.V.row(mesh.F(f, k)).transpose() / 3;
    }
    if (!(pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < sketch.width &&
          pixel.y() < sketch.height))
      continue;
    const int which = label[std::size_t(pixel.y()) * sketch.width + std::size_t(pixel.x())];
    if (which < 0) continue;
    Detail& detail = all[which];
    detail.faces.push_back(f);
    detail.middle += middle;
    detail.quality += view.quality[f];
  }
  std::vector<Detail> out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    Detail& detail = all[i];
    if (detail.faces.empty()) continue;
    detail.view = index;
    detail.drawn = &drawn[i];
    detail.middle /= double(detail.faces.size());
    detail.quality /= float(detail.faces.size());
    detail.ray = view.ray(detail.drawn->middle, detail.drawn->joint);
    const double scale = view.camera.pixels_per_unit(0);
    detail.area = double(detail.drawn->pixels.size()) / (scale * scale);
    out.push_back(std::move(detail));
  }
  for (Detail& one : out)
    one.pattern = kPattern <= std::count_if(out.begin(), out.end(), [&](const Detail& other) {
                    return alike(one, other) && (one.middle - other.middle).norm() < kAstray * size;
                  });
  return out;
}

// Of the faces, the share that a view shows.
float share_seen(const SurfaceView& view, const std::vector<int>& faces) {
  const auto shown =
      std::count_if(faces.begin(), faces.end(), [&](int f) { return view.quality[f] > 0; });
  return float(shown) / float(faces.size());
}

// Whether only one of them can be right about its place: the drawing of one shows that of the
// other.
bool contradict(const Detail& a, const Detail& b, const DrawnSurface& surface) {
  return share_seen(surface.views[a.view], b.faces) >= kMostSeen ||
         share_seen(surface.views[b.view], a.faces) >= kMostSeen;
}

// How far two drawings are from agreeing on a detail's place: from 1 on they show two.
double way_between(const Detail& a, const Detail& b, double size) {
  const double astray = (a.middle - b.middle).norm() / (kAstray * size);
  NearestToRays nearest((a.middle + b.middle) / 2, 1e-2);
  nearest.add(a.ray);
  nearest.add(b.ray);
  const Vec3 there = nearest.point();
  const auto off = [&](const Ray& ray) {
    return (there - ray.origin).cross(ray.direction).norm() / ray.direction.norm();
  };
  const double meet = (off(a.ray) + off(b.ray)) / (kMeet * size),
               deep =
                   std::max((there - a.middle).norm(), (there - b.middle).norm()) / (kDeep * size);
  return std::min(astray, std::hypot(meet, deep));
}

// Which of the known details each new one is: as many as can be, the ways between them as short as
// can be. Two eyes that both lie astray are told apart so, the nearest alone would mix them up.
class Match {
 public:
  Match(const std::vector<Detail>& known, const std::vector<Detail>& found,
        const DrawnSurface& surface, double size)
      : used_(known.size(), 0), now_(found.size(), -1), best_(now_) {
    for (const Detail& one : found) {
      std::vector<std::pair<double, int>>& ways = ways_.emplace_back();
      for (int k = 0; k < int(known.size()); ++k)
        if (!one.pattern && !known[k].pattern && alike(known[k], one))
          ways.emplace_back(way_between(known[k], one, size), k);
      std::sort(ways.begin(), ways.end());
      const bool plain =
          ways.size() == 1 || (ways.size() > 1 && ways[0].first < kPlain * ways[1].first);
      int rank = 0;
      std::erase_if(ways, [&](const auto& way) {
        const Detail& other = known[way.second];
        const bool first = rank++ == 0 && plain && one.drawn->whole && other.drawn->whole;
        return way.first >= 1 || !(first || contradict(other, one, surface));
      });
      for (auto& way : ways) way.first *= way.first;
      if (ways.size() > kMostDetails) ways.resize(kMostDetails);
    }
    go(0, 0);
  }
  int of(std::size_t found) const { return best_[found]; }

 private:
  static constexpr int kMostTrials = 20000;  // then the best so far
  void go(std::size_t i, double cost) {
    if (cost >= least_ || ++trials_ > kMostTrials) return;
    if (i == now_.size()) {
      least_ = cost;
      best_ = now_;
      return;
    }
    for (const auto& [way, k] : ways_[i]) {
      if (used_[k]) continue;
      used_[k] = 1;
      now_[i] = k;
      go(i + 1, cost + way);
      used_[k] = 0;
    }
    now_[i] = -1;
    go(i + 1, cost + 1);
  }
  std::vector<std::vector<std::pair<double, int>>> ways_;
  std::vector<std::uint8_t> used_;
  std::vector<int> now_, best_;
  double least_ = std::numeric_limits<double>::max();
  int trials_ = 0;
};

std::vector<int> with_rings(std::vector<int> faces, const FaceNeighbours& neighbours) {
  std::size_t begin = 0;
  std::vector<std::uint8_t> in(neighbours.size(), 0);
  for (const int f : faces) in[f] = 1;
  for (int ring = 0; ring < kRound; ++ring) {
    const std::size_t end = faces.size();
    for (; begin < end; ++begin)
      for (const int g : neighbours[faces[begin]])
        if (g >= 0 && !in[g]) {
          in[g] = 1;
          faces.push_back(g);
        }
  }
  return faces;
}

// Whether both lie so nearly on one place that no seam between their drawings shows.
bool lie_together(const Detail& a, const Detail& b) {
  return (a.middle - b.middle).norm() < kTogether * std::sqrt(std::min(a.area, b.area));
}

// The one to keep: the earliest of those that are seen whole and nearly best. None where no drawing
// shows it whole, as the tip of an ear, whose sides they show by turns.
const Detail* best_of(const std::vector<Detail>& same) {
  float best = 0;
  for (const Detail& one : same)
    if (one.drawn->whole) best = std::max(best, one.quality);
  const auto kept = std::find_if(same.begin(), same.end(), [&](const Detail& one) {
    return one.drawn->whole && one.quality >= kNearlyAsWell * best;
  });
  return kept == same.end() ? nullptr : &*kept;
}

// Paints over some pixels with what lies round them.
void paint_over(const std::vector<std::size_t>& pixels, Sketch& sketch) {
  std::vector<std::uint8_t> open(sketch.state.size(), 0);
  std::vector<std::size_t> inside;
  for (const std::size_t p : pixels) {
    open[p] = 1;
    if (sketch.state[p] != Sketch::nothing) inside.push_back(p);
  }
  // From the border inward, pixel by pixel.
  std::vector<std::size_t> todo = inside, ring;
  while (!todo.empty()) {
    ring.clear();
    for (const std::size_t p : todo) {
      std::size_t from = p;
      each_beside(sketch, p, [&](std::size_t q) {
        if (!open[q] && sketch.state[q] != Sketch::nothing && sketch.joint[q] == sketch.joint[p])
          from = q;
      });
      if (from == p) continue;
      sketch.colour[p] = sketch.colour[from];
      sketch.plain[p] = sketch.plain[from];
      ring.push_back(p);
    }
    if (ring.empty()) break;
    for (const std::size_t p : ring) open[p] = 0;
    std::erase_if(todo, [&](std::size_t p) { return !open[p]; });
  }
  if (sketch.pixel_art) return;
  // The border's tones run into each other, in place of rays from it.
  for (int round = 0; round < kSoften; ++round)
    for (std::vector<Pixel>* colours : {&sketch.colour, &sketch.plain})
      for (const std::size_t p : inside) {
        std::array<int, 3> sum = {};
        int count = 0;
        each_beside(sketch, p, [&](std::size_t q) {
          if (sketch.state[q] == Sketch::nothing || sketch.joint[q] != sketch.joint[p]) return;
          for (int k = 0; k < 3; ++k) sum[k] += (*colours)[q][k];
          ++count;
        });
        for (int k = 0; k < 3 && count > 0; ++k)
          (*colours)[p][k] = static_cast<unsigned char>((sum[k] + count / 2) / count);
      }
}

}  // namespace

void keep_details_once(const Mesh& mesh, const FaceNeighbours& neighbours, DrawnSurface& surface) {
  const double size = bounds(mesh.V).sizes().norm();
  std::vector<std::vector<DrawnDetail>> drawn(surface.sketches.size());
  std::vector<std::vector<Detail>> found(surface.views.size());
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    std::vector<int> label;
    for (std::size_t v = 0; v < found.size(); ++v) {
      const SurfaceView& view = surface.views[v];
      if (view.sketch != int(i)) continue;
      if (label.empty())
        drawn[i] =
            drawn_details(surface.sketches[i], kLargest * size * view.camera.pixels_per_unit(0),
                          kDepthEdge * size, label);
      found[v] = details_in(mesh, surface, int(v), drawn[i], label, size);
    }
  }
  std::vector<std::vector<Detail>> all;  // each as the views show it
  std::vector<Detail> known;             // the first of each
  for (int view = 0; view < int(surface.views.size()); ++view) {
    std::vector<Detail>& here = found[view];
    const Match match(known, here, surface, size);
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (const int k = match.of(i); k >= 0) {
        all[k].push_back(std::move(here[i]));
      } else {
        known.push_back(here[i]);
        all.push_back({std::move(here[i])});
      }
    }
  }
  for (const std::vector<Detail>& same : all) {
    const Detail* kept = same.size() < 2 ? nullptr : best_of(same);
    if (!kept) continue;
    const std::vector<int> place = with_rings(kept->faces, neighbours);
    for (const Detail& one : same) {
      if (one.view == kept->view || lie_together(one, *kept)) continue;
      SurfaceView& view = surface.views[one.view];
      // A mirror image has no pixels of its own: painting over it would take away the original.
      if (view.mirrored) {
        for (const int f : with_rings(one.faces, neighbours)) view.quality[f] = 0;
      } else {
        Sketch& sketch = surface.sketches[view.sketch];
        const double away = kAway * size * view.camera.pixels_per_unit(0);
        const int steps = int(std::min(away + 0.5, double(std::max(sketch.width, sketch.height))));
        paint_over(grown(sketch, one.drawn->pixels, steps), sketch);
      }
      for (const int f : place) view.quality[f] = 0;
    }
  }
}

}  // namespace artisketch
