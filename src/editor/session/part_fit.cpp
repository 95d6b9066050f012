#include "editor/session/part_fit.h"

#include "document/edit.h"

namespace artisketch {

double distance_in(const std::vector<FrameFit>& fits, int joint, int frame) {
  if (frame >= int(fits.size())) return -1;
  for (const FrameFit::PartFit& fit : fits[std::size_t(frame)].parts)
    if (fit.joint == joint) return fit.distance;
  return -1;
}

double distance_of(const App& app, int joint, int frame) {
  const bool measured = app.session.built && !app.session.built->fits.empty();
  if (measured && (app.view.mode == Mode::result || app.session.as_built()))
    return distance_in(app.session.built->fits, joint, frame);
  // Until the parts are there at the model's poses, those at the person's tell of something else.
  const bool other =
      app.session.as_built() && (!app.session.live.at_built_poses ||
                                 app.session.live.revision != app.session.history.revision());
  return app.session.live.model && !other ? distance_in(app.session.live.fits, joint, frame) : -1;
}

namespace {

// Found once for each state of the document.
bool is_inside(const App& app, int joint, int frame) {
  const std::vector<std::vector<bool>>& inside =
      app.session.insides.of(app.session.history.state(), [&] {
        std::vector<std::vector<bool>> all;
        for (const Frame& each : app.document().frames) {
          std::vector<bool>& of = all.emplace_back();
          for (int j = 0; j < app.document().skeleton.size(); ++j)
            of.push_back(inside_other_parts(each, j));
        }
        return all;
      });
  return inside[std::size_t(frame)][std::size_t(joint)];
}

}  // namespace

Fit fit_of(const App& app, int joint, int frame) {
  const Frame& drawing = app.document().frames[std::size_t(frame)];
  // A thing is held in one drawing and gone in the next: nobody misses it.
  const bool thing = role_of(app.document(), joint) != Role::body;
  if (is_hidden(drawing, joint) || (thing && contours_of(drawing, joint).empty()))
    return Fit::hidden;
  for (const Contour& contour : drawing.contours)
    if (contour.joint == joint)
      return is_inside(app, joint, frame)            ? Fit::inside
             : distance_of(app, joint, frame) > kOff ? Fit::off
                                                     : Fit::outlined;
  return Fit::missing;
}

PartCount count_parts(const App& app, int frame) {
  PartCount count;
  for (const int joint : parts_to_draw(app.document())) {
    const Fit fit = fit_of(app, joint, frame);
    if (fit == Fit::hidden) continue;
    ++count.all;
    count.outlined += fit != Fit::missing;
    count.off += fit == Fit::off;
  }
  return count;
}

std::string fit_in_words(const App& app, int joint, int frame) {
  const std::string name = drawing_words(app.document(), frame);
  switch (fit_of(app, joint, frame)) {
    case Fit::missing:
      return "Missing in " + name;
    case Fit::hidden:
      return "Hidden in " + name;
    case Fit::inside:
      return "Inside other parts: no edge to compare";
    case Fit::off:
      return std::to_string(int(distance_of(app, joint, frame) + 0.5)) + " px off in " + name;
    case Fit::outlined:
      return "Outlined in " + name;
  }
  return "";
}

std::string trust_in_words(const App& app, int joint) {
  const bool known = app.session.built && !app.session.built->fits.empty() &&
                     (app.view.mode == Mode::result || app.session.as_built());
  if (!known) return "";
  const UnseenSides& sides = app.session.built->unseen_sides;
  const auto words = [](Trust trust) {
    return std::string("From sides not drawn: ") +
           (trust == Trust::guess ? "a guess" : trust_word(trust));
  };
  if (joint < 0) return words(sides.whole);
  for (const PartTrust& part : sides.parts)
    if (part.joint == joint) return words(part.trust);
  return "";
}

}  // namespace artisketch
