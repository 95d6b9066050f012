#include "editor/ui/words.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <tuple>
#include <utility>

namespace artisketch {
namespace {

// A sentence taken apart: pieces[0] slots[0] pieces[1] … pieces.back().
struct Sentence {
  struct Slot {
    char kind = ' ', digit = '0';  // kind: '#' a number, '+' words, else as it is
    bool operator==(const Slot&) const = default;
    bool operator<(const Slot& other) const {
      return std::tie(digit, kind) < std::tie(other.digit, other.kind);
    }
  };
  std::vector<std::string> pieces{""};
  std::vector<Slot> slots;
};

Sentence taken_apart(const std::string& text) {
  Sentence result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::size_t end = text[at] == '{' ? text.find('}', at) : text.npos;
    const std::size_t inside = end == text.npos ? 0 : end - at - 1;
    if ((inside != 1 && inside != 2) || !std::isdigit(static_cast<unsigned char>(text[end - 1]))) {
      result.pieces.back() += text[at];
      continue;
    }
    result.slots.push_back({inside == 2 ? text[at + 1] : ' ', text[end - 1]});
    result.pieces.emplace_back();
    at = end;
  }
  return result;
}

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

bool fits(const Sentence::Slot& slot, const std::string& filling) {
  return !filling.empty() &&
         (slot.kind != '#' || std::none_of(filling.begin(), filling.end(), is_letter));
}

// Fills the slots from the i-th on with the text from `at` on, each with as little as fits.
bool fill(const Sentence& sentence, std::size_t i, const std::string& text, std::size_t at,
          std::vector<std::string>& found) {
  if (i == sentence.slots.size()) return at == text.size();
  const std::string& next = sentence.pieces[i + 1];
  const bool last = i + 1 == sentence.slots.size();
  for (std::size_t end = last ? text.size() - std::min(text.size(), next.size()) : at + 1;
       (end = text.find(next, end)) != text.npos; ++end) {
    if (end < at) return false;
    found.push_back(text.substr(at, end - at));
    if (fits(sentence.slots[i], found.back()) &&
        fill(sentence, i + 1, text, end + next.size(), found))
      return true;
    found.pop_back();
  }
  return false;
}

// What stands in the sentence's slots, where the text is such a sentence; else nothing.
std::vector<std::string> fillings(const Sentence& sentence, const std::string& text) {
  std::vector<std::string> found;
  const std::string& first = sentence.pieces.front();
  if (text.starts_with(first) && text.ends_with(sentence.pieces.back()))
    fill(sentence, 0, text, first.size(), found);
  return found;
}

std::size_t own_letters(const std::string& english) {
  std::size_t count = 0;
  for (const std::string& piece : taken_apart(english).pieces) count += piece.size();
  return count;
}

// Something that a translator could say otherwise.
bool has_words(const std::string& text) {
  return std::adjacent_find(text.begin(), text.end(), [](char a, char b) {
           return is_letter(a) && is_letter(b);
         }) != text.end();
}

std::vector<Sentence::Slot> sorted_slots(const std::string& text) {
  std::vector<Sentence::Slot> slots = taken_apart(text).slots;
  std::sort(slots.begin(), slots.end());
  return slots;
}

std::string with_line_breaks(std::string text) {
  for (std::size_t at; (at = text.find("\\n")) != text.npos;) text.replace(at, 2, "\n");
  return text;
}

}  // namespace

std::string language_code(const std::string& tag) {
  for (const Language& language : kLanguages) {
    const std::string code = language.code;
    if (tag.starts_with(code) && (tag.size() == code.size() || !is_letter(tag[code.size()])))
      return code;
  }
  return "en";
}

