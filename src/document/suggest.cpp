#include "document/suggest.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "document/joint_limits.h"
#include "document/posing.h"

namespace artisketch {
namespace {

constexpr int kStarts = 16;      // sides from which a body may be seen that nobody has turned yet
constexpr int kSteps = 14;       // of Gauss–Newton from each
constexpr double kCalm = 0.02;   // what a radian of bend costs, in heights of the figure
constexpr double kStiff = 0.1;   // the same for a trunk
constexpr double kStay = 0.05;   // what a radian costs that the body is turned from where it was
constexpr double kLimit = 0.25;  // what a radian costs beyond what joints can do
constexpr double kUpright = 0.01;
constexpr double kOutlier = 0.06;  // heights; places farther off than this count ever less

// A rival is worth a look where its joints lie so far from the better ones' in the mean, in
// heights, and where it explains the drawing nearly as well.
constexpr double kApart = 0.06;
constexpr double kNearlyAsGood = 3, kGood = 2e-4;  // times the best's cost, and costs
constexpr std::size_t kMostRivals = 3;

Vec3 turn_of(const Quat& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return std::remainder(turn.angle(), 2 * kPi) * turn.axis();
}

// A place on a part and where the drawing shows it.
struct Place {
  int joint = 0;             // whose part it is on
  Vec3 at = Vec3::Zero();    // from the joint, in its own axes; units
  Vec2 seen = Vec2::Zero();  // pixels
};

std::vector<Polyline> closed_lines(const Frame& frame, int joint) {
  std::vector<Polyline> lines = contours_of(frame, joint);
  std::erase_if(lines, [](const Polyline& line) { return !line.closed; });
  return lines;
}

// The middle of what two parts share in the drawing; where they are apart, the middle between the
// two points that are nearest to each other.
Vec2 meeting(const std::vector<Polyline>& a, const std::vector<Polyline>& b) {
  const Box2 common = bounds(a).intersection(bounds(b));
  if (!common.isEmpty()) {
    constexpr int kSamples = 40;
    Vec2 sum = Vec2::Zero();
    int count = 0;
    for (int y = 0; y < kSamples; ++y)
      for (int x = 0; x < kSamples; ++x) {
        const Vec2 p = common.min() + common.sizes().cwiseProduct(
                                          Vec2((x + 0.5) / kSamples, (y + 0.5) / kSamples));
        if (!contains(a, p) || !contains(b, p)) continue;
        sum += p;
        ++count;
      }
    if (count > 0) return sum / count;
  }
  double least = 1e300;
  Vec2 middle = Vec2::Zero();
  for (const Polyline& line : a)
    for (const Vec2& p : line.points)
      for (const Polyline& other : b)
        for (const Vec2& q : other.points)
          if (const double d = (p - q).squaredNorm(); d < least) least = d, middle = (p + q) / 2;
  return middle;
}

// What a frame shows of a joint's part: its centroid, and where it meets its parent's.
struct Shown {
  bool part = false, neighbour = false;
  Vec2 centroid = Vec2::Zero(), meets = Vec2::Zero();
};
std::vector<Shown> shown_in(const Document& document, int frame) {
  const Skeleton& skeleton = document.skeleton;
  std::vector<std::vector<Polyline>> lines;
  for (int j = 0; j < skeleton.size(); ++j)
    lines.push_back(closed_lines(document.frames[frame], j));
  std::vector<Shown> shown(skeleton.joints.size());
  for (int j = 0; j < skeleton.size(); ++j) {
    if (lines[j].empty()) continue;
    shown[j].part = true;
    shown[j].centroid = centroid(lines[j]);
    const int parent = skeleton.joints[j].parent;
    if (parent < 0 || lines[parent].empty()) continue;
    shown[j].neighbour = true;
    shown[j].meets = meeting(lines[j], lines[parent]);
  }
  return shown;
}

// A pixel's point at the depth of a joint of a posed frame, from the joint in its own axes.
Vec3 on_part(const FrameCamera& camera, const Transform& posed, const Vec2& pixel) {
  return posed.inverse() * camera.ray(pixel).at_z(posed.translation().z());
}

std::vector<Place> places_in(const Document& document, int frame) {
  const Skeleton& skeleton = document.skeleton;
  const std::vector<Shown> shown = shown_in(document, frame);
  const bool trusted = frame != 0;
  std::vector<Shown> known(shown.size());
  std::vector<Transform> posed;
  FrameCamera camera;
  if (trusted) {
    known = shown_in(document, 0);
    posed = posed_joints(skeleton, document.frames[0].pose);
    camera = frame_camera(document, 0);
  }
  std::vector<Place> places;
  for (int j = 0; j < skeleton.size(); ++j) {
    if (!shown[j].part) continue;
    Vec3 middle = Vec3::Zero();
    if (known[j].part) {
      // The centroid lies about as deep as the middle of the bone.
      const Vec3 end = end_of_bone(skeleton, j) == j
                           ? Vec3(Vec3::Zero())
                           : skeleton.joints[end_of_bone(skeleton, j)].offset;
      middle =
          on_part(camera, posed[j] * Eigen::Translation3d(end / 2), known[j].centroid) + end / 2;
    } else if (end_of_bone(skeleton, j) != j) {
      middle = skeleton.joints[end_of_bone(skeleton, j)].offset / 2;
    }
    places.push_back({j, middle, shown[j].centroid});
    if (!shown[j].neighbour) continue;
    const Vec3 joint =
        known[j].neighbour ? on_part(camera, posed[j], known[j].meets) : Vec3(Vec3::Zero());
    places.push_back({j, joint, shown[j].meets});
  }
  return places;
}

// Finds the pose by Gauss–Newton over the root's place and the rotations of the joints that carry
// what is seen.
class Search {
 public:
  Search(const Document& document, int frame)
      : skeleton_(document.skeleton),
        camera_(frame_camera(document, frame)),
        mine_(document.frames[frame].pose),
        posed_(is_posed(document, frame)),
        places_(places_in(document, frame)) {
    std::vector<char> carries(skeleton_.joints.size(), 0);
    for (const Place& place : places_) carries[place.joint] = 1;
    for (int j = skeleton_.size() - 1; j > 0; --j)
      if (carries[j]) carries[skeleton_.joints[j].parent] = 1;
    const std::vector<int>& set = document.frames[frame].set_joints;
    for (int j = 0; j < skeleton_.size(); ++j) {
      limits_.push_back(joint_limits(skeleton_, j));
      if (carries[j] && !std::binary_search(set.begin(), set.end(), j)) free_.push_back(j);
    }
    Box3 box;
    for (const Vec3& joint : rest_positions(skeleton_)) box.extend(joint);
    height_ = std::max(1e-6, box.sizes().maxCoeff());
  }

