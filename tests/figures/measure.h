// How far a reconstruction is from the figure it was drawn from.
#pragma once

#include "base/raster.h"
#include "figures.h"
#include "model/stages.h"

namespace artisketch::figures {

// Intersection over union of the figure's inside and a closed mesh's in rest space, sampled on a
// grid with `cells` samples along the longest side of both. Inside the mesh is where its winding
// number is not 0.
double volume_iou(const Figure& figure, const Mesh& rest, int cells = 96);

// What the figure, or a model, covers of a frame when posed. The figure is the union of its rigid
// parts; the model is skinned.
Mask silhouette(const Figure& figure, const Pose& pose, const FrameCamera& camera, int width,
                int height);
Mask silhouette(const Model& model, const Pose& pose, const FrameCamera& camera, int width,
                int height);

// The mean intersection over union of the figure's silhouettes and the model's in six poses, and
// from sides, that no seed's drawings have.
double unseen_silhouettes(const Figure& figure, const Model& model, const FrameCamera& camera,
                          int width, int height, std::uint64_t seed);

// How far a pose is from the true one, over the joints that carry parts.
struct PoseErrors {
  double joint_px = 0, worst_joint_px = 0;  // of projected joints
  // Mean degrees between the parts' rotations in the world, and what they are made of: how far the
  // bone swings along the image, toward or away from the camera, and turns about itself.
  double angle = 0, in_plane = 0, out_of_plane = 0, twist = 0;
};
PoseErrors pose_errors(const Figure& figure, const FrameCamera& camera, const Pose& truth,
                       const Pose& other);

// Adds a share of one to the sum; of the worst joints the worst counts.
void add(PoseErrors& sum, const PoseErrors& one, double share);

}  // namespace artisketch::figures
