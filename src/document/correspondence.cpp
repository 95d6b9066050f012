// Which part an outline is: by its bones, its shape, and where it is cut.
#include <algorithm>
#include <cmath>

#include "document/edit.h"
#include "document/outline_edit.h"

namespace artisketch {

namespace {

// Size and slenderness of an outline, alike for the same part in another drawing.
struct Likeness {
  double area, slenderness;
};
Likeness likeness(const Polyline& line) {
  const double area = std::abs(signed_area(line)), around = length(line);
  return {area, area > 0 ? around * around / area : 1e9};
}

}  // namespace

std::vector<std::vector<DrawnBone>> drawn_bones(const Document& document, int frame) {
  const Skeleton& skeleton = document.skeleton;
  const std::vector<Transform> posed = posed_joints(skeleton, document.frames.at(frame).pose);
  const FrameCamera camera = frame_camera(document, frame);
  const std::vector<int> drawn = drawn_joints(document);
  std::vector<std::vector<DrawnBone>> bones(std::size_t(skeleton.size()));
  const auto at = [&](int j) { return camera.project(posed[j].translation()); };
  for (int j = 0; j < skeleton.size(); ++j) {
    const int parent = skeleton.joints[j].parent;
    const std::vector<int> children = skeleton.children(j);
    for (int child : children)
      if (at(j).allFinite() && at(child).allFinite()) bones[j].push_back({at(j), at(child)});
    if (!children.empty() || parent < 0 || !std::binary_search(drawn.begin(), drawn.end(), j))
      continue;
    constexpr double kOn = 0.5;  // of the bone before
    if (at(j).allFinite() && at(parent).allFinite())
      bones[j].push_back({at(j), at(j) + kOn * (at(j) - at(parent))});
  }
  return bones;
}

std::vector<Candidate> joint_candidates(const Document& document, int frame, const Polyline& line) {
  const Skeleton& skeleton = document.skeleton;
  const std::vector<std::vector<DrawnBone>> bones = drawn_bones(document, frame);
  const Vec2 middle = centroid(std::span(&line, 1));
  struct Scored {
    int joint;
    double distance;
  };
  std::vector<Scored> scored;
  for (int j = 0; j < skeleton.size(); ++j) {
    double best = -1;
    for (const DrawnBone& bone : bones[j]) {
      const Vec2 d = bone.to - bone.from;
      // The middle of the bone counts: the ends belong to the neighbours as well.
      const double t =
          std::clamp((middle - bone.from).dot(d) / std::max(d.squaredNorm(), 1e-9), 0.25, 0.75);
      const double distance = (middle - bone.from - t * d).norm();
      if (best < 0 || distance < best) best = distance;
    }
    if (best >= 0 && std::isfinite(best)) scored.push_back({j, best});
  }
  const auto taken = [&](int joint) { return !contours_of(document.frames[frame], joint).empty(); };
  const auto drawn_anew = [&](int joint) {
    constexpr double kOver = 0.3;  // of both outlines together
    const std::vector<Contour>& all = document.frames[frame].contours;
    return std::any_of(all.begin(), all.end(), [&](const Contour& contour) {
      return contour.joint == joint && contour.line.closed && line.closed &&
             common_share(contour.line, line) > kOver;
    });
  };
  // One that has its outline here already is less likely, unless that is what is drawn over.
  std::vector<double> worths(std::size_t(skeleton.size()), 0);
  for (const Scored& s : scored)
    worths[s.joint] = s.distance * (taken(s.joint) && !drawn_anew(s.joint) ? 3 : 1);
  const auto worth = [&](const Scored& s) { return worths[s.joint]; };
  std::stable_sort(scored.begin(), scored.end(),
                   [&](const Scored& a, const Scored& b) { return worth(a) < worth(b); });
  std::vector<Candidate> result;
  const auto propose = [&](int joint, const std::string& reason) {
    if (joint < 0) return;
    for (Candidate& candidate : result)
      if (candidate.joint == joint) {
        if (candidate.reason.find(reason) == std::string::npos) candidate.reason += " · " + reason;
        return;
      }
    result.push_back({joint, reason});
  };
  if (scored.empty()) return result;
  // A whole figure, to be cut, is the root's: what is cut off goes to the bones in it.
  int within = 0;
  for (const Scored& s : scored)
    within += line.closed &&
              std::all_of(bones[s.joint].begin(), bones[s.joint].end(), [&](const DrawnBone& bone) {
                return contains(line, (bone.from + bone.to) / 2);
              });
  constexpr double kWhole = 0.4;  // of the bones: a rest pose's arms may lie beside the drawing's
  if (scored.size() > 3 && within >= kWhole * double(scored.size()) && !bones[0].empty())
    propose(0, "holds most bones");
  const int nearest = scored[0].joint;
  propose(nearest, "nearest bone");
  const Likeness own = likeness(line);
  double closest = 0.5;  // of a natural logarithm: shapes farther off aren't alike
  int alike = -1;
  std::string where;
  for (int f = 0; f < int(document.frames.size()); ++f) {
    if (f == frame) continue;
    for (const Contour& contour : document.frames[f].contours) {
      if (!contour.line.closed || taken(contour.joint)) continue;
      const Likeness other = likeness(contour.line);
      const double apart = std::abs(std::log(other.area / std::max(own.area, 1e-9))) +
                           std::abs(std::log(other.slenderness / own.slenderness));
      if (apart < closest) {
        closest = apart;
        alike = contour.joint;
        where = document.frames[f].name;
      }
    }
  }
  if (alike >= 0) propose(alike, where.empty() ? "same shape elsewhere" : "same shape in " + where);
  if (scored.size() > 1) propose(scored[1].joint, "next bone");
  if (skeleton.joints[nearest].mirror != nearest)
    propose(skeleton.joints[nearest].mirror, "its mirror image");
  return result;
}

}  // namespace artisketch