  bool possible() const { return places_.size() >= 3; }
  const std::vector<int>& free() const { return free_; }

  // Where the search begins: at the body's own turn and a little to both sides of it, limbs as they
  // are and at rest; of a body that nobody has turned, from all sides.
  std::vector<Pose> starts() const {
    if (free_.empty() || free_[0] != 0) return {mine_, start(mine_.rotations[0])};
    std::vector<Pose> all;
    if (posed_) {
      all.push_back(mine_);
      for (const double aside : {0.0, -0.5, 0.5})
        all.push_back(start(Quat(Eigen::AngleAxisd(aside, Vec3::UnitY())) * mine_.rotations[0]));
    } else {
      for (int k = 0; k < kStarts; ++k)
        all.push_back(start(Quat(Eigen::AngleAxisd(2 * kPi * k / kStarts, Vec3::UnitY()))));
    }
    return all;
  }

  Pose settled(Pose pose, int steps) const {
    double cost = cost_of(pose), damping = 1e-4;
    for (int step = 0; step < steps; ++step) {
      const Eigen::VectorXd r = residuals(pose);
      Eigen::MatrixXd J(r.size(), unknowns());
      constexpr double kDelta = 1e-5;
      for (int k = 0; k < unknowns(); ++k) {
        Eigen::VectorXd d = Eigen::VectorXd::Zero(unknowns());
        d[k] = kDelta;
        J.col(k) = (residuals(moved(pose, d)) - r) / kDelta;
      }
      const Eigen::VectorXd weight = weights(r);
      const Eigen::MatrixXd JtW = J.transpose() * weight.asDiagonal();
      const Eigen::MatrixXd H = JtW * J;
      const Eigen::VectorXd g = JtW * r;
      bool better = false;
      for (int attempt = 0; attempt < 5 && !better; ++attempt) {
        Eigen::MatrixXd damped = H;
        damped.diagonal().array() += damping;
        const Eigen::VectorXd d = -damped.ldlt().solve(g);
        const Pose next = moved(pose, d);
        const double next_cost = d.allFinite() ? cost_of(next) : cost;
        better = next_cost < cost;
        damping = better ? std::max(1e-7, damping / 4) : damping * 8;
        if (!better) continue;
        const bool done = cost - next_cost < 1e-5 * cost;
        pose = next;
        cost = next_cost;
        if (done) return pose;
      }
      if (!better) break;
    }
    return pose;
  }

