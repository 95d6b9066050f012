#include "document/edit.h"

#include <algorithm>
#include <cmath>

#include "base/ensure.h"
#include "document/bone_axis.h"
#include "document/mend.h"
#include "document/outline_edit.h"

namespace artisketch {

// ---------------------------------------------------------------- names

std::string capitalised(std::string words) {
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] = char(words[0] - 'a' + 'A');
  return words;
}

JointWords joint_words(const std::string& name) {
  JointWords words{name, ""};
  const std::size_t size = name.size();
  if (size > 2 && std::string("._ ").find(name[size - 2]) != std::string::npos &&
      std::string("LRlr").find(name[size - 1]) != std::string::npos) {
    words.side = name[size - 1] == 'L' || name[size - 1] == 'l' ? "L" : "R";
    words.name = name.substr(0, size - 2);
  }
  std::replace(words.name.begin(), words.name.end(), '_', ' ');
  std::replace(words.name.begin(), words.name.end(), '.', ' ');
  words.name = capitalised(std::move(words.name));
  return words;
}

std::string drawing_words(const Document& document, int frame) {
  const std::string& name = document.frames.at(frame).name;
  return name.empty() ? "Drawing " + std::to_string(frame + 1) : capitalised(name);
}

Document with_role(Document document, int joint, Role role) {
  document.parts[joint].role = role;
  return document;
}

std::vector<int> parts_to_draw(const Document& document) {
  const std::vector<int> drawn = drawn_joints(document);
  std::vector<int> joints;
  for (int j = 0; j < document.skeleton.size(); ++j)
    if (!document.skeleton.children(j).empty() || role_of(document, j) != Role::body ||
        std::binary_search(drawn.begin(), drawn.end(), j))
      joints.push_back(j);
  return joints;
}

// ---------------------------------------------------------------- frames

Pose fitted_rest_pose(const Document& document, const Frame& frame) {
  Pose pose = rest_pose(document.skeleton);
  pose.root_position.setZero();
  const std::vector<Vec3> joints = rest_positions(document.skeleton);
  Box3 box;
  for (const Vec3& joint : joints) box.extend(joint);
  if (joints.empty()) return pose;
  // The middle of the figure at the image's principal point.
  const Vec3& root = joints[0];
  pose.root_position = root - box.center();
  if (frame.principal_point) return pose;
  pose.root_position.z() = 0;
  return pose;
}

Document with_frame(Document document, Frame frame) {
  if (int(frame.pose.rotations.size()) != document.skeleton.size()) {
    frame.posed = document.frames.empty();
    frame.pose = frame.posed ? fitted_rest_pose(document, frame) : document.frames.back().pose;
  }
  document.frames.push_back(std::move(frame));
  return document;
}

Document without_frame(Document document, int frame) {
  ensure(frame >= 0 && frame < int(document.frames.size()), "a frame of the document");
  document.frames.erase(document.frames.begin() + frame);
  return document;
}

Document with_frame_moved(Document document, int frame, int to) {
  ensure(std::max(frame, to) < int(document.frames.size()) && std::min(frame, to) >= 0,
         "frames of the document");
  Frame moved = std::move(document.frames[frame]);
  document.frames.erase(document.frames.begin() + frame);
  document.frames.insert(document.frames.begin() + to, std::move(moved));
  return document;
}

Document with_frame_copied(Document document, int frame) {
  ensure(frame >= 0 && frame < int(document.frames.size()), "a frame of the document");
  Frame copy = document.frames[frame];
  copy.name += copy.name.empty() ? "" : " copy";
  document.frames.insert(document.frames.begin() + frame + 1, std::move(copy));
  return document;
}

namespace {
void set_by_hand(Frame& frame, int joint) {
  std::vector<int>& set = frame.set_joints;
  const auto at = std::lower_bound(set.begin(), set.end(), joint);
  if (at == set.end() || *at != joint) set.insert(at, joint);
}
}  // namespace

Document with_pose(Document document, int frame, Pose pose) {
  Frame& changed = document.frames.at(frame);
  const std::vector<Quat>&was = changed.pose.rotations, &now = pose.rotations;
  for (int j = 0; j < int(std::min(was.size(), now.size())); ++j) {
    if (was[j].coeffs() == now[j].coeffs()) continue;
    changed.posed = true;
    set_by_hand(changed, j);
  }
  changed.pose = std::move(pose);
  return document;
}

Document with_guessed_pose(Document document, int frame, Pose pose, int set_joint) {
  document.frames.at(frame).pose = std::move(pose);
  if (set_joint >= 0) set_by_hand(document.frames[frame], set_joint);
  return with_frame_posed(std::move(document), frame);
}

Document with_rest_pose(Document document, int frame) {
  Pose rest = fitted_rest_pose(document, document.frames.at(frame));
  document = with_guessed_pose(std::move(document), frame, std::move(rest));
  document.frames[frame].set_joints.clear();
  return document;
}

Document with_frame_posed(Document document, int frame) {
  document.frames.at(frame).posed = true;
  return document;
}

Document with_poses_of(Document document, const Document& other) {
  if (other.frames.size() != document.frames.size() ||
      other.skeleton.size() != document.skeleton.size())
    return document;
  for (std::size_t f = 0; f < document.frames.size(); ++f) {
    document.frames[f].pose = other.frames[f].pose;
    document.frames[f].scale = other.frames[f].scale;
  }
  return document;
}

Document with_frame_scale(Document document, int frame, double scale) {
  Frame& changed = document.frames.at(frame);
  ensure(scale > 0, "a scale");
  changed.pose.root_position.head<2>() *= changed.scale / scale;
  changed.scale = scale;
  return document;
}

