#include "browser.h"

#include <utility>

#include <emscripten.h>

// clang-format off
EM_JS(void, host_open, (int question, bool document), { Module.host.open(question, document); });
EM_JS(void, host_save, (int question, const char* name, const char* place, const char* bytes,
                        std::size_t size), {
  Module.host.save(question, UTF8ToString(name), UTF8ToString(place),
                   HEAPU8.slice(bytes, bytes + size));
});
EM_JS(void, host_open_recent, (int question, const char* place), {
  Module.host.openRecent(question, UTF8ToString(place));
});
EM_JS(void, host_store, (const char* key, const char* bytes, std::size_t size), {
  Module.host.store(UTF8ToString(key), HEAPU8.slice(bytes, bytes + size));
});
EM_JS(void, host_load, (int question, const char* key), {
  Module.host.load(question, UTF8ToString(key));
});
EM_JS(void, host_load_example, (int question, const char* name), {
  Module.host.loadExample(question, UTF8ToString(name));
});
EM_JS(void, host_load_example_picture, (int question, const char* name), {
  Module.host.loadExamplePicture(question, UTF8ToString(name));
});
EM_JS(void, host_load_words, (int question, const char* code), {
  Module.host.loadWords(question, UTF8ToString(code));
});
EM_JS(void, host_title, (const char* title, bool unsaved), {
  Module.host.title(UTF8ToString(title), unsaved);
});
EM_JS(bool, host_has_guide, (), { return Module.host.hasGuide(); });
EM_JS(void, host_show_guide, (), { Module.host.showGuide(); });
EM_JS(bool, host_prefers_dark, (), { return Module.host.prefersDark(); });
EM_JS(void, host_wake, (), { Module.host.wake(); });
EM_JS(bool, host_mac_keys, (), { return Module.host.macKeys(); });
// clang-format on

namespace artisketch {
namespace {

// Takes the question's `then` out of those that wait, and calls it.
template <class Waiting, class Answer>
void answer(Waiting& waiting, int question, Answer&& with) {
  const auto found = waiting.find(question);
  if (found == waiting.end()) return;
  const auto then = std::move(found->second);
  waiting.erase(found);
  then(std::forward<Answer>(with));
  host_wake();
}

}  // namespace

void Browser::open_files(Kind kind, Opened then) {
  opening_[++questions_] = std::move(then);
  host_open(questions_, kind == Kind::document);
}

void Browser::save_file(const std::string& name, const std::string& place, std::string bytes,
                        std::function<void(Result<Saved>)> then) {
  saving_[++questions_] = std::move(then);
  host_save(questions_, name.c_str(), place.c_str(), bytes.data(), bytes.size());
}

void Browser::open_recent(const std::string& place, Opened then) {
  opening_[++questions_] = std::move(then);
  host_open_recent(questions_, place.c_str());
}

void Browser::store(const std::string& key, std::string bytes) {
  host_store(key.c_str(), bytes.data(), bytes.size());
}

void Browser::load(const std::string& key, std::function<void(std::string)> then) {
  loading_[++questions_] = std::move(then);
  host_load(questions_, key.c_str());
}

void Browser::load_example(const std::string& name, std::function<void(Result<Example>)> then) {
  fetching_[++questions_] = std::move(then);
  host_load_example(questions_, name.c_str());
}

void Browser::load_example_picture(const std::string& name, std::function<void(std::string)> then) {
  loading_[++questions_] = std::move(then);
  host_load_example_picture(questions_, name.c_str());
}

void Browser::load_words(const std::string& code, std::function<void(std::string)> then) {
  loading_[++questions_] = std::move(then);
  host_load_words(questions_, code.c_str());
}

bool Browser::has_guide() {
  return host_has_guide();
}

void Browser::show_guide() {
  host_show_guide();
}

void Browser::set_title(const std::string& title, bool unsaved) {
  if (title == title_ && unsaved == unsaved_) return;
  title_ = title;
  unsaved_ = unsaved;
  host_title(title.c_str(), unsaved);
}

bool Browser::prefers_dark() {
  return host_prefers_dark();
}

void Browser::request_frame() {
  host_wake();
}

bool Browser::mac_keys() {
  return host_mac_keys();
}

void Browser::opened(int question, Result<std::vector<NamedBytes>> files) {
  answer(opening_, question, std::move(files));
}

void Browser::saved(int question, Result<Saved> where) {
  answer(saving_, question, std::move(where));
}

void Browser::loaded(int question, std::string bytes) {
  answer(loading_, question, std::move(bytes));
}

void Browser::example_loaded(int question, Result<Example> example) {
  answer(fetching_, question, std::move(example));
}

}  // namespace artisketch
