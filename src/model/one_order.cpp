#include "model/one_order.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <span>
#include <tuple>

namespace artisketch {
namespace {

bool before(const Vec2& a, const Vec2& b) {
  return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
}

bool before(const Polyline& a, const Polyline& b) {
  if (a.closed != b.closed) return a.closed;
  return std::lexicographical_compare(a.points.begin(), a.points.end(), b.points.begin(),
                                      b.points.end(),
                                      [](const Vec2& p, const Vec2& q) { return before(p, q); });
}

bool before(std::span<const Polyline> a, std::span<const Polyline> b) {
  return std::lexicographical_compare(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const Polyline& p, const Polyline& q) { return before(p, q); });
}

bool stands_before(const Transform& a, const Transform& b) {
  return std::lexicographical_compare(a.data(), a.data() + 16, b.data(), b.data() + 16);
}

// From the point farthest from the middle, which is the same however the drawing is turned. Figures
// are drawn upright, and alike left and right: of points about as far, between which a millionth of
// a pixel must not choose, from the one that lies farthest aslant; where the line passes that
// several times, from where it goes on least.
void start_at_farthest(std::vector<Vec2>& points, const Vec2& middle) {
  constexpr double kAsFar = 1e-3;     // of the distance
  const Vec2 aslant(0.8191, 0.5736);  // 35° below level
  const std::size_t n = points.size();
  const auto goes_before = [&](std::size_t a, std::size_t b) {
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 &p = points[(a + i) % n], &q = points[(b + i) % n];
      if (p != q) return before(p, q);
    }
    return false;
  };
  double most = 0;
  for (const Vec2& p : points) most = std::max(most, (p - middle).norm());
  std::size_t start = n;
  for (std::size_t i = 0; i < n; ++i) {
    if ((points[i] - middle).norm() < (1 - kAsFar) * most) continue;
    const double more = start == n ? 1 : (points[i] - points[start]).dot(aslant);
    if (more > 0 || (more == 0 && goes_before(i, start))) start = i;
  }
  if (start < n) std::rotate(points.begin(), points.begin() + std::ptrdiff_t(start), points.end());
}

}  // namespace

Polyline in_one_order(Polyline line) {
  if (line.points.empty()) return line;
  if (!line.closed) {
    if (before(line.points.back(), line.points.front()))
      std::reverse(line.points.begin(), line.points.end());
    return line;
  }
  const Vec2 middle = centroid({&line, 1});
  start_at_farthest(line.points, middle);
  Polyline reversed = line;
  std::reverse(reversed.points.begin(), reversed.points.end());
  start_at_farthest(reversed.points, middle);
  const double area = signed_area(line), other = signed_area(reversed);
  return other > area || (other == area && before(reversed, line)) ? reversed : line;
}

std::vector<Polyline> in_one_order(std::vector<Polyline> lines) {
  for (Polyline& line : lines) line = in_one_order(std::move(line));
  std::sort(lines.begin(), lines.end(),
            [](const Polyline& a, const Polyline& b) { return before(a, b); });
  return lines;
}

Document in_one_order(Document document) {
  for (Frame& frame : document.frames) {
    for (Contour& contour : frame.contours) contour.line = in_one_order(std::move(contour.line));
    std::stable_sort(frame.contours.begin(), frame.contours.end(),
                     [](const Contour& a, const Contour& b) {
                       return a.joint != b.joint ? a.joint < b.joint : before(a.line, b.line);
                     });
  }
  return document;
}

Part with_views_in_one_order(Part part) {
  for (std::vector<PartView>* views : {&part.views, &part.mirrors})
    std::stable_sort(views->begin(), views->end(), [](const PartView& a, const PartView& b) {
      if (before(a.contours, b.contours)) return true;
      return !before(b.contours, a.contours) && stands_before(a.to_world, b.to_world);
    });
  return part;
}

std::vector<int> frames_in_one_order(const Document& document) {
  const Document drawn = in_one_order(document);
  std::vector<std::vector<Polyline>> lines;
  std::vector<Transform> roots;
  for (const Frame& frame : drawn.frames) {
    lines.emplace_back();
    for (const Contour& contour : frame.contours) lines.back().push_back(contour.line);
    roots.push_back(posed_joints(document.skeleton, frame.pose)[0]);
  }
  std::vector<int> order(lines.size());
  std::iota(order.begin(), order.end(), 0);
  if (!order.empty())
    std::stable_sort(order.begin() + 1, order.end(), [&](int a, int b) {
      if (before(lines[a], lines[b])) return true;
      return !before(lines[b], lines[a]) && stands_before(roots[a], roots[b]);
    });
  return order;
}

