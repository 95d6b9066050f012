// The interface's words in the person's language. The sources say everything in English, whole
// sentences with names and numbers in them; what is shown goes through tr(), which looks them up in
// the table of the language chosen. What a table lacks is shown in English.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace artisketch {

struct Language {
  const char *code, *name;  // "de": assets/languages/de.txt; the name in the language itself
};
inline constexpr Language kLanguages[] = {{"en", "English"}, {"de", "Deutsch"}, {"es", "Español"}};

// The code of the language that a browser or system asks for ("de-AT", "de_DE.UTF-8"); "en" where
// there is no table of it.
std::string language_code(const std::string& tag);

// What stands for English sentences in one language.
//
// Its text has a line of English, the line that stands for it, and an empty line, again and again;
// lines that begin with # are for translators. Of what varies in a sentence, {0} to {9} are shown
// as they are, names above all; {#0} is the same, and matches numbers alone; {+0} are words that
// are looked up in turn:
//
//   Undo {+0}
//   {+0} zurücknehmen
class WordTable {
 public:
  WordTable() = default;  // of no words: all stays English
  // Fails on entries that are not of two lines, or stand there twice, and on translations with
  // other {…} than the English.
  static Result<WordTable> parse(const std::string& text);

  struct Entry {
    std::string english, words;
  };
  const std::vector<Entry>& entries() const { return entries_; }

  // What is listed nowhere stays as it is, and joins `missing`.
  std::string translated(const std::string& english, std::vector<std::string>& missing) const;

 private:
  // A text taken apart: pieces[0] slots[0] pieces[1] … pieces.back().
  struct Pattern {
    struct Slot {
      char kind = ' ', digit = '0';  // kind: '#' a number, '+' words, else as it is
      bool operator==(const Slot&) const = default;
    };
    std::vector<std::string> pieces{""};
    std::vector<Slot> slots;
  };
  struct Sentence {
    Pattern english, words;
  };
  struct Reading;  // of patterns, and of texts by them

  const Entry* whole(const std::string& english) const;

  std::vector<Entry> entries_;       // sorted by their English
  std::vector<Sentence> sentences_;  // entries with {…}, most letters of their own first
};

// The language of the frame that is being drawn.
void use_words(WordTable table);
std::string tr(const std::string& english);
// Of all that was shown in this language: what its table lacks.
const std::vector<std::string>& words_missing();

}  // namespace artisketch
