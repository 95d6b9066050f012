#include "app/command_manual.h"

#include <vector>

#include "app/version.h"

namespace artisketch {
namespace {

// An option as it is typed, and what may follow it.
struct Word {
  std::vector<std::string> names;  // "-o", "--output"; none: it stands by itself
  std::string value;               // what it is called: INT, TEXT, IN; empty for a flag
  std::vector<std::string> choices;
  std::string says;
  bool repeats = false;
  bool is_file = false;  // what follows may be one
};

// "{paper,rays}" of "TEXT:{paper,rays}", and "{soft->0,toon->2}".
std::vector<std::string> choices_in(const std::string& type) {
  std::vector<std::string> choices;
  const std::size_t begin = type.find('{');
  if (begin == type.npos) return choices;
  const std::string inside = type.substr(begin + 1, type.find('}', begin) - begin - 1);
  for (std::size_t at = 0; at <= inside.size();) {
    const std::size_t end = std::min(inside.find(',', at), inside.size());
    const std::string one = inside.substr(at, end - at);
    choices.push_back(one.substr(0, one.find("->")));
    at = end + 1;
  }
  return choices;
}

Word word_of(const CLI::Option& option) {
  Word word;
  for (const std::string& name : option.get_snames()) word.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) word.names.push_back("--" + name);
  word.says = option.get_description();
  if (option.get_type_size() == 0 || option.get_expected_max() == 0) return word;
  const std::string type = option.get_type_name();
  word.choices = choices_in(type);
  word.value =
      word.names.empty() ? option.get_name(true) : type.substr(0, type.find_first_of(": "));
  word.repeats = option.get_expected_max() > 1;
  word.is_file = word.choices.empty() && type == "TEXT";
  return word;
}

std::vector<Word> words_of(const CLI::App& verb) {
  std::vector<Word> words;
  for (const CLI::Option* option : verb.get_options()) words.push_back(word_of(*option));
  return words;
}

std::vector<const CLI::App*> verbs_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : between) + word;
  return all;
}

// ---------------------------------------------------------------- the manual

std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '-' || c == '\\') out += '\\';
    out += c == '\\' ? 'e' : c;
  }
  return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

std::string roff_words(const CLI::App& verb) {
  std::string text;
  for (const Word& word : words_of(verb)) {
    text += ".TP\n";
    if (!word.names.empty()) text += "\\fB" + roff(joined(word.names, ", ")) + "\\fR";
    if (!word.value.empty())
      text += (word.names.empty() ? "\\fI" : " \\fI") +
              roff(word.choices.empty() ? word.value : joined(word.choices, "|")) + "\\fR";
    text += "\n" + roff(word.says) + "\n";
  }
  return text;
}

// ---------------------------------------------------------------- shells

// What can be typed after a verb and begins with a dash.
std::string dashed(const std::vector<Word>& words) {
  std::vector<std::string> names;
  for (const Word& word : words) names.insert(names.end(), word.names.begin(), word.names.end());
  return joined(names, " ");
}

std::string names_of(const std::vector<const CLI::App*>& verbs) {
  std::vector<std::string> names;
  for (const CLI::App* verb : verbs) names.push_back(verb->get_name());
  return joined(names, " ");
}

std::string bash(const CLI::App& app) {
  std::string values, options;
  for (const CLI::App* verb : verbs_of(app)) {
    const std::vector<Word> words = words_of(*verb);
    for (const Word& word : words) {
      if (word.value.empty() || word.is_file) continue;
      std::vector<std::string> before;
      for (const std::string& name : word.names)
        before.push_back("'" + verb->get_name() + " " + name + "'");
      if (before.empty()) before = {"'" + verb->get_name() + " " + verb->get_name() + "'"};
      values +=
          "    " + joined(before, " | ") + ") choices='" + joined(word.choices, " ") + "' ;;\n";
    }
    options += "    " + verb->get_name() + ") choices='" + dashed(words) + "' ;;\n";
  }
  return "# bash completion for artisketch; made by: artisketch completions bash\n"
         "_artisketch() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} verb=${COMP_WORDS[1]} choices=''\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    COMPREPLY=($(compgen -W '" +
         names_of(verbs_of(app)) + " " + dashed(words_of(app)) +
         "' -- \"$word\"))\n"
         "    return\n"
         "  fi\n"
         "  case \"$verb ${COMP_WORDS[COMP_CWORD - 1]}\" in\n" +
         values +
         "    *)\n"
         "      case $word in -*) ;; *) return ;; esac # a file: see below\n"
         "      case $verb in\n" +
         options +
         "      esac ;;\n"
         "  esac\n"
         "  compopt +o default 2>/dev/null\n"
         "  COMPREPLY=($(compgen -W \"$choices\" -- \"$word\"))\n"
         "}\n"
         "complete -o default -F _artisketch artisketch\n";
}

// For zsh, between single quotes, where brackets and colons have a meaning of their own.
std::string zsh_words(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'')
      out += "'\\'";
    else if (c == '[' || c == ']' || c == ':' || c == '\\')
      out += '\\';
    out += c;
  }
  return out;
}

