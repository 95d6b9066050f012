#include <cstdio>

#include "editor/actions.h"
#include "editor/panels.h"

namespace artisketch {

std::string bytes_in_words(std::size_t bytes) {
  char words[32];
  if (bytes < 1000 * 1000)
    std::snprintf(words, sizeof words, "%d kB", int(bytes / 1000) + 1);
  else
    std::snprintf(words, sizeof words, "%.1f MB", double(bytes) / 1e6);
  return words;
}

void export_sheet(Work& work, const Rect& place) {
  static std::size_t chosen = 0;
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
  for (std::size_t i = 0; i < formats.size(); ++i) {
    const Rect card = column.cut_top(48).inset(12, 0);
    column.cut_top(6);
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
    write({card.x + 44, card.y + 5, card.w - 80, 20}, Font::body_bold, t.text, formats[i].name);
    write({card.x + 44, card.y + 24, card.w - 80, 18}, Font::caption, t.muted, formats[i].about);
    if (press.clicked) chosen = i;
  }

  Rect foot = column.cut_bottom(96).inset(12, 0);
  if (work.built) {
    const Model& model = work.built->model;
    if (!model.clips.empty()) {
      column.cut_top(8);
      write(column.cut_top(26).inset(16, 0), Font::body_bold, t.text, "Animations");
      for (const Clip& clip : model.clips) {
        Rect row = column.cut_top(26).inset(16, 0);
        char about[48];
        std::snprintf(about, sizeof about, "%d keys, %.1f s", int(clip.times.size()),
                      clip.times.empty() ? 0 : clip.times.back());
        write(row.cut_right(110), Font::caption, t.muted, about, Align::right);
        write(row, Font::body, t.text, clip.name);
      }
    }
    column.cut_top(12);
    const Rect card = column.cut_top(116).inset(12, 0);
    draw().AddRectFilled(card.min(), card.max(), t.control, kRadiusCard);
    Rect lines = card.inset(14, 10);
    const auto line = [&](const char* what, const std::string& value) {
      Rect row = lines.cut_top(24);
      write(row.cut_right(row.w - 80), Font::caption_bold, t.text, value, Align::right);
      write(row, Font::caption, t.muted, what);
    };
    line("Triangles", std::to_string(model.mesh.F.rows()));
    line("Skeleton", std::to_string(model.skeleton.size()) + " joints");
    line("Weights", "4 per vertex, sum to 1");
    line("File", bytes_in_words(work.built->glb.size()));
  }
  Look primary;
  primary.primary = true;
  primary.icon = icon::kDownload;
  primary.enabled = work.built != nullptr;
  const std::string file = export_name(work, formats[chosen]);
  if (button("Export " + file, foot.cut_top(44), primary)) export_model(work, formats[chosen]);
  write(foot.cut_top(30), Font::small, t.muted,
        work.built ? "Saved on this computer. Nothing is uploaded." : "Reconstruct first.",
        Align::centre);
}

}  // namespace artisketch
