#include "editor/ui/words.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <tuple>
#include <utility>

namespace artisketch {
namespace {

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

// Something that a translator could say otherwise.
bool has_words(const std::string& text) {
  return std::adjacent_find(text.begin(), text.end(), [](char a, char b) {
           return is_letter(a) && is_letter(b);
         }) != text.end();
}

std::string with_line_breaks(std::string text) {
  for (std::size_t at; (at = text.find("\\n")) != text.npos;) text.replace(at, 2, "\n");
  return text;
}

}  // namespace

struct WordTable::Reading {
  using Slot = Pattern::Slot;

  static Pattern taken_apart(const std::string& text) {
    Pattern result;
    for (std::size_t at = 0; at < text.size(); ++at) {
      const std::size_t end = text[at] == '{' ? text.find('}', at) : text.npos;
      const std::size_t inside = end == text.npos ? 0 : end - at - 1;
      if ((inside != 1 && inside != 2) ||
          !std::isdigit(static_cast<unsigned char>(text[end - 1]))) {
        result.pieces.back() += text[at];
        continue;
      }
      result.slots.push_back({inside == 2 ? text[at + 1] : ' ', text[end - 1]});
      result.pieces.emplace_back();
      at = end;
    }
    return result;
  }

  static std::vector<Slot> sorted_slots(const std::string& text) {
    std::vector<Slot> slots = taken_apart(text).slots;
    std::sort(slots.begin(), slots.end(), [](const Slot& a, const Slot& b) {
      return std::tie(a.digit, a.kind) < std::tie(b.digit, b.kind);
    });
    return slots;
  }

  static std::size_t own_letters(const Pattern& pattern) {
    std::size_t count = 0;
    for (const std::string& piece : pattern.pieces) count += piece.size();
    return count;
  }

  static bool fits(const Slot& slot, const std::string& filling) {
    return !filling.empty() &&
           (slot.kind != '#' || std::none_of(filling.begin(), filling.end(), is_letter));
  }

  // Fills the slots from the i-th on with the text from `at` on, each with as little as fits.
  static bool fill(const Pattern& pattern, std::size_t i, const std::string& text, std::size_t at,
                   std::vector<std::string>& found) {
    if (i == pattern.slots.size()) return at == text.size();
    const std::string& next = pattern.pieces[i + 1];
    const bool last = i + 1 == pattern.slots.size();
    for (std::size_t end = last ? text.size() - std::min(text.size(), next.size()) : at + 1;
         (end = text.find(next, end)) != text.npos; ++end) {
      if (end < at) return false;
      found.push_back(text.substr(at, end - at));
      if (fits(pattern.slots[i], found.back()) &&
          fill(pattern, i + 1, text, end + next.size(), found))
        return true;
      found.pop_back();
    }
    return false;
  }

  // What stands in the pattern's slots, where the text is such a sentence; else nothing.
  static std::vector<std::string> fillings(const Pattern& pattern, const std::string& text) {
    std::vector<std::string> found;
    const std::string& first = pattern.pieces.front();
    if (text.starts_with(first) && text.ends_with(pattern.pieces.back()))
      fill(pattern, 0, text, first.size(), found);
    return found;
  }
};

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
    if (Reading::sorted_slots(lines[0]) != Reading::sorted_slots(lines[1]))
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
    const Entry& one = table.entries_[i];
    if (i > 0 && one.english == table.entries_[i - 1].english)
      return bad_input("'" + one.english + "' stands there twice");
    Pattern english = Reading::taken_apart(one.english);
    if (english.slots.empty()) continue;
    table.sentences_.push_back({std::move(english), Reading::taken_apart(one.words)});
  }
  // Among equals those that begin with {…} come first: "Pose tool" is a tool, and nobody's pose.
  std::reverse(table.sentences_.begin(), table.sentences_.end());
  std::stable_sort(table.sentences_.begin(), table.sentences_.end(),
                   [](const Sentence& a, const Sentence& b) {
                     return Reading::own_letters(a.english) > Reading::own_letters(b.english);
                   });
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
  for (const Sentence& sentence : sentences_) {
    const std::vector<std::string> found = Reading::fillings(sentence.english, english);
    if (found.empty()) continue;
    const auto& ours = sentence.english.slots;
    const Pattern& theirs = sentence.words;
    std::string words = theirs.pieces[0];
    for (std::size_t i = 0; i < theirs.slots.size(); ++i) {
      const auto slot =
          std::size_t(std::find(ours.begin(), ours.end(), theirs.slots[i]) - ours.begin());
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
