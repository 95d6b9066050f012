#include "model/ray_residuals.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

namespace artisketch {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// What one frame's camera sees of a part at the poses tried.
struct Placed {
  const RayResiduals::View* view;
  FrameCamera camera;
  Transform to_world;  // joint's axes → world
};

// A ray of another frame as one view sees it: at depth λ the pixel is
// principal point + (a + λ b) / (w + λ c).
struct SeenRay {
  Vec2 a, b;
  double w = 1, c = 0;
  Vec2 principal_point;

  SeenRay(const FrameCamera& camera, const Vec3& o, const Vec3& d)
      : principal_point(camera.principal_point) {
    if (camera.camera.type == Camera::Type::orthographic) {
      const double s = camera.pixels_per_unit(0);
      a = Vec2(s * o.x(), -s * o.y());
      b = Vec2(s * d.x(), -s * d.y());
    } else {
      const double f = camera.camera.focal_length;
      a = Vec2(f * o.x(), -f * o.y());
      b = Vec2(f * d.x(), -f * d.y());
      w = camera.camera.distance - o.z();
      c = -d.z();
    }
  }
  bool before_camera(double t) const { return w + t * c > 1e-9; }
  Vec2 pixel(double t) const { return principal_point + (a + t * b) / (w + t * c); }
  Vec2 pixel(double t, Vec2& along) const {
    const double k = 1 / (w + t * c);
    const Vec2 p = (a + t * b) * k;
    along = (b - c * p) * k;
    return principal_point + p;
  }
};

// The views of a part that one ray is compared with, and the search for its best depth.
struct RaySearch {
  std::vector<SeenRay> rays;
  std::vector<const SampledDistance*> outlines;

  double sum(double t) const {
    double total = 0;
    for (std::size_t v = 0; v < rays.size(); ++v) {
      if (!rays[v].before_camera(t)) return kNever;
      const double sd = outlines[v]->distance(rays[v].pixel(t));
      if (sd > 0) total += sd * sd;
    }
    return total;
  }
  // Sum and half its derivative.
  double sum(double t, double& slope) const {
    double total = 0;
    slope = 0;
    for (std::size_t v = 0; v < rays.size(); ++v) {
      if (!rays[v].before_camera(t)) return kNever;
      Vec2 along, gradient;
      const double sd = outlines[v]->distance(rays[v].pixel(t, along), gradient);
      if (sd <= 0) continue;
      total += sd * sd;
      slope += sd * gradient.dot(along);
    }
    return total;
  }

  // Depth of least sum within ±reach: the best of even samples, then the zero of the slope beside
  // it.
  double best(double reach, double& least) const {
    constexpr int kSamples = 13;
    const double step = 2 * reach / (kSamples - 1);
    double at = 0;
    least = kNever;
    // From the middle outward: most rays find their part there.
    for (int i = 0; i < kSamples; ++i) {
      const double t = step * ((i + 1) / 2) * (i % 2 ? 1 : -1);
      const double value = sum(t);
      if (value < least) {
        least = value;
        at = t;
      }
      if (least == 0) return at;
    }
    if (least == kNever) return at;
    double low = at - step, high = at + step;
    double low_slope = 0, high_slope = 0;
    bool have_low = false, have_high = false;
    double t = at;
    for (int i = 0; i < 7; ++i) {
      double slope;
      const double value = sum(t, slope);
      if (value < least) {
        least = value;
        at = t;
      }
      if (least == 0 || slope == 0) break;
      if (slope > 0) {
        high = t;
        high_slope = slope;
        have_high = true;
      } else {
        low = t;
        low_slope = slope;
        have_low = true;
      }
      // False position where both slopes are known, kept off the ends; else halves.
      double w = 0.5;
      if (have_low && have_high)
        w = std::clamp(low_slope / (low_slope - high_slope), 0.1, 0.9);
      t = low + w * (high - low);
    }
    return at;
  }
};

}  // namespace

