// Drawings and skeletons on their way into the document.
#include <algorithm>
#include <cstdlib>

#include <imgui.h>

#include "document/edit.h"
#include "document/skeleton_edit.h"
#include "document/sprite_sheet.h"
#include "editor/session/files.h"
#include "editor/ui/icons.h"

namespace artisketch {

std::optional<Box2> figure_in(const App& app, const Frame& frame) {
  const Drawing* drawing = app.services.drawings.of(frame);
  if (!drawing) return std::nullopt;
  const Box2 box = figure_box(segmented(drawing->image));
  return box.isEmpty() ? std::nullopt : std::optional(box);
}

namespace {

std::string without_ending(const std::string& name) {
  return name.substr(0, name.rfind('.'));
}

// Drawings as files, and what they are called.
struct Arrived {
  std::string name;
  std::string bytes;  // PNG or JPEG
};

// The first drawing sets the scale: the skeleton stands as tall as the figure. The others begin in
// the pose of the one before, over their own figure.
Result<Document> with_drawing(App& app, Document document, const Arrived& arrived) {
  Result<std::string> key = app.services.drawings.add(arrived.bytes, arrived.name);
  if (!key) return key.error();
  Frame frame;
  frame.name = arrived.name;
  frame.image = *key;
  const Drawing& drawing = *app.services.drawings.of(frame);
  frame.width = drawing.image.width;
  frame.height = drawing.image.height;
  const std::optional<Box2> figure = figure_in(app, frame);
  document = with_frame(std::move(document), std::move(frame));
  if (document.frames.size() == 1)
    return with_skeleton_fitted(std::move(document), 0, figure, FitOptions());
  Frame& last = document.frames.back();
  if (figure) last.pose = pose_over(document, last, last.pose, *figure);
  return document;
}

void add_all(App& app, const std::vector<Arrived>& all) {
  Document next = app.document();
  const bool first = next.frames.empty();
  for (const Arrived& arrived : all) {
    Result<Document> with = with_drawing(app, next, arrived);
    if (!with) return complain(app, with.error());
    next = std::move(*with);
  }
  const int at = int(app.document().frames.size());
  app.session.commit(
      all.size() == 1 ? "Add " + all[0].name : "Add " + std::to_string(all.size()) + " drawings",
      std::move(next));
  app.session.selection.frame = at;
  app.session.selection.contour = -1;
  app.view.fit_again();
  if (!first) return;
  Toast toast;
  toast.words = "A person's skeleton lies over the drawing.";
  toast.action = "Choose another";
  toast.act = [&app] { perform(app, "mode_skeleton"); };
  app.say(std::move(toast));
}

// ---------------------------------------------------------------- sheets

void add_sprites(App& app, const Image& sheet, const std::string& name,
                 const std::vector<Sprite>& sprites) {
  std::vector<Arrived> all;
  for (const Sprite& sprite : sprites) {
    all.push_back({name + " " + std::to_string(all.size() + 1), png_bytes(cut_out(sheet, sprite))});
  }
  add_all(app, all);
}

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

void ask_how_to_cut(App& app, const NamedBytes& file, Image sheet, std::vector<Sprite> sprites) {
  const std::string name = without_ending(file.name);
  int columns = 0, rows = 0;
  for (const Sprite& sprite : sprites) {
    columns = std::max(columns, sprite.column + 1);
    rows = std::max(rows, sprite.row + 1);
  }
  const std::string found = std::to_string(columns) + " × " + std::to_string(rows);
  Question question;
  question.title = "One drawing, or " + std::to_string(sprites.size()) + "?";
  question.words = "Figures across × down, as they stand on the sheet:";
  question.asks_path = true;
  question.path = found;
  question.with_path = [&app, name, found, sheet = std::move(sheet),
                        sprites = std::move(sprites)](const std::string& words) {
    const auto [across, down] = columns_and_rows(words);
    const bool as_found = words == found;
    const std::vector<Sprite> cells =
        as_found ? sprites : sprites_by_grid(sheet.width, sheet.height, across, down);
    constexpr std::size_t kMost = 256;
    if (cells.empty() || cells.size() > kMost)
      return complain(app, bad_input("'" + words + "' is no number of figures: say 4 × 2"));
    add_sprites(app, sheet, name, cells);
  };
  question.answers = {{"Cut it up", {}, true}, {"One drawing", [&app, name, bytes = file.bytes] {
                                                  add_all(app, {{name, bytes}});
                                                }}};
  app.question = std::move(question);
}

}  // namespace

void add_drawing(App& app, const NamedBytes& file) {
  const std::string name = without_ending(file.name);
  Result<std::vector<Image>> images = decode_images(file.bytes, file.name);
  if (!images) return complain(app, images.error());
  if (is_gif(file.bytes)) {
    std::vector<Arrived> all;
    for (const Image& image : *images)
      all.push_back({images->size() > 1 ? name + " " + std::to_string(all.size() + 1) : name,
                     png_bytes(image)});
    return add_all(app, all);
  }
  Image& sheet = images->front();
  std::vector<Sprite> sprites = sprites_by_gaps(segmented(sheet));
  if (sprites.size() > 1) return ask_how_to_cut(app, file, std::move(sheet), std::move(sprites));
  add_all(app, {{name, file.bytes}});
}

void begin_with_template(App& app, Template kind) {
  const int frame = app.session.selection.frame;
  Document next = app.document();
  if (app.has_frame()) {
    next = with_template(std::move(next), kind, frame, figure_in(app, app.frame()));
    for (int f = 0; f < int(next.frames.size()); ++f) {
      Frame& other = next.frames[std::size_t(f)];
      const std::optional<Box2> figure = f == frame ? std::nullopt : figure_in(app, other);
      if (figure) other.pose = pose_over(next, other, other.pose, *figure);
    }
  } else {
    next = with_template(std::move(next), kind, frame, std::nullopt);
  }
  for (const TemplateWords& words : all_templates())
    if (words.kind == kind) {
      app.session.commit(std::string(words.name) + " skeleton", std::move(next));
      break;
    }
  app.session.selection.joint = kind == Template::blank ? 0 : -1;
}

}  // namespace artisketch
