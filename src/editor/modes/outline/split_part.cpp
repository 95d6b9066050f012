#include "editor/modes/outline/split_part.h"

#include <algorithm>

#include "document/split.h"
#include "editor/canvas/pointer.h"
#include "editor/session/notes.h"

namespace artisketch {
namespace {

void split(App& app, int joint, std::optional<double> along) {
  const std::string words = part_words(app, joint);
  const std::string name = app.document().skeleton.joints[std::size_t(joint)].name;
  std::optional<Document> next = with_part_split(app.document(), joint, along);
  if (!next) {
    Toast toast;
    toast.words = words + " has no middle to split it in: its outlines are too short.";
    return app.say(std::move(toast));
  }
  app.session.new_outline.reset();
  app.session.commit("Split " + words, std::move(*next));
  Selection& selection = app.session.selection;
  const int near = app.document().skeleton.find(name);
  selection.joint = app.document().skeleton.children(near).front();
  const std::vector<Contour>& contours = app.frame().contours;
  const auto found = std::find_if(contours.begin(), contours.end(), [&](const Contour& contour) {
    return contour.joint == selection.joint;
  });
  selection.contour = found == contours.end() ? -1 : int(found - contours.begin());
}

}  // namespace

bool can_split_chosen(const App& app) {
  return app.has_frame() && !app.session.new_outline &&
         can_split(app.document(), app.session.selection.joint);
}

void split_chosen(App& app) {
  const int joint = app.session.selection.joint;
  const std::optional<Fold> fold = fold_of(app.document(), joint);
  const std::optional<Vec2>& place = app.session.menu_over;
  std::optional<double> along;
  if (place && fold && fold->angle < kFold)
    along = along_part(app.document(), app.session.selection.frame, joint, *place);
  split(app, joint, along);
}

void split_part(App& app, int joint) {
  split(app, joint, std::nullopt);
}

std::vector<int> split_offers(const App& app) {
  std::vector<int> noted;
  for (const PlacedWords& note : notes_of(app))
    if (can_split(app.document(), note.joint)) noted.push_back(note.joint);
  std::sort(noted.begin(), noted.end());
  noted.erase(std::unique(noted.begin(), noted.end()), noted.end());
  return app.session.offered_splits.of(app.session.history.state(), noted, [&] {
    std::vector<int> offered;
    for (const int joint : noted)
      if (const std::optional<Fold> fold = fold_of(app.document(), joint);
          fold && fold->angle >= kFold)
        offered.push_back(joint);
    return offered;
  });
}

}  // namespace artisketch
