// The interface's words in other languages: the tables are well-formed and complete, and whoever
// chose a language sees no English.
#include "editor/ui/words.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "document/edit.h"
#include "editor/harness.h"

namespace artisketch {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

WordTable table_of(const std::string& code) {
  Result<WordTable> table = WordTable::parse(
      text_of(fs::path(ARTISKETCH_SOURCE_DIR "/assets/languages") / (code + ".txt")));
  if (table) return std::move(*table);
  ADD_FAILURE() << code << ": " << table.error().text();
  return {};
}

WordTable table(const std::string& text) {
  Result<WordTable> parsed = WordTable::parse(text);
  EXPECT_TRUE(parsed.ok()) << parsed.error().text();
  return parsed ? *parsed : WordTable();
}

std::string fault_of(const std::string& text) {
  const Result<WordTable> parsed = WordTable::parse(text);
  return parsed ? "" : parsed.error().text();
}

// ---------------------------------------------------------------- a table

TEST(Words, AreLookedUpWholeAndAsSentences) {
  const WordTable words = table(
      "# for translators\nHand\nMano\n\nDelete {+0}\nEliminar {+0}\n\n{#0} of {#1}\n{#1}: {#0}\n\n"
      "Add {0}\nAñadir {0}\n\nSay\\nit\nDilo\\nasí\n");
  std::vector<std::string> missing;
  const auto said = [&](const std::string& english) { return words.translated(english, missing); };
  EXPECT_EQ(said("Hand"), "Mano");
  EXPECT_EQ(said("Delete Hand"), "Eliminar Mano");
  EXPECT_EQ(said("Add Hand"), "Añadir Hand") << "a name";
  EXPECT_EQ(said("3 of 12"), "12: 3") << "in another order";
  EXPECT_EQ(said("Say\nit"), "Dilo\nasí");
  EXPECT_EQ(said("48 %"), "48 %");
  EXPECT_TRUE(missing.empty());
  EXPECT_EQ(said("end of story"), "end of story") << "no numbers";
  EXPECT_EQ(said("Delete Foot"), "Eliminar Foot");
  EXPECT_EQ(missing, (std::vector<std::string>{"end of story", "Foot"}));
}

TEST(Words, TheSentenceWithTheMostOfItsOwnIsTaken) {
  const WordTable words = table("Hide {0}\nVerbirg {0}\n\nHide {#0} parts\nVerbirg {#0} Teile\n");
  std::vector<std::string> missing;
  EXPECT_EQ(words.translated("Hide 2 parts", missing), "Verbirg 2 Teile");
  EXPECT_EQ(words.translated("Hide all parts", missing), "Verbirg all parts");
}

TEST(Words, ATableSaysWhatIsWrongWithIt) {
  EXPECT_NE(fault_of("Hand\n\nFoot\nPie\n").find("'Hand'"), std::string::npos);
  EXPECT_NE(fault_of("Hand\nMano\n\nHand\nMano\n").find("twice"), std::string::npos);
  EXPECT_NE(fault_of("Add {0}\nAñadir\n").find("{…}"), std::string::npos);
  EXPECT_NE(fault_of("Add {0}\nAñadir {1}\n").find("{…}"), std::string::npos);
  EXPECT_NE(fault_of("Add {0}\nAñadir {+0}\n").find("{…}"), std::string::npos);
}

TEST(Words, ALanguageIsKnownByTheSystemsNameForIt) {
  EXPECT_EQ(language_code("de"), "de");
  EXPECT_EQ(language_code("de-AT"), "de");
  EXPECT_EQ(language_code("de_DE.UTF-8"), "de");
  EXPECT_EQ(language_code("es:de"), "es");
  EXPECT_EQ(language_code("den"), "en") << "Slavey";
  EXPECT_EQ(language_code("C.UTF-8"), "en");
  EXPECT_EQ(language_code(""), "en");
}

// ---------------------------------------------------------------- the languages there are

// All that the sources say, literals that go on in the next line joined, '_' and capitals aside.
const std::string& said_by_sources() {
  static const std::string all = [] {
    std::string text;
    for (const char* folder : {"/src", "/native_main", "/web"})
      for (const auto& entry :
           fs::recursive_directory_iterator(std::string(ARTISKETCH_SOURCE_DIR) + folder))
        if (entry.is_regular_file()) text += text_of(entry.path());
    std::string joined;
    for (std::size_t at = 0; at < text.size(); ++at) {
      // JavaScript's go on after a plus.
      const bool ends = text[at] == '"' || text[at] == '\'' || text[at] == '`';
      const std::size_t next = ends ? text.find_first_not_of(" +\n", at + 1) : text.npos;
      if (next != text.npos && next > at + 1 && (text[next] == '"' || text[next] == '\''))
        at = next;
      else
        joined += text[at] == '_' ? ' ' : char(std::tolower(static_cast<unsigned char>(text[at])));
    }
    return joined;
  }();
  return all;
}

// Of one literal, or of several, one after the other.
bool is_said(std::string piece) {
  std::transform(piece.begin(), piece.end(), piece.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  const std::string& all = said_by_sources();
  while (!piece.empty()) {
    std::size_t most = piece.size();
    while (most > 0 && all.find(piece.substr(0, most)) == all.npos) --most;
    constexpr std::size_t kLeast = 3;  // letters: all others stand somewhere
    if (most < std::min(kLeast, piece.size())) return false;
    piece.erase(0, most);
  }
  return true;
}

std::vector<std::string> pieces(const std::string& english) {
  std::vector<std::string> found{""};
  for (std::size_t at = 0; at < english.size(); ++at) {
    if (english[at] != '{') {
      found.back() += english[at];
      continue;
    }
    at = english.find('}', at);
    found.emplace_back();
  }
  return found;
}

class Languages : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, Languages, testing::Values("de", "es"),
                         [](const auto& info) { return info.param; });

TEST_P(Languages, TheTableHasWhatTheSourcesSayAndNoMore) {
  const WordTable table = table_of(GetParam());
  for (const WordTable::Entry& entry : table.entries())
    for (const std::string& piece : pieces(entry.english))
      EXPECT_TRUE(is_said(piece)) << "'" << entry.english << "': no source says '" << piece << "'";
}

// What the page says by itself: say('…'), errors, and what its pickers call files. What varies in a
// template is a number after a bracket, as in "(404)", else a name.
std::vector<std::string> said_by_page() {
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(ARTISKETCH_SOURCE_DIR "/web")) {
    if (entry.path().extension() != ".js" || entry.path().filename() == "worker.js") continue;
    const std::string script =
        std::regex_replace(text_of(entry.path()), std::regex("['`] \\+\\s*'"), "");
    const std::regex said(
        "(?:say\\(|Error\\(|'page_opened', 0, |description: )(?:'([^']+)'|`([^`]+?)(?:`|'\\)))");
    for (std::sregex_iterator it(script.begin(), script.end(), said), end; it != end; ++it) {
      std::string words = (*it)[1].matched ? (*it)[1] : (*it)[2];
      words = std::regex_replace(words, std::regex("\\(\\$\\{[^}]+\\}\\)"), "(404)");
      all.push_back(std::regex_replace(words, std::regex("\\$?\\{[^}]+\\}"), "Hero"));
    }
  }
  return all;
}

