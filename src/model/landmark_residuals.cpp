#include "model/landmark_residuals.h"

#include <cmath>

#include <Eigen/LU>

namespace artisketch {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kSteps =
    3;  // towards the landmark: perspective bends it little, the first all but does
constexpr double kRidge = 1e-6;  // of QᵀQ: views from one direction leave the depth open

// The rows of one part's views at a landmark c, in the joint's axes.
struct Rows {
  VectorXd r;  // 2 per view
  MatrixXd Q;  // their derivative by c
  Rows(const RayResiduals::Part& part, const Placement& placement, const Vec3& c, double weight)
      : r(2 * part.views.size()), Q(2 * part.views.size(), 3) {
    for (int v = 0; v < int(part.views.size()); ++v) {
      const RayResiduals::View& view = part.views[v];
      const Transform& to_world = placement.posed[view.frame][part.joint];
      const FrameCamera& camera = placement.cameras[view.frame];
      const Vec3 X = to_world * c;
      const double k = std::sqrt(weight) / view.size;
      r.segment<2>(2 * v) = k * (camera.project(X) - view.centroid);
      Q.middleRows<2>(2 * v) = k * camera.jacobian(X) * to_world.linear();
    }
  }
};

// Their derivative by the part's motions.
MatrixXd motion_rows(const RayResiduals::Part& part, const Placement& placement, const Vec3& c,
                     double weight) {
  MatrixXd J = MatrixXd::Zero(2 * part.views.size(), kMotion * placement.posed.size());
  for (int v = 0; v < int(part.views.size()); ++v) {
    const RayResiduals::View& view = part.views[v];
    const FrameCamera& camera = placement.cameras[view.frame];
    const Vec3 X = placement.posed[view.frame][part.joint] * c;
    const double k = std::sqrt(weight) / view.size;
    const Eigen::Matrix<double, 2, 3> P = k * camera.jacobian(X);
    const int at = kMotion * view.frame;
    for (int i = 0; i < 2; ++i) {
      const Vec3 by_point = P.row(i).transpose();
      J.block<1, 3>(2 * v + i, at) = X.cross(by_point).transpose();
      J.block<1, 3>(2 * v + i, at + 3) = by_point.transpose();
    }
    if (camera.camera.type == Camera::Type::orthographic)
      J.block<2, 1>(2 * v, at + 6) = k * (camera.project(X) - camera.principal_point);
  }
  return J;
}

bool all_in_front(const RayResiduals::Part& part, const Placement& placement, const Vec3& c) {
  for (const RayResiduals::View& view : part.views)
    if (!placement.cameras[view.frame].in_front(placement.posed[view.frame][part.joint] * c))
      return false;
  return true;
}

}  // namespace

double landmark_energy(const RayResiduals& residuals, const Skeleton& skeleton,
                       const Placement& placement, const LandmarkLoss& loss,
                       std::vector<std::pair<int, MotionSystem>>* systems) {
  double energy = 0;
  if (loss.centroid <= 0) return energy;
  for (const RayResiduals::Part& part : residuals.parts()) {
    const bool has_bone = !skeleton.children(part.joint).empty();
    const double pull = has_bone ? loss.bone / (part.radius * part.radius) : 0;
    Vec3 c = part.middle(placement);
    if (!all_in_front(part, placement, c)) continue;
    Mat3 QQ;
    for (int i = 0; i < kSteps; ++i) {
      const Rows rows(part, placement, c, loss.centroid);
      QQ = rows.Q.transpose() * rows.Q;
      QQ.diagonal().array() += kRidge * QQ.trace() + pull;
      const Vec3 next = c - QQ.inverse() * (rows.Q.transpose() * rows.r + pull * (c - part.bone));
      if (!all_in_front(part, placement, next)) break;
      c = next;
    }
    const Rows rows(part, placement, c, loss.centroid);
    energy += rows.r.squaredNorm() + pull * (c - part.bone).squaredNorm();
    if (!systems) continue;
    const MatrixXd J = motion_rows(part, placement, c, loss.centroid);
    const MatrixXd JQ = J.transpose() * rows.Q;
    MotionSystem system;
    system.H = J.transpose() * J - JQ * QQ.inverse() * JQ.transpose();
    system.g = J.transpose() * rows.r;
    systems->emplace_back(part.joint, std::move(system));
  }
  return energy;
}

}  // namespace artisketch