RayResiduals::RayResiduals(const Document& document, const RayOptions& options)
    : document_(document), options_(options) {
  const auto shared = shared_parts(document);
  const std::vector<Vec3> rest = rest_positions(document.skeleton);
  for (const int joint : drawn_joints(document)) {
    Part part;
    part.joint = joint;
    for (int f = 0; f < frames(); ++f) {
      if (!shared[f][joint]) continue;
      View view;
      view.part = int(parts_.size());
      view.frame = f;
      const std::vector<Polyline> lines = contours_of(document.frames[f], joint);
      std::vector<std::vector<Vec2>> closed;
      double total = 0;
      for (const Polyline& line : lines) {
        if (line.closed) closed.push_back(line.points);
        total += length(line);
      }
      const PolygonDistance exact(closed);
      const double margin = 0.25 * exact.box().sizes().maxCoeff() + 8 * options.pixel;
      view.outline = SampledDistance(exact, std::min(1.0, 160 / (exact.box().sizes().maxCoeff() + 2 * margin)) , margin);
      const double step = total / options.rays_per_contour;
      for (const Polyline& line : lines)
        for (const Vec2& p : resampled(line, step).points) view.points.push_back(p);
      view.weight = total / view.points.size() / options.pixel;
      view.centroid = centroid(lines);
      double area = 0;
      for (const Polyline& line : lines)
        if (line.closed) area += std::abs(signed_area(line));
      view.size = std::sqrt(area);
      const double half = exact.box().sizes().norm() / 2;
      const double per_unit = frame_camera(document, f).pixels_per_unit(
          document.frames[f].pose.root_position.z());
      part.radius = std::max(part.views.empty() ? 0.0 : part.radius, half / per_unit);
      part.views.push_back(std::move(view));
    }
    if (part.views.size() < 2) continue;
    // The landmark's first guess: nearest to the rays through the centroids, pulled slightly to the
    // joint's children's middle.
    Vec3 middle = Vec3::Zero();
    int children = 0;
    for (const int child : document.skeleton.children(joint)) {
      middle += document.skeleton.joints[child].offset / 2;
      ++children;
    }
    if (children) middle /= children;
    part.bone = middle;
    part.has_bone = children > 0;
    Mat3 A = 1e-2 * Mat3::Identity();
    Vec3 b = 1e-2 * middle;
    for (const View& view : part.views) {
      const Transform to_world =
          posed_joints(document.skeleton, document.frames[view.frame].pose)[joint];
      const Ray ray = frame_camera(document, view.frame).ray(view.centroid);
      const Vec3 o = to_world.inverse() * ray.origin;
      const Vec3 d = to_world.linear().transpose() * ray.direction;
      const Mat3 across = Mat3::Identity() - d * d.transpose();
      A += across;
      b += across * o;
    }
    part.landmark = A.inverse() * b;
    parts_.push_back(std::move(part));
  }
}

