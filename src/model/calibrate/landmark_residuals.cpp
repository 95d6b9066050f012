#include "model/calibrate/landmark_residuals.h"

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

// Adds the part's linear system with the landmark c projected out: JᵀJ − (JᵀQ)(QᵀQ)⁻¹(JᵀQ)ᵀ. J, the
// rows' derivative by the part's motions, has a block per view, QQ is QᵀQ with its ridge.
void add_rows(const RayResiduals::Part& part, const Placement& placement, const Vec3& c,
              double weight, const Rows& rows, const Mat3& QQ, MotionSystem& system) {
  const int views = int(part.views.size());
  MatrixXd JQ(kMotion * views, 3);
  for (int v = 0; v < views; ++v) {
    const RayResiduals::View& view = part.views[v];
    const FrameCamera& camera = placement.cameras[view.frame];
    const Vec3 X = placement.posed[view.frame][part.joint] * c;
    const double k = std::sqrt(weight) / view.size;
    const Eigen::Matrix<double, 2, 3> P = k * camera.jacobian(X);
    Eigen::Matrix<double, 2, kMotion> J = Eigen::Matrix<double, 2, kMotion>::Zero();
    for (int i = 0; i < 2; ++i) {
      const Vec3 by_point = P.row(i).transpose();
      J.block<1, 3>(i, 0) = X.cross(by_point).transpose();
      J.block<1, 3>(i, 3) = by_point.transpose();
    }
    if (camera.camera.type == Camera::Type::orthographic)
      J.col(6) = k * (camera.project(X) - camera.principal_point);
    const int at = kMotion * view.frame;
    system.H.block<kMotion, kMotion>(at, at) += J.transpose() * J;
    system.g.segment<kMotion>(at) += J.transpose() * rows.r.segment<2>(2 * v);
    JQ.middleRows<kMotion>(kMotion * v) = J.transpose() * rows.Q.middleRows<2>(2 * v);
  }
  const MatrixXd JQinv = JQ * QQ.inverse();
  for (int v = 0; v < views; ++v)
    for (int u = 0; u < views; ++u)
      system.H.block<kMotion, kMotion>(kMotion * part.views[v].frame,
                                       kMotion * part.views[u].frame) -=
          JQinv.middleRows<kMotion>(kMotion * v) * JQ.middleRows<kMotion>(kMotion * u).transpose();
}

bool all_in_front(const RayResiduals::Part& part, const Placement& placement, const Vec3& c) {
  for (const RayResiduals::View& view : part.views)
    if (!placement.cameras[view.frame].in_front(placement.posed[view.frame][part.joint] * c))
      return false;
  return true;
}

}  // namespace

double landmark_energy(const RayResiduals& residuals, const Document& document,
                       const Placement& placement, const LandmarkLoss& loss,
                       MotionSystems* systems) {
  double energy = 0;
  if (loss.centroid <= 0) return energy;
  for (std::size_t number = 0; number < residuals.parts().size(); ++number) {
    const RayResiduals::Part& part = residuals.parts()[number];
    const bool has_bone = !ends_of_bones(document, part.joint).empty();
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
    if (systems) add_rows(part, placement, c, loss.centroid, rows, QQ, (*systems)[number].second);
  }
  return energy;
}

}  // namespace artisketch
