// Edits at random, as a person might make them. `Bytes` chooses: libFuzzer's FuzzedDataProvider, or
// RandomBytes.
#pragma once

#include <cstdlib>
#include <vector>

#include "document/edit.h"
#include "document/mend.h"
#include "document/skeleton_edit.h"

namespace artisketch::fuzz {

template <class Bytes>
double coordinate(Bytes& bytes) {
  // Mostly on a coarse lattice, where lines meet in points and lie on each other.
  const int at = bytes.ConsumeIntegralInRange(-10, 50);
  return bytes.ConsumeIntegralInRange(0, 9) ? 4 * at : bytes.ConsumeFloatingPointInRange(-1e5, 1e5);
}
template <class Bytes>
Vec2 point(Bytes& bytes) {
  const double x = coordinate(bytes);
  return {x, coordinate(bytes)};
}
template <class Bytes>
std::vector<Vec2> stroke(Bytes& bytes) {
  std::vector<Vec2> points(bytes.ConsumeIntegralInRange(2, 16));
  for (Vec2& p : points) p = point(bytes);
  return points;
}
template <class Bytes>
Vec3 small(Bytes& bytes) {
  Vec3 v;
  for (int a = 0; a < 3; ++a) v[a] = 0.1 * bytes.ConsumeIntegralInRange(-5, 5);
  return v;
}

// One edit of one outline.
template <class Bytes>
Document with_outline_edited(Document d, int f, int c, Bytes& bytes) {
  const int outlines = int(d.frames[f].contours.size());
  switch (bytes.ConsumeIntegralInRange(0, 9)) {
    case 0:
      return without_contour(std::move(d), f, c);
    case 1:
      return with_contour_shifted(std::move(d), f, c, bytes.ConsumeBool() ? 1 : -1);
    case 2:
      if (const int other = bytes.ConsumeIntegralInRange(0, outlines - 1); other != c)
        return with_contours_joined(d, f, c, other, 12).value_or(d);
      return d;
    case 3: {
      const int to = bytes.ConsumeIntegralInRange(0, int(d.frames.size()) - 1);
      return with_contour_copied(std::move(d), f, c, to);
    }
    case 4:
      return with_contour_mirrored(d, f, c).value_or(d);
    case 5: {
      const Vec2 a = point(bytes);
      return with_contour_cut(d, f, c, a, point(bytes)).value_or(d);
    }
    case 6: {
      const Polyline line = with_stretch_redrawn(d.frames[f].contours[c].line, stroke(bytes));
      return with_contour_points(std::move(d), f, c, line.points);
    }
    case 7: {  // a corner dragged
      std::vector<Vec2> points = d.frames[f].contours[c].line.points;
      points[bytes.ConsumeIntegralInRange(0, int(points.size()) - 1)] = point(bytes);
      return with_contour_points(std::move(d), f, c, std::move(points));
    }
    case 8: {
      const Polyline whole = mended(d.frames[f].contours[c].line);
      if (whole.closed && self_crossing(whole)) std::abort();
      return with_contour_points(std::move(d), f, c, whole.points);
    }
    default: {
      const int joint = bytes.ConsumeIntegralInRange(0, d.skeleton.size() - 1);
      return with_contour_joint(std::move(d), f, c, joint);
    }
  }
}

template <class Bytes>
Document edited(Document d, Bytes& bytes) {
  const int f = bytes.ConsumeIntegralInRange(0, int(d.frames.size()) - 1);
  const int j = bytes.ConsumeIntegralInRange(0, d.skeleton.size() - 1);
  const int outlines = int(d.frames[f].contours.size());
  switch (bytes.ConsumeIntegralInRange(0, 10)) {
    case 0: {
      StrokeOptions options;
      options.open = bytes.ConsumeBool();
      options.smooth = bytes.ConsumeIntegralInRange(0, 4);
      if (auto line = outline_of_stroke(stroke(bytes), options))
        return with_contour(std::move(d), f, Contour{j, *line, ""});
      return d;
    }
    case 1:
      return with_hidden(std::move(d), f, j, bytes.ConsumeBool());
    case 2:
      return d.frames.size() > 1 ? without_frame(std::move(d), f) : d;
    case 3:
      return d.frames.size() < 6 ? with_frame_copied(std::move(d), f) : d;
    case 4: {
      const int to = bytes.ConsumeIntegralInRange(0, int(d.frames.size()) - 1);
      return with_frame_moved(std::move(d), f, to);
    }
    case 5:
      if (d.skeleton.size() >= 30) return d;
      return with_joint_added(std::move(d), j, small(bytes), bytes.ConsumeBool());
    case 6:
      return with_joint_renamed(std::move(d), j, bytes.ConsumeRandomLengthString(8));
    case 7:
      return with_joint_moved(std::move(d), j, small(bytes), bytes.ConsumeBool());
    case 8:
      return with_camera_type(std::move(d), bytes.ConsumeBool() ? Camera::Type::orthographic
                                                                : Camera::Type::perspective);
    default:
      if (!outlines) return d;
      return with_outline_edited(std::move(d), f, bytes.ConsumeIntegralInRange(0, outlines - 1),
                                 bytes);
  }
}

}  // namespace artisketch::fuzz
