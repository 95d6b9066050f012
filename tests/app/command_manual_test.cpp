#include "app/command_manual.h"

#include <cstdio>
#include <regex>
#include <set>

#include "app/command_line.h"
#include "app/command_words.h"
#include "files/bytes.h"

namespace artisketch {
namespace {

class Manual : public CommandLine {
 protected:
  std::string said(const std::vector<std::string>& arguments) {
    EXPECT_EQ(run(arguments), 0) << err;
    return out;
  }
  // Those that `artisketch VERB --help` lists.
  std::set<std::string> options(const std::string& verb) {
    const std::string help = said({verb, "--help"});
    std::set<std::string> names;
    const std::regex name("(^|[ ,])(--[a-z][a-z-]*)");
    for (std::sregex_iterator it(help.begin(), help.end(), name), end; it != end; ++it)
      names.insert((*it)[2]);
    return names;
  }
  // What a shell answers to `script`; nothing where it isn't there.
  static std::optional<std::string> answer(const std::string& shell, const std::string& script) {
    if (std::system(("command -v " + shell + " >/dev/null").c_str()) != 0) return std::nullopt;
    std::FILE* pipe = popen((shell + " " + script + " 2>&1").c_str(), "r");
    std::string text;
    char block[4096];
    while (const std::size_t n = std::fread(block, 1, sizeof block, pipe)) text.append(block, n);
    return pclose(pipe) == 0 ? text : shell + " failed: " + text;
  }
};

TEST_F(Manual, NamesEveryVerbAndOptionAsDoCompletionsAndTheReadme) {
  const std::string page = said({"manual"}), bash = said({"completions", "bash"}),
                    zsh = said({"completions", "zsh"}), fish = said({"completions", "fish"}),
                    readme = *read_file(ARTISKETCH_SOURCE_DIR "/README.md"),
                    help = said({"--help"});
  for (const std::string_view name : kVerbs) {
    const std::string verb(name);
    for (const std::string* text : {&page, &bash, &zsh, &fish, &readme, &help})
      EXPECT_NE(text->find(verb), std::string::npos) << verb;
    const std::size_t section = page.find(".SS artisketch " + verb);
    ASSERT_NE(section, std::string::npos) << verb;
    const std::string own = page.substr(section, page.find(".SS", section + 1) - section);
    const std::set<std::string> all = options(verb);
    EXPECT_GE(all.size(), 1u);
    for (const std::string& option : all) {
      EXPECT_NE(own.find(std::regex_replace(option, std::regex("-"), "\\-")), std::string::npos)
          << verb << " " << option;
      EXPECT_NE(bash.find(option), std::string::npos) << option;
      EXPECT_NE(zsh.find(option + "["), std::string::npos) << option;
      EXPECT_NE(fish.find("from " + verb + "' "), std::string::npos) << verb;
      EXPECT_NE(fish.find("-l " + option.substr(2) + " "), std::string::npos) << option;
      if (option == "--output") continue;  // README calls it -o
      EXPECT_TRUE(option == "--help" || readme.find(option) != std::string::npos) << option;
    }
  }
}

TEST_F(Manual, ABashCompletesVerbsOptionsAndTheirChoices) {
  write("script", said({"completions", "bash"}));
  const auto completed = [&](const std::string& words, int at) {
    write("ask", ". " + path("script") + "\nCOMP_WORDS=(artisketch " + words + "); COMP_CWORD=" +
                     std::to_string(at) + "\n_artisketch\necho \"${COMPREPLY[@]}\"\n");
    return answer("bash", path("ask"));
  };
  const auto verbs = completed("re", 1);
  if (!verbs) GTEST_SKIP() << "there is no bash";
  EXPECT_EQ(*verbs, "reconstruct render\n");
  EXPECT_EQ(*completed("reconstruct --method ''", 3), "paper rays\n");
  EXPECT_EQ(*completed("reconstruct --no", 2), "--no-calibrate --no-texture\n");
  EXPECT_EQ(*completed("sprites --light t", 3), "toon\n");
  EXPECT_EQ(*completed("reconstruct a", 2), "\n") << "files are the shell's own";
}

TEST_F(Manual, OtherShellsTakeTheirs) {
  for (const std::string shell : {"zsh", "fish"}) {
    write("script", said({"completions", shell}));
    const auto answered = answer(shell, "-n " + path("script"));
    EXPECT_EQ(answered.value_or(""), "") << shell;
  }
}

TEST_F(Manual, TheVersionSaysItsCommitAndModelsDoNot) {
  EXPECT_TRUE(std::regex_match(said({"--version"}),
                               std::regex("ArtiSketch [0-9.]+( \\(commit [0-9a-f]{10}\\+?\\))?\n")))
      << out;
  ASSERT_EQ(run({"reconstruct", kCircles, "-o", path("c.ply"), "--grid", "16", "--no-texture"}), 0);
  EXPECT_EQ(read_file(path("c.ply"))->find("commit"), std::string::npos);
}

}  // namespace
}  // namespace artisketch
