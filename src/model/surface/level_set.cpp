// The level set of section 3 and the appendix. How we read it:
//
// - Region (Chan and Vese 2001). Each view says of every sample how likely it lies inside the
//   back-projected silhouette: 1 inside, 0 outside, a ramp of two cells between. The views are
//   independent witnesses, so the image to be cut in two is their joint probability f = Π p_v^w_v,
//   and the force outward is ((f − c₂)² − (f − c₁)²) / (c₁ − c₂)², where c₁ and c₂ are the means of
//   f inside and outside, over the band. (Summed instead of multiplied, two views would outvote a
//   third, which is not what a silhouette means.)
// - Edge (geodesic active contour, Caselles et al. 1997, driven by gradient vector flow, Xu and
//   Prince 1998, as Paragios et al. 2004 join them). Each view's edge map is a ridge along its
//   lines, closed and open ones; its flow is found in the plane of the drawing and back-projected
//   across the view's rays. The force outward is Σ w_v V_v · n − kBending g κ, where
//   g = 1 / (1 + Σ w_v e_v) lets the surface bend at the lines.
// - Weights: w_v shares one vote among views that look along one line; the options weigh region
//   against edge.
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/narrow_band.h"
#include "base/vector_flow.h"
#include "model/stages.h"

namespace artisketch {
namespace {

constexpr double kBending = 0.25;      // of curvature beside the flow
constexpr double kLeastBelief = 0.02;  // a view that says "outside" may still be wrong
constexpr float kBeyondHull = 0.5f;    // cells: farther out nothing is known, and the grid ends

// One view's drawing, ready to be asked.
struct ViewFields {
  const PartView* view;
  double weight;
  SampledDistance outline;  // pixels; empty where the view has open lines alone
  VectorFlow flow;
};

// Views that look along one line, from either end, share the weight of one.
std::vector<double> view_weights(const Part& part, const Vec3& at) {
  std::vector<Vec3> directions;
  for (const PartView& view : part.views)
    directions.push_back(view.ray(view.project(at)).direction);
  std::vector<double> weights;
  for (const Vec3& d : directions) {
    double alike = 0;
    for (const Vec3& e : directions) alike += std::pow(d.dot(e), 16);  // half at 17° apart
    weights.push_back(1 / alike);
  }
  return weights;
}

std::vector<ViewFields> view_fields(const Part& part, const Grid3<float>& grid) {
  const Vec3 middle = grid.box().center();
  const std::vector<double> weights = view_weights(part, middle);
  std::vector<ViewFields> fields;
  for (std::size_t v = 0; v < part.views.size(); ++v) {
    const PartView& view = part.views[v];
    if (!view.camera.in_front(view.to_world * middle)) continue;  // its pixels have no size there
    const double cell_pixels = grid.cell * view.pixels_per_unit(middle);
    std::vector<VectorFlow::Segment> segments;
    for (const Polyline& line : view.contours)
      for (std::size_t s = 0; s < line.segments(); ++s)
        segments.emplace_back(line.points[s], line.end_of(s));
    // Half-cell steps: a bilinear raster then rounds corners by less than the grid does.
    fields.push_back({&view, weights[v],
                      SampledDistance(view.outline, 2 / cell_pixels, 4 * cell_pixels),
                      VectorFlow(segments, cell_pixels)});
  }
  return fields;
}

class Forces {
 public:
  Forces(const Part& part, const Grid3<float>& hull, const LevelSetOptions& options)
      : options_(options),
        hull_(hull),
        views_(view_fields(part, hull)),
        answer_at_(hull.values.size(), -1) {
    for (const ViewFields& view : views_) all_weights_ += view.weight;
  }

  // The longest stable step: forces change by at most their weight over a cell, and curvature
  // spreads like heat.
  double time_step() const {
    const double steepest = options_.region + options_.edge * all_weights_;
    return 0.9 / (steepest + 6 * options_.edge * kBending);
  }

  // Where the hull is that of widened contours, no sample lies inside all the drawn ones: then the
  // hull stands for them.
  void trust_hull_if_views_disagree(const NarrowBand& band) {
    find_means(band);
    if (inside_ >= 0.5) return;
    views_disagree_ = true;
    answers_.clear();
    std::fill(answer_at_.begin(), answer_at_.end(), -1);
  }