std::string zsh_line(const Word& word) {
  const std::string action = !word.choices.empty() ? "(" + joined(word.choices, " ") + ")"
                             : word.is_file        ? "_files"
                                                   : " ";
  const std::string value = word.value.empty() ? "" : ":" + zsh_words(word.value) + ":" + action;
  if (word.names.empty()) return " '" + std::string(word.repeats ? "*" : "") + value + "'";
  std::string lines;
  for (const std::string& name : word.names)
    lines += " '" + std::string(word.repeats ? "*" : "") + name + "[" + zsh_words(word.says) + "]" +
             value + "'";
  return lines;
}

std::string zsh(const CLI::App& app) {
  std::string verbs, cases;
  for (const CLI::App* verb : verbs_of(app)) {
    verbs += " '" + verb->get_name() + ":" + zsh_words(verb->get_description()) + "'";
    cases += "    " + verb->get_name() + ") _arguments";
    for (const Word& word : words_of(*verb)) cases += " \\\n     " + zsh_line(word);
    cases += " ;;\n";
  }
  std::string own;
  for (const Word& word : words_of(app)) own += zsh_line(word);
  return "#compdef artisketch\n"
         "# Made by: artisketch completions zsh\n"
         "_artisketch() {\n"
         "  local -a verbs=(" +
         verbs +
         " )\n"
         "  if (( CURRENT == 2 )); then\n"
         "    _describe verb verbs\n"
         "    _arguments" +
         own +
         "\n    return\n"
         "  fi\n"
         "  local verb=$words[2]\n"
         "  shift words\n"
         "  (( CURRENT-- ))\n"
         "  case $verb in\n" +
         cases +
         "  esac\n"
         "}\n"
         "_artisketch \"$@\"\n";
}

std::string fish_words(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return "'" + out + "'";
}

std::string fish_line(const std::string& when, const Word& word) {
  std::string line = "complete -c artisketch -n " + when;
  for (const std::string& name : word.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!word.choices.empty())
    line += std::string(word.names.empty() ? " -f" : " -x") + " -a " +
            fish_words(joined(word.choices, " "));
  else if (!word.names.empty() && !word.value.empty())
    line += word.is_file ? " -r -F" : " -x";
  return line + " -d " + fish_words(word.says) + "\n";
}

std::string fish(const CLI::App& app) {
  std::string text = "# Made by: artisketch completions fish\n";
  for (const CLI::App* verb : verbs_of(app))
    text += "complete -c artisketch -n __fish_use_subcommand -f -a " + verb->get_name() + " -d " +
            fish_words(verb->get_description()) + "\n";
  for (const Word& word : words_of(app)) text += fish_line("__fish_use_subcommand", word);
  for (const CLI::App* verb : verbs_of(app))
    for (const Word& word : words_of(*verb))
      if (!word.names.empty() || !word.choices.empty())
        text += fish_line("'__fish_seen_subcommand_from " + verb->get_name() + "'", word);
  return text;
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string text = ".TH ARTISKETCH 1 \"\" \"" + roff(version_words()) +
                     "\" \"User Commands\"\n"
                     ".SH NAME\n"
                     "artisketch \\- make a 3D character that moves from a few drawings of it\n"
                     ".SH SYNOPSIS\n";
  for (const CLI::App* verb : verbs_of(app))
    text += std::string(text.ends_with("SYNOPSIS\n") ? "" : ".br\n") + ".B artisketch " +
            roff(verb->get_name()) + "\n[\\fIoption\\fR...]\n";
  text +=
      ".SH DESCRIPTION\n" + roff(app.get_description()) +
      "\nA document (.artisketch) holds the skeleton, the poses and each part's outlines beside "
      "its drawings; artisketch\\-editor makes one.\n";
  text += ".SH OPTIONS\n" + roff_words(app);
  for (const CLI::App* verb : verbs_of(app))
    text += ".SS artisketch " + roff(verb->get_name()) + "\n" + roff(verb->get_description()) +
            ".\n" + roff_words(*verb);
  text +=
      ".SH EXIT STATUS\n"
      "0 done; 1 the input is bad, a line per fault; 2 the command line is bad; 3 the result could "
      "not be written; 130 stopped by Ctrl\\-C.\n"
      "An output file is complete or absent.\n"
      ".SH EXAMPLES\n"
      ".nf\n"
      "artisketch reconstruct hero.artisketch \\-o hero.glb \\-\\-preview hero.png\n"
      "artisketch reconstruct sketches/*.artisketch \\-o models/ \\-\\-jobs 4\n"
      "artisketch sprites hero.glb \\-o walk.png \\-\\-clip walk\n"
      ".fi\n";
  return text;
}

std::string completions(const CLI::App& app, const std::string& shell) {
  return shell == "bash" ? bash(app) : shell == "zsh" ? zsh(app) : fish(app);
}

}  // namespace artisketch
