#include "document/outline_edit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/ensure.h"
#include "document/bone_axis.h"
#include "document/edit.h"
#include "document/line_fit.h"

namespace artisketch {
namespace {

std::vector<Contour>& drawn_in(Document& document, int frame, const ContourSet& contours) {
  ensure(frame >= 0 && frame < int(document.frames.size()), "a frame of the document");
  std::vector<Contour>& all = document.frames[std::size_t(frame)].contours;
  ensure(contours.empty() || (*contours.begin() >= 0 && *contours.rbegin() < int(all.size())),
         "contours of the frame");
  return all;
}

double smaller_side(const Frame& frame) {
  return std::max(1, std::min(frame.width, frame.height));
}

}  // namespace

Document with_contours_mapped(Document document, int frame, const ContourSet& contours,
                              const PictureMap& map) {
  std::vector<Contour>& all = drawn_in(document, frame, contours);
  for (const int i : contours)
    for (Vec2& p : all[std::size_t(i)].line.points) p = map * p;
  return document;
}

Document without_contours(Document document, int frame, const ContourSet& contours) {
  std::vector<Contour>& all = drawn_in(document, frame, contours);
  for (auto i = contours.rbegin(); i != contours.rend(); ++i) all.erase(all.begin() + *i);
  return document;
}

Document with_contours_simplified(Document document, int frame, const ContourSet& contours,
                                  double error) {
  std::vector<Contour>& all = drawn_in(document, frame, contours);
  for (const int i : contours) {
    Polyline& line = all[std::size_t(i)].line;
    Polyline fewer{simplified(line.points, line.closed, error), line.closed};
    if (fewer.points.size() < (line.closed ? 3u : 2u)) continue;
    if (self_crossing(fewer) && !self_crossing(line)) continue;
    constexpr double kKept = 0.9;  // of what it encloses
    if (std::abs(signed_area(fewer)) < kKept * std::abs(signed_area(line))) continue;
    line = std::move(fewer);
  }
  return document;
}

std::vector<LooseOutline> loose_outlines(const Document& document, int frame,
                                         const ContourSet& contours) {
  const Frame& drawn = document.frames.at(std::size_t(frame));
  std::vector<LooseOutline> loose;
  for (const int i : contours) {
    const Contour& contour = drawn.contours.at(std::size_t(i));
    const BoneAxis bone = bone_axis(document, frame, contour.joint);
    loose.push_back({document.skeleton.joints[std::size_t(contour.joint)].name, contour.line,
                     bone.start, bone.along, smaller_side(drawn)});
  }
  return loose;
}

Document with_outlines_laid(Document document, int frame,
                            const std::vector<LooseOutline>& outlines) {
  const std::vector<Joint>& joints = document.skeleton.joints;
  for (const LooseOutline& loose : outlines) {
    const auto joint = std::find_if(joints.begin(), joints.end(),
                                    [&](const Joint& j) { return j.name == loose.joint; });
    if (joint == joints.end()) continue;
    Contour contour;
    contour.joint = int(joint - joints.begin());
    contour.line = loose.line;
    const BoneAxis to = bone_axis(document, frame, contour.joint);
    const double scale = smaller_side(document.frames[std::size_t(frame)]) / loose.size;
    Eigen::Matrix2d turn;
    const double c = loose.along.dot(to.along),
                 s = loose.along.x() * to.along.y() - loose.along.y() * to.along.x();
    turn << c, -s, s, c;
    for (Vec2& p : contour.line.points) p = to.start + scale * (turn * (p - loose.start));
    document = with_contour(std::move(document), frame, std::move(contour));
  }
  return document;
}

}  // namespace artisketch
