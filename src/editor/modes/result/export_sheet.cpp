#include "editor/modes/result/export_sheet.h"

#include <cmath>
#include <cstdio>

#include "editor/canvas/controls.h"
#include "editor/modes/result/exports.h"
#include "editor/ui/menu.h"
#include "model/rig/rig_profile.h"

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

void clip_rows(App& app, Rect& column, float room) {
  const Theme& t = theme();
  constexpr float kRow = 26;
  const std::vector<Clip>& clips = app.session.built->model.clips;
  column.cut_top(6);
  write(column.cut_top(26), Font::body_bold, t.text, "Animations");
  room = std::max(room - 32, kRow);
  Rect list = column.cut_top(std::min(room, kRow * float(clips.size())));
  list.w -= 6;
  const Rows rows = scrolled_rows(app.session.export_wish.first_row, int(clips.size()), kRow, list);
  for (int c = rows.first; c < rows.end; ++c) {
    const Clip& clip = clips[std::size_t(c)];
    Rect row = list.cut_top(kRow);
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

void texture_row(App& app, Rect row) {
  ExportChoice& wish = app.view.export_choice;
  write(row.cut_left(64), Font::body, theme().text, "Texture");
  constexpr int kSizes = 3;
  const int side =
      std::max(app.session.built->model.texture->width, app.session.built->model.texture->height);
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

// How an engine knows the joints; a press lists those that are known.
void rig_row(App& app, Rect row) {
  ExportChoice& wish = app.view.export_choice;
  write(row.cut_left(64), Font::body, theme().text, "Joints");
  const std::span<const RigProfile> rigs = rig_profiles();
  Look look;
  look.id = "Joints' names";
  look.hint = "Named and completed as an engine has them";
  look.icon = icon::kChevronDown;
  constexpr const char* kNone = "Only this pose, no skeleton";
  const char* chosen = wish.rig == 0                    ? "As drawn"
                       : wish.rig == without_skeleton() ? kNone
                                                        : rigs[wish.rig - 1].about;
  const bool opens = button(chosen, row.middle(row.w, 28), look);
  Menu menu("Rigs", opens);
  if (!menu) return;
  if (menu.line("As drawn")) wish.rig = 0;
  for (std::size_t i = 0; i < rigs.size(); ++i)
    if (menu.line(rigs[i].about)) wish.rig = i + 1;
  if (menu.line(kNone)) wish.rig = without_skeleton();
}

// A row of choices by words, and the value that each stands for; whether one was clicked.
template <class T, std::size_t N>
void choice_row(Rect row, const char* what, const std::pair<const char*, T> (&offered)[N],
                T& value) {
  write(row.cut_left(76), Font::body, theme().text, what);
  std::vector<std::pair<std::string, Look>> choices;
  for (const auto& [words, stands_for] : offered) {
    auto& [label, look] = choices.emplace_back();
    label = words;
    look.on = value == stands_for;
    look.id = std::string(what) + " " + words;
  }
  const int chosen =
      segments(choices, row.middle(row.w, std::min(26.0f, row.h - 3)), Font::caption);
  if (chosen >= 0) value = offered[chosen].second;
}

void sprite_rows(App& app, Rect& column, float room) {
  SpriteOptions& wish = app.view.export_choice.sprites;
  constexpr float kOthers = 26 + 28, kChoices = 7;
  const float tall = std::clamp((room - kOthers) / kChoices, 22.0f, 31.0f);
  Rect clip = column.cut_top(26);
  write(clip.cut_left(76), Font::body, theme().text, "Clip");
  write_name(clip, Font::body_bold, theme().text, sprite_wish(app).clip);
  choice_row<int>(column.cut_top(tall), "Sides", {{"1", 1}, {"4", 4}, {"8", 8}, {"16", 16}},
                  wish.directions);
  choice_row<int>(column.cut_top(tall), "Size",
                  {{"32", 32}, {"64", 64}, {"128", 128}, {"256", 256}}, wish.size);
  choice_row<double>(column.cut_top(tall), "A second", {{"6", 6}, {"8", 8}, {"12", 12}, {"24", 24}},
                     wish.rate);
  choice_row<int>(column.cut_top(tall), "Padding", {{"0", 0}, {"1", 1}, {"2", 2}, {"4", 4}},
                  wish.padding);
  choice_row<Light>(column.cut_top(tall), "Light",
                    {{"Soft", Light::soft}, {"Toon", Light::toon}, {"Plain", Light::plain}},
                    wish.light);
  choice_row<int>(column.cut_top(tall), "Pixels", {{"Off", 0}, {"1", 1}, {"2", 2}, {"4", 4}},
                  wish.pixels);
  choice_row<SheetLayout>(column.cut_top(tall), "JSON",
                          {{"Array", SheetLayout::array}, {"By name", SheetLayout::hash}},
                          wish.layout);
  Rect row = column.cut_top(28);
  constexpr float kBox = 34;  // with what is left beside it
  checkbox("Ink", row.cut_left(std::max(row.w / 4, text_width(Font::body, "Ink") + kBox)),
           wish.ink);
  checkbox("Normals", row.cut_left(row.w * 0.55f), wish.normals);
  checkbox("Depth", row, wish.depth);
}

bool is_gltf(const App& app) {
  const std::string format = export_formats()[app.view.export_choice.format].name;
  return format == "GLB" || format == "VRM";
}

bool still(const App& app) {
  const ExportChoice& wish = app.view.export_choice;
  return export_formats()[wish.format].name == std::string("GLB") && wish.rig == without_skeleton();
}

// What the chosen format leaves to choose.
void choices(App& app, Rect& column, float room) {
  ExportChoice& wish = app.view.export_choice;
  const std::string format = export_formats()[wish.format].name;
  const bool rigged = is_gltf(app);
  const float bottom = column.y + room;
  if (format == "Sprites") return sprite_rows(app, column, room);
  if (format != "PNG") triangles_row(app, column.cut_top(56));
  if (rigged && app.session.built->model.texture) texture_row(app, column.cut_top(34));
  if (format == "GLB") rig_row(app, column.cut_top(34));
  if (rigged) {
    checkbox("Compressed (not for Godot)", column.cut_top(28), wish.compress);
    if (!app.session.built->model.clips.empty() && !still(app))
      clip_rows(app, column, bottom - column.y);
  } else if (format == "PNG") {
    Look one, all;
    one.on = !wish.sides;
    all.on = wish.sides;
    const int chosen =
        segments({{"From here", one}, {"From 8 sides", all}}, column.cut_top(30), Font::caption);
    if (chosen >= 0) wish.sides = chosen == 1;
  }
}

// The formats as cards, two side by side or more; what the chosen one holds, below them.
void format_cards(App& app, Rect& column, bool low) {
  const Theme& t = theme();
  std::size_t& chosen = app.view.export_choice.format;
  const std::span<const ExportFormat> formats = export_formats();
  // Where there is little room, names alone.
  const bool tiny = column.h < 510;
  const std::size_t columns = tiny || column.w > 600 ? 4 : 2;
  const float gap = 6, width = (column.w - 24 - gap * float(columns - 1)) / float(columns);
  const float tall = low ? 34 : 40;
  for (std::size_t i = 0; i < formats.size(); ++i) {
    const Rect card{column.x + 12 + (width + gap) * float(i % columns), column.y, width, tall};
    if (i % columns + 1 == columns || i + 1 == formats.size()) column.cut_top(tall + gap);
    const bool on = i == chosen;
    const Press press = press_area(std::string("Format ") + formats[i].name, card, true, on);
    draw().AddRectFilled(card.min(), card.max(),
                         on              ? t.selection
                         : press.hovered ? t.hover
                                         : t.control,
                         kRadiusCard);
    if (on) draw().AddRect(card.min(), card.max(), t.accent, kRadiusCard, 0, 1.5f);
    if (!tiny)
      write_icon({card.x + 22, card.centre().y}, IconSize::normal, on ? t.accent : t.muted,
                 formats[i].icon);
    const float beside = tiny ? 2 : 44;
    write({card.x + beside, card.y, card.w - beside - 2, card.h},
          tiny ? Font::caption_bold : Font::body_bold, t.text, formats[i].name,
          tiny ? Align::centre : Align::left);
    if (press.hovered) tooltip(formats[i].about, "");
    if (press.clicked) chosen = i;
  }
  if (!tiny) write(column.cut_top(22).inset(16, 0), Font::caption, t.muted, formats[chosen].about);
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
  line("Skeleton", still(app) ? "None"
                              : std::to_string(model.skeleton.size()) +
                                    (model.skeleton.size() == 1 ? " joint" : " joints"));
  line("Weights", still(app) ? "None" : "4 a vertex, sum 1");
  const ExportChoice& wish = app.view.export_choice;
  const bool less = !wish.texture || wish.halvings > 0 || wish.compress || still(app) ||
                    !app.session.export_wish.without.empty();
  line(is_gltf(app) ? "Valid glTF" : "File",
       (less ? "less than " : "") + bytes_in_words(app.session.built->glb.size()));
}

void export_button(App& app, Rect foot) {
  Look primary;
  primary.primary = true;
  primary.icon = icon::kDownload;
  const bool draws = app.busy() && app.session.job->kind == JobRequest::Kind::sprites;
  const bool waits = draws || (app.session.export_wish.waits && app.busy());
  primary.enabled = available(app, "export_file") && !waits;
  const ExportFormat& format = export_formats()[app.view.export_choice.format];
  if (button("Export " + export_name(app, format), foot.cut_top(44), primary))
    app.ask("export_file");
  if (foot.h < 30) return;
  write(foot.cut_top(30), Font::small, theme().muted,
        !app.session.built    ? "Reconstruct first."
        : draws               ? "Drawing the sprites."
        : waits               ? "Making it first, as you changed it."
        : app.session.stale() ? "The model is made again first: you changed it."
                              : "Saved here. Nothing is uploaded.",
        Align::centre);
}

}  // namespace

void export_sheet(App& app, const Rect& place) {
  const bool low = place.h < 680, tiny = place.h < 480;
  Rect column = place;
  if (sheet_head(column.cut_top(48).inset(16, 0), "Export")) app.ask("export");
  format_cards(app, column, low);
  export_button(app, column.cut_bottom(tiny ? 58 : low ? 80 : 96).inset(12, 0));
  if (!app.session.built) return;
  column.cut_top(4);
  const bool sprites =
      std::string(export_formats()[app.view.export_choice.format].name) == "Sprites";
  const float tall = sprites ? 0.0f : low ? 100.0f : 116.0f;
  Rect inner = column.inset(16, 0);
  choices(app, inner, column.h - tall - 14);
  column.cut_top(inner.y - column.y + 8);
  if (tall > 0 && column.h >= tall) facts(app, column.cut_top(tall).inset(12, 0), low);
}

}  // namespace artisketch
