// What comes with the program, as cards: a few on the first screen, all in the gallery over it.
#include <algorithm>
#include <cmath>

#include "document/edit.h"
#include "editor/canvas/controls.h"
#include "editor/session/files.h"
#include "editor/shell/panels.h"

namespace artisketch {
namespace {

using Shelf = ExampleCard::Shelf;

constexpr float kCardGap = 12;  // cards

std::string title_of(const ExampleCard& example) {
  std::string name = capitalised(example.name);
  std::replace(name.begin(), name.end(), '-', ' ');
  return name;
}

// Asked for once, and there when it came.
const Drawing* example_picture(App& app, const std::string& name) {
  if (const auto known = app.services.example_pictures.find(name);
      known != app.services.example_pictures.end())
    return app.services.drawings.at(known->second);
  app.services.example_pictures[name] = "";
  app.services.platform.load_example_picture(name, [&app, name](std::string png) {
    const Result<std::string> key = app.services.drawings.add(std::move(png), name);
    if (key) app.services.example_pictures[name] = *key;
  });
  return nullptr;
}

void model_of(App& app, const ExampleCard& example, const Rect& place) {
  const Drawing* model = example_picture(app, example.name);
  if (!model) return write_icon(place.centre(), IconSize::large, theme().muted, icon::kWalk);
  const float scale =
      std::min(place.w / float(model->image.width), place.h / float(model->image.height));
  show_picture(model->texture,
               place.middle(scale * float(model->image.width), scale * float(model->image.height)),
               1);
}

// Picture and words: beside each other; below it, the count left out in a small card.
void fill_card(App& app, const ExampleCard& example, const Rect& card) {
  const Theme& t = theme();
  const std::string name = title_of(example),
                    count = example.drawings == 1 ? "one drawing"
                                                  : std::to_string(example.drawings) + " drawings";
  constexpr float kGap = 8, kRoomy = 130;
  Rect picture = card.inset(6, 4), words;
  const float wide = std::max(name_width(Font::body_bold, name), text_width(Font::caption, count));
  if (card.h >= kRoomy && wide < picture.w) {
    words = picture.cut_bottom(40);
    write_name(words.cut_top(20), Font::body_bold, t.text, name, Align::centre);
    write(words, Font::caption, t.muted, count, Align::centre);
    picture.cut_bottom(2);
  } else if (picture.w - std::min(picture.h, picture.w / 2) - kGap > wide) {
    words = picture;
    picture = words.cut_left(std::min(words.h, words.w / 2));
    words.cut_left(kGap);
    words = words.middle(words.w, 40);
    write_name(words.cut_top(20), Font::body_bold, t.text, name);
    write(words, Font::caption, t.muted, count);
  } else {
    write_name(picture.cut_bottom(16), Font::caption_bold, t.text, name, Align::centre);
  }
  model_of(app, example, picture);
}

// Whether it was opened.
bool example_card(App& app, const ExampleCard& example, const Rect& card, bool greets) {
  const Theme& t = theme();
  const Press press = press_area("Example " + title_of(example), card);
  draw().AddRectFilled(card.min(), card.max(), press.hovered ? t.hover : t.control, kRadiusCard);
  if (greets) draw().AddRect(card.min(), card.max(), t.accent, kRadiusCard, 0, 1.5f);
  if (press.clicked) {
    open_example(app, example.name, false);
    return true;
  }
  fill_card(app, example, card);
  return false;
}

std::size_t count_on(const App& app, Shelf shelf) {
  const std::vector<ExampleCard>& all = app.services.examples;
  return std::size_t(std::count_if(all.begin(), all.end(),
                                   [&](const ExampleCard& card) { return card.shelf == shelf; }));
}

// As many columns as let the cards come nearest to the shape that a figure standing above its name
// fills best.
std::size_t best_columns(std::size_t cards, const Rect& place) {
  constexpr float kShape = 0.85f;  // width over height
  const auto off = [&](std::size_t columns) {
    const std::size_t rows = (cards + columns - 1) / columns;
    const float wide = (place.w + kCardGap) / float(columns) - kCardGap,
                high = (place.h + kCardGap) / float(rows) - kCardGap;
    return std::abs(std::log(wide / std::max(high, 1.0f) / kShape));
  };
  std::size_t best = 1;
  for (std::size_t columns = 2; columns <= cards; ++columns)
    if (off(columns) < off(best)) best = columns;
  return best;
}

}  // namespace

void examples_row(App& app, const Rect& place) {
  const Theme& t = theme();
  Rect column = place.inset(24, 12);
  Rect head = column.cut_top(22);
  const std::size_t shown = count_on(app, Shelf::first_screen);
  if (count_on(app, Shelf::gallery) > 0) {
    Look look;
    look.quiet = true;
    look.icon = icon::kGrid;
    look.hint = "The paper's figures, and others";
    Rect target = head.cut_right(text_width(Font::body, "Gallery") + 44);
    target.y -= 8;  // for a finger, up to the panel's edge and down to the cards
    target.h += 12;
    if (button("Gallery", target, look)) app.view.gallery = true;
  }
  write(head.cut_left(text_width(Font::body_bold, "Examples") + 10), Font::body_bold, t.text,
        "Examples");
  const std::size_t left_out = count_on(app, Shelf::elsewhere);
  const std::string whole =
      std::to_string(left_out) + " more in the page as a folder: this one file comes without them";
  const std::string more = left_out == 0 ? "open one and change anything"
                           : text_width(Font::caption, whole) < head.w
                               ? whole
                               : "the gallery isn't in here";
  write(head, Font::caption, t.muted, more);
  column.cut_top(6);
  if (shown == 0) return;
  const float width = std::min(178.0f, (column.w + kCardGap) / float(shown) - kCardGap);
  for (std::size_t i = 0; i < shown; ++i) {
    const Rect card = column.cut_left(width);
    column.cut_left(kCardGap);
    if (example_card(app, app.services.examples[i], card, i == 0)) return;
  }
}

void gallery(App& app, const Rect& place) {
  const Theme& t = theme();
  const Panel panel("Gallery", place, t.panel);
  Rect column = place.inset(24, 16);
  Rect head = column.cut_top(32);
  const std::string about = "open one and change anything";
  const float title = text_width(Font::title, "Gallery") + 12;
  if (sheet_head(head, "Gallery", "Close the gallery")) app.view.gallery = false;
  head.cut_left(title);
  head.cut_right(36);
  if (text_width(Font::caption, about) < head.w) write(head, Font::caption, t.muted, about);
  column.cut_top(10);
  const std::vector<ExampleCard>& all = app.services.examples;
  const std::size_t cards = all.size() - count_on(app, Shelf::elsewhere);
  const std::size_t columns = best_columns(cards, column);
  const std::size_t rows = (cards + columns - 1) / columns;
  const float wide = (column.w + kCardGap) / float(columns) - kCardGap,
              high = (column.h + kCardGap) / float(rows) - kCardGap;
  for (std::size_t i = 0; i < cards; ++i) {
    const Rect card{column.x + float(i % columns) * (wide + kCardGap),
                    column.y + float(i / columns) * (high + kCardGap), wide, high};
    if (example_card(app, all[i], card, false)) return;
  }
}

}  // namespace artisketch
