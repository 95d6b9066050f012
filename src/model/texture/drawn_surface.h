// What the drawings show of a posed model: per drawing its colours, freed of the ink along the
// model's outlines, and where each vertex stands in it.
#pragma once

#include <array>

#include "model/stages.h"

namespace artisketch {

using Rgb = Eigen::Vector3f;                 // sRGB, 0 … 1
using Pixel = std::array<unsigned char, 4>;  // sRGB and alpha, as pictures have them

// A drawing with the model laid over it in the drawing's own pose.
struct Sketch {
  int width = 0, height = 0;
  std::vector<float> depth;  // of the model before the camera, units; +infinity beside it
  // Colours to paint the surface with. Within the ink's width of an outline, the model's or that of
  // a part before another, a colour comes from farther inside the same stretch of surface.
  std::vector<Pixel> colour;
  std::vector<Pixel> plain;  // the same without thin dark lines, for what is seen at a slant
  enum State : std::uint8_t { nothing, pulled, drawn };
  std::vector<std::uint8_t> state;

  // The colour of a point at `depth` that projects to `pixel`, of those pixels round it that lie
  // within `reach` units of it; nothing where none does.
  std::optional<Rgb> at(const std::vector<Pixel>& colours, const Vec2& pixel, double depth,
                        double reach) const;
};

// The surface as one drawing shows it, or shows its mirror image.
struct SurfaceView {
  int sketch = 0;
  bool mirrored = false;
  std::vector<Vec2> pixels;   // #V; not finite where it can't be seen
  std::vector<double> depth;  // #V, before the camera
  double reach = 0;           // units: how far from the drawn surface still counts as on it
  // #F: how squarely and finely the drawing shows the triangle, 0 … 1; 0 where it can't be used:
  // another part hides it, or it faces away.
  std::vector<float> quality;

  std::optional<Rgb> colour(const std::vector<Sketch>& sketches, const Triangles& F, int face,
                            const Vec3& weights) const;
};

struct DrawnSurface {
  std::vector<Sketch> sketches;
  std::vector<SurfaceView> views;  // of each drawing, then of each drawing's mirror image
};

// drawings: one per frame; frames without one (or of another size) are left out.
Result<DrawnSurface> drawn_surface(const Document& calibrated, std::span<const Image> drawings,
                                   const Model& model, Run& run);

}  // namespace artisketch
