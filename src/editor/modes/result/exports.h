// The model out, as a file.
#pragma once

#include <span>
#include <string>

#include "editor/session/app.h"

namespace artisketch {

struct ExportFormat {
  const char* name;
  const char* about;
  const char* icon;
  const char* ending;
  Result<std::string> (*bytes)(const App& app);  // null: a job makes them
};
std::span<const ExportFormat> export_formats();
std::string export_name(const App& app, const ExportFormat& format);
SpriteOptions sprite_wish(const App& app);  // of the clip chosen in the timeline
// Of a GLB's joints (ExportChoice::rig): none, the surface alone in the pose that is shown.
std::size_t without_skeleton();
void export_model(App& app);  // in the format that was chosen

}  // namespace artisketch
