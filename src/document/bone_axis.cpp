#include "document/bone_axis.h"

#include "document/camera.h"

namespace artisketch {

BoneAxis bone_axis(const Document& document, int frame, int joint) {
  const FrameCamera camera = frame_camera(document, frame);
  const std::vector<Transform> posed = posed_joints(document.skeleton, document.frames[frame].pose);
  const auto at = [&](int j) { return camera.project(posed[j].translation()); };
  const std::vector<int> children = document.skeleton.children(joint);
  const int parent = document.skeleton.joints[joint].parent;
  BoneAxis bone{at(joint), Vec2(0, 1), 0};
  const Vec2 d = !children.empty() ? Vec2(at(children[0]) - bone.start)
                 : parent >= 0     ? Vec2(bone.start - at(parent))
                                   : Vec2(0, 1);
  bone.length = d.norm();
  if (bone.length > 1e-6) bone.along = d / bone.length;
  return bone;
}

}  // namespace artisketch
