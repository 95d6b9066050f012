#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>

#include "base/words.h"
#include "files/canvas.h"
#include "files/marks.h"
#include "files/preview.h"
#include "files/render.h"

namespace artisketch {
namespace {

// EDITOR.md, theme light.
constexpr unsigned kSheet = 0xF5F6F8, kPaper = 0xFFFFFF, kLine = 0xD2D6DC, kText = 0x1C2025,
                   kMuted = 0x59616B, kAccent = 0x0B7F6B, kWarning = 0x8A5A00, kError = 0xBF2F1F;
constexpr int kMargin = 36, kGutter = 20, kHeader = 92, kCaption = 30, kRowGap = 22;
constexpr double kTileRadius = 8;
constexpr Lettering kTitle{26, true}, kName{14, true}, kBody{13, false};
const std::string kDot = "  \xC2\xB7  ";

constexpr const char* kSides[] = {"Front", "Right side", "Back", "Left side"};

// "12 000 triangles".
std::string in_thousands(long long n, const std::string& one) {
  std::string digits = std::to_string(n);
  for (int i = int(digits.size()) - 3; i > 0; i -= 3) digits.insert(i, 1, ' ');
  return digits + " " + plural(n, one);
}

std::string decimal(double value, int places) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", places, value);
  return text;
}

void draw_text_right(Image& image, const Vec2& right, const std::string& text,
                     const Lettering& lettering, const Colour& colour) {
  draw_text(image, right - Vec2(text_width(text, lettering), 0), text, lettering, colour);
}

// Where everything goes, in pixels of the sheet.
struct Layout {
  int columns = 1;      // of tiles
  bool paired = false;  // a frame's two tiles stand side by side, else one above the other
  int tile_width = 0, tile_height = 0;
  double scale = 1;  // of the sketches, one for all
  int groups = 0;    // rows of frames
  int width = 0, content = 0;
  int side_width = 0, side_height = 0;

