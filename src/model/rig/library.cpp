#include "model/rig/library.h"

#include <cstdlib>

#include "model/rig/clip_making.h"
#include "model/rig/puppet.h"

namespace artisketch {
namespace {

constexpr double kKeys = 24;  // a second

using Make = Pose (*)(const Puppet&, const ClipStyle&, double phase);
struct Row {
  LibraryClip clip;
  double period;  // seconds
  bool (*fits)(const Puppet&);
  Make pose;
};
bool upright(const Puppet& body) {
  return body.stands_up();
}
bool many_legged(const Puppet& body) {
  return body.on_many_legs();
}
const Row kRows[] = {
    {{"idle", "stands and breathes"}, 3, [](const Puppet&) { return true; }, idle_pose},
    {{"walk", "walks on the spot"}, 1.0, &upright, walk_pose},
    {{"run", "runs on the spot"}, 0.64, &upright, run_pose},
    {{"walk", "walks on the spot"}, 1.1, &many_legged, four_walk_pose},
    {{"trot", "trots on the spot"}, 0.64, &many_legged, trot_pose},
    {{"jump", "jumps up and lands"}, 1.3, &upright, jump_pose},
    {{"wave", "waves its left hand"},
     2.4,
     [](const Puppet& body) { return body.has_arms() && !body.has_wings() && body.stands_up(); },
     wave_pose},
    {{"sit", "sits down and gets up"},
     3.2,
     [](const Puppet& body) { return body.stands_up() && !body.has_wings(); },
     sit_pose},
};

}  // namespace

std::vector<LibraryClip> library_clips(const Skeleton& skeleton) {
  const Puppet body(skeleton);
  std::vector<LibraryClip> fitting;
  for (const Row& row : kRows)
    if (row.fits(body)) fitting.push_back(row.clip);
  return fitting;
}

Result<Clip> library_clip(const Skeleton& skeleton, std::string_view name, const ClipStyle& style) {
  const Puppet body(skeleton);
  std::string fitting;
  for (const Row& row : kRows) {
    if (!row.fits(body)) continue;
    fitting += (fitting.empty() ? "" : ", ") + std::string(row.clip.name);
    if (name != row.clip.name) continue;
    Clip clip{row.clip.name, {}, {}};
    const double length = row.period / style.speed;
    const int keys = std::max(8, int(std::lround(length * kKeys)));
    for (int k = 0; k <= keys; ++k) {
      clip.times.push_back(length * k / keys);
      clip.poses.push_back(row.pose(body, style, double(k) / keys));
    }
    // To the last bit, so that it can go round.
    clip.poses.back() = clip.poses.front();
    return clip;
  }
  return bad_input("no clip '" + std::string(name) + "' fits this skeleton: there are " + fitting);
}

Animation animation_of(const Clip& clip) {
  constexpr double kTurn = 0.25;         // degrees
  constexpr double kMove = 0.002;        // of the root's height
  constexpr std::size_t kFarthest = 60;  // keys between two that stay
  const auto said_by = [&](std::size_t a, std::size_t b) {
    for (std::size_t k = a + 1; k < b; ++k) {
      const double t = (clip.times[k] - clip.times[a]) / (clip.times[b] - clip.times[a]);
      const Pose &from = clip.poses[a], &to = clip.poses[b], &at = clip.poses[k];
      const Vec3 root = from.root_position + t * (to.root_position - from.root_position);
      if ((root - at.root_position).norm() > kMove * std::abs(clip.poses[0].root_position.y()))
        return false;
      for (std::size_t j = 0; j < at.rotations.size(); ++j)
        if (from.rotations[j].slerp(t, to.rotations[j]).angularDistance(at.rotations[j]) >
            radians(kTurn))
          return false;
    }
    return true;
  };
  Animation animation;
  animation.name = clip.name;
  const auto keep = [&](std::size_t k) {
    animation.keys.push_back({clip.times[k], clip.poses[k], ""});
  };
  keep(0);
  for (std::size_t last = 0; last + 1 < clip.poses.size();) {
    std::size_t next = last + 1;
    while (next + 1 < clip.poses.size() && next + 1 - last <= kFarthest && said_by(last, next + 1))
      ++next;
    keep(next);
    last = next;
  }
  return animation;
}

Result<ClipWish> clip_wish(const std::string& words) {
  ClipWish wish;
  const std::size_t colon = words.find(':');
  wish.name = words.substr(0, colon);
  const struct {
    const char* name;
    double* value;
  } settings[] = {{"speed", &wish.style.speed},
                  {"stride", &wish.style.stride},
                  {"bounce", &wish.style.bounce},
                  {"weight", &wish.style.weight}};
  for (std::size_t at = colon; at < words.size();) {
    const std::size_t end = std::min(words.find(',', at + 1), words.size());
    const std::string one = words.substr(at + 1, end - at - 1);
    const std::size_t equals = one.find('=');
    bool known = false;
    for (const auto& setting : settings) {
      if (equals == one.npos || one.substr(0, equals) != setting.name) continue;
      char* stop = nullptr;
      const std::string number = one.substr(equals + 1);
      *setting.value = std::strtod(number.c_str(), &stop);
      known = !number.empty() && *stop == 0 && *setting.value >= 0.1 && *setting.value <= 4;
    }
    if (!known)
      return bad_input("'" + one +
                       "': wanted speed, stride, bounce or weight, from 0.1 to 4, like " +
                       wish.name + ":stride=1.2");
    at = end;
  }
  return wish;
}

}  // namespace artisketch
