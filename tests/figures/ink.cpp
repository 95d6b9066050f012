#include "figures/ink.h"

#include <algorithm>
#include <cmath>

namespace artisketch::figures {
namespace {

constexpr int kSamples = 3;      // a pixel's side in samples
constexpr double kJump = 0.035;  // units of depth between samples that make an outline
constexpr double kFold = 0.3;    // cosine between normals that makes a fold
const Vec3 kLight = Vec3(-0.45, 0.6, 0.8).normalized();

// Smooth noise in the plane: −1 … 1, a bump about every unit.
double noise(const Vec2& p, std::uint64_t seed) {
  const double fx = std::floor(p.x()), fy = std::floor(p.y());
  const auto corner = [&](int i, int j) {
    std::uint64_t h = seed * 0x9e3779b97f4a7c15u +
                      std::uint64_t(std::int64_t(fx) + i) * 0xbf58476d1ce4e5b9u +
                      std::uint64_t(std::int64_t(fy) + j) * 0x94d049bb133111ebu;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
    return double((h ^ (h >> 31)) >> 11) * 0x1p-52 - 1;
  };
  const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
  const double u = smooth(p.x() - fx), v = smooth(p.y() - fy);
  return (1 - v) * ((1 - u) * corner(0, 0) + u * corner(1, 0)) +
         v * ((1 - u) * corner(0, 1) + u * corner(1, 1));
}

Vec3 rgb(unsigned colour) {
  return Vec3(colour >> 16 & 255, colour >> 8 & 255, colour & 255);
}

struct Sample {
  float depth = INFINITY;
  short part = -1;
  short region = -1;  // colour_index
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
};

class Sheet {
 public:
  Sheet(const Figure& figure, const Pose& pose, const FrameCamera& camera, int width, int height,
        const InkStyle& style)
      : figure_(figure),
        camera_(camera),
        style_(style),
        width_(width),
        height_(height),
        nx_(width * kSamples),
        ny_(height * kSamples),
        samples_(std::size_t(nx_) * ny_) {
    for (const Transform& t : skinning_transforms(figure.skeleton, pose)) {
      to_world_.push_back(t);
      to_rest_.push_back(t.inverse());
    }
    for (const Solid& part : figure.parts) casters_.emplace_back(part);
  }

  Image draw() {
    for (int j = 0; j < figure_.skeleton.size(); ++j)
      if (!figure_.parts[j].empty()) see(j);
    lay_colours();
    draw_lines();
    return image();
  }

 private:
  // Where the hand puts what stands at this sample.
  Vec2 pixel(int x, int y) const {
    const Vec2 p = Vec2(x + 0.5, y + 0.5) / kSamples;
    return p + style_.wobble * Vec2(noise(p / 45, style_.seed), noise(p / 45, style_.seed + 1));
  }

  void see(int j) {
    Box2 box;
    const Vec3 centre = to_world_[j] * casters_[j].ball().centre;
    for (int c = 0; c < 8; ++c)
      box.extend(
          camera_.project(centre + casters_[j].ball().radius *
                                       Vec3(c & 1 ? 1 : -1, c & 2 ? 1 : -1, c & 4 ? 1 : -1)));
    const int x0 = std::max(0, int((box.min().x() - 2) * kSamples)),
              x1 = std::min(nx_, int((box.max().x() + 2) * kSamples));
    const int y0 = std::max(0, int((box.min().y() - 2) * kSamples)),
              y1 = std::min(ny_, int((box.max().y() + 2) * kSamples));
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) {
        const Ray world = camera_.ray(pixel(x, y));
        const Ray ray{to_rest_[j] * world.origin, to_rest_[j].linear() * world.direction};
        const auto depth = casters_[j].hit(ray);
        Sample& s = samples_[std::size_t(y) * nx_ + x];
        if (!depth || float(*depth) >= s.depth) continue;
        s.depth = float(*depth);
        s.part = short(j);
      }
  }

  bool in_shadow(const Sample& s, const Vec3& at) const {
    if (s.normal.cast<double>().dot(kLight) < 0) return true;
    const Vec3 from = at + 0.02 * s.normal.cast<double>();
    for (int j = 0; j < figure_.skeleton.size(); ++j) {
      if (j == s.part || figure_.parts[j].empty()) continue;
      const Ray ray{to_rest_[j] * from, to_rest_[j].linear() * kLight};
      const double ahead =
          (casters_[j].ball().centre - ray.origin).dot(ray.direction) + casters_[j].ball().radius;
      if (ahead <= 0) continue;
      if (const auto depth = casters_[j].hit(ray); depth && *depth > 0) return true;
    }
    return false;
  }

  void lay_colours() {
    colours_.assign(samples_.size(), Eigen::Vector4f::Zero());
    for (int y = 0; y < ny_; ++y)
      for (int x = 0; x < nx_; ++x) {
        const std::size_t i = std::size_t(y) * nx_ + x;
        Sample& s = samples_[i];
        if (s.part < 0) continue;
        const Solid& part = figure_.parts[s.part];
        const Vec3 at = camera_.ray(pixel(x, y)).at(s.depth), rest = to_rest_[s.part] * at;
        s.region = short(colour_index(part, rest));
        s.normal = (to_world_[s.part].linear() * normal(part, rest)).cast<float>();
        Vec3 c = rgb(colour_at(part, s.region));
        if (in_shadow(s, at)) c = c.cwiseProduct(rgb(style_.shadow) / 255);
        colours_[i] << c.cast<float>(), 255;
      }
  }

