// A picture over all else, on which boxes are picked and drawn.
#include <algorithm>
#include <cmath>

#include "editor/canvas/controls.h"
#include "editor/canvas/pointer.h"
#include "editor/session/files.h"
#include "editor/shell/panels.h"
#include "editor/ui/ui.h"

namespace artisketch {
namespace {

OnScreen fitted(const Picking& picking, const Rect& place) {
  const float zoom = std::min(place.w / float(picking.width), place.h / float(picking.height));
  return {{place.x + (place.w - zoom * float(picking.width)) / 2,
           place.y + (place.h - zoom * float(picking.height)) / 2},
          zoom};
}

Rect on_screen(const PixelBox& box, const OnScreen& on) {
  const ImVec2 low = on.of({double(box.x), double(box.y)});
  return {low.x, low.y, on.zoom * float(box.width), on.zoom * float(box.height)};
}

// The smallest one under the pointer, so that one within another can be told.
int box_under(const Picking& picking, const OnScreen& on, ImVec2 at) {
  int best = -1;
  for (int i = 0; i < int(picking.boxes.size()); ++i) {
    const PixelBox& own = picking.boxes[std::size_t(i)].sprite.own;
    const auto area = [](const PixelBox& box) { return double(box.width) * box.height; };
    if (on_screen(own, on).holds(at) &&
        (best < 0 || area(own) < area(picking.boxes[std::size_t(best)].sprite.own)))
      best = i;
  }
  return best;
}

PixelBox spanned(const Vec2& a, const Vec2& b) {
  const Vec2 low = a.cwiseMin(b), high = a.cwiseMax(b);
  const int x = int(std::floor(low.x())), y = int(std::floor(low.y()));
  return {x, y, int(std::ceil(high.x())) - x, int(std::ceil(high.y())) - y};
}

// A press picks a figure or lets it go; a drag draws a box. What the press began on is kept as a
// box without a size.
void use_hand(Picking& picking, const Press& press, const OnScreen& on) {
  const ImGuiIO& io = ImGui::GetIO();
  constexpr double kFarthest = 1e6;  // pixels
  const Vec2 now = on.back(io.MousePos).cwiseMax(-kFarthest).cwiseMin(kFarthest);
  if (ImGui::IsItemActivated()) picking.begun = spanned(now, now);
  const Vec2 from(picking.begun.x, picking.begun.y);
  if (press.held && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) picking.drawing = true;
  if (press.held && picking.drawing) {
    const Rect shown = on_screen(spanned(from, now), on);
    draw().AddRect(shown.min(), shown.max(), theme().accent, 0, 0, 2);
  }
  if (press.held || !ImGui::IsItemDeactivated()) return;
  if (std::exchange(picking.drawing, false)) return picking.add(spanned(from, now));
  const int under = box_under(picking, on, io.MousePos);
  if (press.clicked && under >= 0 && !picking.one) picking.boxes[std::size_t(under)].taken ^= true;
}

void paint_boxes(const Picking& picking, const OnScreen& on, const std::vector<Sprite>& all) {
  const Theme& t = theme();
  for (const PickedBox& box : picking.boxes) {
    const Rect place = on_screen(box.sprite.own, on);
    const std::string cell = cell_words(box.sprite, all);
    record(picking.one ? "Crop box" : "Figure " + cell, place, true, box.taken);
    if (!box.taken) {
      draw().AddRectFilled(place.min(), place.max(), faded(t.canvas, 0.72f));
      dashed_frame(place, 0, t.muted);
      continue;
    }
    draw().AddRect(place.min(), place.max(), rgb(0xFFFFFF, 0.8f), 0, 0, 4);
    draw().AddRect(place.min(), place.max(), t.accent, 0, 0, 2);
    const float wide = text_width(Font::caption_bold, cell) + 8;
    if (picking.one || wide > place.w || place.h < 40) continue;
    draw().AddRectFilled(place.min(), {place.x + wide, place.y + 18}, t.accent);
    write({place.x, place.y, wide, 18}, Font::caption_bold, t.on_accent, cell, Align::centre);
  }
}

void picture(App& app, Picking& picking, const Rect& place) {
  draw().AddRectFilled(place.min(), place.max(), theme().canvas, kRadius);
  const OnScreen on = fitted(picking, place.inset(8));
  const Rect paper = on_screen({0, 0, picking.width, picking.height}, on);
  const Drawing* drawing = app.services.drawings.at(picking.picture);
  draw().AddRectFilled(paper.min(), paper.max(), ground_of(drawing));
  if (drawing) show_picture(drawing->texture, paper, 1, {0, 0}, {1, 1}, theme().paper_tint);
  std::vector<Sprite> all;
  for (const PickedBox& box : picking.boxes) all.push_back(box.sprite);
  paint_boxes(picking, on, all);
  const Press press = press_area("Picture to pick on", place);
  if (press.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  use_hand(picking, press, on);
}

// Typed, it shows at once; Enter takes it.
bool grid_field(App& app, Picking& picking, Rect row) {
  write(row.cut_left(std::min(row.w / 2, text_width(Font::body, "Across × down") + 10)), Font::body,
        theme().muted, "Across × down");
  const std::string before = picking.grid;
  const bool entered = text_field("Across × down", row, picking.grid, ImGui::IsWindowAppearing());
  const bool other = picking.grid != before && picking.grid != picking.as_found;
  if (other) picking.cut_by_grid();
  if (!entered || picking.grid == picking.as_found || picking.cut_by_grid()) return entered;
  complain(app, bad_input("'" + picking.grid + "' is no number of figures: say 4 × 2"));
  return false;
}

std::string action_words(const Picking& picking, std::size_t taken) {
  if (picking.one) return picking.action;
  return taken == 1 ? "Add 1 drawing" : "Add " + std::to_string(taken) + " drawings";
}

}  // namespace

void picking_sheet(App& app, float width, float height) {
  if (app.picking.empty()) return;
  const Theme& t = theme();
  Picking& picking = app.picking.front();
  const bool narrow = width < 600;
  const Rect place =
      Rect{0, 0, width, height}.middle(std::min(980.0f, width - 16), std::min(800.0f, height - 16));
  bool closed = !over_all(place, width, height);
  bool done = false, whole = false;
  {
    const Panel panel("Picking", place, t.raised, Panel::Layer::floating, kRadiusPanel);
    Rect column = place.inset(16, 12);
    closed |= sheet_head(column.cut_top(36), picking.title, "Close picking");
    const float high = lines_height(Font::body, picking.words, column.w, 20);
    write_lines(column.cut_top(high), Font::body, t.muted, picking.words, 20);
    column.cut_top(8);
    Rect foot = column.cut_bottom(narrow && !picking.one ? 84 : 36);
    column.cut_bottom(12);
    Rect buttons = narrow && !picking.one ? foot.cut_bottom(36) : foot;
    const std::size_t taken = picking.taken().size();
    Look add;
    add.primary = true;
    add.enabled = taken > 0;
    add.id = picking.one ? "Crop to the box" : "Cut it up";
    const std::string words = action_words(picking, taken);
    const float wide = std::max(120.0f, text_width(Font::body_bold, words) + 32);
    done = button(words, buttons.cut_right(wide), add);
    buttons.cut_right(8);
    if (picking.whole) whole = button("One drawing", buttons.cut_right(120));
    buttons.cut_right(16);
    if (!picking.one) {
      Rect& left = narrow ? foot : buttons;
      done |= grid_field(app, picking, left.cut_left(std::min(left.w, 260.0f)).cut_top(36)) &&
              taken > 0;
    }
    picture(app, picking, column);
  }
  if (!closed && !done && !whole) return;
  const Picking answered = std::move(picking);
  app.picking.pop_front();
  if (done)
    answered.with(answered.taken());
  else if (whole)
    answered.whole();
}

}  // namespace artisketch