  // Outward forces at the surface, one for each front cell of the band.
  void operator()(const NarrowBand& band, std::vector<float>& forces) {
    find_means(band);
    at_cell_.clear();
    for (const NarrowBand::Front& f : band.front()) {
      const Answer& a = answer(f.index);
      const double region = (2 * a.inside - inside_ - outside_) / (inside_ - outside_);
      const double edge =
          a.flow.cast<double>().dot(f.normal) - kBending * a.stop * band.curvature(f);
      at_cell_.push_back(
          float(options_.region * std::clamp(region, -1.0, 1.0) + options_.edge * edge));
    }
    forces.clear();
    for (int f = 0; f < int(at_cell_.size()); ++f)
      forces.push_back(float(band.at_surface(f, at_cell_)));
  }

 private:
  // What the views say of one sample.
  struct Answer {
    float inside;          // f
    float stop;            // g
    Eigen::Vector3f flow;  // Σ w_v V_v
  };

  const Answer& answer(int index) {
    int& at = answer_at_[index];
    if (at < 0) {
      at = int(answers_.size());
      answers_.push_back(ask_views(index));
    }
    return answers_[at];
  }

  static double log_belief(double distance) {
    return std::log(std::clamp(0.5 - distance / 2, kLeastBelief, 1.0));
  }

  Answer ask_views(int index) const {
    const int nx = hull_.size.x(), ny = hull_.size.y();
    const Vec3 p = hull_.position(index % nx, index / nx % ny, index / nx / ny);
    double belief = 0, edges = 0;
    Vec3 flow = Vec3::Zero();
    for (const ViewFields& v : views_) {
      const Vec3 X = v.view->to_world * p;
      if (!v.view->camera.in_front(X)) continue;
      const Vec2 pixel = v.view->camera.project(X);
      const double scale = v.view->camera.pixels_per_unit(X.z());
      if (!v.outline.empty())
        belief += v.weight *
                  log_belief(v.outline.distance(pixel) / (scale * hull_.cell) - options_.grown);
      const VectorFlow::Value at_pixel = v.flow.at(pixel);
      edges += v.weight * at_pixel.edge;
      const Vec3 in_world = v.view->camera.jacobian(X).transpose() * (at_pixel.flow / scale);
      flow += v.weight * (v.view->to_world.linear().transpose() * in_world);
    }
    if (views_disagree_) belief = log_belief(hull_.values[index] / hull_.cell - options_.grown);
    return {float(std::exp(belief)), float(1 / (1 + edges)), flow.cast<float>()};
  }

  void find_means(const NarrowBand& band) {
    double sum[2] = {0, 0};
    int n[2] = {0, 0};
    for (const NarrowBand::Cell& cell : band.cells()) {
      const int out = band.phi().values[cell.index] >= 0;
      sum[out] += answer(cell.index).inside;
      ++n[out];
    }
    inside_ = n[0] ? sum[0] / n[0] : 1;
    outside_ = n[1] ? sum[1] / n[1] : 0;
    if (inside_ - outside_ >= 0.1) return;
    // Means that fall together tell nothing apart.
    inside_ = std::min(inside_, 0.49);
    outside_ = inside_ - 0.1;
  }

  const LevelSetOptions& options_;
  const Grid3<float>& hull_;
  std::vector<ViewFields> views_;
  double all_weights_ = 0;
  bool views_disagree_ = false;
  double inside_ = 1, outside_ = 0;  // c₁, c₂
  std::vector<int> answer_at_;       // by sample: its answer, once asked
  std::vector<Answer> answers_;
  std::vector<float> at_cell_;
};

}  // namespace

Result<Grid3<float>> level_set(const Part& part, const Grid3<float>& hull,
                               const LevelSetOptions& options, Run& run) {
  Grid3<float> phi = hull;
  for (float& v : phi.values) v = v / float(hull.cell) - float(options.grown);
  NarrowBand band(std::move(phi), std::max(options.band, 2.0));
  Forces forces(part, hull, options);
  forces.trust_hull_if_views_disagree(band);
  const float most_grown = float(options.grown) + kBeyondHull;
  const auto least = [&](int index) { return hull.values[index] / float(hull.cell) - most_grown; };
  const double dt = forces.time_step();
  std::vector<float> way;
  for (int i = 0; i < options.iterations && !band.front().empty(); ++i) {
    if (run.cancelled()) return cancelled();
    forces(band, way);
    for (float& w : way) w *= float(dt);
    band.move(way, least);
    run.report((i + 1.0) / options.iterations);
  }
  band.lay();
  Grid3<float> field = band.phi();
  for (float& v : field.values) v *= float(hull.cell);
  return field;
}

}  // namespace artisketch
