#include "document/outline_edit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/ensure.h"
#include "base/raster.h"
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

// Areas in cells of a raster that is laid over two lines.
struct Areas {
  double a = 0, b = 0, both = 0;
};

Areas areas(const Polyline& a, const Polyline& b) {
  constexpr int kAcross = 128;  // cells along the longer side: a hundredth of it is still told
  const Polyline lines[] = {a, b};
  const Box2 box = bounds(lines);
  const double cells = kAcross / std::max(1e-9, box.sizes().maxCoeff());
  std::vector<Mask> masks;
  for (const Polyline& line : lines) {
    std::vector<Vec2> points;
    for (const Vec2& p : line.points) points.push_back(cells * (p - box.min()));
    add_polygons(std::span(&points, 1), masks.emplace_back(kAcross, kAcross));
  }
  Areas sums;
  for (std::size_t i = 0; i < masks[0].in.size(); ++i) {
    sums.a += masks[0].in[i];
    sums.b += masks[1].in[i];
    sums.both += masks[0].in[i] & masks[1].in[i];
  }
  return sums;
}

bool lies_within(const Polyline& inner, const Polyline& outer, double larger = 1) {
  const Vec2 middle = centroid(std::span(&inner, 1));
  return std::all_of(inner.points.begin(), inner.points.end(), [&](const Vec2& p) {
    return contains(outer, middle + larger * (p - middle));
  });
}

bool drawn_over(const Polyline& line, const Polyline& old) {
  constexpr double kClear = 1.15;  // times its size, and still within: a hand that redraws an edge
                                   // comes nearer to it
  if (lies_within(line, old, kClear)) return false;
  const Areas shared = areas(line, old);
  return 2 * shared.both >= std::min(shared.a, shared.b);
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

ContourSet contours_redrawn(const Frame& frame, int joint, const Polyline& line) {
  ContourSet old;
  if (!line.closed) return old;
  const auto each = [&](const auto& is_one) {
    for (int i = 0; i < int(frame.contours.size()); ++i) {
      const Contour& contour = frame.contours[std::size_t(i)];
      if (contour.joint == joint && contour.line.closed && is_one(contour.line)) old.insert(i);
    }
  };
  each([&](const Polyline& other) { return drawn_over(line, other); });
  const ContourSet outer = old;
  each([&](const Polyline& other) {
    return std::any_of(outer.begin(), outer.end(), [&](int i) {
      return lies_within(other, frame.contours[std::size_t(i)].line);
    });
  });
  return old;
}

Document with_contour_over(Document document, int frame, Contour contour) {
  const ContourSet old =
      contours_redrawn(document.frames.at(std::size_t(frame)), contour.joint, contour.line);
  const std::size_t count = document.frames[std::size_t(frame)].contours.size();
  document = with_contour(std::move(document), frame, std::move(contour));
  std::vector<Contour>& all = document.frames[std::size_t(frame)].contours;
  if (old.empty() || all.size() == count) return document;
  std::rotate(all.begin() + *old.begin(), all.end() - 1, all.end());
  ContourSet gone;
  for (const int i : old) gone.insert(i + 1);  // behind the new one, now
  return without_contours(std::move(document), frame, gone);
}

double common_share(const Polyline& a, const Polyline& b) {
  const Areas shared = areas(a, b);
  return shared.both / std::max(1.0, shared.a + shared.b - shared.both);
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
