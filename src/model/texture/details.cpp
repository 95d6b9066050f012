#include "model/texture/details.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/raster.h"
#include "model/texture/unlikeness.h"

namespace artisketch {
namespace {

// In shares of the figure's size.
constexpr double kLargest = 0.1;  // detail; what is larger is the ground that details lie on
constexpr double kAstray = 0.1;   // how far apart two drawings may lay the same detail
constexpr int kLeastFaces = 3;
constexpr float kAlike = 0.2f;       // colours of neighbours that hang together, and of one detail
constexpr float kStandsOut = 0.35f;  // from the ground round it
constexpr float kMostRatio = 3;      // between the areas of one detail in two drawings
constexpr float kMostSeen = 0.5f;    // of a place, to know that there is no such detail there
constexpr float kNearlyAsWell = 0.6f;  // of the best quality: good enough for the earlier drawing
constexpr int kRound = 2;         // rings of triangles that belong to a detail: its line, its blur
constexpr int kSoften = 40;       // rounds that even out what is painted over
constexpr int kMostDetails = 10;  // of a drawing that can be the same as one: the nearest

struct Detail {
  int view = 0;
  std::vector<int> faces;
  Vec3 middle = Vec3::Zero();
  double area = 0;
  Rgb colour = Rgb::Zero();
  float quality = 0;
  bool whole = true;  // doesn't run on where the view shows nothing
};

// Finds what stands out in one view.
class Finder {
 public:
  Finder(const Mesh& mesh, const FaceNeighbours& neighbours, const DrawnSurface& surface)
      : neighbours_(neighbours), surface_(surface), size_(bounds(mesh.V).sizes().norm()) {
    for (int f = 0; f < mesh.F.rows(); ++f) {
      const Vec3 a = mesh.V.row(mesh.F(f, 0)).transpose(), b = mesh.V.row(mesh.F(f, 1)).transpose(),
                 c = mesh.V.row(mesh.F(f, 2)).transpose();
      middle_.push_back((a + b + c) / 3);
      area_.push_back((b - a).cross(c - a).norm() / 2);
    }
    faces_ = &mesh.F;
  }
  double size() const { return size_; }

  std::vector<Detail> details(int view) {
    look(view);
    const int n = int(colour_.size());
    // Stretches of one colour; those that are small.
    std::vector<std::uint8_t> small(n, 0);
    for (const std::vector<int>&stretch : stretches([&](int f, int g) {
           return seen(f) && seen(g) && unlikeness(colour_[f], colour_[g]) < kAlike;
         }))
      if (extent(stretch) <= kLargest * size_)
        for (const int f : stretch) small[f] = 1;
    // What is small and hangs together is one: an eye's white, its iris and its ring.
    std::vector<Detail> out;
    for (std::vector<int>&stretch : stretches([&](int f, int g) { return small[f] && small[g]; }))
      if (int(stretch.size()) >= kLeastFaces && extent(stretch) <= kLargest * size_)
        add(view, std::move(stretch), out);
    return out;
  }

 private:
  bool seen(int f) const { return colour_[f].x() >= 0; }
  void look(int view) {
    const SurfaceView& shown = surface_.views[view];
    colour_.assign(middle_.size(), Rgb::Constant(-1));
    for (int f = 0; f < int(colour_.size()); ++f)
      if (shown.quality[f] > 0)
        if (const auto c = shown.colour(surface_.sketches, *faces_, f, Vec3::Constant(1 / 3.0)))
          colour_[f] = *c;
  }
  double extent(const std::vector<int>& faces) const {
    Box3 box;
    for (const int f : faces) box.extend(middle_[f]);
    return box.sizes().norm();
  }
  // The faces in sets that hang together.
  template <class Together>
  std::vector<std::vector<int>> stretches(const Together& together) const {
    std::vector<std::vector<int>> out;
    std::vector<std::uint8_t> done(colour_.size(), 0);
    for (int seed = 0; seed < int(done.size()); ++seed) {
      if (done[seed] || !together(seed, seed)) continue;
      done[seed] = 1;
      std::vector<int> faces = {seed};
      for (std::size_t head = 0; head < faces.size(); ++head)
        for (const int g : neighbours_[faces[head]])
          if (g >= 0 && !done[g] && together(faces[head], g)) {
            done[g] = 1;
            faces.push_back(g);
          }
      out.push_back(std::move(faces));
    }
    return out;
  }
  void add(int view, std::vector<int> faces, std::vector<Detail>& out) const {
    Detail detail;
    detail.view = view;
    Rgb ground = Rgb::Zero();
    int round = 0, open = 0;
    for (const int f : faces) {
      detail.middle += area_[f] * middle_[f];
      detail.colour += float(area_[f]) * colour_[f];
      detail.quality += float(area_[f]) * surface_.views[view].quality[f];
      detail.area += area_[f];
      for (const int g : neighbours_[f]) {
        if (g < 0 || !seen(g))
          ++open;
        else if (std::find(faces.begin(), faces.end(), g) == faces.end())
          ground += colour_[g], ++round;
      }
    }
    if (!(detail.area > 0) || round == 0) return;
    detail.middle /= detail.area;
    detail.colour /= float(detail.area);
    detail.quality /= float(detail.area);
    detail.whole = open == 0;
    if (unlikeness(detail.colour, ground / float(round)) < kStandsOut) return;
    detail.faces = std::move(faces);
    out.push_back(std::move(detail));
  }

