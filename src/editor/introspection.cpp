#include "editor/introspection.h"

#include <cmath>

#include "editor/ui/words.h"

namespace artisketch {
namespace {

Json rounded(double value) {
  return std::round(value * 100) / 100;
}

}  // namespace

Json widgets_json(const Editor& editor) {
  Json all = Json::array();
  for (const Widget& w : editor.widgets())
    all.push_back({{"label", w.label},
                   {"words", tr(w.label)},
                   {"x", rounded(w.x)},
                   {"y", rounded(w.y)},
                   {"width", rounded(w.width)},
                   {"height", rounded(w.height)},
                   {"enabled", w.enabled},
                   {"active", w.active}});
  return all;
}

Json state_json(const Editor& editor) {
  const EditorState s = editor.state();
  return {{"mode", s.mode},
          {"busy", s.busy},
          {"stage", s.stage},
          {"progress", s.progress},
          {"frame", s.frame},
          {"frames", s.frames},
          {"joints", s.joints},
          {"hasModel", s.has_model},
          {"liveParts", s.live_parts},
          {"revision", s.revision},
          {"liveRevision", s.live_revision},
          {"canUndo", s.can_undo},
          {"undo", s.undo},
          {"message", tr(s.message)},
          {"unsaved", editor.unsaved()}};
}

}  // namespace artisketch
