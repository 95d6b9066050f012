#include "model/texture/unseen.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace artisketch {
namespace {

constexpr double kAlong = 8;               // a step along the bone counts as so many round it
constexpr double kNear = 0.1;              // of the figure's size: within it, all votes count alike
constexpr std::size_t kMostVoters = 4000;  // of a part: few of many would vote in bars
// Between these qualities what is seen is believed more and more: below, it is at a slant, or taken
// from farther inside an outline, and may be a smear.
constexpr float kSeenBadly = 0.15f, kSeenWell = 0.5f;
constexpr float kMatch = 0.2f;  // how unlike its palette a colour may be that spreads
constexpr float kLittle = 1e-3f;
constexpr int kMost = PlainPaint::kMostColours;
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

// Unit directions of the joints' bones in the rest pose; upwards where they lead to all sides.
std::vector<Vec3> bone_directions(const Skeleton& skeleton) {
  constexpr double kOneWay = 0.5;  // of the bones' lengths, what is left of them in one direction
  const std::vector<Vec3> rest = rest_positions(skeleton);
  std::vector<Vec3> directions;
  for (int j = 0; j < skeleton.size(); ++j) {
    Vec3 way = Vec3::Zero();
    double length = 0;
    for (const int child : skeleton.children(j)) {
      way += rest[child] - rest[j];
      length += (rest[child] - rest[j]).norm();
    }
    if (const int parent = skeleton.joints[j].parent; length < 1e-9 && parent >= 0)
      way = rest[j] - rest[parent];
    const bool one_way = way.norm() > std::max(kOneWay * length, 1e-9);
    directions.push_back(one_way ? Vec3(way.normalized()) : Vec3(Vec3::UnitY()));
  }
  return directions;
}

// Gives what isn't seen of a part a share of each colour of its palette.
class Spread {
 public:
  Spread(const Model& model, const Adjacency& beside, const Seen& seen)
      : model_(model),
        beside_(beside),
        seen_(seen),
        bones_(bone_directions(model.skeleton)),
        palettes_(model.skeleton.joints.size()),
        label_(seen.quality.size(), -1),
        holder_(label_.size()),
        share_(label_.size()),
        own_(label_.size(), 0) {
    std::vector<std::vector<std::pair<Rgb, double>>> samples(palettes_.size());
    for (int v = 0; v < int(label_.size()); ++v)
      if (seen.quality[v] > 0)
        samples[part(v)].emplace_back(seen.colour[v],
                                      std::max(seen.quality[v] - kPulledQuality, kLittle));
    for (std::size_t j = 0; j < palettes_.size(); ++j) {
      palettes_[j] = palette_of(samples[j]);
      if (j > 0) samples[0].insert(samples[0].end(), samples[j].begin(), samples[j].end());
    }
    if (const Palette all = palette_of(samples[0]); !all.colours.empty()) usual_ = all.colours[0];
    begin();
    vote();
    reach_others();
  }
  PlainPaint paint() && {
    PlainPaint out;
    out.palettes.reserve(palettes_.size());
    for (Palette& palette : palettes_) out.palettes.push_back(std::move(palette.colours));
    out.part = std::move(holder_);
    out.share = std::move(share_);
    out.own.assign(label_.size(), -1);
    out.colour = seen_.colour;
    out.usual = usual_;
    for (std::size_t v = 0; v < label_.size(); ++v) {
      if (label_[v] < 0) out.part[v] = -1;
      if (own_[v]) out.own[v] = label_[v];
    }
    return out;
  }