  const FaceNeighbours& neighbours_;
  const DrawnSurface& surface_;
  const Triangles* faces_ = nullptr;
  double size_;
  std::vector<Vec3> middle_;  // #F
  std::vector<double> area_;  // #F
  std::vector<Rgb> colour_;   // #F, of the view that is looked at; −1 where it shows nothing
};

// Of the faces, the share that a view shows.
float share_seen(const SurfaceView& view, const std::vector<int>& faces) {
  const auto shown =
      std::count_if(faces.begin(), faces.end(), [&](int f) { return view.quality[f] > 0; });
  return float(shown) / float(faces.size());
}

// Whether both can be the same thing, and only one of them right about its place.
bool may_be_one(const Detail& a, const Detail& b, const DrawnSurface& surface) {
  const double ratio = a.area / b.area;
  return unlikeness(a.colour, b.colour) < kAlike && ratio < kMostRatio && 1 / ratio < kMostRatio &&
         (share_seen(surface.views[a.view], b.faces) >= kMostSeen ||
          share_seen(surface.views[b.view], a.faces) >= kMostSeen);
}

// Which of the known details each new one is: as many as can be, the ways between them as short as
// can be. Two eyes that both lie astray are told apart so, the nearest alone would mix them up.
class Match {
 public:
  Match(const std::vector<Detail>& known, const std::vector<Detail>& found,
        const DrawnSurface& surface, double far)
      : used_(known.size(), 0), now_(found.size(), -1), best_(now_) {
    for (const Detail& one : found) {
      std::vector<std::pair<double, int>>& ways = ways_.emplace_back();
      for (int k = 0; k < int(known.size()); ++k)
        if (const double way = (known[k].middle - one.middle).norm() / far;
            way < 1 && may_be_one(known[k], one, surface))
          ways.emplace_back(way * way, k);
      std::sort(ways.begin(), ways.end());
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

// The one to keep: the earliest of those that are seen whole and nearly best. None where no drawing
// shows it whole, as the tip of an ear, whose sides they show by turns.
const Detail* best_of(const std::vector<Detail>& same) {
  float best = 0;
  for (const Detail& one : same)
    if (one.whole) best = std::max(best, one.quality);
  const auto kept = std::find_if(same.begin(), same.end(), [&](const Detail& one) {
    return one.whole && one.quality >= kNearlyAsWell * best;
  });
  return kept == same.end() ? nullptr : &*kept;
}

// Paints over the pixels of some triangles with what lies round them.
void paint_over(const Mesh& mesh, const SurfaceView& view, const std::vector<int>& faces,
                Sketch& sketch) {
  Triangles F(faces.size(), 3);
  for (std::size_t i = 0; i < faces.size(); ++i) F.row(i) = mesh.F.row(faces[i]);
  Mask mask(sketch.width, sketch.height);
  add_triangles(view.pixels, F, mask);
  std::vector<std::size_t> inside;
  const std::size_t width = sketch.width;
  for (std::size_t p = 0; p < mask.in.size(); ++p)
    if (mask.in[p] && sketch.state[p] != Sketch::nothing) inside.push_back(p);
  const auto each_beside = [&](std::size_t p, const auto& visit) {
    const std::size_t x = p % width, y = p / width;
    if (x > 0) visit(p - 1);
    if (x + 1 < width) visit(p + 1);
    if (y > 0) visit(p - width);
    if (y + 1 < std::size_t(sketch.height)) visit(p + width);
  };
  // From the border inward, pixel by pixel.
  std::vector<std::uint8_t> open = mask.in;
  std::vector<std::size_t> todo = inside, ring;
  while (!todo.empty()) {
    ring.clear();
    for (const std::size_t p : todo) {
      std::size_t from = p;
      each_beside(p, [&](std::size_t q) {
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
        each_beside(p, [&](std::size_t q) {
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
  Finder finder(mesh, neighbours, surface);
  std::vector<std::vector<Detail>> all;  // each as the views show it
  std::vector<Detail> known;             // the first of each
  for (int view = 0; view < int(surface.views.size()); ++view) {
    std::vector<Detail> found = finder.details(view);
    const Match match(known, found, surface, kAstray * finder.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (const int k = match.of(i); k >= 0) {
        all[k].push_back(std::move(found[i]));
      } else {
        known.push_back(found[i]);
        all.push_back({std::move(found[i])});
      }
    }
  }
  for (const std::vector<Detail>& same : all) {
    const Detail* kept = same.size() < 2 ? nullptr : best_of(same);
    if (!kept) continue;
    const std::vector<int> place = with_rings(kept->faces, neighbours);
    for (const Detail& one : same) {
      if (one.view == kept->view) continue;
      SurfaceView& view = surface.views[one.view];
      const std::vector<int> astray = with_rings(one.faces, neighbours);
      // A mirror image has no pixels of its own: painting over it would take away the original.
      if (view.mirrored)
        for (const int f : astray) view.quality[f] = 0;
      else
        paint_over(mesh, view, astray, surface.sketches[view.sketch]);
      for (const int f : place) view.quality[f] = 0;
    }
  }
}

}  // namespace artisketch
