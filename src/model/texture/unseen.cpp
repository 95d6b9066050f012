#include "model/texture/unseen.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace artisketch {
namespace {

constexpr double kAlong = 8;  // a step along the bone counts as so many round it
// Between these qualities what is seen holds out against what lies beside: below, it is at a slant,
// or taken from farther inside an outline, and may be a smear.
constexpr float kSeenBadly = 0.15f, kSeenWell = 0.5f;
constexpr double kDetour = 0.05;  // of the figure's size: the way worth going for what is better
constexpr float kMatch = 0.2f;    // how unlike its palette a colour may be that spreads
constexpr float kLittle = 1e-3f;
constexpr float kHold = 20;          // of what is seen so well, against what lies beside
constexpr int kMost = 6;             // colours of a part
constexpr int kVotes = 10;           // rounds: more would have belts end on their way round
constexpr int kSofteningRounds = 2;  // of the borders between colours
constexpr double kFar = std::numeric_limits<double>::infinity();

// What the paint shows at the vertices.
struct Seen {
  std::vector<Rgb> colour;
  std::vector<float> quality;  // 0 where nothing is painted
};
Seen seen_colours(const Mesh& mesh, const std::vector<int>& chosen, const DrawnSurface& surface) {
  const Eigen::Index n = mesh.V.rows();
  Seen seen{std::vector<Rgb>(n, Rgb::Zero()), std::vector<float>(n, 0.0f)};
  std::vector<float> sum(n, 0.0f);
  for (int f = 0; f < mesh.F.rows(); ++f) {
    if (chosen[f] < 0) continue;
    const SurfaceView& view = surface.views[chosen[f]];
    for (int k = 0; k < 3; ++k) {
      // A little inside, where it is sure to be the triangle that is seen.
      const Vec3 w = Vec3::Constant(0.1) + 0.7 * Vec3::Unit(k);
      const auto c = view.colour(surface.sketches, mesh.F, f, w);
      if (!c) continue;
      const int v = mesh.F(f, k);
      seen.colour[v] += *c;
      sum[v] += 1;
      seen.quality[v] = std::max(seen.quality[v], view.quality[f]);
    }
  }
  for (Eigen::Index v = 0; v < n; ++v)
    if (sum[v] > 0) seen.colour[v] /= sum[v];
  return seen;
}

// The colours that a part is painted in, the most common first.
struct Palette {
  std::vector<Rgb> colours;
  int nearest(const Rgb& c) const {
    int best = -1;
    float least = std::numeric_limits<float>::max();
    for (int i = 0; i < int(colours.size()); ++i)
      if (const float d = (colours[i] - c).squaredNorm(); d < least) {
        least = d;
        best = i;
      }
    return best;
  }
};

// From colours and how much each counts: the heaviest of what is left with all that is like it,
// again and again. A speck of ink or a smear at the edge of what is seen makes none.
Palette palette_of(const std::vector<std::pair<Rgb, double>>& samples) {
  constexpr float kAlike = 0.16f;
  constexpr double kLeast = 0.05;  // of all, for a colour worth the name
  constexpr int kBins = 12;        // a channel
  double all = 0;
  std::vector<int> bin;
  std::vector<double> weight(kBins * kBins * kBins, 0.0);
  for (const auto& [c, w] : samples) {
    const auto part = [&colour = c](int k) {
      return std::clamp(int(colour[k] * kBins), 0, kBins - 1);
    };
    bin.push_back((part(0) * kBins + part(1)) * kBins + part(2));
    weight[bin.back()] += w;
    all += w;
  }
  Palette palette;
  std::vector<std::uint8_t> used(samples.size(), 0);
  while (int(palette.colours.size()) < kMost) {
    const int top = int(std::max_element(weight.begin(), weight.end()) - weight.begin());
    if (weight[top] <= 0) break;
    Rgb middle = Rgb::Zero();
    double sum = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (!used[i] && bin[i] == top)
        middle += float(samples[i].second) * samples[i].first, sum += samples[i].second;
    middle /= float(sum);
    Rgb mean = Rgb::Zero();
    sum = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (used[i] || !((samples[i].first - middle).norm() <= kAlike)) continue;
      used[i] = 1;
      mean += float(samples[i].second) * samples[i].first;
      sum += samples[i].second;
      weight[bin[i]] = std::max(weight[bin[i]] - samples[i].second, 0.0);
    }
    weight[top] = 0;
    if (sum >= kLeast * all || palette.colours.empty())
      palette.colours.push_back(mean / float(sum));
  }
  return palette;
}

