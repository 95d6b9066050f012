#include "editor/session/picking.h"

#include <algorithm>
#include <cstdlib>

namespace artisketch {
namespace {

constexpr int kMostFigures = 256;

// "4 × 2", by whatever stands between the numbers; 0 where there is none.
std::pair<int, int> columns_and_rows(const std::string& words) {
  const auto number = [&](std::size_t& at) {
    at = words.find_first_of("0123456789", at);
    if (at == words.npos) return 0;
    const std::size_t end = std::min(words.find_first_not_of("0123456789", at), words.size());
    const int value = end - at > 3 ? 0 : std::atoi(words.substr(at, end - at).c_str());
    at = end;
    return value;
  };
  std::size_t at = 0;
  const int columns = number(at);
  const int rows = at == words.npos ? 0 : number(at);
  return {columns, std::max(rows, columns > 0 ? 1 : 0)};
}

}  // namespace

std::vector<Sprite> Picking::taken() const {
  std::vector<Sprite> all;
  for (const PickedBox& box : boxes)
    if (box.taken) all.push_back(box.sprite);
  return all;
}

bool Picking::cut_by_grid() {
  const auto [columns, rows] = columns_and_rows(grid);
  if (columns * rows > kMostFigures) return false;
  const std::vector<Sprite> cells = sprites_by_grid(width, height, columns, rows);
  if (cells.empty()) return false;
  boxes.clear();
  for (const Sprite& cell : cells) boxes.push_back({cell});
  return true;
}

void Picking::add(PixelBox box) {
  const int right = std::min(box.right(), width), bottom = std::min(box.bottom(), height);
  box.x = std::max(box.x, 0), box.y = std::max(box.y, 0);
  box.width = right - box.x, box.height = bottom - box.y;
  if (box.width < 2 || box.height < 2 || int(boxes.size()) >= kMostFigures) return;
  if (one) boxes.clear();
  // After those of its row: a row is what overlaps it by half of its height.
  PickedBox added{{box, box, 0, 0}};
  int row = -1, below = 0;
  for (const PickedBox& other : boxes) {
    const PixelBox& own = other.sprite.own;
    const int common = std::min(own.bottom(), box.bottom()) - std::max(own.y, box.y);
    if (2 * common >= std::min(own.height, box.height)) row = other.sprite.row;
    if (own.bottom() <= box.y) below = std::max(below, other.sprite.row + 1);
  }
  if (row < 0) {
    row = below;
    for (PickedBox& other : boxes) other.sprite.row += other.sprite.row >= row;
  }
  added.sprite.row = row;
  boxes.push_back(added);
  std::stable_sort(boxes.begin(), boxes.end(), [](const PickedBox& a, const PickedBox& b) {
    return a.sprite.row != b.sprite.row ? a.sprite.row < b.sprite.row
                                        : a.sprite.own.x < b.sprite.own.x;
  });
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const bool first = i == 0 || boxes[i].sprite.row != boxes[i - 1].sprite.row;
    boxes[i].sprite.column = first ? 0 : boxes[i - 1].sprite.column + 1;
  }
}

std::string cell_words(const Sprite& sprite, const std::vector<Sprite>& all) {
  const bool rows = std::any_of(all.begin(), all.end(),
                                [&](const Sprite& other) { return other.row != all.front().row; });
  const std::string column = std::to_string(sprite.column + 1);
  if (!rows) return column;
  // As in tables: A … Z, AA.
  std::string row;
  for (int n = sprite.row; n >= 0; n = n / 26 - 1) row.insert(row.begin(), char('A' + n % 26));
  return row + column;
}

}  // namespace artisketch
