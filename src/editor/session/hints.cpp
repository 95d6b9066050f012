#include "editor/session/hints.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace artisketch {
namespace {

constexpr double kRound = 5;  // seconds
constexpr int kRounds = 3;    // then the window rests

double shown_for(const App& app) {
  return app.services.now - app.view.hints.since;
}

}  // namespace

bool hints_shown(const App& app) {
  return app.view.hints.open && !app.view.welcome && app.has_frame() &&
         app.view.hints.mode == app.view.mode && !app.view.exporting && !app.view.mapping;
}

bool hints_move(const App& app) {
  return hints_shown(app) && shown_for(app) < kRound * kRounds;
}

float hints_time(const App& app) {
  constexpr double kLast = 0.9;  // all is done there
  if (!hints_move(app)) return float(kLast);
  return float(std::fmod(std::max(0.0, shown_for(app)), kRound) / kRound);
}

void close_hints(App& app) {
  Hints& hints = app.view.hints;
  if (!hints.open) return;
  hints.open = false;
  if (std::exchange(hints.seen[std::size_t(hints.mode)], true)) return;
  std::string kept;
  for (int mode = 0; mode < kModes; ++mode)
    if (hints.seen[std::size_t(mode)]) kept += char('1' + mode);
  app.services.platform.store("hints", kept);
}

void recall_hints(App& app) {
  app.services.platform.load("hints", [&app](const std::string& kept) {
    for (int mode = 0; mode < kModes; ++mode)
      app.view.hints.seen[std::size_t(mode)] |= kept.find(char('1' + mode)) != kept.npos;
    app.view.hints.recalled = true;
  });
}

void follow_hints(App& app) {
  Hints& hints = app.view.hints;
  if (app.view.welcome || !app.has_frame()) return;
  if (hints.open && hints.mode != app.view.mode) close_hints(app);
  if (hints.open || !hints.recalled || hints.seen[std::size_t(app.view.mode)]) return;
  hints.open = true;
  hints.mode = app.view.mode;
  hints.since = app.services.now;
}

}  // namespace artisketch
