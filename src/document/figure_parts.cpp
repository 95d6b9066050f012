#include "document/figure_parts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "document/edit.h"
#include "document/figure_cells.h"

namespace artisketch {
namespace {

constexpr double kAlongBone = 0.5;  // cells along a bone
constexpr double kRough = 0.02;     // of the picture: how far a bone may lie beside its part

// ---------------------------------------------------------------- the bones

struct PosedBone {
  int joint = 0, child = -1;      // −1: ends in no joint
  Vec2 a, b;                      // cells
  double za = 0, zb = 0;          // toward the viewer, cells
  double trim_a = 0, trim_b = 0;  // of its length: near a joint two parts meet
  Vec2 at(double t) const { return a + t * (b - a); }
  double z(double t) const { return za + t * (zb - za); }
};

struct Skeletal {
  std::vector<int> parts;  // joints; a part's index here is its label
  std::vector<int> label;  // by joint, −1: no part
  Flags trunk;             // by label: several limbs hang on it
  std::vector<PosedBone> bones;
};

Skeletal bones_in(const Document& document, int frame, double cell) {
  const Skeleton& skeleton = document.skeleton;
  Skeletal all;
  all.label.assign(std::size_t(skeleton.size()), -1);
  const std::vector<std::vector<DrawnBone>> drawn = drawn_bones(document, frame);
  for (const int joint : parts_to_draw(document)) {
    if (role_of(document, joint) != Role::body || is_hidden(document.frames[frame], joint) ||
        drawn[joint].empty())
      continue;
    all.label[joint] = int(all.parts.size());
    all.parts.push_back(joint);
    all.trunk.push_back(drawn[joint].size() > 1);
  }
  const std::vector<Transform> posed = posed_joints(skeleton, document.frames[frame].pose);
  const FrameCamera camera = frame_camera(document, frame);
  const auto depth = [&](int joint) {
    const double z = posed[joint].translation().z();
    return z * camera.pixels_per_unit(z) / cell;
  };
  for (const int joint : all.parts) {
    const std::vector<int> children = skeleton.children(joint);
    for (std::size_t k = 0; k < drawn[joint].size(); ++k) {
      PosedBone bone;
      bone.joint = joint;
      bone.child = children.empty() ? -1 : children[k];
      bone.a = drawn[joint][k].from / cell, bone.b = drawn[joint][k].to / cell;
      bone.za = depth(joint), bone.zb = bone.child < 0 ? bone.za : depth(bone.child);
      all.bones.push_back(bone);
    }
  }
  // Where two parts meet, the bones of both begin equally far from the joint.
  constexpr double kTrim = 0.15;
  for (PosedBone& bone : all.bones) {
    const double length = std::max(1e-9, (bone.b - bone.a).norm());
    for (const PosedBone& other : all.bones) {
      const double least = kTrim * std::min(length, (other.b - other.a).norm()) / length;
      if (other.child == bone.joint) bone.trim_a = std::max(bone.trim_a, least);
      if (bone.child == other.joint) bone.trim_b = std::max(bone.trim_b, least);
    }
  }
  return all;
}

// ---------------------------------------------------------------- what shows of them

struct Seeds {
  std::vector<int> label;          // by cell, −1: none
  std::vector<int> all, on, seen;  // samples by label: of its bones, on the figure, not covered
};

// How thick a bone's part may be about each place of it, as far as the figure's edge tells.
double thickness(const PosedBone& bone, const std::vector<float>& edge, const Cells& cells,
                 double t) {
  const int c = cells.at(bone.at(t));
  return c < 0 ? 0 : std::min(double(edge[c]), 0.5 * (bone.b - bone.a).norm());
}

// The figure's cell at a place or close by, where a pose is only rough; −1: none.
int figure_cell(const Cells& cells, const Vec2& p) {
  const int reach = std::max(1, int(kRough * std::max(cells.width, cells.height)));
  int best = -1;
  double least = reach + 1;
  for (int v = int(p.y()) - reach; v <= int(p.y()) + reach; ++v)
    for (int u = int(p.x()) - reach; u <= int(p.x()) + reach; ++u) {
      const int c = cells.at(Vec2(u + 0.5, v + 0.5));
      if (c < 0 || !cells.figure[c]) continue;
      if (const double d = (cells.middle(c) - p).norm(); d < least) least = d, best = c;
    }
  return best;
}

// Whether another part's bone lies right before that place.
bool lies_behind(const Skeletal& all, const PosedBone& bone, double t,
                 const std::vector<float>& edge, const Cells& cells) {
  constexpr double kBefore = 0.5;  // of its thickness
  const Vec2 p = bone.at(t);
  for (const PosedBone& other : all.bones) {
    if (other.joint == bone.joint || other.child == bone.joint || bone.child == other.joint)
      continue;
    const Vec2 d = other.b - other.a;
    const double s = std::clamp((p - other.a).dot(d) / std::max(d.squaredNorm(), 1e-9), 0.0, 1.0);
    const double thick = thickness(other, edge, cells, s);
    if ((p - other.at(s)).norm() < thick && other.z(s) - bone.z(t) > kBefore * thick) return true;
  }
  return false;
}

Seeds seeds_of(const Skeletal& all, const Cells& cells) {
  Seeds seeds;
  seeds.label.assign(std::size_t(cells.count()), -1);
  seeds.all.assign(all.parts.size(), 0);
  seeds.on = seeds.seen = seeds.all;
  std::vector<double> depth(std::size_t(cells.count()), -1e9);
  const std::vector<float> edge = inset(cells, cells.figure);
  for (const PosedBone& bone : all.bones) {
    const int label = all.label[bone.joint];
    const int steps = 1 + int((bone.b - bone.a).norm() / kAlongBone);
    for (int i = 0; i <= steps; ++i) {
      const double t = double(i) / steps;
      if (t < bone.trim_a || t > 1 - bone.trim_b) continue;
      ++seeds.all[label];
      const int c = figure_cell(cells, bone.at(t));
      if (c < 0) continue;
      ++seeds.on[label];
      if (lies_behind(all, bone, t, edge, cells)) continue;
      ++seeds.seen[label];
      if (bone.z(t) < depth[c]) continue;
      seeds.label[c] = label;
      depth[c] = bone.z(t);
    }
  }
  return seeds;
}

// ---------------------------------------------------------------- who gets which cell

// Outlines that are there draw what lies in them to their parts; what lies in a thing is no part's.
Shares pulls_of(const Document& document, int frame, const Skeletal& all, const Cells& cells,
                double cell) {
  constexpr float kPull = 0.02f;  // a step within one colour: 1
  Shares pulls(cells.count(), int(all.parts.size()));
  for (std::size_t l = 0; l < all.parts.size(); ++l) {
    const std::vector<std::vector<Vec2>> lines =
        closed_contours(document.frames[frame], all.parts[l]);
    std::vector<Polyline> closed;
    for (const std::vector<Vec2>& line : lines) closed.push_back({line, true});
    if (closed.empty()) continue;
    for (int c = 0; c < cells.count(); ++c)
      if (cells.figure[c] && contains(closed, cell * cells.middle(c))) pulls.at(c, int(l)) = kPull;
  }
  return pulls;
}

std::vector<int> likeliest(const Cells& cells, const Shares& likely) {
  std::vector<int> labels;
  for (int c = 0; c < cells.count(); ++c) labels.push_back(likely.largest(c));
  return labels;
}

// Of a limb's places the largest piece stays; others are their next likeliest part's.
void keep_whole(const Cells& cells, const Skeletal& all, Shares& likely) {
  const std::vector<int> labels = likeliest(cells, likely);
  Flags known(labels.size(), 0);
  std::vector<std::vector<int>> largest(all.parts.size());
  std::vector<std::vector<int>> rest;
  for (int c = 0; c < cells.count(); ++c) {
    const int label = labels[c];
    if (known[c] || label < 0 || all.trunk[label]) continue;
    std::vector<int> piece = {c};
    known[c] = 1;
    for (std::size_t i = 0; i < piece.size(); ++i)
      beside(cells, piece[i], [&](int n) {
        if (!known[n] && labels[n] == label) known[n] = 1, piece.push_back(n);
      });
    if (piece.size() > largest[label].size()) std::swap(piece, largest[label]);
    rest.push_back(std::move(piece));
  }
  for (const std::vector<int>& piece : rest)
    for (const int c : piece) likely.at(c, labels[c]) = 0;
}

// ---------------------------------------------------------------- where parts meet

struct Disc {
  Vec2 middle = Vec2::Zero();  // cells
  double radius = 0;
};

class Joints {
 public:
  Joints(const Cells& cells, const std::vector<int>& labels, int parts)
      : cells_(cells), labels_(labels) {
    for (int l = 0; l < parts; ++l) {
      const std::vector<float> in = inset(cells, chosen(l, l));
      own_.push_back(in.empty() ? 0 : *std::max_element(in.begin(), in.end()));
    }
  }