  // Width of the line between two neighbouring samples, in pixels; 0: none.
  double line_between(const Sample& a, const Sample& b) const {
    if (a.part < 0 && b.part < 0) return 0;
    if (a.part < 0 || b.part < 0) return style_.line;
    if (std::abs(a.depth - b.depth) > kJump) return style_.line;
    const Solid &pa = figure_.parts[a.part], &pb = figure_.parts[b.part];
    if (colour_at(pa, a.region) != colour_at(pb, b.region)) {
      const bool plain = !lined(pa, a.region) || !lined(pb, b.region);
      return plain ? 0 : style_.detail;
    }
    return a.normal.dot(b.normal) < kFold ? style_.detail : 0;
  }
  static bool lined(const Solid& part, int region) { return region < int(part.blobs.size()); }

  void draw_lines() {
    for (int y = 0; y + 1 < ny_; ++y)
      for (int x = 0; x + 1 < nx_; ++x) {
        const std::size_t i = std::size_t(y) * nx_ + x;
        for (const std::size_t next : {i + 1, i + nx_})
          if (const double line = line_between(samples_[i], samples_[next]); line > 0) {
            // Heavier on the side away from the light, and uneven as a pen is.
            const Sample& s =
                samples_[i].depth < samples_[next].depth ? samples_[i] : samples_[next];
            const double away = -s.normal.cast<double>().dot(Vec3(kLight.x(), kLight.y(), 0));
            const double pen = noise(Vec2(x, y) / (kSamples * 28.0), style_.seed + 2);
            dab(x, y, line * (1 + 0.3 * away + 0.22 * pen) * kSamples / 2);
          }
      }
  }

  void dab(int x, int y, double radius) {
    const int r = int(radius);
    for (int j = std::max(0, y - r); j <= std::min(ny_ - 1, y + r); ++j)
      for (int i = std::max(0, x - r); i <= std::min(nx_ - 1, x + r); ++i)
        if ((i - x) * (i - x) + (j - y) * (j - y) <= radius * radius)
          colours_[std::size_t(j) * nx_ + i] << rgb(style_.ink).cast<float>(), 255;
  }

  Image image() const {
    Image image(width_, height_);
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        Eigen::Vector4f colour =
            style_.medium == InkStyle::Medium::pixels ? commonest(x, y) : mean(x, y);
        if (style_.medium == InkStyle::Medium::pencil) colour = pencilled(x, y, colour);
        std::uint8_t* pixel = image.at(x, y);
        for (int a = 0; a < 4; ++a) pixel[a] = std::uint8_t(std::lround(colour[a]));
      }
    return image;
  }

  const Eigen::Vector4f& sample(int x, int y, int k) const {
    return colours_[std::size_t(y * kSamples + k / kSamples) * nx_ + x * kSamples + k % kSamples];
  }

  Eigen::Vector4f mean(int x, int y) const {
    Eigen::Vector4f sum = Eigen::Vector4f::Zero();
    for (int k = 0; k < kSamples * kSamples; ++k) {
      const Eigen::Vector4f& c = sample(x, y, k);
      sum.head<3>() += c.head<3>() * (c[3] / 255);
      sum[3] += c[3];
    }
    const Eigen::Vector3f colour =
        sum[3] > 0 ? (sum.head<3>() * 255 / sum[3]).eval() : Eigen::Vector3f::Constant(255);
    return {colour[0], colour[1], colour[2], sum[3] / (kSamples * kSamples)};
  }

  Eigen::Vector4f commonest(int x, int y) const {
    int best = 0, most = 0;
    for (int k = 0; k < kSamples * kSamples; ++k) {
      int same = 0;
      for (int i = 0; i < kSamples * kSamples; ++i) same += sample(x, y, i) == sample(x, y, k);
      if (same > most) {
        most = same;
        best = k;
      }
    }
    const Eigen::Vector4f& c = sample(x, y, best);
    return c[3] > 0 ? c : Eigen::Vector4f(255, 255, 255, 0);
  }

  // Strokes all one way, closer where it is dark; the paper's grain takes less of them here than
  // there.
  Eigen::Vector4f pencilled(int x, int y, const Eigen::Vector4f& colour) const {
    constexpr double kPaper = 250, kGrain = 1.6, kStroke = 5.5;  // grey; pixels
    const double grain = noise(Vec2(x, y) / kGrain, style_.seed + 3);
    const double stroke = noise(Vec2((x + y) / kStroke, (x - y) / (kStroke * 9)), style_.seed + 4);
    const double covered = colour[3] / 255, tone = colour.head<3>().mean();
    const double laid = covered * (kPaper - tone) * (1 + 0.16 * grain + 0.2 * stroke);
    const double grey = std::clamp(kPaper - laid + 1.5 * grain, 0.0, 255.0);
    return Eigen::Vector4d(grey, grey - 1, grey - 4, 255).cwiseMax(0).cast<float>();
  }

  const Figure& figure_;
  FrameCamera camera_;
  InkStyle style_;
  int width_, height_, nx_, ny_;
  std::vector<Sample> samples_;
  std::vector<Eigen::Vector4f> colours_;
  std::vector<Transform> to_world_, to_rest_;
  std::vector<Caster> casters_;  // one per joint
};

}  // namespace

Image ink_drawing(const Figure& figure, const Pose& pose, const FrameCamera& camera, int width,
                  int height, const InkStyle& style) {
  return Sheet(figure, pose, camera, width, height, style).draw();
}

}  // namespace artisketch::figures
