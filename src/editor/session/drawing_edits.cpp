#include "editor/session/drawing_edits.h"

#include <algorithm>
#include <cmath>

#include "document/drawing_edit.h"
#include "document/edit.h"
#include "editor/session/files.h"
#include "files/canvas.h"
#include "files/image_file.h"

namespace artisketch {
namespace {

// One step of undo: the document as it is to be, with the frame's picture changed along.
template <class Change>
void commit_picture(App& app, int f, const char* undo_name, Document next, const Change& change) {
  Frame& frame = next.frames[std::size_t(f)];
  if (const Drawing* drawing = app.services.drawings.of(app.document().frames[std::size_t(f)])) {
    Result<std::string> key =
        app.services.drawings.add(png_bytes(change(drawing->image)), frame.name);
    if (!key) return complain(app, key.error());
    frame.image = *key;
  }
  app.session.commit(undo_name, std::move(next));
  app.view.fit_again();
}

// The frame with another picture for what it shows; fails where that has another shape.
Result<Document> with_picture(App& app, int f, const NamedBytes& file) {
  Result<Image> picture = decode_image(file.bytes, file.name);
  if (!picture) return picture.error();
  Document next = app.document();
  const Frame& frame = next.frames[std::size_t(f)];
  constexpr double kAlike = 0.01;  // proportions: scans are cut to whole pixels
  const double wider =
      double(picture->width) * frame.height / (double(picture->height) * frame.width);
  if (!(std::abs(wider - 1) <= kAlike))
    return bad_input(file.name + ": has " + size_words(picture->width, picture->height) +
                     " pixels, and the drawing " + size_words(frame.width, frame.height) +
                     ", another shape: its outlines would not fit. Add it as a drawing of its own");
  const bool same = picture->width == frame.width && picture->height == frame.height;
  std::string bytes = file.bytes;
  if (!same && next.camera.type == Camera::Type::orthographic)
    next = with_drawing_resized(std::move(next), f, picture->width, picture->height);
  else if (!same)
    bytes = png_bytes(resized(*picture, frame.width, frame.height));
  Result<std::string> key = app.services.drawings.add(std::move(bytes), file.name);
  if (!key) return key.error();
  next.frames[std::size_t(f)].image = *key;
  return next;
}

}  // namespace

void turn_drawing(App& app, int frame, int quarters) {
  commit_picture(app, frame, "Turn drawing", with_drawing_turned(app.document(), frame, quarters),
                 [&](const Image& picture) { return turned(picture, quarters); });
}

void flip_drawing(App& app, int frame) {
  commit_picture(app, frame, "Flip drawing", with_drawing_flipped(app.document(), frame), flipped);
}

void crop_drawing(App& app, int f) {
  constexpr double kRoom = 0.06;  // of the figure's larger side, all round
  constexpr double kWorth = 0.9;  // of the area: more than that left is no crop
  const Frame& frame = app.document().frames[std::size_t(f)];
  Box2 figure = figure_in(app, frame).value_or(Box2());
  for (const Contour& contour : frame.contours)
    for (const Vec2& p : contour.line.points) figure.extend(p);
  Box2 box;
  if (!figure.isEmpty()) {
    const Vec2 room = Vec2::Constant(kRoom * figure.sizes().maxCoeff());
    box = Box2(Vec2((figure.min() - room).array().floor()),
               Vec2((figure.max() + room).array().ceil()))
              .intersection(Box2(Vec2::Zero(), Vec2(frame.width, frame.height)));
  }
  const Vec2 size = box.isEmpty() ? Vec2(Vec2::Zero()) : Vec2(box.sizes());
  if (size.minCoeff() < 1 || size.prod() > kWorth * frame.width * frame.height) {
    Toast toast;
    toast.words = "Nothing to cut away: the figure fills its drawing.";
    return app.say(std::move(toast));
  }
  const PixelBox kept{int(box.min().x()), int(box.min().y()), int(size.x()), int(size.y())};
  commit_picture(app, f, "Crop drawing", with_drawing_cropped(app.document(), f, kept),
                 [&](const Image& picture) { return cropped(picture, kept); });
}

void crop_by_hand(App& app, int f) {
  const Frame& frame = app.document().frames[std::size_t(f)];
  Picking picking;
  picking.one = true;
  picking.title = "Crop " + drawing_words(app.document(), f);
  picking.words = "Drag a box round what stays. Outlines stay, too.";
  picking.action = "Crop";
  picking.picture = frame.image;
  picking.width = frame.width;
  picking.height = frame.height;
  const long session = app.session.id();
  picking.with = [&app, f, session, key = frame.image](const std::vector<Sprite>& taken) {
    const std::vector<Frame>& frames = app.document().frames;
    if (app.session.id() != session || f >= int(frames.size()) ||
        frames[std::size_t(f)].image != key || taken.empty())
      return;
    const PixelBox kept = taken[0].own;
    commit_picture(app, f, "Crop drawing", with_drawing_cropped(app.document(), f, kept),
                   [&](const Image& picture) { return cropped(picture, kept); });
  };
  app.picking.push_back(std::move(picking));
}

void replace_picture(App& app, int f) {
  const long session = app.session.id();
  const auto then = [&app, f, session](Result<std::vector<NamedBytes>> files) {
    if (!files) return complain(app, files.error());
    // Another document may have been opened while one looked for it.
    if (files->empty() || app.session.id() != session || f >= int(app.document().frames.size()))
      return;
    Result<Document> next = with_picture(app, f, files->front());
    if (!next) return complain(app, next.error());
    app.session.commit("Replace picture", std::move(*next));
    app.view.fit_again();
  };
  if (app.services.platform.has_dialogs())
    return app.services.platform.open_files(Platform::Kind::drawings, then);
  Question question;
  question.title = "Replace picture";
  question.words = "The path of a picture (PNG or JPEG):";
  question.asks_path = true;
  question.with_path = [&app, then](const std::string& path) {
    app.services.platform.open_recent(path, then);
  };
  question.answers = {{"Replace", {}, true}, {"Cancel", {}}};
  app.question = std::move(question);
}

}  // namespace artisketch
