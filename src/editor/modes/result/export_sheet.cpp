#include "editor/modes/result/export_sheet.h"

#include <cmath>
#include <cstdio>

#include "editor/canvas/controls.h"
#include "editor/modes/result/exports.h"

namespace artisketch {
namespace {

std::string bytes_in_words(std::size_t bytes) {
  char words[32];
  if (bytes < 1000 * 1000)
    std::snprintf(words, sizeof words, "%d kB", int(bytes / 1000) + 1);
  else
    std::snprintf(words, sizeof words, "%.1f MB", double(bytes) / 1e6);
  return words;
}

// How many triangles the model shall have; another number makes another model.
void triangles_row(App& app, Rect column) {
  constexpr int kFewest = 1000, kMost = 60000, kStep = 500, kDefault = 15000;
  const Document& document = app.document();
  const int now = document.settings.triangles.value_or(kDefault);
  Rect head = column.cut_top(26);
  write(head.cut_right(90), Font::body_bold, theme().text, in_thousands(now), Align::right);
  write(head, Font::body, theme().text, "Triangles");
  const double low = std::log(double(kFewest)), high = std::log(double(kMost));
  float value = float((std::log(double(std::clamp(now, kFewest, kMost))) - low) / (high - low));
  const bool moved = slider("Triangles", column.cut_top(24), value, 0, 1);
  const int wanted = kStep * int(std::lround(std::exp(low + double(value) * (high - low)) / kStep));
  if (ImGui::IsItemActivated()) app.session.begin_gesture();
  if (!moved || wanted == now) return;
  Document next = document;
  next.settings.triangles = wanted;
  app.session.change("Set triangles", std::move(next));
}

void clip_rows(App& app, Rect& column) {
  const Theme& t = theme();
  column.cut_top(6);
  write(column.cut_top(26), Font::body_bold, t.text, "Animations");
  for (const Clip& clip : app.session.built->model.clips) {
    Rect row = column.cut_top(26);
    char about[48];
    std::snprintf(about, sizeof about, "%d keys, %.1f s", int(clip.times.size()),
                  clip.times.empty() ? 0 : clip.times.back());
    write(row.cut_right(110), Font::caption, t.muted, about, Align::right);
    bool with = !app.session.export_wish.without.contains(clip.name);
    if (!checkbox(clip.name, row, with)) continue;
    if (with)
      app.session.export_wish.without.erase(clip.name);
    else
      app.session.export_wish.without.insert(clip.name);
  }
}

// What the chosen format leaves to choose.
void choices(App& app, Rect& column) {
  const Theme& t = theme();
  ExportChoice& wish = app.view.export_choice;
  const std::string format = export_formats()[wish.format].name;
  if (format != "PNG") triangles_row(app, column.cut_top(56));
  if (format == "GLB") {
    Rect row = column.cut_top(34);
    if (app.session.built->model.texture) {
      write(row.cut_left(64), Font::body, t.text, "Texture");
      constexpr int kSizes = 3;
      const int side = std::max(app.session.built->model.texture->width,
                                app.session.built->model.texture->height);
      std::vector<std::pair<std::string, Look>> choices(1);
      choices[0].first = "None";
      choices[0].second.on = !wish.texture;
      for (int halvings = kSizes - 1; halvings >= 0; --halvings) {
        auto& [label, look] = choices.emplace_back();
        label = std::to_string(side >> halvings);
        look.on = wish.texture && wish.halvings == halvings;
        look.id = "Texture " + label;
        look.hint = label + " pixels along the longer side";
      }
      const int chosen = segments(choices, row.middle(row.w, 28), Font::caption);
      if (chosen >= 0) wish.texture = chosen > 0;
      if (chosen > 0) wish.halvings = kSizes - chosen;
    }
    if (!app.session.built->model.clips.empty()) clip_rows(app, column);
  } else if (format == "PNG") {
    Look one, all;
    one.on = !wish.sides;
    all.on = wish.sides;
    const int chosen =
        segments({{"From here", one}, {"From 8 sides", all}}, column.cut_top(30), Font::caption);
    if (chosen >= 0) wish.sides = chosen == 1;
  }
}

// The formats as cards, side by side where the sheet is wide.
void format_cards(App& app, Rect& column, bool low) {
  const Theme& t = theme();
  std::size_t& chosen = app.view.export_choice.format;
  const std::span<const ExportFormat> formats = export_formats();
  const std::size_t columns = column.w > 600 ? 2 : 1;
  const float width = (column.w - 24 - 8 * float(columns - 1)) / float(columns);
  for (std::size_t i = 0; i < formats.size(); ++i) {
    const Rect card{column.x + 12 + (width + 8) * float(i % columns), column.y, width,
                    low ? 42.0f : 48.0f};
    if (i % columns + 1 == columns || i + 1 == formats.size())
      column.cut_top(card.h + (low ? 4 : 6));
    const bool on = i == chosen;
    const Press press = press_area(std::string("Format ") + formats[i].name, card, true, on);
    draw().AddRectFilled(card.min(), card.max(),
                         on              ? t.selection
                         : press.hovered ? t.hover
                                         : t.control,
                         kRadiusCard);
    if (on) {
      draw().AddRect(card.min(), card.max(), t.accent, kRadiusCard, 0, 1.5f);
      write_icon({card.right() - 20, card.centre().y}, IconSize::small, t.accent,
                 icon::kCheckCircle);
    }
    write_icon({card.x + 22, card.centre().y}, IconSize::normal, on ? t.accent : t.muted,
               formats[i].icon);
    write({card.x + 44, card.y + (low ? 2.0f : 5.0f), card.w - 80, 20}, Font::body_bold, t.text,
          formats[i].name);
    write({card.x + 44, card.y + (low ? 20.0f : 24.0f), card.w - 50, 18}, Font::caption, t.muted,
          formats[i].about);
    if (press.clicked) chosen = i;
  }
}

void facts(const App& app, const Rect& card, bool low) {
  const Theme& t = theme();
  const Model& model = app.session.built->model;
  draw().AddRectFilled(card.min(), card.max(), t.control, kRadiusCard);
  Rect lines = card.inset(14, low ? 4 : 10);
  const auto line = [&](const char* what, const std::string& value) {
    Rect row = lines.cut_top(24);
    write(row.cut_right(row.w - 80), Font::caption_bold, t.text, value, Align::right);
    write(row, Font::caption, t.muted, what);
  };
  line("Triangles", in_thousands(int(model.mesh.F.rows())));
  line("Skeleton",
       std::to_string(model.skeleton.size()) + (model.skeleton.size() == 1 ? " joint" : " joints"));
  line("Weights", "4 per vertex, sum to 1");
  const ExportChoice& wish = app.view.export_choice;
  const bool less = !wish.texture || wish.halvings > 0 || !app.session.export_wish.without.empty();
  line("File", (less ? "less than " : "") + bytes_in_words(app.session.built->glb.size()));
}

void export_button(App& app, Rect foot) {
  Look primary;
  primary.primary = true;
  primary.icon = icon::kDownload;
  const bool waits = app.session.export_wish.waits && app.busy();
  primary.enabled = available(app, "export_file") && !waits;
  const ExportFormat& format = export_formats()[app.view.export_choice.format];
  if (button("Export " + export_name(app, format), foot.cut_top(44), primary))
    app.ask("export_file");
  write(foot.cut_top(30), Font::small, theme().muted,
        !app.session.built    ? "Reconstruct first."
        : waits               ? "Making it first, as you changed it."
        : app.session.stale() ? "The model is made again first: you changed it."
                              : "Saved on this computer. Nothing is uploaded.",
        Align::centre);
}

}  // namespace

void export_sheet(App& app, const Rect& place) {
  const bool low = place.h < 680;
  Rect column = place;
  Rect head = column.cut_top(48).inset(16, 0);
  Look close;
  close.icon = icon::kClose;
  close.quiet = true;
  close.key = "Esc";
  if (icon_button("Close", head.cut_right(28).middle(28, 28), close)) app.ask("export");
  write(head, Font::title, theme().text, "Export");
  format_cards(app, column, low);
  export_button(app, column.cut_bottom(low ? 80 : 96).inset(12, 0));
  if (!app.session.built) return;
  column.cut_top(6);
  Rect inner = column.inset(16, 0);
  choices(app, inner);
  column.cut_top(inner.y - column.y + 10);
  facts(app, column.cut_top(low ? 100 : 116).inset(12, 0), low);
}

}  // namespace artisketch
