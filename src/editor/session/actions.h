// What commands do: files, jobs, edits.
#pragma once

#include <span>

#include "document/templates.h"
#include "editor/session/work.h"

namespace artisketch {

void perform(Work& work, Command command);

// ---------------------------------------------------------------- files

void complain(Work& work, const Error& error);  // in a toast
void open_files(Work& work, Result<std::vector<NamedBytes>> files);
void open_document(Work& work, const NamedBytes& file);
void open_example(Work& work, const std::string& name, bool greet);
void new_document(Work& work);
// A drawing at the end of the strip, a GIF's all; a sheet of several asks how to cut it.
void add_drawing(Work& work, const NamedBytes& file);
// Another skeleton, fitted to the drawing in view.
void begin_with_template(Work& work, Template kind);
void save(Work& work, bool ask_where, std::function<void()> then = {});
// Where the platform has no dialogs: a path to type, for a document or a drawing.
void ask_for_path(Work& work, const std::string& title, const std::string& words);
// Runs `then` at once where nothing would be lost, else asks first.
void unless_unsaved(Work& work, std::function<void()> then);
void autosave(Work& work);        // once in a while
void offer_recovery(Work& work);  // at the start

struct ExportFormat {
  const char* name;
  const char* about;
  const char* icon;
  const char* ending;
  Result<std::string> (*bytes)(const Work& work);
};
std::span<const ExportFormat> export_formats();
std::string export_name(const Work& work, const ExportFormat& format);
void export_model(Work& work, const ExportFormat& format);

// ---------------------------------------------------------------- jobs

void start_job(Work& work, JobRequest::Kind kind);
void collect_job(Work& work);  // takes what a job brought, each frame
void show_built(Work& work, Built built);

}  // namespace artisketch
