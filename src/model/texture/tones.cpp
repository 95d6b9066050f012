#include "model/texture/tones.h"

#include <algorithm>
#include <cmath>

namespace artisketch {
namespace {

constexpr int kBins = 24;             // of a histogram's channel
constexpr double kLeast = 0.04;       // of a part's pixels, for a tone
constexpr int kMostTones = 8;         // of a part
constexpr float kToneWidth = 0.035f;  // how far a tone's pixels are from it
constexpr float kLightest = 0.94f;    // times the lit tone: no shade is lighter,
constexpr float kDarkest = 0.45f;     // none darker,
constexpr float kTinted = 0.16f;      // and none differs more from channel to channel
constexpr float kSame = 0.04f;        // between factors of one kind of shade
constexpr float kOwn = 0.06f;         // how far from the way between its tones a pixel may be
constexpr float kLit = 0.2f;          // of the shade's pixels: less is a highlight
// Drawings in flat colours have them on nine pixels of ten, and one kind of shade; painted and
// rendered ones on hardly more than three of four, and tones at all distances.
constexpr double kFlatShare = 0.85, kOneKind = 0.67;
constexpr int kBorder = 12;  // pixels that a tone and its shade share as a border

struct Tone {
  Rgb colour = Rgb::Zero();
  double pixels = 0;
};

// A part's, or two mirror images' together.
struct PartTones {
  std::vector<Tone> tones;
  std::vector<int> lit;  // of each tone: the one that it is the shade of; −1: lit itself
  int nearest(const Rgb& c, float within) const {
    int best = -1;
    for (int i = 0; i < int(tones.size()); ++i)
      if (const float d = (tones[i].colour - c).norm(); d < within) {
        within = d;
        best = i;
      }
    return best;
  }
};

// The peaks of the colours of a part.
class Histogram {
 public:
  void add(const Pixel& pixel) {
    if (count_.empty()) {
      count_.resize(kBins * kBins * kBins, 0);
      sum_.resize(count_.size(), Rgb::Zero());
    }
    const int at = (bin(pixel[0]) * kBins + bin(pixel[1])) * kBins + bin(pixel[2]);
    count_[at] += 1;
    sum_[at] += rgb_of(pixel);
    all_ += 1;
  }
  std::vector<Tone> tones() {
    std::vector<Tone> tones;
    while (int(tones.size()) < kMostTones && all_ > 0) {
      const int top = int(std::max_element(count_.begin(), count_.end()) - count_.begin());
      Tone tone;
      const int r = top / kBins / kBins, g = top / kBins % kBins, b = top % kBins;
      for (int i = std::max(r - 1, 0); i <= std::min(r + 1, kBins - 1); ++i)
        for (int j = std::max(g - 1, 0); j <= std::min(g + 1, kBins - 1); ++j)
          for (int k = std::max(b - 1, 0); k <= std::min(b + 1, kBins - 1); ++k) {
            const int at = (i * kBins + j) * kBins + k;
            tone.pixels += count_[at];
            tone.colour += sum_[at];
            count_[at] = 0;
            sum_[at] = Rgb::Zero();
          }
      if (tone.pixels < kLeast * all_) break;
      tone.colour /= float(tone.pixels);
      tones.push_back(tone);
    }
    return tones;
  }

 private:
  static int bin(int value) { return value * kBins / 256; }
  std::vector<float> count_;
  std::vector<Rgb> sum_;
  double all_ = 0;
};

// Which tone a pixel of a part has, −1: none. Remembers the last one: flat colours lie in rows.
class ToneOf {
 public:
  explicit ToneOf(const std::vector<PartTones>& parts) : parts_(parts) {}
  int operator()(int part, const Pixel& pixel) {
    if (part != part_ || pixel != pixel_) {
      part_ = part;
      pixel_ = pixel;
      tone_ = parts_[part].nearest(rgb_of(pixel), kToneWidth);
    }
    return tone_;
  }