TEST_P(Languages, ThePageSaysNothingInEnglish) {
  const WordTable table = table_of(GetParam());
  const std::vector<std::string> said = said_by_page();
  ASSERT_GT(said.size(), 15u);
  for (const std::string& words : said) {
    std::vector<std::string> missing;
    (void)table.translated(words, missing);
    EXPECT_TRUE(missing.empty()) << "'" << words << "'";
  }
}

TEST_P(Languages, TheTableSaysAsMuchAsTheOthers) {
  const auto english = [](const WordTable& table) {
    std::set<std::string> all;
    for (const WordTable::Entry& entry : table.entries()) all.insert(entry.english);
    return all;
  };
  const std::set<std::string> here = english(table_of(GetParam())), there = english(table_of("de"));
  EXPECT_EQ(here, there);
}

// ---------------------------------------------------------------- who speaks it

// Goes through the editor and hears all that it says: what is drawn, what is told of a control
// under the pointer, and what screen readers are told.
class Listener {
 public:
  explicit Listener(const std::string& code, std::vector<std::string> examples = {"hero"})
      : h(std::move(examples), {{"language", code}}) {}

  void hear() {
    for (const std::string& label : h.labels()) (void)tr(label);
    for (const std::string& words : h.state().messages) (void)tr(words);
    (void)tr(h.state().undo);
    left.insert(words_missing().begin(), words_missing().end());
  }
  void hear_tooltips() {
    const std::vector<Widget> all = h.editor().widgets();
    for (const Widget& widget : all) {
      if (widget.width <= 0 || widget.height <= 0) continue;
      h.point_at({widget.x + widget.width / 2, widget.y + widget.height / 2});
      h.wait(0.7);
    }
    hear();
  }
  // What is a name stays as it is.
  void expect_no_english() {
    std::set<std::string> names{"GLB", "VRM",  "OBJ",     "STL",   "PLY",
                                "PNG", "Hero", "Monster", "frames"};
    for (const Language& language : kLanguages) names.insert(language.name);
    const Document& document = h.document();
    names.insert(document.name);
    for (int f = 0; f < int(document.frames.size()); ++f) names.insert(drawing_words(document, f));
    for (const Animation& animation : document.animations) names.insert(animation.name);
    for (const std::string& words : left) EXPECT_TRUE(names.contains(words)) << "'" << words << "'";
  }

