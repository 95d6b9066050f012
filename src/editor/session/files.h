// Documents and drawings in and out.
#pragma once

#include <functional>
#include <optional>

#include "document/templates.h"
#include "editor/session/app.h"

namespace artisketch {

void complain(App& app, const Error& error);  // in a toast
void open_files(App& app, Result<std::vector<NamedBytes>> files);
void open_document(App& app, const NamedBytes& file);
void open_example(App& app, const std::string& name, bool greet);
void new_document(App& app);
// A drawing at the end of the strip, a GIF's all; a sheet of several asks how to cut it.
void add_drawing(App& app, const NamedBytes& file);
// The figures of a drawing that is a sheet, picked on it, become drawings in its place.
void cut_up_drawing(App& app, int frame);
// Where the figure stands in a frame's drawing, in its pixels; none without one.
std::optional<Box2> figure_in(const App& app, const Frame& frame);
// Another skeleton, fitted to the drawing in view.
void begin_with_template(App& app, Template kind);
void save(App& app, bool ask_where, std::function<void()> then = {});
// Where the platform has no dialogs: a path to type, for a document or a drawing.
void ask_for_path(App& app, const std::string& title, const std::string& words);
// Runs `then` at once where nothing would be lost, else asks first.
void unless_unsaved(App& app, std::function<void()> then);
void autosave(App& app);        // once in a while
void offer_recovery(App& app);  // at the start

}  // namespace artisketch
