#include "model/rig/snap_rims.h"

#include <cmath>
#include <limits>
#include <numeric>

#include "base/raster.h"
#include "model/consolidate/resolve_self_intersections.h"
#include "model/consolidate/unfold.h"

namespace artisketch {
namespace {

constexpr int kPasses = 3;
constexpr double kDamping = 0.7;  // of a pass
constexpr double kFarthest = 6;   // pixels; outlines farther apart disagree about something else
constexpr double kDoubt = 3;      // pixels at which a pull weighs half
constexpr double kBeside = 1.5;   // pixels beyond the model's outline where nothing of it is left
constexpr double kAligned = 0.5;  // cosine between the two outlines' normals
constexpr double kSmooth = 2;     // weight of the squared Laplacian beside a pull's
constexpr double kStay = 0.3;     // weight of a vertex' own step: it fades out over two rings

// A vertex on the posed model's outline, and what it misses the drawn one by.
struct Pull {
  int vertex;
  double gain;  // pixels toward the drawn outline's outside, per unit along the vertex' normal
  double miss;  // pixels to go that way
};

// One frame, with what is drawn in it.
class Target {
 public:
  Target(const Document& document, int frame, std::span<const Part> parts)
      : pose_(&document.frames[frame].pose),
        camera_(frame_camera(document, frame)),
        shown_(document.skeleton.size(), 0),
        drawn_(document.frames[frame].width, document.frames[frame].height) {
    for (const Part& part : parts)
      for (const PartView& view : part.views)
        if (view.frame == frame && view.seen()) {
          outlines_.push_back(&view.outline);
          shown_[part.joint] = 1;
          add_polygons(closed_contours(document.frames[frame], part.joint), drawn_);
        }
  }
  bool empty() const { return outlines_.empty(); }

  // Lays the model over the frame.
  void pose(const Mesh& mesh, const Weights& weights, const Skeleton& skeleton) {
    posed_ = posed_vertices(mesh.V, weights, skeleton, *pose_);
    pixels_.assign(mesh.V.rows(), Vec2::Constant(std::numeric_limits<double>::quiet_NaN()));
    for (Eigen::Index v = 0; v < posed_.rows(); ++v)
      if (const Vec3 X = posed_.row(v).transpose(); camera_.in_front(X))
        pixels_[v] = camera_.project(X);
    model_ = Mask(drawn_.width, drawn_.height);
    add_surface(pixels_, mesh.F, model_);
  }
  double overlap() const { return intersection_over_union(model_, drawn_); }

  // After pose(). normals: of the rest surface.
  void add_pulls(const Mesh& mesh, const Points3& normals, const Weights& weights,
                 const Skeleton& skeleton, std::vector<Pull>& pulls) const {
    const std::vector<Transform> motions = skinning_transforms(skeleton, *pose_);
    for (const int v : rim_vertices(mesh)) {
      if (!shown_[weights.joints(v, 0)]) continue;
      Vec3 normal = Vec3::Zero();
      for (int k = 0; k < 4; ++k)
        normal += weights.weights(v, k) *
                  (motions[weights.joints(v, k)].linear() * normals.row(v).transpose());
      const Vec2 way = camera_.jacobian(posed_.row(v).transpose()) * normal;  // pixels per unit
      if (!(way.norm() > 0) || covered(pixels_[v] + kBeside * way.normalized())) continue;
      Vec2 outward;
      const double distance = drawn_distance(pixels_[v], outward);
      if (std::abs(distance) > kFarthest || outward.dot(way) < kAligned * way.norm()) continue;
      pulls.push_back({v, outward.dot(way), -distance});
    }
  }

 private:
  // The vertices between triangles that face the camera and triangles that face away.
  std::vector<int> rim_vertices(const Mesh& mesh) const {
    std::vector<std::uint8_t> sides(mesh.V.rows(), 0);
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
      const Vec2 &a = pixels_[mesh.F(f, 0)], &b = pixels_[mesh.F(f, 1)], &c = pixels_[mesh.F(f, 2)];
      const double area = cross(b - a, c - a);
      for (int k = 0; k < 3; ++k) sides[mesh.F(f, k)] |= area < 0 ? 1 : area > 0 ? 2 : 0;
    }
    std::vector<int> rim;
    for (int v = 0; v < int(sides.size()); ++v)
      if (sides[v] == 3) rim.push_back(v);
    return rim;
  }
  bool covered(const Vec2& p) const {
    return p.x() >= 0 && p.y() >= 0 && p.x() < model_.width && p.y() < model_.height &&
           model_.at(int(p.x()), int(p.y()));
  }
  // Signed distance to the outline of all that is drawn, in pixels: true outside and near it.
  double drawn_distance(const Vec2& p, Vec2& outward) const {
    double least = std::numeric_limits<double>::infinity();
    for (const PolygonDistance* outline : outlines_) {
      if (outline->box().exteriorDistance(p) > std::min(least, kFarthest)) continue;
      Vec2 gradient;
      const double d = outline->distance(p, gradient);
      if (d < least) least = d, outward = gradient;
    }
    return least;
  }