std::vector<int> joints_in_one_order(const Skeleton& skeleton) {
  std::vector<int> order;
  if (skeleton.size() > 0) order.push_back(0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::vector<int> children = skeleton.children(order[i]);
    std::sort(children.begin(), children.end(), [&](int a, int b) {
      const Joint &p = skeleton.joints[a], &q = skeleton.joints[b];
      return std::tie(p.offset.x(), p.offset.y(), p.offset.z(), p.name) <
             std::tie(q.offset.x(), q.offset.y(), q.offset.z(), q.name);
    });
    order.insert(order.end(), children.begin(), children.end());
  }
  return order;
}

std::vector<int> inverse(const std::vector<int>& order) {
  std::vector<int> place(order.size());
  for (int i = 0; i < int(order.size()); ++i) place[order[i]] = i;
  return place;
}

namespace {

// Renames joints: `order` as with_joints_in() has it.
class Renaming {
 public:
  explicit Renaming(const std::vector<int>& order) : order_(order), place_(inverse(order)) {}

  void joint(int& joint) const { joint = joint < 0 ? joint : place_[joint]; }
  void skeleton(Skeleton& skeleton) const {
    skeleton.joints = reordered(skeleton.joints);
    for (Joint& one : skeleton.joints) {
      joint(one.parent);
      joint(one.mirror);
    }
  }
  void pose(Pose& pose) const { pose.rotations = reordered(pose.rotations); }
  template <class T>
  void keys(std::map<int, T>& by_joint) const {
    std::map<int, T> renamed;
    for (auto& [old, value] : by_joint) renamed.emplace(place_[old], std::move(value));
    by_joint = std::move(renamed);
  }
  // A list of what has a joint; the stages give such by joint, and in one joint as before.
  template <class T>
  void by_joint(std::vector<T>& list) const {
    for (T& one : list) joint(one.joint);
    std::stable_sort(list.begin(), list.end(),
                     [](const T& a, const T& b) { return a.joint < b.joint; });
  }

 private:
  template <class T>
  std::vector<T> reordered(const std::vector<T>& list) const {
    std::vector<T> result;
    for (const int i : order_) result.push_back(list[i]);
    return result;
  }

  const std::vector<int>& order_;
  std::vector<int> place_;
};

}  // namespace

Document with_joints_in(Document document, const std::vector<int>& order) {
  const Renaming to(order);
  to.skeleton(document.skeleton);
  for (Frame& frame : document.frames) {
    to.pose(frame.pose);
    for (Contour& contour : frame.contours) to.joint(contour.joint);
    for (int& joint : frame.hidden) to.joint(joint);
    for (int& joint : frame.set_joints) to.joint(joint);
  }
  for (int& joint : document.calibration.locked) to.joint(joint);
  to.keys(document.spheres);
  to.keys(document.parts);
  for (Animation& animation : document.animations)
    for (Key& key : animation.keys) to.pose(key.pose);
  for (auto& [name, joint] : document.motion.joints) to.joint(joint);
  return document;
}

Calibration with_joints_in(Calibration calibration, const std::vector<int>& order) {
  const Renaming to(order);
  for (Pose& pose : calibration.poses) to.pose(pose);
  to.joint(calibration.largest_rotation_joint);
  to.by_joint(calibration.coverage);
  return calibration;
}

Reconstruction with_joints_in(Reconstruction made, const std::vector<int>& order) {
  const Renaming to(order);
  to.skeleton(made.model.skeleton);
  for (Clip& clip : made.model.clips)
    for (Pose& pose : clip.poses) to.pose(pose);
  auto& joints = made.model.weights.joints;
  std::for_each(joints.data(), joints.data() + joints.size(), [&](int& joint) { to.joint(joint); });
  made.calibrated = with_joints_in(std::move(made.calibrated), order);
  if (made.calibration) made.calibration = with_joints_in(std::move(*made.calibration), order);
  to.by_joint(made.parts);
  for (FrameFit& fit : made.fits) to.by_joint(fit.parts);
  return made;
}

}  // namespace artisketch
