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

namespace {

// In the document that is open: it may have been changed since.
PlacedWords placed_now(const App& app, const Document& then, const std::string& words) {
  PlacedWords note = placed_words(then, words);
  if (note.frame >= int(app.document().frames.size())) note.frame = -1;
  if (note.joint >= 0)
    note.joint = app.document().skeleton.find(then.skeleton.joints[std::size_t(note.joint)].name);
  return note;
}

// The warning that a drawing shows the figure in another size, by the field that it names: where
// such a drawing agrees with no other, that is why. −1: none.
int warning_of_size(const Noticed& all, int frame) {
  const std::string field = "frames[" + std::to_string(frame) + "].scale";
  for (std::size_t i = 0; i < all.warnings->size(); ++i)
    if ((*all.warnings)[i].find(field) != std::string::npos) return int(i);
  return -1;
}

// For each warning the one that it follows from, or −1.
std::vector<int> causes_of(const Noticed& all) {
  std::vector<int> causes(all.warnings->size(), -1);
  for (int f = 0; f < int(all.document->frames.size()); ++f) {
    const int cause = warning_of_size(all, f);
    if (cause < 0) continue;
    const std::string drawing = frame_words(*all.document, f);
    for (std::size_t i = 0; i < causes.size(); ++i)
      if (int(i) != cause && (*all.warnings)[i].find(drawing) != std::string::npos)
        causes[i] = cause;
  }
  return causes;
}

}  // namespace

std::vector<Note> notes_of(const App& app) {
  std::vector<Note> notes;
  const Noticed all = noticed(app);
  if (!all.warnings) return notes;
  const std::vector<int> causes = causes_of(all);
  for (std::size_t i = 0; i < causes.size(); ++i) {
    if (causes[i] >= 0) continue;
    Note note{placed_now(app, *all.document, (*all.warnings)[i]), {}};
    for (std::size_t k = 0; k < causes.size(); ++k)
      if (causes[k] == int(i))
        note.follow.push_back(placed_now(app, *all.document, (*all.warnings)[k]));
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
