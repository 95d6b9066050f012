// Skeletons to begin with, and how one is laid over a drawing.
#pragma once

#include <optional>
#include <span>

#include "document/document.h"

namespace artisketch {

enum class Template { human, quadruped, bird, spider, fish, hand, blank };

struct TemplateWords {
  Template kind;
  const char* name;   // "Human"
  const char* about;  // "two arms, two legs"
};
std::span<const TemplateWords> all_templates();

// In its rest pose, facing the viewer, about one to two units tall, its feet on y = 0. Names that
// end in .L and .R are each other's mirror images, as are the joints in the middle their own.
Skeleton template_skeleton(Template kind);

// The document's skeleton laid over a figure, all frames in its rest pose. Where the camera is
// orthographic it takes on the skeleton's scale, else the skeleton the camera's.
//   frame   the one that the skeleton is fitted to
//   figure  where the figure stands in that frame's drawing, in pixels; none: most of the sheet
struct FitOptions {
  bool by_height = true;  // else as large as fits
  bool may_turn = false;  // to face left, where the figure is wider than the skeleton would be
};
Document with_skeleton_fitted(Document document, int frame, const std::optional<Box2>& figure,
                              const FitOptions& options);

// The document with a template's skeleton, fitted so. Contours go to the joint of the same name,
// else to the nearest bone.
Document with_template(Document document, Template kind, int frame,
                       const std::optional<Box2>& figure);

// A frame's pose moved, and nothing else, so that the joints lie about the middle of the figure.
Pose pose_over(const Document& document, const Frame& frame, Pose pose, const Box2& figure);

}  // namespace artisketch
