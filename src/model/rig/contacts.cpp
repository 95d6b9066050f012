#include <algorithm>
#include <cmath>

#include "model/rig/feet.h"

namespace artisketch {
namespace {

// All of a leg's length, and seconds.
constexpr double kLow = 0.06;    // higher than this above where it stands, a foot is off the ground
constexpr double kStill = 0.5;   // a leg a second: a foot that swings goes at three or more
constexpr double kQuiet = 0.06;  // and at a contact's ends this: one that lands goes faster
constexpr double kBlink = 0.08;  // shorter contacts, and shorter gaps in one, are noise

// The height at which most of the values lie, to within a band; where two do as well, the one that
// a ground at zero would give.
double usual_height(std::vector<double> heights, double leg) {
  std::sort(heights.begin(), heights.end());
  constexpr double kBand = 0.03;
  double best = heights.front();
  double most = -1;
  for (std::size_t first = 0, last = 0; first < heights.size(); ++first) {
    while (last < heights.size() && heights[last] <= heights[first] + kBand * leg) ++last;
    const double middle = heights[first + (last - first) / 2];
    const bool on_zero = middle > -0.02 * leg && middle < 0.3 * leg;
    const double votes = double(last - first) * (on_zero ? 1.5 : 1);
    if (votes > most) {
      most = votes;
      best = middle;
    }
  }
  return best;
}

std::vector<double> speeds_of(const std::vector<Vec3>& at, double step) {
  const std::size_t count = at.size();
  std::vector<double> speeds(count, 0);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t a = k > 0 ? k - 1 : 0, b = std::min(k + 1, count - 1);
    if (b > a) speeds[k] = (at[b] - at[a]).norm() / (double(b - a) * step);
  }
  return speeds;
}

// Runs of `value` that are shorter than `least` become the other.
void drop_short(std::vector<bool>& flags, bool value, std::size_t least) {
  for (std::size_t k = 0; k < flags.size();) {
    std::size_t end = k;
    while (end < flags.size() && flags[end] == flags[k]) ++end;
    const bool at_an_end = k == 0 || end == flags.size();
    if (flags[k] == value && end - k < least && !at_an_end)
      for (std::size_t i = k; i < end; ++i) flags[i] = !value;
    k = end;
  }
}

// A contact begins and ends where the foot goes from pose to pose as slowly as one that stands, if
// it ever does so in it: from there on inward, since outward it lands and leaves.
//   low    where it may stand at all
//   quiet  what it goes from pose to pose at most
void find_ends(std::vector<bool>& flags, const std::vector<bool>& low, const std::vector<Vec3>& at,
               double quiet) {
  const auto still = [&](std::size_t k) { return (at[k + 1] - at[k]).norm() <= quiet; };
  const std::size_t count = flags.size();
  std::vector<bool> found = flags;
  for (std::size_t k = 0; k < count;) {
    std::size_t end = k;
    while (end < count && flags[end] == flags[k]) ++end;
    if (flags[k]) {
      std::size_t first = k, last = end;
      while (first + 1 < last && !still(first)) ++first;
      while (last - 1 > first && !still(last - 2)) --last;
      if (last - first > 1) {
        while (first > 0 && low[first - 1] && still(first - 1)) --first;
        while (last < count && low[last] && still(last - 1)) ++last;
        std::fill(found.begin() + std::ptrdiff_t(k), found.begin() + std::ptrdiff_t(end), false);
        std::fill(found.begin() + std::ptrdiff_t(first), found.begin() + std::ptrdiff_t(last),
                  true);
      }
    }
    k = end;
  }
  flags = std::move(found);
}

std::vector<bool> contacts(const std::vector<Vec3>& at, double stance, double leg, double step) {
  const std::vector<double> speeds = speeds_of(at, step);
  std::vector<bool> flags, low;
  for (std::size_t k = 0; k < at.size(); ++k) {
    low.push_back(std::abs(at[k].y() - stance) < kLow * leg);
    flags.push_back(low[k] && speeds[k] < kStill * leg);
  }
  const auto least = std::size_t(std::lround(kBlink / step));
  drop_short(flags, false, least);
  drop_short(flags, true, least);
  find_ends(flags, low, at, kQuiet * leg * step);
  return flags;
}

}  // namespace

void find_contacts(std::vector<FootTrack>& feet, double leg, double step) {
  if (feet.empty() || leg <= 0) return;
  const std::size_t count = feet[0].ankle.size();
  std::vector<double> lowest(count, 1e300);
  for (const FootTrack& foot : feet)
    for (std::size_t k = 0; k < count; ++k) lowest[k] = std::min(lowest[k], foot.ankle[k].y());
  const double ground = usual_height(lowest, leg);
  for (FootTrack& foot : feet) {
    foot.stance = ground;
    foot.stands = contacts(foot.ankle, ground, leg, step);
    // Toes are as high as they are while the foot is flat.
    std::vector<double> heights;
    for (std::size_t k = 0; k < count; ++k)
      if (foot.stands[k]) heights.push_back(foot.toe[k].y());
    if (heights.empty()) {
      foot.toes_stand.assign(count, false);
      continue;
    }
    std::nth_element(heights.begin(), heights.begin() + std::ptrdiff_t(heights.size() / 2),
                     heights.end());
    foot.toes_stand = contacts(foot.toe, heights[heights.size() / 2], leg, step);
  }
}

}  // namespace artisketch