// Unit directions of the joints' bones in the rest pose.
std::vector<Vec3> bone_directions(const Skeleton& skeleton) {
  const std::vector<Vec3> rest = rest_positions(skeleton);
  std::vector<Vec3> directions;
  for (int j = 0; j < skeleton.size(); ++j) {
    Vec3 way = Vec3::Zero();
    for (const int child : skeleton.children(j)) way += rest[child] - rest[j];
    if (const int parent = skeleton.joints[j].parent; way.norm() < 1e-9 && parent >= 0)
      way = rest[j] - rest[parent];
    directions.push_back(way.norm() > 1e-9 ? Vec3(way.normalized()) : Vec3(Vec3::UnitY()));
  }
  return directions;
}

// Spreads the colours of each part's palette over what isn't seen of it.
class Spread {
 public:
  Spread(const Model& model, const Adjacency& beside, const Seen& seen)
      : model_(model),
        beside_(beside),
        seen_(seen),
        bones_(bone_directions(model.skeleton)),
        palettes_(model.skeleton.joints.size()),
        label_(seen.quality.size(), -1),
        holder_(label_.size()) {
    std::vector<std::vector<std::pair<Rgb, double>>> samples(palettes_.size());
    for (int v = 0; v < int(label_.size()); ++v)
      if (seen.quality[v] > 0)
        samples[part(v)].emplace_back(seen.colour[v],
                                      std::max(seen.quality[v] - kPulledQuality, kLittle));
    for (std::size_t j = 0; j < palettes_.size(); ++j) palettes_[j] = palette_of(samples[j]);
    reach_all();
    vote();
  }
  // Nothing where nothing is seen from.
  std::optional<Rgb> colour(int v) const {
    if (label_[v] < 0) return std::nullopt;
    return palettes_[holder_[v]].colours[label_[v]];
  }
  bool passes(int from, int to) const { return holder_[from] == holder_[to]; }