  // Whether the joints lie elsewhere, seen from the root.
  bool differ(const Pose& a, const Pose& b) const {
    const std::vector<Transform> here = posed_joints(skeleton_, a),
                                 there = posed_joints(skeleton_, b);
    double sum = 0;
    for (std::size_t j = 0; j < here.size(); ++j)
      sum += ((here[j].translation() - here[0].translation()) -
              (there[j].translation() - there[0].translation()))
                 .norm();
    return sum > kApart * height_ * double(here.size());
  }

  double cost_of(const Pose& pose) const {
    const Eigen::VectorXd r = residuals(pose);
    const Eigen::Index seen = 2 * Eigen::Index(places_.size());
    double cost = r.tail(r.size() - seen).squaredNorm();
    for (Eigen::Index i = 0; i < seen; i += 2) {
      const double e = r.segment<2>(i).squaredNorm(), c = kOutlier * kOutlier;
      cost += c * e / (c + e);  // Geman–McClure
    }
    return cost;
  }

 private:
  // The body turned so, what may turn at rest, over the places seen.
  Pose start(const Quat& turn) const {
    Pose pose = mine_;
    for (const int j : free_) pose.rotations[j] = Quat::Identity();
    pose.rotations[0] = turn;
    const std::vector<Transform> posed = posed_joints(skeleton_, pose);
    Vec3 off = Vec3::Zero();
    for (const Place& place : places_) {
      const Vec3 here = posed[place.joint] * place.at;
      off += camera_.ray(place.seen).at_z(here.z()) - here;
    }
    pose.root_position += off / double(places_.size());
    return pose;
  }

  int unknowns() const { return 3 + 3 * int(free_.size()); }

  Pose moved(Pose pose, const Eigen::VectorXd& d) const {
    pose.root_position += height_ * d.head<3>();
    for (std::size_t k = 0; k < free_.size(); ++k) {
      const Vec3 turn = d.segment<3>(3 + 3 * Eigen::Index(k));
      const double angle = turn.norm();
      if (angle < 1e-12) continue;
      Quat& rotation = pose.rotations[free_[k]];
      rotation = (rotation * Quat(Eigen::AngleAxisd(angle, turn / angle))).normalized();
    }
    return pose;
  }

  // In heights of the figure: two per place; three per joint for its bend (for the root, its turn
  // from where it was), three for what no joint can do; two for uprightness, one for the root's
  // depth.
  Eigen::VectorXd residuals(const Pose& pose) const {
    const std::vector<Transform> posed = posed_joints(skeleton_, pose);
    Eigen::VectorXd r(2 * Eigen::Index(places_.size()) + 6 * Eigen::Index(free_.size()) + 3);
    Eigen::Index i = 0;
    const double unit = height_ * camera_.pixels_per_unit(0);
    for (const Place& place : places_) {
      const Vec3 X = posed[place.joint] * place.at;
      constexpr double kBehind = 10;  // heights
      if (camera_.in_front(X))
        r.segment<2>(i) = (camera_.project(X) - place.seen) / unit;
      else
        r.segment<2>(i).setConstant(kBehind);
      i += 2;
    }
    for (const int j : free_) {
      const Vec3 turn = turn_of(pose.rotations[j]);
      r.segment<3>(i) = j > 0 ? (is_trunk(skeleton_, j) ? kStiff : kCalm) * turn
                        : posed_
                            ? kStay * turn_of(mine_.rotations[0].conjugate() * pose.rotations[0])
                            : Vec3(Vec3::Zero());
      r.segment<3>(i + 3) = kLimit * (j > 0 ? beyond(limits_[j], turn) : Vec3(Vec3::Zero()));
      i += 6;
    }
    const Vec3 up = pose.rotations[0] * Vec3::UnitY();
    r[i++] = kUpright * up.x();
    r[i++] = kUpright * up.z();
    r[i++] = kUpright * pose.root_position.z() / height_;
    return r;
  }

