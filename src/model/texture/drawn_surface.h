// What the drawings show of a posed model: per drawing its colours, freed of the ink along the
// model's outlines, and where each vertex stands in it.
#pragma once

#include <algorithm>
#include <array>
#include <memory>

#include "model/stages.h"

namespace artisketch {

using Rgb = Eigen::Vector3f;                 // sRGB, 0 … 1
using Pixel = std::array<unsigned char, 4>;  // sRGB and alpha, as pictures have them
inline Rgb rgb_of(const Pixel& pixel) {
  return Rgb(pixel[0], pixel[1], pixel[2]) / 255;
}
inline Pixel pixel_of(const Rgb& colour) {
  const auto channel = [&](int k) {
    return static_cast<unsigned char>(std::clamp(255 * colour[k] + 0.5f, 0.0f, 255.0f));
  };
  return {channel(0), channel(1), channel(2), 255};
}

// The joints that hold a triangle: the one that moves it most first, then those with a share worth
// the name; −1 where there are fewer.
struct Holders {
  std::array<int, 4> joints = {-1, -1, -1, -1};
  int first() const { return joints[0]; }
  bool has(int joint) const {
    return joint >= 0 && std::find(joints.begin(), joints.end(), joint) != joints.end();
  }
};
std::vector<Holders> holders_of(const Triangles& F, const Weights& weights);

// A drawing with the model laid over it in the drawing's own pose.
struct Sketch {
  int frame = 0;
  int width = 0, height = 0;
  bool pixel_art = false;    // its pixels are squares of one colour: none is mixed with another
  std::vector<float> depth;  // of the model before the camera, units; +infinity beside it
  std::vector<int> joint;    // that holds what the model shows there; −1 beside it
  // Colours to paint the surface with. Within the ink's width of an outline, the model's or that of
  // a part before another, a colour comes from farther inside the same stretch of surface.
  std::vector<Pixel> colour;
  std::vector<Pixel> plain;  // the same without thin dark lines, for what is seen at a slant
  enum State : std::uint8_t { nothing, pulled, drawn };
  std::vector<std::uint8_t> state;

  // The colour of a point at `depth` that projects to `pixel`, of those pixels round it that lie
  // within `reach` units of it and belong to one of its holders; nothing where none does.
  std::optional<Rgb> at(const std::vector<Pixel>& colours, const Vec2& pixel, double depth,
                        double reach, const Holders& holders) const;
};

// The surface as one drawing shows it, or shows its mirror image.
inline constexpr float kPulledQuality = 0.4f;  // at most, where colours come from farther inside
struct SurfaceView {
  int sketch = 0;
  bool mirrored = false;
  std::vector<Vec2> pixels;   // #V; not finite where it can't be seen
  std::vector<double> depth;  // #V, before the camera
  double reach = 0;           // units: how far from the drawn surface still counts as on it
  // #F: whose pixels show the triangle: its own joints, or their mirror images.
  std::shared_ptr<const std::vector<Holders>> holders;
  FrameCamera camera;
  std::vector<Transform> to_rest;  // by joint: from where the drawing has it
  double middle = 0;               // x of the plane that mirror images are reflected in
  // #F: how squarely and finely the drawing shows the triangle, 0 … 1; 0 where it can't be used:
  // another part hides it, or it faces away.
  std::vector<float> quality;

  std::optional<Rgb> colour(const std::vector<Sketch>& sketches, const Triangles& F, int face,
                            const Vec3& weights) const;
  // Ray through a pixel of the sketch, in the rest space of the joint drawn there (or reflected).
  Ray ray(const Vec2& pixel, int joint) const;
};

struct DrawnSurface {
  std::vector<Sketch> sketches;
  // The drawings' colours where these are pixel art, all of few colours and with hard edges; the
  // model has no others then. Empty otherwise.
  std::vector<Rgb> palette;
  std::vector<SurfaceView> views;  // of each drawing, then of each drawing's mirror image
};

// drawings: one per frame; frames without one (or of another size) are left out.
Result<DrawnSurface> drawn_surface(const Document& calibrated, std::span<const Image> drawings,
                                   const Model& model, Run& run);

}  // namespace artisketch
