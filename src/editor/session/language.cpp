#include "editor/session/language.h"

#include "editor/ui/words.h"

namespace artisketch {
namespace {

const Language& language_of(const std::string& code) {
  for (const Language& language : kLanguages)
    if (language.code == code) return language;
  return kLanguages[0];
}

void speak(App& app, const Language& language) {
  app.view.language = language.code;
  if (&language == &kLanguages[0]) return use_words({});
  app.services.platform.load_words(language.code, [&app, &language](const std::string& text) {
    if (app.view.language != language.code) return;  // another one was chosen meanwhile
    Result<WordTable> table = WordTable::parse(text);
    if (table && !table->entries().empty()) return use_words(std::move(*table));
    app.view.language = kLanguages[0].code;
    use_words({});
    Toast toast;
    toast.words = std::string("The words of ") + language.name + " could not be loaded";
    toast.error = true;
    app.say(std::move(toast));
  });
}

}  // namespace

void recall_language(App& app) {
  use_words({});
  app.services.platform.load("language", [&app](const std::string& kept) {
    speak(app, language_of(kept.empty() ? language_code(app.services.platform.language()) : kept));
  });
}

void choose_language(App& app, const std::string& code) {
  app.services.platform.store("language", code);
  speak(app, language_of(code));
}

}  // namespace artisketch
