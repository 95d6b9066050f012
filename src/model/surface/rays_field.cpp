#include "model/surface/rays_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/surface/agreement.h"
#include "model/surface/bulge.h"
#include "model/surface/held_back.h"
#include "model/surface/inflate.h"
#include "model/surface/mirror.h"
#include "model/surface/proportions.h"
#include "model/surface/shown_details.h"
#include "model/surface/thin_parts.h"

namespace artisketch {
namespace {

Curves curves_of(const std::vector<RayRim>& rims) {
  Curves curves;
  for (const RayRim& rim : rims) {
    curves.emplace_back();
    for (const RimRay& ray : rim.rays) curves.back().push_back(ray.ray.at(ray.depth));
    curves.back().push_back(curves.back().front());
  }
  return curves;
}

// The samples of a field that a surface inside it is sought at: near it or inside it.
constexpr double kAbove = 3;  // cells
constexpr float kBeyond = 4;  // times that: what is farther outside

// Nothing near and in the hull, for another surface's distances to take its place.
Grid3<float> laid_bare(const Grid3<float>& hull) {
  Grid3<float> bare = hull;
  for (float& v : bare.values)
    if (v < kAbove * hull.cell) v = std::numeric_limits<float>::lowest();
  return bare;
}

// f's distance near and in the hull.
Grid3<float> near_hull(const HermiteSurface& f, const Grid3<float>& hull) {
  Grid3<float> field = laid_bare(hull);
  raise([&](const Vec3& start, const Vec3& step, int n, float* v) { f.values(start, step, n, v); },
        kAbove * hull.cell, field);
  return field;
}

// hull = max(hull, surface)
void cut_to(const Grid3<float>& surface, Grid3<float>& hull) {
  for (std::size_t i = 0; i < hull.values.size(); ++i)
    hull.values[i] = std::max(hull.values[i], surface.values[i]);
}

// The part of the hull that lies inside f, `plain`, bulging `fatness` times as far between the
// rims. What would lose its middle when thinned that much is thinned less.
Grid3<float> plump(const HermiteSurface& f, const std::vector<RayRim>& rims, double radius,
                   double fatness, const Grid3<float>& hull, const Grid3<float>& plain) {
  const Grid3<float> bare = laid_bare(hull);
  const Bulge bulge(curves_of(rims), radius);
  const auto raised = [&](double times) {
    Grid3<float> field = bare;
    const auto rows = [&](const Vec3& start, const Vec3& step, int n, float* values) {
      f.values(start, step, n, values);
      for (int i = 0; i < n; ++i) values[i] -= float((times - 1) * bulge.height(start + i * step));
    };
    raise(rows, kAbove * hull.cell, field);
    return field;
  };
  Grid3<float> field = raised(fatness);
  if (fatness < 1) {
    const auto trimmed = [&](Grid3<float> g) {
      cut_to(hull, g);
      return isosurface(g);
    };
    const Result<Mesh> whole = trimmed(plain);
    for (int tries = 0; whole && tries < 4; ++tries) {
      if (alike(*whole, trimmed(field), hull.cell)) break;
      fatness = (1 + fatness) / 2;
      field = raised(fatness);
    }
  }
  return field;
}

// How much of a part's depth is left to guess: all of it where its views show it from one
// direction, less the more they tell. Outlines that are wrong by a little tell the depth as badly
// as that over the square of the sine between them, so the guess goes with a power of how open the
// depth is: the more they contradict each other, the lower a power. Outlines of rendered figures
// contradict each other by some 0.3 % of the part's radius, those of a hand by 3 to 13 %.
double agreement(double contradiction) {
  constexpr double kMiddle = 0.01;  // the contradiction halfway between 1, for none, and 0
  return 1 / (1 + contradiction * contradiction / (kMiddle * kMiddle));
}
double guessed_share(const Carving& carving, double contradiction) {
  constexpr double kAgreed = 2, kContradicted = 0.6;  // powers
  return std::pow(carving.open_depth,
                  kContradicted + (kAgreed - kContradicted) * agreement(contradiction));
}

// The body that the views suggest which say nothing of its depth: the mean of those that each of
// the part's own outlines alone would be inflated to, so that outlines that contradict each other
// meet in the middle. True up to kAbove outside the hull.
Grid3<float> guessed(const Carving& carving, const Part& part, const Grid3<float>& hull) {
  const float above = float(kAbove * hull.cell);
  Grid3<float> bare = hull, sum = hull;
  for (float& v : bare.values)
    v = v < above ? std::numeric_limits<float>::lowest() : kBeyond * above;
  std::fill(sum.values.begin(), sum.values.end(), 0.0f);
  const auto own = std::count_if(carving.views.begin(), carving.views.end(),
                                 [](const Silhouette& s) { return !s.view->mirrored; });
  for (const Silhouette& silhouette : carving.views) {
    if (silhouette.view->mirrored) continue;
    Grid3<float> body = bare;
    inflate(silhouette, part.bones, carving.centre, part.fatness, body);
    for (std::size_t i = 0; i < body.values.size(); ++i)
      sum.values[i] += body.values[i] / float(own);
  }
  return sum;
}

// Views up to which each gives all its rays.
constexpr double kFullViews = 3;

// Indices of the views whose rims are sought. A mirrored outline from a direction that another one
// has already seen adds nothing but the doubt whether both are right.
std::vector<int> views_to_ask(const Carving& carving) {
  std::vector<int> asked;
  constexpr double kLeastTrust = 0.05;  // less weighs nothing
  const auto seen = [&](const Silhouette& view) {
    return std::any_of(asked.begin(), asked.end(), [&](int other) {
      return sin2_between(carving.views[other].direction, view.direction) <= kOneDirection;
    });
  };
  for (int v = 0; v < int(carving.views.size()); ++v) {
    const Silhouette& view = carving.views[v];
    if (view.trust > kLeastTrust && !(view.view->mirrored && seen(view))) asked.push_back(v);
  }
  return asked;
}

// How much a view's rim is left to guess.
double doubt_of(const Carving& carving, int view) {
  double most = 0;
  for (const Silhouette& other : carving.views)
    most = std::max(most, sin2_between(carving.views[view].direction, other.direction));
  return 1 - most;
}

// The rays of all rims, at depths that the hull and the middle sheet suggest.
std::vector<RayRim> first_rims(const Carving& carving, const Part& part, const Box3& box,
                               double rays_of_three) {
  std::vector<RayRim> rims;
  const std::vector<int> asked = views_to_ask(carving);
  // The rims' equations are dense: with many views each gives fewer rays.
  const double share = std::min(1.0, kFullViews / double(asked.size()));
  const int rays = int(std::clamp(share * rays_of_three, 16.0, 96.0));
  for (const int v : asked) {
    const PartView& view = *carving.views[v].view;
    const MiddleSheet sheet = middle_sheet(view, part.bones, carving.centre);
    for (RayRim& rim : outline_rays(carving.views[v], rays)) {
      rim.view = v;
      rim.doubt = doubt_of(carving, v);
      for (RimRay& ray : rim.rays)
        ray.sheet = view.camera.ray(ray.pixel).depth_at(sheet.depth(ray.pixel));
      choose_depths(carving, box, rim);
      rims.push_back(std::move(rim));
    }
  }
  return rims;
}

// Whether a surface leaves next to nothing of the hull, as happens where views contradict each
// other: the hull is better.
bool leaves_nothing(const Grid3<float>& surface, const Grid3<float>& hull, double expected = 0) {
  constexpr double kLeast = 0.35, kAtAll = 0.02;  // shares of what is expected, and of the hull
  double in_hull = 0, in_both = 0;
  for (std::size_t i = 0; i < hull.values.size(); ++i) {
    in_hull += hull.values[i] < 0;
    in_both += hull.values[i] < 0 && surface.values[i] < 0;
  }
  return in_both < std::max(kLeast * expected, kAtAll) * in_hull;
}

// Of a blade or a plate the smooth surface may miss the middle, where no outline holds it: it gives
// way to the hull until it has no more holes than that.
void leave_no_holes(const Grid3<float>& hull, double radius, Grid3<float>& surface) {
  constexpr double kThin = 10;  // cells: thicker parts are wide enough between their outlines
  if (radius > kThin * hull.cell) return;
  const auto genus_of = [](const Grid3<float>& field) {
    const Result<Mesh> mesh = isosurface(field);
    return mesh ? topology(*mesh).genus() : std::numeric_limits<int>::max();
  };
  const int given = genus_of(hull);
  for (int tries = 0; tries < 4; ++tries) {
    Grid3<float> trimmed = hull;
    cut_to(surface, trimmed);
    if (genus_of(trimmed) <= given) return;
    for (std::size_t i = 0; i < hull.values.size(); ++i)
      surface.values[i] = (surface.values[i] + hull.values[i]) / 2;
  }
  surface = hull;
}

// max(hull, surface) on a finer hull's samples, where it tells where the surface is: the signs
// alone are right elsewhere.
void cut_finer(const Grid3<float>& surface, Grid3<float>& hull) {
  constexpr int kBlock = 4;
  constexpr double kSteepest = 2;  // what a distance of first order may change by on the way
  const double reach = kSteepest * hull.cell * (kBlock + 1) / 2.0 * std::sqrt(3.0);
  for (int k0 = 0; k0 < hull.size.z(); k0 += kBlock)
    for (int j0 = 0; j0 < hull.size.y(); j0 += kBlock)
      for (int i0 = 0; i0 < hull.size.x(); i0 += kBlock) {
        const Index3 first(i0, j0, k0),
            end = (first + Index3::Constant(kBlock)).cwiseMin(hull.size);
        const auto visit = [&](const auto& at) {
          for (int k = k0; k < end.z(); ++k)
            for (int j = j0; j < end.y(); ++j)
              for (int i = i0; i < end.x(); ++i) at(i, j, k, hull(i, j, k));
        };
        float least = std::numeric_limits<float>::max();
        visit([&](int, int, int, float here) { least = std::min(least, here); });
        if (least >= hull.cell) continue;  // outside, whatever the surface says
        const Vec3 middle =
            hull.origin + hull.cell * (first + end - Index3::Ones()).cast<double>() / 2;
        const double there = sample(surface, middle);
        if (there < -reach) continue;  // inside, where the hull is
        visit([&](int i, int j, int k, float& here) {
          const double cut = there > reach ? there : sample(surface, hull.position(i, j, k));
          here = std::max(here, float(cut));
        });
      }
}

// The smooth surface that trims a part's hull, on the hull's grid. Empty where the hull is better
// alone: as where the rims lie nowhere, before a camera that stands in the figure's midst.
//   rims  filled
Result<Grid3<float>> smooth_surface(const Carving& carving, const Part& part, double contradiction,
                                    const RaysFieldOptions& options, const Grid3<float>& hull,
                                    std::vector<RayRim>& rims, Run& run) {
  if (carving.one_direction()) {
    Grid3<float> body = guessed(carving, part, hull);
    return leaves_nothing(body, hull) ? Grid3<float>() : body;
  }
  const Box3 box = hull.box();
  rims = first_rims(carving, part, box, options.rays_per_cell * options.cells);
  const auto hull_alone = [&] {
    rims.clear();
    return Grid3<float>();
  };
  // The depths are sought on looser and coarser surfaces, which don't fold to pass through points
  // whose depths are still wrong.
  constexpr double kLooser = 40;
  constexpr int kCoarser = 2;
  HermiteOptions fine = options.surface;
  fine.length = carving.radius;
  HermiteOptions rough = fine;
  rough.value_ridge *= kLooser;
  for (int pass = 0; pass < options.refits; ++pass) {
    if (run.cancelled()) return cancelled();
    const std::vector<SurfacePoint> points = surface_points(carving, rims, kCoarser);
    if (int(points.size()) < kFewestSurfacePoints) return hull_alone();
    const HermiteSurface f(points, rough);
    for (RayRim& rim : rims) detect_depths(carving, box, f, rim);
  }
  if (run.cancelled()) return cancelled();
  const std::vector<SurfacePoint> points = surface_points(carving, rims);
  if (int(points.size()) < kFewestSurfacePoints) return hull_alone();
  HermiteSurface f(points, fine);
  Grid3<float> surface = near_hull(f, hull);
  std::vector<Vec3> held;  // f need not pass there, but must not pass beyond
  for (int pass = 0; pass < options.refits; ++pass) {
    if (run.cancelled()) return cancelled();
    const std::vector<Vec3> further = held_back(surface, hull, carving.radius);
    if (further.empty()) break;
    held.insert(held.end(), further.begin(), further.end());
    f = HermiteSurface(points, fine, held);
    surface = near_hull(f, hull);
  }
  if (part.fatness != 1) surface = plump(f, rims, carving.radius, part.fatness, hull, surface);
  // Of a round body's hull by two views the body is π/4 times the sine between them.
  if (part.fatness >= 1 && leaves_nothing(surface, hull, std::sqrt(carving.spread))) surface = hull;
  if (part.fatness >= 1) leave_no_holes(hull, carving.radius, surface);

  constexpr double kLeastAgreed = 0.5;
  constexpr float kLeastGuess = 0.005f;  // moves nothing that a cell would show
  if (const float guess = float(guessed_share(carving, contradiction)); guess > kLeastGuess) {
    Grid3<float> body = guessed(carving, part, hull);
    for (std::size_t i = 0; i < body.values.size(); ++i)
      body.values[i] = surface.values[i] + guess * (body.values[i] - surface.values[i]);
    // Where next to all of the depth is open, so is where along the ray such a thing lies.
    const double told = std::clamp(2 - 4 * double(guess), 0.0, 1.0);
    if (const double agreed = told * agreement(contradiction); agreed > kLeastAgreed)
      keep_what_is_shown(carving, agreed, surface, body);
    if (!leaves_nothing(body, hull)) surface = std::move(body);
  }
  return surface;
}

}  // namespace

Result<RaysField> rays_field(const Part& given, const RaysFieldOptions& options, Run& run) {
  const auto [part, disproportion] = in_proportion(given);
  RaysField out;
  Result<Carving> carving = carving_with_mirrors(part, disproportion, options.cells);
  if (!carving) return carving.error();
  widen_until_they_meet(*carving, out.warnings);
  // Outlines brought to one proportion agree in their lengths, not in who was right.
  constexpr double kStillDoubted = 0.3;  // radii per size
  const double contradiction =
      std::max(swell_until_covered(*carving), kStillDoubted * disproportion);
  // The rims' surface lies inside the hull: next to that alone must the hull's distances be true.
  const double band = carving->one_direction() ? 4 : 1.5;
  Result<Grid3<float>> hull = carve(*carving, std::min(options.cells, kSmoothCells), run, band);
  if (!hull) return hull.error();
  out.distance = std::move(*hull);
  const Result<Grid3<float>> smooth =
      smooth_surface(*carving, part, contradiction, options, out.distance, out.rims, run);
  if (!smooth) return smooth.error();
  if (!smooth->empty()) cut_to(*smooth, out.distance);
  if (options.cells > kSmoothCells) {
    constexpr double kFineBand = 1.5;
    Result<Grid3<float>> fine = carve(*carving, options.cells, run, kFineBand, Beyond::signs);
    if (!fine) return fine.error();
    out.fine = std::move(*fine);
    if (!smooth->empty()) cut_finer(*smooth, out.fine);
  }
  for (const RayRim& rim : out.rims) out.rim_frames.push_back(carving->views[rim.view].view->frame);
  return out;
}

}  // namespace artisketch