  // As wide as the figure where the two part, about the middle of the cut nearest to the joint; as
  // wide as the slimmer of them, where others cover the joint.
  Disc between(int a, int b, const Vec2& joint) const {
    const double most = std::min(own_[a], own_[b]);
    Disc disc{joint, most};
    const std::vector<float> in = inset(cells_, chosen(a, b));
    double best = -1e9;
    for (int c = 0; c < cells_.count(); ++c) {
      if (labels_[c] != a) continue;
      bool rim = false;
      beside(cells_, c, [&](int n) { rim |= labels_[n] == b; });
      if (!rim) continue;
      const double worth = std::min(double(in[c]), most) - (cells_.middle(c) - joint).norm();
      if (worth > best) best = worth, disc = {cells_.middle(c), std::min(double(in[c]), most)};
    }
    return disc;
  }

 private:
  Flags chosen(int a, int b) const {
    Flags flags;
    for (const int l : labels_) flags.push_back(l == a || l == b);
    return flags;
  }
  const Cells& cells_;
  const std::vector<int>& labels_;
  std::vector<float> own_;  // the radius of the largest disc in each part
};

// Whether a place lies in the hull of two discs.
bool within(const Disc& a, const Disc& b, const Vec2& p) {
  const Vec2 d = b.middle - a.middle;
  const double t = std::clamp((p - a.middle).dot(d) / std::max(d.squaredNorm(), 1e-9), 0.0, 1.0);
  return (p - a.middle - t * d).norm() < a.radius + t * (b.radius - a.radius);
}

// By label, pairs of discs whose hulls the part fills.
using Fillings = std::vector<std::vector<std::pair<Disc, Disc>>>;

Fillings fillings_of(const Skeletal& all, const Joints& joints) {
  Fillings fillings(all.parts.size());
  std::vector<std::optional<Disc>> start(all.parts.size());
  for (const PosedBone& bone : all.bones) {
    const int a = all.label[bone.joint], b = bone.child < 0 ? -1 : all.label[bone.child];
    if (b < 0) continue;
    const Disc disc = joints.between(a, b, bone.b);
    start[b] = disc;
    fillings[b].push_back({disc, disc});
    fillings[a].push_back({start[a] ? *start[a] : disc, disc});
  }
  return fillings;
}

// ---------------------------------------------------------------- from cells to pixels

// By pixel, the likeliest part among the cells about it, those of its own colour first.
std::vector<int> pixel_labels(const SegmentedImage& image, const Cells& cells,
                              const Shares& likely) {
  constexpr float kAlike = 0.05f;
  std::vector<int> labels(image.tones.size(), -1);
  std::vector<float> sum(std::size_t(likely.labels));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::size_t pixel = std::size_t(y) * image.width + x;
      if (image.paper[pixel]) continue;
      const Vec2 p = Vec2(x + 0.5, y + 0.5) / cells.size;
      std::fill(sum.begin(), sum.end(), 0.0f);
      for (int v = int(p.y()) - 1; v <= int(p.y()) + 1; ++v)
        for (int u = int(p.x()) - 1; u <= int(p.x()) + 1; ++u) {
          if (u < 0 || v < 0 || u >= cells.width || v >= cells.height) continue;
          const int c = v * cells.width + u;
          const float away = float((cells.middle(c) - p).squaredNorm());
          const float unlike = unlikeness(image.tones[pixel], cells.tones[c]) / kAlike;
          const float near = std::exp(-2 * away - std::min(4.0f, unlike * unlike));
          for (int l = 0; l < likely.labels; ++l) sum[l] += near * likely.at(c, l);
        }
      const auto best = std::max_element(sum.begin(), sum.end());
      if (best != sum.end() && *best > 0) labels[pixel] = int(best - sum.begin());
    }
  return labels;
}

// The hull of a part's cells; where limbs lie over a trunk, it runs on behind them.
Polyline hull_of(const Cells& cells, const std::vector<int>& labels, int label) {
  std::vector<Vec2> all, hull;
  for (int x = 0; x < cells.width; ++x)
    for (int y = 0; y < cells.height; ++y)
      if (labels[y * cells.width + x] == label) all.push_back(cells.middle(y * cells.width + x));
  // Andrew 1979: the lower chain on the way there, the upper one on the way back.
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = hull.size();
    for (const Vec2& p : all) {
      while (hull.size() >= start + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    if (!hull.empty()) hull.pop_back();
    std::reverse(all.begin(), all.end());
  }
  return {hull, true};
}

Flags pixels_of(const SegmentedImage& image, const Cells& cells, const std::vector<int>& labels,
                int label, const Polyline& hull, const Flags& trunk,
                const std::vector<std::pair<Disc, Disc>>& fillings) {
  Flags pixels(labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    pixels[i] = labels[i] == label;
    if (pixels[i] || labels[i] < 0) continue;
    const Vec2 p = Vec2(double(i % image.width) + 0.5, double(i / image.width) + 0.5) / cells.size;
    if (hull.points.size() > 2 && !trunk[labels[i]]) pixels[i] |= contains(hull, p);
    for (const auto& [a, b] : fillings) pixels[i] |= within(a, b, p);
  }
  return pixels;
}

// Before the first outline of a part that lies nearer to the viewer.
void insert(Frame& frame, Contour contour, const std::vector<double>& depth) {
  const auto nearer =
      std::find_if(frame.contours.begin(), frame.contours.end(),
                   [&](const Contour& other) { return depth[other.joint] > depth[contour.joint]; });
  frame.contours.insert(nearer, std::move(contour));
}

// By joint, in steps that are coarse enough for a pose that is only rough; things stand before all.
std::vector<double> depths_of(const Document& document, const Skeletal& all, const Cells& cells) {
  const double step = std::max(1.0, 0.06 * std::max(cells.width, cells.height));
  std::vector<double> depth(all.label.size(), 0);
  for (std::size_t j = 0; j < depth.size(); ++j)
    if (role_of(document, int(j)) != Role::body) depth[j] = 1e9;
  for (const int joint : all.parts) {
    double sum = 0, count = 0;
    for (const PosedBone& bone : all.bones)
      if (bone.joint == joint) sum += bone.z(0.5), ++count;
    depth[joint] = std::round(sum / count / step);
  }
  return depth;
}

}  // namespace

FigureParts with_figure_parts(const Document& document, int frame, const SegmentedImage& image) {
  FigureParts result;
  result.document = document;
  const Cells cells = cells_of(image);
  if (cells.count() == 0) return result;
  const double cell = cells.size * image.pixels;
  const Skeletal all = bones_in(document, frame, cell);
  const Seeds seeds = seeds_of(all, cells);
  Shares likely = meetings(cells, seeds.label, pulls_of(document, frame, all, cells, cell));
  keep_whole(cells, all, likely);
  const std::vector<int> cell_labels = likeliest(cells, likely);
  const Joints joints(cells, cell_labels, int(all.parts.size()));
  const Fillings fillings = fillings_of(all, joints);
  const std::vector<int> labels = pixel_labels(image, cells, likely);
  const std::vector<double> depth = depths_of(document, all, cells);
  constexpr double kOn = 0.5, kSeen = 0.15;  // of the bones
  for (std::size_t l = 0; l < all.parts.size(); ++l) {
    const int joint = all.parts[l];
    if (!contours_of(document.frames[frame], joint).empty()) {
      result.had_outline.push_back(joint);
    } else if (seeds.on[l] < kOn * seeds.all[l]) {
      result.off_figure.push_back(joint);
    } else if (seeds.seen[l] < kSeen * seeds.all[l]) {
      result.behind.push_back(joint);
    } else if (const auto found = outline_of_pixels(
                   image, pixels_of(image, cells, labels, int(l),
                                    all.trunk[l] ? hull_of(cells, cell_labels, int(l)) : Polyline(),
                                    all.trunk, fillings[l]))) {
      insert(result.document.frames[frame], {joint, found->outline, ""}, depth);
      for (const Polyline& hole : found->holes)
        insert(result.document.frames[frame], {joint, hole, ""}, depth);
      result.outlined.push_back(joint);
    }
  }
  return result;
}

}  // namespace artisketch
