// A model as the editor holds it, with the document that it was made from and its picture.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "document/document.h"
#include "editor/pictures/model_picture.h"
#include "model/calibrate/unseen_sides.h"
#include "model/stages.h"

namespace artisketch {

struct BuiltModel {
  Model model;
  Document document;  // at the poses that the model was made from
  std::vector<FrameFit> fits;
  UnseenSides unseen_sides;  // how well it will hold from there
  std::vector<std::string> warnings;
  std::string glb;
  Document source;                   // that it was made from
  std::vector<JointSphere> spheres;  // that join its parts
  bool spheres_sought = false;       // where they didn't come with the model
  bool fresh = true;                 // the document makes just this, as far as its shape goes
  bool clips_edited = false;         // since the bytes were made
  // Per clip and key: moves the posed model's feet to the middle of the ground.
  std::vector<std::vector<Vec3>> footing;
  std::unique_ptr<ModelPicture> picture;

  // Takes the document's own clips in place of those it had; whether they were others.
  bool take_clips(const Document& from);
};
Result<BuiltModel> built_from(const std::string& glb, const std::string& document);
BuiltModel built_of(Model model, Document document);  // without fits and bytes

// Where a clip stands at a time; between keys as glTF interpolates.
Pose pose_at(const Clip& clip, double time);
Vec3 footing_at(const BuiltModel& built, int clip, double time);

}  // namespace artisketch
