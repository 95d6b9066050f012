#include "editor/session/notes.h"

#include "model/calibrate/drawn_size.h"

namespace artisketch {

namespace {

// What there is to read, and the document that it names places of; nothing: null.
struct Noticed {
  const Document* document = nullptr;
  const std::vector<std::string>* warnings = nullptr;
};
Noticed noticed(const App& app) {
  if (const auto& proposal = app.session.proposal)
    return {&proposal->document, &proposal->warnings};
  if (const auto& built = app.session.built) return {&built->document, &built->warnings};
  return {};
}

}  // namespace

int count_notes(const App& app) {
  const Noticed all = noticed(app);
  return all.warnings ? int(all.warnings->size()) : 0;
}

std::vector<PlacedWords> notes_of(const App& app) {
  std::vector<PlacedWords> notes;
  const Noticed all = noticed(app);
  if (!all.warnings) return notes;
  for (const std::string& words : *all.warnings) {
    PlacedWords note = placed_words(*all.document, words);
    // The document may have been changed since.
    if (note.frame >= int(app.document().frames.size())) note.frame = -1;
    if (note.joint >= 0)
      note.joint =
          app.document().skeleton.find(all.document->skeleton.joints[std::size_t(note.joint)].name);
    notes.push_back(std::move(note));
  }
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
