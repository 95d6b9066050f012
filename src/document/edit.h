// What a person does to a document, as functions from the document to the next one. They change
// nothing but what they say; indices must be valid (asserted).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "document/document.h"

namespace artisketch {

// ---------------------------------------------------------------- names

std::string capitalised(std::string words);

// A joint's name as people read it, and its side apart: "upper_arm.L" → {"Upper arm", "L"}.
struct JointWords {
  std::string name;
  std::string side;  // "L", "R" or empty
  std::string whole() const { return side.empty() ? name : name + " " + side; }
};
JointWords joint_words(const std::string& name);

// A drawing's name as people read it: "front" → "Front"; its number where it has none.
std::string drawing_words(const Document& document, int frame);

// The joints whose parts are to be outlined: those that have a child, carry a contour anywhere, or
// stand for a thing.
std::vector<int> parts_to_draw(const Document& document);

// ---------------------------------------------------------------- frames

// A drawing at the end of the strip, in the pose of the last one (the rest pose, fitted to the
// drawing, where there is none). That is where posing it begins: until then it isn't posed.
Document with_frame(Document document, Frame frame);
Document without_frame(Document document, int frame);
Document with_frame_moved(Document document, int frame, int to);
Document with_frame_copied(Document document, int frame);  // right after it
// A person's pose: joints that it turns count as set by hand, and the frame as posed, unless the
// body was only moved.
Document with_pose(Document document, int frame, Pose pose);
// A pose that was guessed: the frame counts as posed, and no joint as set but the one, if any, that
// the person decided about.
Document with_guessed_pose(Document document, int frame, Pose pose, int set_joint = -1);
// The rest pose, with no joint set by hand.
Document with_rest_pose(Document document, int frame);
// The pose as it is, said to be right.
Document with_frame_posed(Document document, int frame);
// At the poses and scales of another document of as many drawings and joints; as it is where those
// differ.
Document with_poses_of(Document document, const Document& other);
// The other kind of camera, which shows what stands at depth 0 as large as before; a perspective
// one stands four figures' heights away, and before every joint.
Document with_camera_type(Document document, Camera::Type type);

// How large an orthographic camera shows the figure in that frame (frames[].scale, above 0); its
// root stays where it is seen.
Document with_frame_scale(Document document, int frame, double scale);

// A pose that shows the rest pose upright within the middle of the frame: its root position.
Pose fitted_rest_pose(const Document& document, const Frame& frame);

// ---------------------------------------------------------------- contours

Document with_contour(Document document, int frame, Contour contour);  // in front
Document without_contour(Document document, int frame, int contour);
Document with_contour_joint(Document document, int frame, int contour, int joint);
Document with_role(Document document, int joint, Role role);
Document with_contour_points(Document document, int frame, int contour, std::vector<Vec2> points);
// Behind or in front of its neighbour.
Document with_contour_shifted(Document document, int frame, int contour, int by);
// The first outline joined with the second (document/mend.h), which goes. Nothing where they can't
// be.
std::optional<Document> with_contours_joined(const Document& document, int frame, int contour,
                                             int other, double reach);
// A copy in another frame, as that frame's pose shows the joint.
Document with_contour_copied(Document document, int frame, int contour, int to_frame);
// The mirror image for the mirror joint, across the joint's own middle line in the drawing.
// Nothing where the joint has no mirror joint.
std::optional<Document> with_contour_mirrored(const Document& document, int frame, int contour);

// The joint's part is marked as one that the drawing doesn't show, or no longer; an outline that it
// gets there unmarks it, too.
Document with_hidden(Document document, int frame, int joint, bool hidden);

// Whether no edge of a joint's part shows in the drawing: its closed contours run inside those of
// other parts in front of it, but for a twentieth of their length. False where it has none.
bool inside_other_parts(const Frame& frame, int joint);

// A freehand stroke as an outline: smoothed over `smooth` pixels, simplified to within `error`
// pixels, closed where its ends are within `reach` of each other, without the small loop that a
// hand leaves there. Nothing where it is too short.
struct StrokeOptions {
  double smooth = 2;
  double error = 0.35;
  double reach = 12;
  bool open = false;  // keep the ends apart
};
std::optional<Polyline> outline_of_stroke(std::span<const Vec2> stroke,
                                          const StrokeOptions& options);

// Cuts a closed outline along the segment a–b into two that overlap: each half goes up to `overlap`
// times the cut's length inside the outline beyond the line, and never outside the outline. Where
// the segment passes through several times, the stretch nearest to its middle counts. Nothing where
// it doesn't go right across.
std::optional<std::pair<Polyline, Polyline>> cut_outline(const Polyline& outline, const Vec2& a,
                                                         const Vec2& b, double overlap);

// The outline cut so: the half with more of its part's bone stays in place, the other comes in
// front as another part's, by the bones that lie in it. Nothing where cut_outline() gives nothing.
std::optional<Document> with_contour_cut(const Document& document, int frame, int contour,
                                         const Vec2& a, const Vec2& b);

// The outline with the stretch nearest to the stroke's ends replaced by the stroke.
Polyline with_stretch_redrawn(const Polyline& outline, std::span<const Vec2> stroke);

// A part's bones as a frame shows them, in pixels; by joint. A joint without children has none,
// unless it carries a contour in some frame: then its bone goes on from the one before it.
struct DrawnBone {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
};
std::vector<std::vector<DrawnBone>> drawn_bones(const Document& document, int frame);

// Joints that a new outline may belong to, the likeliest first, each with the reason in words.
struct Candidate {
  int joint = 0;
  std::string reason;
};
std::vector<Candidate> joint_candidates(const Document& document, int frame, const Polyline& line);

}  // namespace artisketch
