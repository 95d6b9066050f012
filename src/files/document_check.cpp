#include "files/document_check.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/raster.h"
#include "files/json.h"

namespace artisketch {
namespace {

constexpr double kLeastArea = 0.01;  // pixels²; below, a closed contour encloses nothing to see

std::string frame_words(const Document& document, std::size_t frame) {
  const std::string& name = document.frames[frame].name;
  return "frame " + std::to_string(frame + 1) + (name.empty() ? "" : " " + in_quotes(name));
}

const std::string& name_of_joint(const Document& document, int joint) {
  return document.skeleton.joints[joint].name;
}

// The areas of all triangles between the first point and a side: nothing only where all points lie
// on one line.
double fan_area(const Polyline& line) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < line.points.size(); ++i)
    sum +=
        std::abs(cross(line.points[i] - line.points[0], line.points[i + 1] - line.points[0])) / 2;
  return sum;
}

void check_line(const Polyline& line, const std::string& whose, const JsonPath& at,
                Faults& faults) {
  if (!line.closed) return;
  // A flat line crosses itself too, but those are not the words for it.
  const auto crossing = fan_area(line) < kLeastArea ? std::nullopt : self_crossing(line);
  if (crossing)
    faults.add(at, whose + " crosses itself near (" + std::to_string(std::lround(crossing->x())) +
                       ", " + std::to_string(std::lround(crossing->y())) +
                       "); should go round once without crossing");
  else if (std::abs(signed_area(line)) < kLeastArea)
    faults.add(at, whose +
                       " encloses nothing; should go round an area, or have "
                       "\"closed\": false");
}

// Whether nothing to speak of is left of closed lines by the even-odd rule: an outline given twice.
bool cancel_out(const std::vector<std::vector<Vec2>>& lines) {
  constexpr int kAcross = 256;       // cells
  constexpr double kNothing = 0.01;  // of the largest
  if (lines.size() < 2) return false;
  Box2 box;
  for (const std::vector<Vec2>& line : lines)
    for (const Vec2& p : line) box.extend(p);
  const double scale = kAcross / std::max(box.sizes().maxCoeff(), 1e-9);
  std::vector<std::vector<Vec2>> scaled = lines;
  for (std::vector<Vec2>& line : scaled)
    for (Vec2& p : line) p = scale * (p - box.min());
  const auto cells = [&](std::span<const std::vector<Vec2>> polygons) {
    Mask mask(kAcross, kAcross);
    add_polygons(polygons, mask);
    return std::count(mask.in.begin(), mask.in.end(), 1);
  };
  std::ptrdiff_t largest = 0;
  for (const std::vector<Vec2>& line : scaled) largest = std::max(largest, cells({&line, 1}));
  return double(cells(scaled)) < kNothing * double(largest);
}

void check_frame(const Document& document, std::size_t f, const JsonPath& at, Faults& faults) {
  const Frame& frame = document.frames[f];
  const JsonPath contours = at / "contours";
  std::set<int> drawn;
  for (std::size_t c = 0; c < frame.contours.size(); ++c) {
    const Contour& contour = frame.contours[c];
    drawn.insert(contour.joint);
    const JsonPath one = contours / c;
    check_line(contour.line,
               frame_words(document, f) + ": the contour of " +
                   in_quotes(name_of_joint(document, contour.joint)),
               one / "points", faults);
  }
  for (const int joint : drawn)
    if (cancel_out(closed_contours(frame, joint)))
      faults.add(contours, frame_words(document, f) + ": the contours of " +
                               in_quotes(name_of_joint(document, joint)) +
                               " cancel out, since what lies in two of them is a hole; should be "
                               "there once");
  // In perspective, what is drawn must stand before the camera.
  if (document.camera.type != Camera::Type::perspective) return;
  const std::vector<Transform> posed = posed_joints(document.skeleton, frame.pose);
  const auto behind = std::find_if(drawn.begin(), drawn.end(), [&](int j) {
    return posed[j].translation().z() >= document.camera.distance;
  });
  if (behind != drawn.end())
    faults.add(at / "pose", frame_words(document, f) + ": " +
                                in_quotes(name_of_joint(document, *behind)) +
                                " stands at or behind the camera; should have z below the "
                                "camera's distance: move root_position away");
}

}  // namespace

std::vector<std::string> open_contour_words(const Document& document) {
  std::set<int> closed, open;
  for (const Frame& frame : document.frames)
    for (const Contour& contour : frame.contours)
      (contour.line.closed ? closed : open).insert(contour.joint);
  const std::vector<int> shaping = drawn_joints(with_shaping_contours(document));
  std::vector<std::string> words;
  for (const int joint : open)
    if (!closed.contains(joint))
      words.push_back(in_quotes(name_of_joint(document, joint)) +
                      (std::find(shaping.begin(), shaping.end(), joint) != shaping.end()
                           ? " has open contours alone: they are closed by straight lines"
                           : " has open contours alone, and none goes round an area: no part is "
                             "made of it"));
  for (std::size_t f = 0; f < document.frames.size(); ++f) {
    std::set<int> named;
    for (const Contour& contour : document.frames[f].contours)
      if (!contour.line.closed && closed.contains(contour.joint) &&
          named.insert(contour.joint).second)
        words.push_back(
            frame_words(document, f) + ": an open contour of " +
            in_quotes(name_of_joint(document, contour.joint)) +
            " shapes nothing, but that --method paper draws the surface to it. Close it, "
            "if it goes round the part");
  }
  return words;
}

Result<Done> check_document(const Document& document, const std::string& file) {
  Faults faults(file);
  const JsonPath root, frames = root / "frames";
  for (std::size_t f = 0; f < document.frames.size(); ++f)
    check_frame(document, f, frames / f, faults);
  if (document.frames.empty())
    faults.add(frames, "is empty; should have at least one frame");
  else if (drawn_joints(with_shaping_contours(document)).empty())
    faults.add(frames,
               "have no closed contour: no part has a body; should have one for at least "
               "one joint");
  if (!faults.none()) return faults.error();
  return Done{};
}

}  // namespace artisketch
