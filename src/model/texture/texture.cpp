// The drawings' colours on the model: the view that shows a triangle best paints it, views fade
// into each other where they meet, and what none shows takes the colours of its own part.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/raster.h"
#include "model/texture/atlas.h"
#include "model/texture/details.h"
#include "model/texture/on_paper.h"
#include "model/texture/unlikeness.h"
#include "model/texture/unseen.h"

namespace artisketch {
namespace {

constexpr int kFadeRounds = 2;        // rings of triangles over which views fade into each other
constexpr double kPlainScale = 0.35;  // texels of what no view shows, per pixel: it has no detail

// How much each view has of the paint at each vertex, #V×#views; what is missing to 1 is the
// vertex' own plain colour.
class Fades {
 public:
  Fades(const Mesh& mesh, const Adjacency& beside, const std::vector<int>& chosen,
        const DrawnSurface& surface)
      : views_(int(surface.views.size())) {
    const Eigen::Index n = mesh.V.rows();
    // A view may fade in only where it shows everything round the vertex.
    Eigen::ArrayXXf open = Eigen::ArrayXXf::Ones(views_, n);
    share_.setZero(views_, n);
    for (int f = 0; f < mesh.F.rows(); ++f)
      for (int k = 0; k < 3; ++k) {
        for (int v = 0; v < views_; ++v)
          if (surface.views[v].quality[f] <= 0) open(v, mesh.F(f, k)) = 0;
        if (chosen[f] >= 0) share_(chosen[f], mesh.F(f, k)) += 1;
      }
    normalise(open);
    for (int round = 0; round < kFadeRounds; ++round) {
      const Eigen::ArrayXXf before = share_;
      for (int i = 0; i < n; ++i)
        for (const int j : beside.of(i)) share_.col(i) += before.col(j);
      normalise(open);
    }
  }
  int views() const { return views_; }
  float share(int view, int vertex) const { return share_(view, vertex); }

 private:
  void normalise(const Eigen::ArrayXXf& open) {
    share_ *= open;
    for (Eigen::Index v = 0; v < share_.cols(); ++v)
      if (const float sum = share_.col(v).sum(); sum > 0) share_.col(v) /= sum;
  }
  int views_;
  Eigen::ArrayXXf share_;
};

// The colours of one triangle after another.
class Painter {
 public:
  Painter(const Mesh& mesh, const DrawnSurface& surface, const Fades& fades,
          const PlainPaint& plain)
      : mesh_(mesh), surface_(surface), fades_(fades), plain_(plain) {}

  void begin(int face) {
    face_ = face;
    views_.clear();
    begin_plain();
    for (int v = 0; v < fades_.views(); ++v) {
      View view{v, {}};
      for (int k = 0; k < 3; ++k) view.shares[k] = fades_.share(v, mesh_.F(face, k));
      if (view.shares.maxCoeff() > kLeastShare) views_.push_back(view);
    }
  }
  Rgb at(const Vec3& weights) const {
    if (!surface_.palette.empty()) return unmixed(weights);
    Rgb sum = Rgb::Zero();
    float all = 0;
    for (const View& view : views_) {
      const float share = view.shares.dot(weights.cast<float>());
      if (share <= kLeastShare) continue;
      const SurfaceView& shown = surface_.views[view.index];
      if (const auto c = shown.colour(surface_.sketches, mesh_.F, face_, weights)) {
        sum += share * *c;
        all += share;
      }
    }
    if (all >= 1 - 1e-3f) return sum / all;
    return sum + (1 - all) * plain(weights);
  }