 private:
  // Whether what is seen has a colour of its part: ink has not.
  bool alike(int v) const {
    return (palettes_[part(v)].colours[label_[v]] - seen_.colour[v]).norm() <= kMatch;
  }
  int part(int vertex) const { return model_.weights.joints(vertex, 0); }
  // What is seen has the colour of its part's palette that is nearest, if one is near.
  void begin() {
    for (int v = 0; v < int(label_.size()); ++v) {
      holder_[v] = part(v);
      share_[v].fill(0);
      if (seen_.quality[v] <= 0) continue;
      const Palette& palette = palettes_[part(v)];
      const int label = palette.nearest(seen_.colour[v]);
      label_[v] = label;
      own_[v] = seen_.quality[v] >= (alike(v) ? kSeenBadly : kSeenWell);
      if (!alike(v) && !own_[v]) label_[v] = -1;
      share_[v][label] = 1;
    }
  }
  // What is seen of the same part votes for its colour, the nearer and the better seen the more.
  // Nearness counts heights along the bone above all: belts, cuffs and stockings run round it,
  // and end along a line.
  void vote() {
    const double size = bounds(model_.mesh.V).sizes().norm(), floor = kNear * size;
    struct Voter {
      Vec3 place;
      float weight;
      int label;
    };
    std::vector<std::vector<Voter>> voters(palettes_.size());
    // In a space where the bone's direction is longer.
    const auto stretched = [&](int v) {
      const Vec3 p = model_.mesh.V.row(v).transpose(), &bone = bones_[part(v)];
      return Vec3(p + (kAlong - 1) * p.dot(bone) * bone);
    };
    for (int v = 0; v < int(label_.size()); ++v)
      if (label_[v] >= 0 && alike(v))
        voters[part(v)].push_back(
            {stretched(v), std::max(std::min(seen_.quality[v], kSeenWell) - kSeenBadly, kLittle),
             label_[v]});
    for (std::vector<Voter>& of_part : voters) {
      const std::size_t stride = 1 + of_part.size() / kMostVoters;
      for (std::size_t i = 0; i * stride < of_part.size(); ++i) of_part[i] = of_part[i * stride];
      of_part.resize((of_part.size() + stride - 1) / stride);
    }
    for (int v = 0; v < int(label_.size()); ++v) {
      if (own_[v] || voters[part(v)].empty()) continue;
      std::array<float, kMost> sum;
      sum.fill(0);
      const Vec3 here = stretched(v);
      for (const Voter& voter : voters[part(v)]) {
        const double near = floor * floor / ((voter.place - here).squaredNorm() + floor * floor);
        sum[voter.label] += voter.weight * float(near * near * near * near * near);
      }
      float all = 0;
      for (const float one : sum) all += one;
      if (!(all > 0)) continue;
      for (int l = 0; l < kMost; ++l) share_[v][l] = sum[l] / all;
      label_[v] = int(std::max_element(sum.begin(), sum.end()) - sum.begin());
    }
  }
  // Parts that are seen nowhere take what lies beside them (Dijkstra 1959).
  void reach_others() {
    std::vector<double> way(label_.size(), kFar);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open;
    const std::vector<int> before = label_;
    for (int v = 0; v < int(label_.size()); ++v)
      if (before[v] >= 0) open.emplace(way[v] = 0, v);
    while (!open.empty()) {
      const auto [here, v] = open.top();
      open.pop();
      if (here > way[v]) continue;
      for (const int u : beside_.of(v)) {
        const double there = here + (model_.mesh.V.row(u) - model_.mesh.V.row(v)).norm();
        if (before[u] >= 0 || there >= way[u]) continue;
        way[u] = there;
        label_[u] = label_[v];
        holder_[u] = holder_[v];
        share_[u] = share_[v];
        open.emplace(there, u);
      }
    }
  }

  const Model& model_;
  const Adjacency& beside_;
  const Seen& seen_;
  std::vector<Vec3> bones_;
  std::vector<Palette> palettes_;  // by joint; empty where its part is seen nowhere
  std::vector<int> label_;         // of each vertex, in the palette of its holder; -1: none
  std::vector<int> holder_;        // the joint whose colours it takes
  std::vector<std::array<float, kMost>> share_;
  Rgb usual_ = Rgb::Constant(0.5f);
  std::vector<std::uint8_t> own_;  // whether it keeps what is seen of it
};

}  // namespace

PlainPaint plain_paint(const Model& model, const Adjacency& beside, const std::vector<int>& chosen,
                       const DrawnSurface& surface) {
  return Spread(model, beside, seen_colours(model.mesh, chosen, surface)).paint();
}

}  // namespace artisketch
