#include "editor/session/notes.h"

#include "model/calibrate/drawn_size.h"

namespace artisketch {

std::vector<PlacedWords> notes_of(const App& app) {
  std::vector<PlacedWords> notes;
  const auto add = [&](const Document& document, const std::vector<std::string>& warnings) {
    for (const std::string& words : warnings) {
      PlacedWords note = placed_words(document, words);
      // The document may have been changed since.
      if (note.frame >= int(app.document().frames.size())) note.frame = -1;
      if (note.joint >= app.document().skeleton.size()) note.joint = -1;
      notes.push_back(std::move(note));
    }
  };
  if (app.session.proposal)
    add(app.session.proposal->document, app.session.proposal->warnings);
  else if (app.session.built)
    add(app.session.built->document, app.session.built->warnings);
  return notes;
}

std::vector<ScaleOffer> scale_offers(const App& app) {
  const Document& document = app.document();
  const std::vector<double>& scales = app.session.offered_scales.of(
      app.session.history.state(), [&] { return offered_scales(document); });
  std::vector<ScaleOffer> offers;
  for (int f = 0; f < int(document.frames.size()); ++f)
    if (scales[std::size_t(f)] != document.frames[std::size_t(f)].scale)
      offers.push_back({f, scales[std::size_t(f)]});
  return offers;
}

}  // namespace artisketch