 private:
  static constexpr float kLeastShare = 1e-4f;
  static constexpr float kOneKind = 0.12f;  // unlikeness of shades of one colour
  static constexpr double kSoft = 0.3;      // of a share: a border this soft shows no steps
  int kind_of(const Rgb& colour) const {
    for (const Plain& one : plains_)
      if (unlikeness(*one.colour, colour) < kOneKind) return one.kind;
    return int(plains_.size());
  }
  // The colours that the corners' parts may have where no view paints.
  void begin_plain() {
    plains_.clear();
    for (int k = 0; k < 3; ++k) {
      const int v = mesh_.F(face_, k), part = plain_.part[v];
      if (part < 0) continue;
      for (int l = 0; l < int(plain_.palettes[part].size()); ++l) {
        const Rgb* colour = &plain_.palettes[part][l];
        auto same = std::find_if(plains_.begin(), plains_.end(),
                                 [&](const Plain& one) { return one.colour == colour; });
        if (same == plains_.end())
          same = plains_.insert(
              same, {colour, kind_of(*colour), Vec3::Zero(), {*colour, *colour, *colour}});
        same->shares[k] = plain_.share[v][l];
        if (plain_.own[v] == l) same->tones[k] = plain_.colour[v];
      }
    }
  }
  // The colour that has the most; shades of one colour count together and run into each other.
  Rgb plain(const Vec3& weights) const {
    std::array<double, 3 * PlainPaint::kMostColours> kinds = {};
    double most = -1;
    for (const Plain& one : plains_) {
      kinds[one.kind] += one.shares.dot(weights);
      most = std::max(most, kinds[one.kind]);
    }
    Rgb sum = Rgb::Zero();
    double all = 0;
    for (const Plain& one : plains_) {
      const double kind = kinds[one.kind], sure = kind - most + kSoft;
      if (!(kind > 0 && sure > 0)) continue;
      const Vec3 w = sure / kind * one.shares.cwiseProduct(weights);
      for (int k = 0; k < 3; ++k) sum += float(w[k]) * one.tones[k];
      all += w.sum();
    }
    return all > 0 ? Rgb(sum / float(all)) : plain_.usual;
  }
  // Pixel art: the colour of the view that has most of the paint, else the nearest in the palette.
  Rgb unmixed(const Vec3& weights) const {
    std::optional<Rgb> best;
    float most = 0, all = 0;
    for (const View& view : views_) {
      const float share = view.shares.dot(weights.cast<float>());
      all += std::max(share, 0.0f);
      if (share <= std::max(most, kLeastShare)) continue;
      const SurfaceView& shown = surface_.views[view.index];
      if (const auto c = shown.colour(surface_.sketches, mesh_.F, face_, weights)) {
        best = c;
        most = share;
      }
    }
    if (best && all >= 0.5f) return *best;
    const Rgb like = plain(weights);
    return *std::min_element(surface_.palette.begin(), surface_.palette.end(),
                             [&](const Rgb& a, const Rgb& b) {
                               return (a - like).squaredNorm() < (b - like).squaredNorm();
                             });
  }
  struct View {
    int index;
    Eigen::Vector3f shares;  // at the triangle's corners
  };
  const Mesh& mesh_;
  const DrawnSurface& surface_;
  const Fades& fades_;
  struct Plain {
    const Rgb* colour;
    int kind;                  // the first that it may be a shade of
    Vec3 shares;               // at the triangle's corners,
    std::array<Rgb, 3> tones;  // and the tone there
  };
  const PlainPaint& plain_;
  int face_ = 0;
  std::vector<View> views_;
  std::vector<Plain> plains_;
};

// The atlas' vertices along the borders of charts.
std::vector<std::uint8_t> border_vertices(const Atlas& atlas, const FaceNeighbours& neighbours) {
  std::vector<std::uint8_t> border(atlas.vertex.size(), 0);
  for (int f = 0; f < atlas.corners.rows(); ++f)
    for (int k = 0; k < 3; ++k)
      if (const int g = neighbours[f][k]; g < 0 || atlas.chart[g] != atlas.chart[f])
        border[atlas.corners(f, k)] = border[atlas.corners(f, (k + 1) % 3)] = 1;
  return border;
}

Image paint(const Atlas& atlas, const FaceNeighbours& neighbours, Painter painter) {
  Image picture(atlas.width, atlas.height, 0);  // without alpha: not yet painted
  const std::vector<std::uint8_t> border = border_vertices(atlas, neighbours);
  // Texels up to so far off a chart are mixed into it: they are painted too, unless another has.
  constexpr double kRound = 0.75;
  for (const bool round : {false, true})
    for (int f = 0; f < atlas.corners.rows(); ++f) {
      const auto corner = atlas.corners.row(f);
      if (round && !(border[corner[0]] || border[corner[1]] || border[corner[2]])) continue;
      const Vec2 &a = atlas.texels[corner[0]], &b = atlas.texels[corner[1]],
                 &c = atlas.texels[corner[2]];
      Box2 box(a);
      box.extend(b).extend(c);
      const double margin = round ? kRound : 0;
      const Vec2 d = b - a, e = c - a;
      const double per_area = 1 / (d.x() * e.y() - d.y() * e.x());
      painter.begin(f);
      for (int y = int(box.min().y() - margin); y <= int(box.max().y() + margin); ++y)
        for (int x = int(box.min().x() - margin); x <= int(box.max().x() + margin); ++x) {
          std::uint8_t* texel = picture.at(x, y);
          if (texel[3] > 0) continue;
          const Vec2 centre(x + 0.5, y + 0.5), p = centre - a;
          const double u = (p.x() * e.y() - p.y() * e.x()) * per_area,
                       v = (d.x() * p.y() - d.y() * p.x()) * per_area;
          Vec3 weights(1 - u - v, u, v);
          if (round) {
            weights = corner_weights(centre, a, b, c, Vec3::Ones());
            const Vec2 nearest = weights[0] * a + weights[1] * b + weights[2] * c;
            if (!((nearest - centre).norm() <= kRound)) continue;
          } else if (!(weights.minCoeff() >= 0)) {
            continue;
          }
          const Rgb colour = painter.at(weights);
          for (int k = 0; k < 3; ++k)
            texel[k] = std::uint8_t(255 * std::clamp(colour[k], 0.0f, 1.0f) + 0.5f);
          texel[3] = 255;
        }
    }
  fill_gutters(picture);
  return picture;
}

// Per frame, the share of the surface that its drawing paints, as it is or mirrored.
std::vector<double> shares_of(const Mesh& mesh, const std::vector<int>& chosen,
                              const DrawnSurface& surface, std::size_t frames) {
  std::vector<double> shares(frames, 0.0);
  double all = 0;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    const Vec3 a = mesh.V.row(mesh.F(f, 0)), b = mesh.V.row(mesh.F(f, 1)),
               c = mesh.V.row(mesh.F(f, 2));
    const double area = (b - a).cross(c - a).norm();
    all += area;
    if (chosen[f] < 0) continue;
    const SurfaceView& view = surface.views[chosen[f]];
    shares[surface.sketches[view.sketch].frame] += area;
  }
  for (double& share : shares) share /= std::max(all, std::numeric_limits<double>::min());
  return shares;
}

}  // namespace