 private:
  const std::vector<PartTones>& parts_;
  int part_ = -1, tone_ = -1;
  Pixel pixel_ = {};
};

// Of the drawn pixels those that have a tone's colour.
double flat_share(const std::vector<PartTones>& parts, const std::vector<int>& twin,
                  const std::vector<Sketch>& sketches) {
  double flat = 0, all = 0;
  ToneOf tone_of(parts);
  for (const Sketch& sketch : sketches)
    for (std::size_t p = 0; p < sketch.state.size(); ++p) {
      if (sketch.state[p] != Sketch::drawn) continue;
      all += 1;
      flat += tone_of(twin[sketch.joint[p]], sketch.colour[p]) >= 0;
    }
  return all > 0 ? flat / all : 0;
}

struct Pair {
  int part = 0, lit = 0, shade = 0;
  Rgb factor = Rgb::Ones();
  double pixels = 0;
};

// What may be a tone and its shade.
std::vector<Pair> pairs_of(const std::vector<PartTones>& parts) {
  std::vector<Pair> pairs;
  for (int p = 0; p < int(parts.size()); ++p)
    for (int l = 0; l < int(parts[p].tones.size()); ++l)
      for (int s = 0; s < int(parts[p].tones.size()); ++s) {
        const Tone &lit = parts[p].tones[l], &shade = parts[p].tones[s];
        const Rgb factor = shade.colour.cwiseQuotient(lit.colour.cwiseMax(0.02f));
        if (l == s || factor.maxCoeff() > kLightest || factor.minCoeff() < kDarkest ||
            factor.maxCoeff() - factor.minCoeff() > kTinted || lit.pixels < kLit * shade.pixels)
          continue;
        pairs.push_back({p, l, s, factor, std::min(lit.pixels, shade.pixels)});
      }
  return pairs;
}

// Pixels along which each pair's tones meet, a soft step of a pixel between them.
std::vector<int> borders(const std::vector<Pair>& pairs, const std::vector<PartTones>& parts,
                         const std::vector<int>& twin, const std::vector<Sketch>& sketches) {
  constexpr int kStep = 2;
  std::vector<int> border(pairs.size(), 0);
  std::vector<std::int8_t> tone;
  ToneOf tone_of(parts);
  for (const Sketch& sketch : sketches) {
    tone.assign(sketch.state.size(), -1);
    for (std::size_t p = 0; p < tone.size(); ++p)
      if (sketch.state[p] == Sketch::drawn)
        tone[p] = std::int8_t(tone_of(twin[sketch.joint[p]], sketch.colour[p]));
    const auto meet = [&](std::size_t p, std::size_t q) {
      if (tone[p] < 0 || tone[q] < 0 || tone[p] == tone[q]) return;
      const int part = twin[sketch.joint[p]];
      if (part != twin[sketch.joint[q]]) return;
      for (std::size_t i = 0; i < pairs.size(); ++i)
        if (pairs[i].part == part && ((pairs[i].lit == tone[p] && pairs[i].shade == tone[q]) ||
                                      (pairs[i].lit == tone[q] && pairs[i].shade == tone[p])))
          ++border[i];
    };
    for (int y = 0; y + kStep < sketch.height; ++y)
      for (int x = 0; x + kStep < sketch.width; ++x) {
        const std::size_t p = std::size_t(y) * sketch.width + x;
        meet(p, p + kStep);
        meet(p, p + std::size_t(kStep) * sketch.width);
      }
  }
  return border;
}

// The pairs of which one drawing shows the shade where another shows the lit tone: light depends on
// where it is seen from, colour doesn't.
std::vector<Pair> told_by_views(const std::vector<Pair>& pairs, const std::vector<PartTones>& parts,
                                const std::vector<int>& twin, const Model& model,
                                std::span<const SurfaceView> views,
                                const std::vector<Sketch>& sketches) {
  constexpr float kSquarely = 0.3f;  // quality of what has a say
  constexpr int kLeastFaces = 20;    // on which drawings differ
  constexpr double kOften = 0.5;     // of the faces that any of two drawings shows in shade
  const Triangles& F = model.mesh.F;
  std::vector<int> tone(std::size_t(F.rows()) * views.size(), -1), part(F.rows());
  ToneOf tone_of(parts);
  for (int f = 0; f < F.rows(); ++f) {
    part[f] = twin[model.weights.joints(F(f, 0), 0)];
    for (std::size_t v = 0; v < views.size(); ++v) {
      if (views[v].quality[f] < kSquarely) continue;
      const auto c = views[v].colour(sketches, F, f, Vec3::Constant(1 / 3.0));
      if (!c) continue;
      const Pixel pixel = pixel_of(*c);
      tone[std::size_t(f) * views.size() + v] = tone_of(part[f], pixel);
    }
  }
  std::vector<Pair> told;
  for (const Pair& pair : pairs) {
    int differ = 0, same = 0;
    for (int f = 0; f < F.rows(); ++f) {
      if (part[f] != pair.part) continue;
      int lit = 0, shade = 0;
      for (std::size_t v = 0; v < views.size(); ++v) {
        const int here = tone[std::size_t(f) * views.size() + v];
        lit += here == pair.lit;
        shade += here == pair.shade;
      }
      differ += lit > 0 && shade > 0;
      same += shade > 1;
    }
    if (differ >= kLeastFaces && differ > kOften * (differ + same)) told.push_back(pair);
  }
  return told;
}

// The pairs of the one kind of shade that most of the drawings' pixels have, if several colours
// have it: what is a darker colour by its own right has a factor of its own.
std::vector<Pair> common(const std::vector<Pair>& pairs, const std::vector<PartTones>& parts) {
  constexpr float kOther = 0.15f;  // between different colours
  std::vector<Pair> best;
  double most = 0;
  for (const Pair& pair : pairs) {
    std::vector<Pair> like;
    double pixels = 0;
    bool several = false;
    for (const Pair& other : pairs) {
      if ((pair.factor - other.factor).cwiseAbs().maxCoeff() > kSame) continue;
      like.push_back(other);
      pixels += other.pixels;
      several = several || (parts[pair.part].tones[pair.lit].colour -
                            parts[other.part].tones[other.lit].colour)
                                   .norm() > kOther;
    }
    if (!several || pixels <= most) continue;
    most = pixels;
    best = std::move(like);
  }
  return best;
}

// Gives each lit tone the kinds of shade that other parts have, however little of it is drawn.
void add_rare_shades(const std::vector<Pair>& pairs, std::vector<PartTones>& parts) {
  std::vector<Rgb> factors;
  for (const Pair& pair : pairs)
    if (std::none_of(factors.begin(), factors.end(), [&](const Rgb& one) {
          return (one - pair.factor).cwiseAbs().maxCoeff() <= kSame;
        }))
      factors.push_back(pair.factor);
  for (PartTones& part : parts)
    for (int l = 0, count = int(part.tones.size()); l < count; ++l) {
      if (part.lit[l] >= 0) continue;
      for (const Rgb& factor : factors) {
        const Rgb shade = part.tones[l].colour.cwiseProduct(factor);
        if (part.nearest(shade, kOwn) >= 0) continue;
        part.tones.push_back({shade, 0});
        part.lit.push_back(l);
      }
    }
}

// Moves a pixel on the way between a shade and its lit tone to the lit one's end.
void lighten(const PartTones& part, Pixel& pixel) {
  const Rgb c = rgb_of(pixel);
  float least = kOwn;
  Rgb by = Rgb::Zero();
  for (int s = 0; s < int(part.tones.size()); ++s) {
    const Rgb& shade = part.tones[s].colour;
    const bool lit = part.lit[s] < 0;
    const Rgb way = lit ? Rgb(Rgb::Zero()) : Rgb(part.tones[part.lit[s]].colour - shade);
    const float t =
        lit ? 0 : std::clamp((c - shade).dot(way) / std::max(way.squaredNorm(), 1e-6f), 0.0f, 1.0f);
    const float off = (c - shade - t * way).norm();
    if (off >= least) continue;
    least = off;
    by = (1 - t) * way;
  }
  for (int k = 0; k < 3; ++k)
    pixel[k] = static_cast<unsigned char>(std::clamp(255 * (c[k] + by[k]) + 0.5f, 0.0f, 255.0f));
}

}  // namespace

void take_lit_tones(const Model& model, std::span<const SurfaceView> views,
                    std::vector<Sketch>& sketches) {
  const Skeleton& skeleton = model.skeleton;
  std::vector<int> twin;
  for (int j = 0; j < skeleton.size(); ++j)
    twin.push_back(skeleton.joints[j].mirror >= 0 ? std::min(j, skeleton.joints[j].mirror) : j);
  std::vector<Histogram> histograms(twin.size());
  for (const Sketch& sketch : sketches)
    for (std::size_t p = 0; p < sketch.state.size(); ++p)
      if (sketch.state[p] == Sketch::drawn) histograms[twin[sketch.joint[p]]].add(sketch.colour[p]);
  std::vector<PartTones> parts(twin.size());
  for (std::size_t j = 0; j < parts.size(); ++j) {
    parts[j].tones = histograms[j].tones();
    parts[j].lit.assign(parts[j].tones.size(), -1);
  }
  if (flat_share(parts, twin, sketches) < kFlatShare) return;
  std::vector<Pair> pairs = pairs_of(parts);
  const std::vector<int> border = borders(pairs, parts, twin, sketches);
  std::vector<Pair> beside;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (border[i] >= kBorder) beside.push_back(pairs[i]);
  pairs = common(beside, parts);
  if (double(pairs.size()) < kOneKind * double(beside.size())) pairs.clear();
  for (const Pair& pair : told_by_views(beside, parts, twin, model, views, sketches))
    if (std::none_of(pairs.begin(), pairs.end(), [&](const Pair& one) {
          return one.part == pair.part && one.lit == pair.lit && one.shade == pair.shade;
        }))
      pairs.push_back(pair);
  if (pairs.empty()) return;
  // A shade's shade leads on to the brightest: no cycles, since each is brighter than the last.
  for (const Pair& pair : pairs) {
    int& lit = parts[pair.part].lit[pair.shade];
    if (lit < 0 ||
        parts[pair.part].tones[pair.lit].colour.sum() > parts[pair.part].tones[lit].colour.sum())
      lit = pair.lit;
  }
  add_rare_shades(pairs, parts);
  for (PartTones& part : parts)
    for (int& lit : part.lit)
      while (lit >= 0 && part.lit[lit] >= 0) lit = part.lit[lit];
  const PartTones* last_part = nullptr;
  Pixel last = {}, lit = {};
  for (Sketch& sketch : sketches)
    for (std::size_t p = 0; p < sketch.state.size(); ++p) {
      if (sketch.state[p] == Sketch::nothing) continue;
      const PartTones& part = parts[twin[sketch.joint[p]]];
      if (std::all_of(part.lit.begin(), part.lit.end(), [](int lit) { return lit < 0; })) continue;
      for (std::vector<Pixel>* colours : {&sketch.colour, &sketch.plain}) {
        Pixel& pixel = (*colours)[p];
        if (&part != last_part || pixel != last) {
          last_part = &part;
          last = lit = pixel;
          lighten(part, lit);
        }
        pixel = lit;
      }
    }
}

}  // namespace artisketch
