#include "app/cli.h"

#include <csignal>
#include <cstdio>

#include "app/command_manual.h"
#include "app/command_run.h"
#include "app/command_table.h"
#include "app/command_words.h"
#include "app/outputs.h"
#include "app/verbs.h"

namespace artisketch {
namespace {

// What a verb doesn't know, with what it may have been meant to be.
int unknown_words(const CLI::App& app) {
  const CLI::App* verb = app.get_subcommands().empty() ? &app : app.get_subcommands()[0];
  std::vector<std::string> options;
  for (const CLI::Option* option : verb->get_options())
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  std::string words;
  bool after_option = false;  // what follows one is its value
  for (const std::string& word : app.remaining(true)) {
    if (!word.starts_with("-") && after_option) continue;
    after_option = word.starts_with("-");
    const std::string near =
        word.starts_with("--") ? meant(word.substr(0, word.find('=')), options) : std::string();
    words += (words.empty() ? "" : "\n") + ("artisketch " + verb->get_name()) + ": " +
             (word.starts_with("-") ? "there is no option " : "what is to be done with ") + word +
             (word.starts_with("-") ? "" : "?") +
             (near.empty() ? "" : "; did you mean " + near + "?");
  }
  return bad_command_line(words + "\nartisketch " + verb->get_name() +
                          " --help lists what it takes");
}

int print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  return kDone;
}

int run_verb(const CLI::App& app, Arguments& a) {
  const std::string verb = app.get_subcommands()[0]->get_name();
  if (verb == "reconstruct") return reconstruct_verb(a);
  if (verb == "calibrate") return calibrate_verb(a);
  if (verb == "check") return check_verb(a);
  if (verb == "skeleton") return skeleton_verb(a);
  if (verb == "sprites") return sprites_verb(a);
  if (verb == "manual") return print(manual_page(app));
  if (verb == "completions") return print(completions(app, a.shell));
  return render_verb(a);
}

int run_verbs(const std::vector<std::string>& arguments, Arguments& a) {
  if (const std::string fault = verb_fault(arguments); !fault.empty())
    return bad_command_line(fault);
  const std::unique_ptr<CLI::App> table = command_table(a);
  CLI::App& app = *table;
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ExtrasError&) {
    return unknown_words(app);
  } catch (const CLI::RequiredError& error) {
    // What is missing may be there, mistyped.
    return app.remaining(true).empty() ? (app.exit(error), kBadCommandLine) : unknown_words(app);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) ? kBadCommandLine : kDone;
  }
  return run_verb(app, a);
}

}  // namespace

int run_cli(const std::vector<std::string>& arguments) {
  // A file that may not grow further is an error of writing, not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  Arguments a;
  return guarded(a.grid, [&] { return run_verbs(arguments, a); });
}

}  // namespace artisketch