  Harness h;
  std::set<std::string> left;
};

constexpr ImGuiKey kModeKeys[] = {ImGuiKey_1, ImGuiKey_2, ImGuiKey_3, ImGuiKey_4};

TEST_P(Languages, NothingIsLeftInEnglish) {
  Listener l(GetParam(), {"hero", "monster"});
  Harness& h = l.h;
  h.settle();
  l.hear_tooltips();
  h.click("Gallery");
  l.hear_tooltips();
  h.open_example("hero");
  h.settle();
  for (const ImGuiKey mode : kModeKeys) {
    h.key(mode);
    h.settle();
    l.hear_tooltips();  // what one does there lies over it
    h.key(ImGuiKey_Escape);
    l.hear_tooltips();
  }
  h.click("Menu");
  l.hear();
  h.key(ImGuiKey_Escape);
  h.click("Shortcuts");
  l.hear();
  h.key(ImGuiKey_Escape);
  l.expect_no_english();
}

TEST_P(Languages, NoToolIsLeftInEnglish) {
  Listener l(GetParam());
  Harness& h = l.h;
  h.open_example("hero");
  h.settle();
  for (const ImGuiKey mode : kModeKeys) {
    h.key(mode);
    h.key(ImGuiKey_Escape);
    for (const std::string& label : h.labels())
      if (label.ends_with(" tool") && h.enabled(label)) {
        h.click(label);
        l.hear();
      }
  }
  h.key(ImGuiKey_1);
  h.click("Forearm L");
  h.key(ImGuiKey_Delete);
  l.hear();
  h.key(ImGuiKey_3);
  h.click("Joint Hand L");
  l.hear_tooltips();
  l.expect_no_english();
}

TEST_P(Languages, NoSheetIsLeftInEnglish) {
  Listener l(GetParam());
  Harness& h = l.h;
  h.open_example("hero");
  h.settle();
  h.right_click("Drawing card 1");
  l.hear();
  h.key(ImGuiKey_Escape);
  h.key(ImGuiKey_R);
  h.settle();
  l.hear();
  h.key(ImGuiKey_4);
  h.settle();
  l.hear_tooltips();
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  h.wait(2);
  for (const char* format : {"GLB", "VRM", "OBJ", "STL", "PLY", "PNG", "Sprites"}) {
    h.click(std::string("Format ") + format);
    h.frames(2);
    l.hear_tooltips();
  }
  h.key(ImGuiKey_Escape);
  h.key(ImGuiKey_C, ImGuiMod_Shift);
  h.settle();
  l.hear();
  l.expect_no_english();
}

TEST(Language, IsTheSystemsUntilAnotherIsChosen) {
  Harness h({"hero"}, {}, {1440, 900}, "es-MX");
  EXPECT_EQ(tr("Undo"), "Deshacer");
  h.click("Menu");
  h.click("Deutsch");
  EXPECT_EQ(tr("Undo"), "Rückgängig");
  EXPECT_EQ(h.platform.kept["language"], "de");
  EXPECT_EQ(tr("nobody translated this"), "nobody translated this");
  h.click("English");
  EXPECT_EQ(tr("Undo"), "Undo");
  EXPECT_EQ(h.platform.kept["language"], "en") << "whatever the system speaks";
}

}  // namespace
}  // namespace artisketch