  int row_height() const { return kCaption + tile_height + kRowGap; }
  int group_height() const { return (paired ? 1 : 2) * row_height(); }
  int sides_top() const { return kHeader + groups * group_height(); }
  int legend_top() const { return sides_top() + kCaption + side_height + kRowGap; }
  int tile_x(int column) const { return kMargin + column * (tile_width + kGutter); }
};

Layout layout_of(const Document& document, int width) {
  Layout layout;
  const int n = std::max(int(document.frames.size()), 1);
  layout.paired = n <= 2;
  layout.columns = n <= 2   ? 2 * n
                   : n <= 4 ? n
                            : std::clamp(int(std::ceil(std::sqrt(n))) + 1, 4, 10);
  const int per_row = layout.paired ? n : layout.columns;
  layout.groups = document.frames.empty() ? 0 : (n + per_row - 1) / per_row;
  constexpr int kWidest = 640;  // of a tile
  const int room = width - 2 * kMargin - (layout.columns - 1) * kGutter;
  layout.tile_width = std::min(room / layout.columns, kWidest);
  layout.content = layout.columns * (layout.tile_width + kGutter) - kGutter;
  layout.width = layout.content + 2 * kMargin;
  double widest = 1, tallest = 1;
  for (const Frame& frame : document.frames) {
    widest = std::max(widest, double(frame.width));
    tallest = std::max(tallest, double(frame.height));
  }
  // Sketches as large as they fit, at most at twice their size and no taller than 1.5 times a
  // tile's width.
  layout.scale = std::min({layout.tile_width / widest, 1.5 * layout.tile_width / tallest, 2.0});
  layout.tile_height = std::max(int(std::ceil(tallest * layout.scale)), 60);
  layout.side_width = (layout.content - 3 * kGutter) / 4;
  layout.side_height = layout.side_width * 11 / 10;
  return layout;
}

// A frame's own drawing area at the sheet's scale.
Image paper(const Frame& frame, const Image* sketch, double scale, double opacity) {
  Image tile(std::max(int(std::lround(frame.width * scale)), 1),
             std::max(int(std::lround(frame.height * scale)), 1));
  fill(tile, colour(kPaper));
  if (sketch && sketch->width > 0 && sketch->height > 0)
    draw_image(tile, resized(*sketch, tile.width, tile.height), 0, 0, opacity);
  return tile;
}

FrameCamera scaled_camera(const Document& document, int frame, double scale) {
  FrameCamera camera = frame_camera(document, frame);
  camera.camera.pixels_per_unit *= scale;
  camera.camera.focal_length *= scale;
  camera.principal_point *= scale;
  return camera;
}

std::vector<Vec2> skeleton_pixels(const Document& document, int frame, double scale) {
  return joint_pixels(document.skeleton, document.frames[frame].pose, Transform::Identity(),
                      scaled_camera(document, frame, scale));
}

bool moved(const std::vector<Vec2>& before, const std::vector<Vec2>& after) {
  constexpr double kLeast = 0.75;  // pixels of the sheet
  for (std::size_t j = 0; j < before.size(); ++j)
    if ((before[j] - after[j]).norm() > kLeast) return true;
  return false;
}

Image sketch_tile(const Document& document, const Document& calibrated, int frame,
                  const Image* sketch, double scale, bool& shows_former) {
  Image tile = paper(document.frames[frame], sketch, scale, 1);
  draw_contours(tile, document.frames[frame], scale, 2, 0.10);
  const auto before = skeleton_pixels(document, frame, scale);
  const auto after = skeleton_pixels(calibrated, frame, scale);
  shows_former = moved(before, after);
  if (shows_former) draw_former_skeleton(tile, document.skeleton, before);
  draw_skeleton(tile, calibrated.skeleton, after);
  return tile;
}

Image result_tile(const Document& calibrated, const Model& model, int frame, const Image* sketch,
                  double scale) {
  constexpr double kSketch = 0.6, kModel = 0.86;  // opacity
  const Frame& f = calibrated.frames[frame];
  Image tile = paper(f, sketch, scale, kSketch);
  if (model.mesh.F.rows() > 0) {
    const Shape shape = shape_of(model, &f.pose, false);
    draw_image(tile,
               render_shape(shape, Transform::Identity(), scaled_camera(calibrated, frame, scale),
                            tile.width, tile.height),
               0, 0, kModel);
  }
  draw_contours(tile, f, scale, 1.5, 0);
  return tile;
}

// A tile in the middle of its place, framed, with a caption above: a name and, to the right, a
// remark.
struct Caption {
  std::string name, remark;
  unsigned remark_colour = kMuted;
};
void place_tile(Image& sheet, const Image& tile, const Caption& caption, int x, int y, int width,
                int height) {
  const Vec2 baseline(x + 2, y + kCaption - 10.5);
  // Where both don't fit, the name is what a person looks for.
  const double remark = text_width(caption.remark, kBody);
  const bool roomy = remark < 0.65 * width;
  draw_text(sheet, baseline, shortened(caption.name, kName, width - (roomy ? remark + 24 : 4)),
            kName, colour(kText));
  if (roomy)
    draw_text_right(sheet, {x + width - 2.0, baseline.y()}, caption.remark, kBody,
                    colour(caption.remark_colour));
  const int left = x + (width - tile.width) / 2, top = y + kCaption + (height - tile.height) / 2;
  draw_image(sheet, tile, left, top, 1, kTileRadius);
  const Box2 box(Vec2(left, top), Vec2(left + tile.width, top + tile.height));
  draw_rectangle(sheet, box, kTileRadius, 1, colour(kLine));
}

// The colour of an overlap.
unsigned verdict(double iou) {
  return iou < 0.8 ? kError : iou < 0.9 ? kWarning : kAccent;
}

Caption fit_caption(const Reconstruction& result, int frame) {
  Caption caption{"Result", "", kMuted};
  if (frame >= int(result.fits.size())) return caption;
  const FrameFit& fit = result.fits[frame];
  caption.remark = "IoU " + decimal(fit.iou, 3);
  if (!fit.parts.empty()) {
    const double sum =
        std::accumulate(fit.parts.begin(), fit.parts.end(), 0.0,
                        [](double s, const FrameFit::PartFit& part) { return s + part.distance; });
    caption.remark += kDot + "parts " + decimal(sum / double(fit.parts.size()), 1) + " px";
  }
  caption.remark_colour = verdict(fit.iou);
  return caption;
}

Caption sketch_caption(const Document& document, int frame, bool shows_former) {
  const Frame& f = document.frames[frame];
  const std::string number = std::to_string(frame + 1);
  return {f.name.empty() ? "Drawing " + number : number + "  " + f.name,
          shows_former ? "dotted: before calibration"
                       : in_thousands((long long)f.contours.size(), "outline")};
}

void draw_header(Image& sheet, const Layout& layout, const Document& document,
                 const Reconstruction& result) {
  const double right = layout.width - kMargin;
  draw_text(sheet, {kMargin, 48}, shortened(document.name, kTitle, layout.content * 0.7), kTitle,
            colour(kText));
  const std::string facts = in_thousands((long long)document.frames.size(), "drawing") + kDot +
                            in_thousands((long long)drawn_joints(document).size(), "part") + kDot +
                            in_thousands(document.skeleton.size(), "joint") + kDot +
                            in_thousands((long long)result.model.mesh.F.rows(), "triangle");
  const std::string unit = "mean silhouette IoU";
  draw_text(sheet, {kMargin, 73},
            shortened(facts, kBody, layout.content - text_width(unit, kBody) - 24), kBody,
            colour(kMuted));
  if (result.fits.empty()) return;
  double sum = 0;
  for (const FrameFit& fit : result.fits) sum += fit.iou;
  const double mean = sum / double(result.fits.size());
  draw_text_right(sheet, {right, 48}, decimal(mean, 3), kTitle, colour(verdict(mean)));
  draw_text_right(sheet, {right, 73}, unit, kBody, colour(kMuted));
}

// Draws the parts' names beside their colours from y on, or only measures; returns the height.
int legend(Image* sheet, const Layout& layout, const Document& document, int y) {
  constexpr int kLineHeight = 24, kChip = 18, kGap = 22;
  double x = kMargin;
  const int top = y;
  for (const int joint : drawn_joints(document)) {
    const std::string name = shortened(document.skeleton.joints[joint].name, kBody, 240);
    const double width = kChip + text_width(name, kBody);
    if (x > kMargin && x + width > layout.width - kMargin) {
      x = kMargin;
      y += kLineHeight;
    }
    if (sheet) {
      fill_disc(*sheet, {x + 6, y + 9}, 5, colour(joint_colour(joint)));
      draw_text(*sheet, {x + kChip, y + 13.5}, name, kBody, colour(kText));
    }
    x += width + kGap;
  }
  return y + kLineHeight - top;
}

}  // namespace

