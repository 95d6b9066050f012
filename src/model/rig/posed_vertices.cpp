// Linear blend skinning, as viewers of glTF do it.
#include "base/ensure.h"
#include "model/stages.h"

namespace artisketch {

Points3 posed_vertices(const Points3& V, const Weights& weights, const Skeleton& skeleton,
                       const Pose& pose) {
  ensure(weights.joints.rows() == V.rows() && weights.weights.rows() == V.rows(),
         "weights for every vertex");
  const std::vector<Transform> move = skinning_transforms(skeleton, pose);
  Points3 posed(V.rows(), 3);
  for (Eigen::Index v = 0; v < V.rows(); ++v) {
    const Vec3 p = V.row(v).transpose();
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 4; ++k)
      if (const double w = weights.weights(v, k); w != 0)
        sum += w * (move[weights.joints(v, k)] * p);
    posed.row(v) = sum.transpose();
  }
  return posed;
}

}  // namespace artisketch
