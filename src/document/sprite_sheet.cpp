#include "document/sprite_sheet.h"

#include <algorithm>
#include <cmath>

#include "base/ensure.h"

namespace artisketch {
namespace {

struct Run {
  int from = 0, to = 0;  // [from, to)
};

// The stretches of what is taken, those closer than `gap` as one.
std::vector<Run> runs(const std::vector<bool>& taken, int gap) {
  std::vector<Run> found;
  for (int i = 0; i < int(taken.size()); ++i) {
    if (!taken[i]) continue;
    if (!found.empty() && i - found.back().to < gap)
      found.back().to = i + 1;
    else
      found.push_back({i, i + 1});
  }
  return found;
}

}  // namespace

std::vector<Sprite> sprites_by_gaps(const SegmentedImage& sheet) {
  const int w = sheet.width, h = sheet.height;
  const int gap = std::max(2, int(std::lround(0.01 * std::min(w, h))));
  struct Found {
    PixelBox box;
    int column, row, area;
  };
  std::vector<Found> found;
  const auto drawn = [&](int x, int y) { return !sheet.paper[std::size_t(y) * w + x]; };
  std::vector<bool> rows(std::size_t(h), false);
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w && !rows[y]; ++x) rows[y] = drawn(x, y);
  int largest = 0;
  const std::vector<Run> bands = runs(rows, gap);
  for (int row = 0; row < int(bands.size()); ++row) {
    std::vector<bool> columns(std::size_t(w), false);
    for (int y = bands[row].from; y < bands[row].to; ++y)
      for (int x = 0; x < w; ++x)
        if (drawn(x, y)) columns[x] = true;
    int column = 0;
    for (const Run& run : runs(columns, gap)) {
      Found f{{run.from, bands[row].from, run.to - run.from, bands[row].to - bands[row].from},
              column++,
              row,
              0};
      for (int y = f.box.y; y < f.box.bottom(); ++y)
        for (int x = f.box.x; x < f.box.right(); ++x) f.area += drawn(x, y);
      largest = std::max(largest, f.area);
      found.push_back(f);
    }
  }
  // Specks, the letters of a title, a number below each figure.
  constexpr double kOtherThing = 0.2;  // of the largest figure
  found.erase(std::remove_if(found.begin(), found.end(),
                             [&](const Found& f) { return f.area < kOtherThing * largest; }),
              found.end());
  if (found.size() < 2) return {};
  // Counted without those.
  int last = found[0].row, row = 0, column = 0;
  for (Found& f : found) {
    if (f.row != last) ++row, column = 0;
    last = f.row;
    f.row = row;
    f.column = column++;
  }
  int width = 0, height = 0;
  for (const Found& f : found) {
    width = std::max(width, f.box.width);
    height = std::max(height, f.box.height);
  }
  const int margin = std::max(4, int(std::lround(0.06 * std::max(width, height))));
  width += 2 * margin;
  height += 2 * margin;
  std::vector<Sprite> sprites;
  const int k = sheet.pixels;
  const auto scaled = [&](const PixelBox& b) {
    return PixelBox{k * b.x, k * b.y, k * b.width, k * b.height};
  };
  for (const Found& f : found) {
    const PixelBox drawing{f.box.x + (f.box.width - width) / 2, f.box.bottom() + margin - height,
                           width, height};
    sprites.push_back({scaled(f.box), scaled(drawing), f.column, f.row});
  }
  return sprites;
}

std::vector<Sprite> sprites_by_grid(int width, int height, int columns, int rows) {
  if (columns < 1 || rows < 1 || width < columns || height < rows) return {};
  std::vector<Sprite> sprites;
  const int w = width / columns, h = height / rows;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const PixelBox cell{column * w, row * h, w, h};
      sprites.push_back({cell, cell, column, row});
    }
  return sprites;
}

Image cut_out(const Image& sheet, const Sprite& sprite) {
  const PixelBox &own = sprite.own, &place = sprite.drawing;
  ensure(own.x >= 0 && own.y >= 0 && own.right() <= sheet.width && own.bottom() <= sheet.height,
         "a sprite within its sheet");
  Image cut(place.width, place.height);
  for (int y = 0; y < place.height; ++y)
    for (int x = 0; x < place.width; ++x) {
      const int sx = place.x + x, sy = place.y + y;
      const bool inside = sx >= own.x && sy >= own.y && sx < own.right() && sy < own.bottom();
      std::copy_n(inside ? sheet.at(sx, sy) : sheet.at(0, 0), 4, cut.at(x, y));
    }
  return cut;
}

}  // namespace artisketch