Result<Model> textured(const Document& calibrated, std::span<const Image> drawings,
                       const Model& model, Run& run, std::vector<double>* shares) {
  const std::vector<Image> laid = laid_on_paper(drawings);
  if (!laid.empty()) drawings = laid;
  Result<DrawnSurface> surface = drawn_surface(calibrated, drawings, model, run);
  if (!surface) return surface.error();
  const FaceNeighbours neighbours = face_neighbours(model.mesh.F);
  keep_details_once(model.mesh, neighbours, *surface);
  const std::vector<int> chosen = choose_views(model.mesh, neighbours, *surface);
  if (std::all_of(chosen.begin(), chosen.end(), [](int view) { return view < 0; })) return model;
  if (shares) *shares = shares_of(model.mesh, chosen, *surface, calibrated.frames.size());
  if (run.cancelled()) return cancelled();
  run.report(0.7);
  const Adjacency beside = vertex_adjacency(model.mesh);
  const Fades fades(model.mesh, beside, chosen, *surface);
  const PlainPaint plain = plain_paint(model, beside, chosen, *surface);
  const Atlas atlas =
      make_atlas(model.mesh, neighbours, chosen, *surface, kPlainScale / pixel_size(calibrated));
  if (run.cancelled()) return cancelled();
  run.report(0.8);

  Model out = model;
  const Eigen::Index n = Eigen::Index(atlas.vertex.size());
  out.mesh.V.resize(n, 3);
  out.mesh.F = atlas.corners;
  out.weights.joints.resize(n, 4);
  out.weights.weights.resize(n, 4);
  out.texcoords.clear();
  for (Eigen::Index i = 0; i < n; ++i) {
    out.mesh.V.row(i) = model.mesh.V.row(atlas.vertex[i]);
    out.weights.joints.row(i) = model.weights.joints.row(atlas.vertex[i]);
    out.weights.weights.row(i) = model.weights.weights.row(atlas.vertex[i]);
    out.texcoords.push_back(atlas.texels[i].cwiseQuotient(Vec2(atlas.width, atlas.height)));
  }
  out.texture = paint(atlas, neighbours, Painter(model.mesh, *surface, fades, plain));
  run.report(1);
  return out;
}

}  // namespace artisketch