  const Pose* pose_;
  FrameCamera camera_;
  std::vector<const PolygonDistance*> outlines_;
  std::vector<char> shown_;  // by joint: whether its part is outlined here
  Mask drawn_, model_;
  Points3 posed_;
  std::vector<Vec2> pixels_;
};

double overlap(const std::vector<Target>& targets) {
  double sum = 0;
  for (const Target& target : targets) sum += target.overlap();
  return sum;
}

// The normal equations of what the pulls ask for and of as little bending as may be, which is
// measured by the umbrella operator L: a vertex' difference from the mean of those round it.
class Equations {
 public:
  Equations(const Adjacency& adjacency, const std::vector<Pull>& pulls, double pixels_per_unit)
      : adjacency_(adjacency),
        diagonal_(Eigen::VectorXd::Constant(Eigen::Index(adjacency.offsets.size()) - 1, kStay)),
        right_(Eigen::VectorXd::Zero(diagonal_.size())) {
    for (const Pull& pull : pulls) {
      const double gain = pull.gain / pixels_per_unit;
      const double weight = 1 / (1 + (pull.miss / kDoubt) * (pull.miss / kDoubt));
      diagonal_[pull.vertex] += weight * gain * gain;
      right_[pull.vertex] += weight * gain * pull.miss;
    }
  }
  // How far each vertex steps along its normal, pixels: by conjugate gradients (Hestenes and
  // Stiefel 1952), without the matrix, whose products of neighbours are many.
  Eigen::VectorXd solve() const {
    constexpr double kTolerance = 1e-3;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(right_.size()), residual = right_, way = residual;
    double left = dot(residual, residual);
    const double enough = kTolerance * kTolerance * left;
    for (Eigen::Index i = 0; i < right_.size() && left > enough; ++i) {
      const Eigen::VectorXd product = times(way);
      const double step = left / dot(way, product);
      x += step * way;
      residual -= step * product;
      const double now = dot(residual, residual);
      way = residual + (now / left) * way;
      left = now;
    }
    return x;
  }

 private:
  // One by one, so that the sum is the same on every machine.
  static double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  }
  Eigen::VectorXd times(const Eigen::VectorXd& x) const {
    Eigen::VectorXd y = diagonal_.cwiseProduct(x), bend = x;
    for (int v = 0; v < int(x.size()); ++v) {
      const auto ring = adjacency_.of(v);
      double sum = 0;
      for (const int u : ring) sum += x[u];
      if (!ring.empty()) bend[v] -= sum / double(ring.size());
    }
    for (int v = 0; v < int(x.size()); ++v) {
      const auto ring = adjacency_.of(v);
      y[v] += kSmooth * bend[v];
      for (const int u : ring) y[u] -= kSmooth * bend[v] / double(ring.size());
    }
    return y;
  }

  const Adjacency& adjacency_;
  Eigen::VectorXd diagonal_, right_;
};

}  // namespace

void snap_rims(const Document& calibrated, std::span<const Part> parts, const Weights& weights,
               Mesh& mesh, Run& run) {
  std::vector<Target> targets;
  for (int f = 0; f < int(calibrated.frames.size()); ++f)
    if (Target target(calibrated, f, parts); !target.empty()) targets.push_back(std::move(target));
  if (targets.empty()) return;
  const Skeleton& skeleton = calibrated.skeleton;
  const auto lay = [&](const Mesh& over) {
    for (Target& target : targets) target.pose(over, weights, skeleton);
    return overlap(targets);
  };
  const int folded = int(folds(mesh, face_neighbours(mesh.F)).size());
  double best = lay(mesh);
  Mesh moved = mesh;
  for (int pass = 0; pass < kPasses && !run.cancelled(); ++pass) {
    const Points3 normals = vertex_normals(moved);
    std::vector<Pull> pulls;
    for (const Target& target : targets) target.add_pulls(moved, normals, weights, skeleton, pulls);
    if (pulls.empty()) break;
    const double pixel = pixel_size(calibrated);
    const Adjacency adjacency = vertex_adjacency(moved);  // edges may have been flipped
    const Eigen::VectorXd step = kDamping * pixel * Equations(adjacency, pulls, 1 / pixel).solve();
    moved.V += step.asDiagonal() * normals;
    if (const SurfaceFaults left = mend_surface(moved); left.crossings > 0 || left.folds > folded)
      break;
    const double now = lay(moved);
    if (now <= best) break;
    best = now;
    mesh = moved;
  }
}

}  // namespace artisketch