 private:
  int part(int vertex) const { return model_.weights.joints(vertex, 0); }
  bool shown(int joint) const { return !palettes_[joint].colours.empty(); }
  double step(int from, int to) const {
    const Vec3 d = (model_.mesh.V.row(to) - model_.mesh.V.row(from)).transpose();
    const double along = d.dot(bones_[part(to)]);
    return std::sqrt(d.squaredNorm() + (kAlong * kAlong - 1) * along * along);
  }
  // Where to begin: each vertex takes the colour of the nearest one seen, of its own part first, of
  // any where its part is in pieces or seen nowhere (Dijkstra 1959).
  void reach_all() {
    std::vector<double> way(label_.size(), kFar);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open;
    const double size = bounds(model_.mesh.V).sizes().norm();
    for (int v = 0; v < int(label_.size()); ++v) {
      if (seen_.quality[v] <= 0) continue;
      const Palette& palette = palettes_[part(v)];
      const int label = palette.nearest(seen_.colour[v]);
      if ((palette.colours[label] - seen_.colour[v]).norm() > kMatch) continue;  // ink, say
      label_[v] = label;
      holder_[v] = part(v);
      way[v] = seen_.quality[v] < kSeenBadly ? kDetour * size : 0;
    }
    for (const bool across : {false, true}) {
      const std::vector<int> before = label_;
      for (int v = 0; v < int(label_.size()); ++v)
        if (before[v] >= 0) open.emplace(way[v], v);
      while (!open.empty()) {
        const double here = open.top().first;
        const int v = open.top().second;
        open.pop();
        if (here > way[v]) continue;
        // Neighbours' neighbours too: along edges alone, ways round a bone would zigzag.
        const auto reach = [&](int from, int to) {
          if ((before[to] >= 0 && across) ||
              !(across || part(to) == part(from) || !shown(part(to))))
            return false;
          const double there = here + step(v, to);
          if (there >= way[to]) return true;
          way[to] = there;
          label_[to] = label_[v];
          holder_[to] = holder_[v];
          open.emplace(there, to);
          return true;
        };
        for (const int u : beside_.of(v))
          if (reach(v, u))
            for (const int w : beside_.of(u)) reach(u, w);
      }
    }
  }
  // Harmonic shares of each colour, held by what is seen as firmly as it is seen well; the largest
  // wins. A smear dies out on the way where a belt goes on.
  void vote() {
    const int n = int(label_.size());
    std::vector<std::array<float, kMost>> share(n);
    std::vector<int> free;
    for (int v = 0; v < n; ++v) {
      share[v].fill(0);
      if (label_[v] < 0) continue;
      share[v][label_[v]] = 1;
      if (seen_.quality[v] < kSeenWell) free.push_back(v);
    }
    for (int round = 0; round < kVotes; ++round) {
      for (const int v : free) {
        std::array<float, kMost> sum;
        sum.fill(0);
        float all = 0;
        for (const int u : beside_.of(v)) {
          if (label_[u] < 0 || !passes(u, v)) continue;
          const double length = step(u, v);
          const float w = float(1 / std::max(length * length, 1e-12));
          all += w;
          for (int l = 0; l < kMost; ++l) sum[l] += w * share[u][l];
        }
        if (all <= 0) continue;
        const float sure = (seen_.quality[v] - kSeenBadly) / (kSeenWell - kSeenBadly),
                    hold = kHold * std::max(sure, 0.0f) * all;
        if (hold > 0) sum[label_[v]] += hold;
        for (int l = 0; l < kMost; ++l) share[v][l] = sum[l] / (all + hold);
      }
      std::reverse(free.begin(), free.end());
    }
    for (const int v : free)
      label_[v] = int(std::max_element(share[v].begin(), share[v].end()) - share[v].begin());
  }

  const Model& model_;
  const Adjacency& beside_;
  const Seen& seen_;
  std::vector<Vec3> bones_;
  std::vector<Palette> palettes_;  // by joint; empty where its part is seen nowhere
  std::vector<int> label_;         // of each vertex, in the palette of its holder; −1: none
  std::vector<int> holder_;        // the joint whose colours it takes
};

}  // namespace

std::vector<Rgb> plain_colours(const Model& model, const Adjacency& beside,
                               const std::vector<int>& chosen, const DrawnSurface& surface) {
  const Seen seen = seen_colours(model.mesh, chosen, surface);
  const Spread spread(model, beside, seen);
  std::vector<Rgb> colour = seen.colour;
  std::vector<int> unseen;
  for (int v = 0; v < int(colour.size()); ++v) {
    if (seen.quality[v] >= kSeenWell) continue;
    if (const auto c = spread.colour(v)) colour[v] = *c;
    if (seen.quality[v] <= 0) unseen.push_back(v);
  }
  for (int round = 0; round < kSofteningRounds; ++round) {
    const std::vector<Rgb> before = colour;
    for (const int v : unseen) {
      Rgb sum = 2 * before[v];
      float all = 2;
      for (const int u : beside.of(v)) {
        if (!spread.passes(u, v)) continue;
        sum += before[u];
        all += 1;
      }
      colour[v] = sum / all;
    }
  }
  return colour;
}

}  // namespace artisketch