double RayResiduals::evaluate(const PoseChange& change, const RayLoss& loss,
                              std::vector<std::pair<int, MotionSystem>>* systems) const {
  const Skeleton& skeleton = document_.skeleton;
  std::vector<std::vector<Transform>> posed;
  std::vector<FrameCamera> cameras;
  for (int f = 0; f < frames(); ++f) {
    posed.push_back(posed_joints(skeleton, changed(document_.frames[f].pose, change[f])));
    cameras.push_back(frame_camera(document_, f));
    cameras.back().scale *= std::exp(change[f].log_scale);
  }
  if (systems) systems->clear();
  double energy = 0;
  const double c2 = loss.reach * loss.reach;
  const bool ortho = document_.camera.type == Camera::Type::orthographic;
  for (const Part& part : parts_) {
    MotionSystem system(systems ? frames() : 0);
    const int n = int(part.views.size());
    struct Row {
      int view;
      double r, q, tangent2;
      Vec3 g;  // by the world point
      Vec3 X;
      double by_scale;
    };
    std::vector<Row> rows;
    for (int a = 0; loss.rays && a < n; ++a) {
      const View& from = part.views[a];
      const FrameCamera& camera = cameras[from.frame];
      const Transform& to_world = posed[from.frame][part.joint];
      const Transform from_world = to_world.inverse();
      std::vector<Transform> across;
      std::vector<int> others;
      for (int v = 0; v < n; ++v)
        if (v != a) {
          others.push_back(v);
          across.push_back(posed[part.views[v].frame][part.joint] * from_world);
        }
      const Vec3 middle = to_world * part.landmark;
      RaySearch search;
      for (const Vec2& pixel : from.points) {
        const Ray ray = camera.ray(pixel);
        const double centre = (middle - ray.origin).dot(ray.direction);
        const Vec3 origin = ray.at(centre);
        search.rays.clear();
        search.outlines.clear();
        for (std::size_t i = 0; i < others.size(); ++i) {
          search.rays.emplace_back(cameras[part.views[others[i]].frame], across[i] * origin,
                                   across[i].linear() * ray.direction);
          search.outlines.push_back(&part.views[others[i]].outline);
        }
        double e;
        const double t = search.best(1.3 * part.radius, e);
        if (e == 0) continue;
        if (e == kNever) e = 1e6;
        energy += from.weight * (c2 > 0 ? c2 * e / (c2 + e) : e);
        if (!systems) continue;
        const double w = from.weight * (c2 > 0 ? (c2 / (c2 + e)) * (c2 / (c2 + e)) : 1.0);
        rows.clear();
        double depth = 0;  // second derivative by the depth
        for (std::size_t i = 0; i < others.size(); ++i) {
          const SeenRay& seen = search.rays[i];
          if (!seen.before_camera(t)) continue;
          Vec2 along, gradient;
          const Vec2 u = seen.pixel(t, along);
          const double sd = search.outlines[i]->distance(u, gradient);
          if (sd <= 0) continue;
          const FrameCamera& other = cameras[part.views[others[i]].frame];
          Row row;
          row.view = int(i);
          row.r = sd;
          row.q = gradient.dot(along);
          row.X = across[i] * ray.at(centre + t);
          row.g = other.jacobian(row.X).transpose() * gradient;
          row.by_scale = gradient.dot(u - other.principal_point);
          // Along its tangent a ray leaves an outline of radius ρ as a parabola does.
          const double rho = 0.25 * part.views[others[i]].size;
          depth += row.q * row.q +
                   sd * std::max(0.0, along.squaredNorm() - row.q * row.q) / (rho + sd);
          rows.push_back(row);
        }
        if (rows.empty()) continue;
        const Vec3 XA = ray.at(centre + t);
        const int fa = kMotion * from.frame;
        Motion qa = Motion::Zero();
        Eigen::Matrix<double, kMotion, kMotion> HA =
            Eigen::Matrix<double, kMotion, kMotion>::Zero();
        Motion gA = Motion::Zero();
        std::vector<std::pair<int, Motion>> qv;
        for (const Row& row : rows) {
          const int fv = kMotion * part.views[others[row.view]].frame;
          Motion mv, ma;
          mv << row.X.cross(row.g), row.g, (ortho ? row.by_scale : 0.0);
          const Vec3 h = across[row.view].linear().transpose() * row.g;
          ma << -XA.cross(h), -h, (ortho ? -(h.x() * XA.x() + h.y() * XA.y()) : 0.0);
          system.H.block<kMotion, kMotion>(fv, fv) += w * mv * mv.transpose();
          system.H.block<kMotion, kMotion>(fv, fa) += w * mv * ma.transpose();
          system.H.block<kMotion, kMotion>(fa, fv) += w * ma * mv.transpose();
          HA += w * ma * ma.transpose();
          system.g.segment<kMotion>(fv) += w * row.r * mv;
          gA += w * row.r * ma;
          qa += row.q * ma;
          qv.emplace_back(fv, row.q * mv);
        }
        system.H.block<kMotion, kMotion>(fa, fa) += HA;
        system.g.segment<kMotion>(fa) += gA;
        if (depth > 1e-12) {
          qv.emplace_back(fa, qa);
          for (const auto& [i, x] : qv)
            for (const auto& [j, y] : qv)
              system.H.block<kMotion, kMotion>(i, j) -= (w / depth) * x * y.transpose();
        }
      }
    }
    if (loss.landmark > 0) {
      // The landmark projected out: c least-squares, then rows less their share in it.
      Vec3 c = part.landmark;
      Eigen::MatrixXd Q(2 * n, 3);
      Eigen::VectorXd r(2 * n), wt(2 * n);
      Mat3 QQ;
      for (int it = 0; it < 3; ++it) {
        for (int v = 0; v < n; ++v) {
          const View& view = part.views[v];
          const Transform& T = posed[view.frame][part.joint];
          const Vec3 X = T * c;
          const double k = std::sqrt(loss.landmark) / view.size;
          r.segment<2>(2 * v) = k * (cameras[view.frame].project(X) - view.centroid);
          Q.middleRows<2>(2 * v) = k * cameras[view.frame].jacobian(X) * T.linear();
        }
        QQ = Q.transpose() * Q;
        QQ.diagonal().array() += 1e-6 * QQ.trace();
        const double pull = part.has_bone ? loss.bone / (part.radius * part.radius) : 0;
        QQ.diagonal().array() += pull;
        c -= QQ.inverse() * (Q.transpose() * r + pull * (c - part.bone));
      }
      energy += r.squaredNorm() + (part.has_bone ? loss.bone / (part.radius * part.radius) : 0) *
                                      (c - part.bone).squaredNorm();
      if (systems) {
        Eigen::MatrixXd J = Eigen::MatrixXd::Zero(2 * n, kMotion * frames());
        for (int v = 0; v < n; ++v) {
          const View& view = part.views[v];
          const Transform& T = posed[view.frame][part.joint];
          const Vec3 X = T * c;
          const double k = std::sqrt(loss.landmark) / view.size;
          const Eigen::Matrix<double, 2, 3> P = k * cameras[view.frame].jacobian(X);
          const int f = kMotion * view.frame;
          for (int i = 0; i < 2; ++i) {
            const Vec3 g = P.row(i).transpose();
            J.block<1, 3>(2 * v + i, f) = X.cross(g).transpose();
            J.block<1, 3>(2 * v + i, f + 3) = g.transpose();
          }
          if (ortho)
            J.block<2, 1>(2 * v, f + 6) =
                k * (cameras[view.frame].project(X) - cameras[view.frame].principal_point);
        }
        const Eigen::MatrixXd JQ = J.transpose() * Q;
        system.H += J.transpose() * J - JQ * QQ.inverse() * JQ.transpose();
        system.g += J.transpose() * r;
      }
    }
    if (systems) systems->emplace_back(part.joint, std::move(system));
  }
  return energy;
}

}  // namespace artisketch