Result<WordTable> WordTable::parse(const std::string& text) {
  WordTable table;
  std::vector<std::string> lines;
  const auto entry = [&]() -> std::string {
    if (lines.empty()) return "";
    if (lines.size() != 2) return "'" + lines[0] + "' has no line that stands for it alone";
    if (sorted_slots(lines[0]) != sorted_slots(lines[1]))
      return "'" + lines[0] + "' and what stands for it have different {…}";
    table.entries_.push_back({with_line_breaks(lines[0]), with_line_breaks(lines[1])});
    lines.clear();
    return "";
  };
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string line = text.substr(at, end - at);
    if (line.ends_with('\r')) line.pop_back();
    at = end + 1;
    if (line.starts_with('#')) continue;
    if (!line.empty()) lines.push_back(std::move(line));
    const bool ends = lines.empty() || at > text.size() || text[at] == '\n' || text[at] == '\r';
    if (const std::string fault = ends ? entry() : ""; !fault.empty()) return bad_input(fault);
  }
  std::sort(table.entries_.begin(), table.entries_.end(),
            [](const Entry& a, const Entry& b) { return a.english < b.english; });
  for (std::size_t i = 0; i < table.entries_.size(); ++i) {
    if (i > 0 && table.entries_[i].english == table.entries_[i - 1].english)
      return bad_input("'" + table.entries_[i].english + "' stands there twice");
    if (!taken_apart(table.entries_[i].english).slots.empty()) table.sentences_.push_back(int(i));
  }
  // Among equals those that begin with {…} come first: "Pose tool" is a tool, and nobody's pose.
  std::reverse(table.sentences_.begin(), table.sentences_.end());
  const auto letters = [&](int i) { return own_letters(table.entries_[std::size_t(i)].english); };
  std::stable_sort(table.sentences_.begin(), table.sentences_.end(),
                   [&](int a, int b) { return letters(a) > letters(b); });
  return table;
}

const WordTable::Entry* WordTable::whole(const std::string& english) const {
  const auto found =
      std::lower_bound(entries_.begin(), entries_.end(), english,
                       [](const Entry& entry, const std::string& e) { return entry.english < e; });
  return found != entries_.end() && found->english == english ? &*found : nullptr;
}

std::string WordTable::translated(const std::string& english,
                                  std::vector<std::string>& missing) const {
  if (const Entry* entry = whole(english)) return entry->words;
  for (const int row : sentences_) {
    const Entry& entry = entries_[std::size_t(row)];
    const Sentence sentence = taken_apart(entry.english);
    const std::vector<std::string> found = fillings(sentence, english);
    if (found.empty()) continue;
    const Sentence theirs = taken_apart(entry.words);
    std::string words = theirs.pieces[0];
    for (std::size_t i = 0; i < theirs.slots.size(); ++i) {
      const auto slot =
          std::size_t(std::find(sentence.slots.begin(), sentence.slots.end(), theirs.slots[i]) -
                      sentence.slots.begin());
      words += theirs.slots[i].kind == '+' ? translated(found[slot], missing) : found[slot];
      words += theirs.pieces[i + 1];
    }
    return words;
  }
  if (has_words(english)) missing.push_back(english);
  return english;
}

// ---------------------------------------------------------------- the language chosen

namespace {

struct Chosen {
  WordTable table;
  std::map<std::string, std::string> known;  // frames say the same again and again
  std::vector<std::string> missing;
};

Chosen& chosen() {
  static Chosen words;
  return words;
}

}  // namespace

void use_words(WordTable table) {
  chosen() = {std::move(table), {}, {}};
}

std::string tr(const std::string& english) {
  Chosen& words = chosen();
  if (words.table.entries().empty()) return english;
  const auto found = words.known.find(english);
  if (found != words.known.end()) return found->second;
  constexpr std::size_t kMost = 4096;  // numbers change, and with them what is said
  if (words.known.size() >= kMost) words.known.clear(), words.missing.clear();
  return words.known[english] = words.table.translated(english, words.missing);
}

const std::vector<std::string>& words_missing() {
  return chosen().missing;
}

}  // namespace artisketch
