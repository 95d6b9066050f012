// Drawings and skeletons on their way into the document.
#include <algorithm>

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
  for (const Sprite& sprite : sprites)
    all.push_back({name + " " + cell_words(sprite, sprites), png_bytes(cut_out(sheet, sprite))});
  add_all(app, all);
}

// "4 × 2"
std::string grid_words(const std::vector<Sprite>& sprites) {
  int columns = 0, rows = 0;
  for (const Sprite& sprite : sprites) {
    columns = std::max(columns, sprite.column + 1);
    rows = std::max(rows, sprite.row + 1);
  }
  return std::to_string(columns) + " × " + std::to_string(rows);
}

// The figures of a picture that the drawings hold, to be picked.
Picking figures_on(const std::string& key, const Image& sheet, const std::vector<Sprite>& sprites) {
  Picking picking;
  picking.picture = key;
  picking.width = sheet.width;
  picking.height = sheet.height;
  picking.words = "Click a figure to leave it out; drag a box round one that is missing.";
  for (const Sprite& sprite : sprites) picking.boxes.push_back({sprite});
  picking.grid = picking.as_found = sprites.empty() ? "" : grid_words(sprites);
  return picking;
}

void ask_how_to_cut(App& app, const NamedBytes& file, Image sheet, std::vector<Sprite> sprites) {
  const std::string name = without_ending(file.name);
  const Result<std::string> key = app.services.drawings.add(file.bytes, file.name);
  if (!key) return complain(app, key.error());
  Picking picking = figures_on(*key, sheet, sprites);
  picking.title = "One drawing, or " + std::to_string(sprites.size()) + "?";
  picking.with = [&app, name, sheet = std::move(sheet)](const std::vector<Sprite>& taken) {
    add_sprites(app, sheet, name, taken);
  };
  picking.whole = [&app, name, bytes = file.bytes] { add_all(app, {{name, bytes}}); };
  app.picking.push_back(std::move(picking));
}

// In place of the drawing that they are pieces of, or after all others where that has outlines of
// its own.
void add_pieces(App& app, int f, const std::vector<Sprite>& pieces) {
  const Frame sheet = app.document().frames[std::size_t(f)];
  const Image picture = app.services.drawings.of(sheet)->image;
  const bool stays = !sheet.contours.empty();
  Document next = app.document();
  if (!stays) next = without_frame(std::move(next), f);
  const int first = int(next.frames.size());
  const std::string name = drawing_words(app.document(), f);
  for (const Sprite& piece : pieces) {
    Result<Document> with = with_drawing(
        app, next, {name + " " + cell_words(piece, pieces), png_bytes(cut_out(picture, piece))});
    if (!with) return complain(app, with.error());
    next = std::move(*with);
  }
  app.session.commit("Cut up " + name, std::move(next));
  app.session.show_frame(first);
  app.view.fit_again();
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

void cut_up_drawing(App& app, int f) {
  const Frame& frame = app.document().frames[std::size_t(f)];
  const Drawing* drawing = app.services.drawings.of(frame);
  if (!drawing) return;
  Picking picking =
      figures_on(frame.image, drawing->image, sprites_by_gaps(segmented(drawing->image)));
  picking.title = "Cut up " + drawing_words(app.document(), f);
  const long session = app.session.id();
  picking.with = [&app, f, session, key = frame.image](const std::vector<Sprite>& taken) {
    const std::vector<Frame>& frames = app.document().frames;
    if (app.session.id() != session || f >= int(frames.size()) ||
        frames[std::size_t(f)].image != key)
      return;
    add_pieces(app, f, taken);
  };
  app.picking.push_back(std::move(picking));
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