  Eigen::VectorXd weights(const Eigen::VectorXd& r) const {
    Eigen::VectorXd weight = Eigen::VectorXd::Ones(r.size());
    for (Eigen::Index i = 0; i < 2 * Eigen::Index(places_.size()); i += 2) {
      const double c = kOutlier * kOutlier, e = r.segment<2>(i).squaredNorm();
      weight.segment<2>(i).setConstant(c * c / ((c + e) * (c + e)));
    }
    return weight;
  }

  const Skeleton& skeleton_;
  FrameCamera camera_;
  const Pose& mine_;
  bool posed_;
  std::vector<JointLimits> limits_;  // by joint
  std::vector<Place> places_;
  std::vector<int> free_;
  double height_ = 1;
};

}  // namespace

std::vector<Pose> suggested_poses(const Document& document, int frame) {
  const Pose& mine = document.frames.at(frame).pose;
  const Search search(document, frame);
  if (!search.possible()) return {mine};
  struct Found {
    double cost;
    Pose pose;
  };
  std::vector<Found> found;
  for (const Pose& start : search.starts()) {
    Pose pose = search.settled(start, kSteps);
    const double cost = search.cost_of(pose);
    found.push_back({cost, std::move(pose)});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.cost < b.cost; });
  // Each limb may have settled on the wrong side of the paper.
  Found best = found[0];
  for (const int joint : search.free()) {
    if (joint == 0 || !leans(document.skeleton, best.pose, joint)) continue;
    const Pose other = search.settled(
        with_bone_flipped(document.skeleton, best.pose, end_of_bone(document.skeleton, joint)),
        kSteps);
    if (const double cost = search.cost_of(other); cost < best.cost) best = {cost, other};
  }
  std::vector<Pose> poses = {search.settled(best.pose, 2 * kSteps)};
  for (const Found& rival : found) {
    if (poses.size() == kMostRivals || rival.cost > kNearlyAsGood * best.cost + kGood) break;
    if (std::all_of(poses.begin(), poses.end(),
                    [&](const Pose& pose) { return search.differ(pose, rival.pose); }))
      poses.push_back(rival.pose);
  }
  return poses;
}

Pose suggested_pose(const Document& document, int frame) {
  return suggested_poses(document, frame)[0];
}

Pose with_lean_flipped(const Document& document, int frame, const Pose& pose, int joint) {
  const Skeleton& skeleton = document.skeleton;
  const Pose flipped = with_bone_flipped(skeleton, pose, end_of_bone(skeleton, joint));
  const Search search(document, frame);
  if (!search.possible()) return flipped;
  const Pose settled = search.settled(flipped, kSteps);
  const auto lean = [&](const Pose& p) {
    const std::vector<Transform> posed = posed_joints(skeleton, p);
    return posed[end_of_bone(skeleton, joint)].translation().z() -
           posed[start_of_bone(skeleton, joint)].translation().z();
  };
  // Where settling leads back, the plain flip is what was asked for.
  return lean(settled) * lean(flipped) > 0 ? settled : flipped;
}

bool leans(const Skeleton& skeleton, const Pose& pose, int joint) {
  constexpr double kSine = 0.2588;  // of 15°
  const std::vector<Transform> posed = posed_joints(skeleton, pose);
  const Vec3 bone = posed[end_of_bone(skeleton, joint)].translation() -
                    posed[start_of_bone(skeleton, joint)].translation();
  return std::abs(bone.z()) > kSine * bone.norm() && bone.norm() > 1e-9;
}

}  // namespace artisketch
