#include <cmath>
#include <cstdio>

#include "editor/session/actions.h"
#include "editor/shell/panels.h"

namespace artisketch {
std::string bytes_in_words(std::size_t bytes) {
  char words[32];
  if (bytes < 1000 * 1000)
    std::snprintf(words, sizeof words, "%d kB", int(bytes / 1000) + 1);
  else
    std::snprintf(words, sizeof words, "%.1f MB", double(bytes) / 1e6);
  return words;
}

namespace {

// How many triangles the model shall have; another number makes another model.
void triangles_row(Work& work, Rect column) {
  constexpr int kFewest = 1000, kMost = 60000, kStep = 500, kDefault = 15000;
  const Document& document = work.document();
  const int now = document.settings.triangles.value_or(kDefault);
  Rect head = column.cut_top(26);
  write(head.cut_right(90), Font::body_bold, theme().text, in_thousands(now), Align::right);
  write(head, Font::body, theme().text, "Triangles");
  const double low = std::log(double(kFewest)), high = std::log(double(kMost));
  float value = float((std::log(double(std::clamp(now, kFewest, kMost))) - low) / (high - low));
  const bool moved = slider("Triangles", column.cut_top(24), value, 0, 1);
  const int wanted = kStep * int(std::lround(std::exp(low + double(value) * (high - low)) / kStep));
  if (ImGui::IsItemActivated()) work.gesture = {};
  if (!moved || wanted == now) return;
  Document next = document;
  next.settings.triangles = wanted;
  work.change("Set triangles", std::move(next));
}

void clip_rows(Work& work, Rect& column) {
  const Theme& t = theme();
  column.cut_top(6);
  write(column.cut_top(26), Font::body_bold, t.text, "Animations");
  for (const Clip& clip : work.built->model.clips) {
    Rect row = column.cut_top(26);
    char about[48];
    std::snprintf(about, sizeof about, "%d keys, %.1f s", int(clip.times.size()),
                  clip.times.empty() ? 0 : clip.times.back());
    write(row.cut_right(110), Font::caption, t.muted, about, Align::right);
    bool with = !work.view.wish.without.contains(clip.name);
    if (!checkbox(clip.name, row, with)) continue;
    if (with)
      work.view.wish.without.erase(clip.name);
    else
      work.view.wish.without.insert(clip.name);
  }
}

// What the chosen format leaves to choose.
void choices(Work& work, Rect& column) {
  const Theme& t = theme();
  ExportWish& wish = work.view.wish;
  const std::string format = export_formats()[wish.format].name;
  if (format != "PNG") triangles_row(work, column.cut_top(56));
  if (format == "GLB") {
    Rect row = column.cut_top(34);
    if (work.built->model.texture) {
      write(row.cut_left(64), Font::body, t.text, "Texture");
      constexpr int kSizes = 3;
      const int side =
          std::max(work.built->model.texture->width, work.built->model.texture->height);
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
    if (!work.built->model.clips.empty()) clip_rows(work, column);
  } else if (format == "PNG") {
    Look one, all;
    one.on = !wish.sides;
    all.on = wish.sides;
    const int chosen =
        segments({{"From here", one}, {"From 8 sides", all}}, column.cut_top(30), Font::caption);
    if (chosen >= 0) wish.sides = chosen == 1;
  }
}

}  // namespace

void export_sheet(Work& work, const Rect& place) {
  std::size_t& chosen = work.view.wish.format;
  const Theme& t = theme();
  Rect column = place;
  Rect head = column.cut_top(48).inset(16, 0);
  Look close;
  close.icon = icon::kClose;
  close.quiet = true;
  close.key = "Esc";
  if (icon_button("Close", head.cut_right(28).middle(28, 28), close)) work.view.exporting = false;
  write(head, Font::title, t.text, "Export");

  const std::span<const ExportFormat> formats = export_formats();
  // A wide sheet has them side by side.
  const std::size_t columns = place.w > 600 ? 2 : 1;
  const bool low = place.h < 680;
  const float gap = low ? 4 : 6;
  const float width = (place.w - 24 - 8 * float(columns - 1)) / float(columns);
  for (std::size_t i = 0; i < formats.size(); ++i) {
    const Rect card{place.x + 12 + (width + 8) * float(i % columns), column.y, width,
                    low ? 42.0f : 48.0f};
    if (i % columns + 1 == columns || i + 1 == formats.size()) column.cut_top(card.h + gap);
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

  Rect foot = column.cut_bottom(low ? 80 : 96).inset(12, 0);
  if (work.built) {
    const Model& model = work.built->model;
    column.cut_top(6);
    Rect inner = column.inset(16, 0);
    choices(work, inner);
    column.cut_top(inner.y - column.y + 10);
    const Rect card = column.cut_top(low ? 100 : 116).inset(12, 0);
    draw().AddRectFilled(card.min(), card.max(), t.control, kRadiusCard);
    Rect lines = card.inset(14, low ? 4 : 10);
    const auto line = [&](const char* what, const std::string& value) {
      Rect row = lines.cut_top(24);
      write(row.cut_right(row.w - 80), Font::caption_bold, t.text, value, Align::right);
      write(row, Font::caption, t.muted, what);
    };
    line("Triangles", in_thousands(int(model.mesh.F.rows())));
    line("Skeleton", std::to_string(model.skeleton.size()) +
                         (model.skeleton.size() == 1 ? " joint" : " joints"));
    line("Weights", "4 per vertex, sum to 1");
    const ExportWish& wish = work.view.wish;
    const bool less = !wish.texture || wish.halvings > 0 || !wish.without.empty();
    line("File", (less ? "less than " : "") + bytes_in_words(work.built->glb.size()));
  }
  Look primary;
  primary.primary = true;
  primary.icon = icon::kDownload;
  const bool waits = work.view.wish.waits && work.busy();
  primary.enabled = work.built != nullptr && !waits;
  const std::string file = export_name(work, formats[chosen]);
  if (button("Export " + file, foot.cut_top(44), primary)) {
    if (work.stale() && available(work, Command::reconstruct)) {
      work.view.wish.waits = true;
      start_job(work, JobRequest::Kind::reconstruct);
    } else {
      export_model(work, formats[chosen]);
    }
  }
  write(foot.cut_top(30), Font::small, t.muted,
        !work.built    ? "Reconstruct first."
        : waits        ? "Making it first, as you changed it."
        : work.stale() ? "The model is made again first: you changed it."
                       : "Saved on this computer. Nothing is uploaded.",
        Align::centre);
}

}  // namespace artisketch