Document with_camera_type(Document document, Camera::Type type) {
  Camera& camera = document.camera;
  if (camera.type == type) return document;
  camera.type = type;
  constexpr double kLeast = 1e-9, kMost = 1e9;  // that a document holds
  if (type == Camera::Type::orthographic) {
    camera.pixels_per_unit = std::clamp(camera.focal_length / camera.distance, kLeast, kMost);
    return document;
  }
  // A skeleton of one joint has no height; what is drawn may have.
  Box3 box;
  for (const Vec3& joint : rest_positions(document.skeleton)) box.extend(joint);
  double height = box.isEmpty() ? 0 : box.sizes().maxCoeff();
  double nearest = 0;  // of the joints, toward the viewer
  for (const Frame& frame : document.frames) {
    for (const Transform& joint : posed_joints(document.skeleton, frame.pose))
      nearest = std::max(nearest, joint.translation().z());
    if (box.isEmpty() || box.sizes().maxCoeff() > 0) continue;
    for (const Contour& contour : frame.contours)
      height = std::max(height, bounds({&contour.line, 1}).sizes().maxCoeff() /
                                    (camera.pixels_per_unit * frame.scale));
  }
  if (!(height > 0)) height = 1;
  constexpr double kHeights = 4;
  camera.distance = std::clamp(std::max(kHeights * height, nearest + height), kLeast, kMost);
  camera.focal_length = std::clamp(camera.pixels_per_unit * camera.distance, kLeast, kMost);
  for (Frame& frame : document.frames) frame.scale = 1;
  return document;
}

// ---------------------------------------------------------------- contours

namespace {
std::vector<Contour>& contours_in(Document& document, int frame, int contour = 0) {
  std::vector<Contour>& contours = document.frames.at(frame).contours;
  ensure(contour >= 0 && (contour == 0 || contour < int(contours.size())),
         "a contour of the frame");
  (void)contour;
  return contours;
}

Vec2 within_paper(const Vec2& p) {
  constexpr double kFarthest = 1e6;  // pixels, as FORMAT.md has it
  return p.cwiseMax(-kFarthest).cwiseMin(kFarthest);
}

// As FORMAT.md has contours: points within its bounds, none like the one before it. False where too
// few are left for a line.
bool made_storable(Polyline& line) {
  std::vector<Vec2>& points = line.points;
  for (Vec2& p : points) p = within_paper(p);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  while (line.closed && points.size() > 1 && points.back() == points.front()) points.pop_back();
  return points.size() >= (line.closed ? 3u : 2u);
}
}  // namespace

// A contour of fewer different points than a line has is not added, nor made of one that is there.
Document with_contour(Document document, int frame, Contour contour) {
  if (!made_storable(contour.line)) return document;
  document = with_hidden(std::move(document), frame, contour.joint, false);
  contours_in(document, frame).push_back(std::move(contour));
  return document;
}

Document without_contour(Document document, int frame, int contour) {
  std::vector<Contour>& contours = contours_in(document, frame, contour);
  contours.erase(contours.begin() + contour);
  return document;
}

Document with_contour_joint(Document document, int frame, int contour, int joint) {
  contours_in(document, frame, contour)[contour].joint = joint;
  return with_hidden(std::move(document), frame, joint, false);
}

Document with_contour_points(Document document, int frame, int contour, std::vector<Vec2> points) {
  Polyline& line = contours_in(document, frame, contour)[contour].line;
  if (Polyline next{points, line.closed}; !made_storable(next)) return document;
  // A point dragged onto the next one stays a point of its own: whoever drags it counts them.
  for (Vec2& p : points) p = within_paper(p);
  line.points = std::move(points);
  return document;
}

Document with_contour_shifted(Document document, int frame, int contour, int by) {
  std::vector<Contour>& contours = contours_in(document, frame, contour);
  const int to = std::clamp(contour + by, 0, int(contours.size()) - 1);
  Contour moved = std::move(contours[contour]);
  contours.erase(contours.begin() + contour);
  contours.insert(contours.begin() + to, std::move(moved));
  return document;
}

std::optional<Document> with_contours_joined(const Document& document, int frame, int contour,
                                             int other, double reach) {
  const std::vector<Contour>& contours = document.frames.at(frame).contours;
  if (contour == other) return std::nullopt;
  std::optional<Polyline> line = joined(contours.at(contour).line, contours.at(other).line, reach);
  if (!line || !made_storable(*line)) return std::nullopt;
  Document next = document;
  next.frames[frame].contours[contour].line = std::move(*line);
  return without_contour(std::move(next), frame, other);
}

Document with_contour_copied(Document document, int frame, int contour, int to_frame) {
  contours_in(document, frame, contour);
  const std::vector<LooseOutline> copy = loose_outlines(document, frame, {contour});
  return with_outlines_laid(std::move(document), to_frame, copy);
}

std::optional<Document> with_contour_mirrored(const Document& document, int frame, int contour) {
  Contour copy = document.frames.at(frame).contours.at(contour);
  const int mirror = document.skeleton.joints[copy.joint].mirror;
  if (mirror < 0 || mirror == copy.joint) return std::nullopt;
  const BoneAxis from = bone_axis(document, frame, copy.joint),
                 to = bone_axis(document, frame, mirror);
  for (Vec2& p : copy.line.points) {
    const Vec2 d = p - from.start;
    const double along = d.dot(from.along),
                 across = from.along.x() * d.y() - from.along.y() * d.x();
    p = to.start + along * to.along - across * Vec2(-to.along.y(), to.along.x());
  }
  copy.joint = mirror;
  return with_contour(document, frame, std::move(copy));
}

}  // namespace artisketch
