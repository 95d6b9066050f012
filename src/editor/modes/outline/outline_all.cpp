#include "editor/modes/outline/outline_all.h"

#include <algorithm>

#include "document/edit.h"
#include "document/figure_parts.h"
#include "editor/canvas/pointer.h"

namespace artisketch {
namespace {

bool lacks_outlines(const App& app) {
  const std::vector<int> parts = parts_to_draw(app.document());
  return std::any_of(parts.begin(), parts.end(), [&](int joint) {
    return role_of(app.document(), joint) == Role::body && !is_hidden(app.frame(), joint) &&
           contours_of(app.frame(), joint).empty();
  });
}

std::string words_of(const App& app, const FigureParts& found) {
  const std::size_t count = found.outlined.size();
  std::string words = count == 0   ? "No part is outlined."
                      : count == 1 ? "1 part is outlined."
                                   : std::to_string(count) + " parts are outlined.";
  if (!found.had_outline.empty()) words += " Outlines that were there stay.";
  if (!found.behind.empty()) words += " Behind others: " + parts_listed(app, found.behind) + ".";
  if (!found.off_figure.empty())
    words += " Bones beside the figure: " + parts_listed(app, found.off_figure) + ".";
  return words;
}

}  // namespace

bool can_outline_all(const App& app) {
  return app.has_frame() && app.services.drawings.of(app.frame()) && lacks_outlines(app);
}

std::string why_not_outline_all(const App& app) {
  if (!app.has_frame()) return "";
  return app.services.drawings.of(app.frame())
             ? "Every part has its outline here."
             : "There is no picture to trace here. Draw around the part: D.";
}

void outline_all(App& app) {
  app.session.keep_new_outline();
  const int frame = app.session.selection.frame;
  FigureParts found = with_figure_parts(app.document(), frame,
                                        segmented(app.services.drawings.of(app.frame())->image));
  Toast toast;
  toast.words = words_of(app, found);
  const std::size_t count = found.outlined.size();
  if (count > 0) {
    const std::string parts = count == 1 ? "1 part" : std::to_string(count) + " parts";
    app.session.commit("Outline " + parts, std::move(found.document));
    app.session.selection.contour = -1;
  }
  app.say(std::move(toast));
}

}  // namespace artisketch