Image contact_sheet(const Document& document, const std::vector<Image>& sketches,
                    const Reconstruction& result, int width) {
  const Layout layout = layout_of(document, width);
  const int legend_height = legend(nullptr, layout, document, 0);
  Image sheet(layout.width, layout.legend_top() + legend_height + kMargin - 12);
  fill(sheet, colour(kSheet));
  draw_header(sheet, layout, document, result);

  const int per_row = layout.paired ? layout.columns / 2 : layout.columns;
  for (int f = 0; f < int(document.frames.size()); ++f) {
    const Image* sketch = f < int(sketches.size()) ? &sketches[f] : nullptr;
    const int column = (f % per_row) * (layout.paired ? 2 : 1);
    const int y = kHeader + f / per_row * layout.group_height();
    bool shows_former = false;
    const Image drawn =
        sketch_tile(document, result.calibrated, f, sketch, layout.scale, shows_former);
    place_tile(sheet, drawn, sketch_caption(document, f, shows_former), layout.tile_x(column), y,
               layout.tile_width, layout.tile_height);
    place_tile(sheet, result_tile(result.calibrated, result.model, f, sketch, layout.scale),
               fit_caption(result, f), layout.tile_x(column + layout.paired),
               layout.paired ? y : y + layout.row_height(), layout.tile_width, layout.tile_height);
  }

  RenderOptions options;
  options.width = layout.side_width;
  options.height = layout.side_height;
  options.pitch = radians(6);
  const Image sides = render_turntable(result.model, options, 4);
  for (int i = 0; i < 4; ++i) {
    Image side(options.width, options.height);
    draw_image(side, sides, -i * options.width, 0);
    place_tile(sheet, side, {kSides[i], i == 0 ? "rest pose" : ""},
               kMargin + i * (layout.side_width + kGutter), layout.sides_top(), layout.side_width,
               layout.side_height);
  }
  legend(&sheet, layout, document, layout.legend_top());
  return sheet;
}

}  // namespace artisketch
