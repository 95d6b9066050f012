#include "app/many_documents.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

#include "app/command_run.h"
#include "app/outputs.h"
#include "files/document_file.h"
#include "files/report_file.h"

namespace artisketch {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// ---------------------------------------------------------------- where everything goes

struct FolderOption {
  const char* option;
  std::string Arguments::*path;
  const char* ending;
  Kind kind;
};
constexpr FolderOption kFolders[] = {
    {"-o", &Arguments::out, ".glb", Kind::model},
    {"--calibrated", &Arguments::calibrated, ".artisketch", Kind::document},
    {"--preview", &Arguments::preview, ".png", Kind::picture},
    {"--trace", &Arguments::trace, "", Kind::model}};

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

// Each option's path is a folder, or will be: where it isn't there its place must be sound.
int judge_folders(const Arguments& a) {
  for (const FolderOption& folder : kFolders) {
    std::string path = a.*folder.path;
    if (path.empty()) continue;
    const bool is_there = is_folder(path);
    if (!is_there && !path.ends_with('/'))
      return bad_command_line(std::string(folder.option) + " " + path + ": " +
                              std::to_string(a.documents.size()) +
                              (a.documents.size() == 1 ? " document goes" : " documents go") +
                              " to a folder; end its name in /");
    while (path.size() > 1 && path.ends_with('/')) path.pop_back();
    const Target place{folder.option, is_there ? path + "/x" : path, folder.kind};
    if (const int status = judge_places({place})) return status;
  }
  const std::vector<Target> report{{"--report", a.report, Kind::report}};
  if (const int status = judge_endings(report)) return status;
  return judge_places(report);
}

// The same words for each document, with places of its own.
Result<std::vector<Arguments>> placed(const Arguments& a) {
  std::vector<Arguments> each;
  std::map<std::string, std::string> named;
  for (const std::string& in : a.documents) {
    const std::string name = fs::path(in).stem().string();
    const auto [other, is_new] = named.emplace(name, in);
    if (!is_new)
      return bad_input(in + ": would become " + a.out + (a.out.ends_with('/') ? "" : "/") + name +
                       ".glb, as would " + other->second + "; rename one, or make them apart");
    Arguments one = a;
    one.documents.clear();
    one.in = in;
    one.report.clear();
    one.progress = false;
    for (const FolderOption& folder : kFolders)
      if (!(a.*folder.path).empty())
        one.*folder.path = (fs::path(a.*folder.path) / (name + folder.ending)).string();
    each.push_back(std::move(one));
  }
  return each;
}

// No result takes the place of anything that is read, by whichever of the documents. One that can't
// be read is itself alone; it fails in its turn.
int judge_all_overwriting(const Arguments& a, const std::vector<Arguments>& each) {
  std::vector<Target> targets{{"--report", a.report, Kind::report}};
  std::vector<std::string> inputs{a.motion};
  for (const Arguments& one : each) {
    for (const FolderOption& folder : kFolders)
      if (folder.option != std::string_view("--trace"))
        targets.push_back({folder.option, one.*folder.path, folder.kind});
    const Result<Document> document = read_document(one.in);
    const std::vector<std::string> files =
        document ? files_of(*document, one.in) : std::vector<std::string>{one.in};
    inputs.insert(inputs.end(), files.begin(), files.end());
  }
  return judge_overwriting(targets, inputs);
}

int make_folders(const Arguments& a) {
  for (const FolderOption& folder : kFolders) {
    const std::string& path = a.*folder.path;
    std::error_code failed;
    if (path.empty() || is_folder(path)) continue;
    fs::create_directory(fs::path(path.substr(0, path.find_last_not_of('/') + 1)), failed);
    if (failed && !is_folder(path))
      return fail(io_error(path + ": the folder cannot be made: " + failed.message()));
  }
  return kDone;
}

// ---------------------------------------------------------------- a process for each

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File scratch() {
  return {std::tmpfile(), std::fclose};
}

std::string text_of(std::FILE* file) {
  std::string text;
  std::rewind(file);
  char block[1 << 14];
  while (const std::size_t n = std::fread(block, 1, sizeof block, file)) text.append(block, n);
  return text;
}

struct Child {
  std::size_t which;
  pid_t pid;
  File out, err, report;
};

// In the child: does the work, leaves what it says and its report in the scratch files.
[[noreturn]] void work(Arguments one, const Child& child) {
  dup2(fileno(child.out.get()), STDOUT_FILENO);
  dup2(fileno(child.err.get()), STDERR_FILENO);
  const int status = guarded(one.grid, [&] {
    std::string report;
    const int done = reconstruct_one(one, &report);
    std::fputs(report.c_str(), child.report.get());
    return done;
  });
  std::fflush(nullptr);
  _exit(status);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

// Why a process ended that didn't return.
std::string ended_by(int signal) {
  return std::string("ended by a signal: ") + strsignal(signal) +
         (signal == SIGKILL ? "; perhaps there was not enough memory: try fewer --jobs" : "");
}

class Workshop {
 public:
  Workshop(const Arguments& a, std::vector<Arguments> each)
      : all_(a), each_(std::move(each)), command_(shows_progress(a)) {
    made_.resize(each_.size());
    for (std::size_t i = 0; i < each_.size(); ++i)
      made_[i].in = each_[i].in, made_[i].out = each_[i].out;
  }

  void run() {
    while (!running_.empty() || (next_ < each_.size() && !CommandRun::asked_to_stop())) {
      while (next_ < each_.size() && int(running_.size()) < all_.jobs &&
             !CommandRun::asked_to_stop())
        begin(next_++);
      if (CommandRun::asked_to_stop())
        for (const Child& child : running_) kill(child.pid, SIGTERM);
      if (!settle_ended()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    command_.finish();
  }

  const std::vector<DocumentOutcome>& outcomes() const { return made_; }

 private:
  void begin(std::size_t which) {
    DocumentOutcome& outcome = made_[which];
    std::error_code ignored;
    if (all_.skip_existing && fs::exists(outcome.out, ignored)) {
      outcome.became = DocumentOutcome::Became::there_already;
      return;
    }
    Child child{which, -1, scratch(), scratch(), scratch()};
    std::fflush(nullptr);  // or the child would say it again
    const bool sound = child.out && child.err && child.report;
    if (sound) child.pid = fork();
    if (child.pid == 0) work(each_[which], child);
    if (child.pid > 0) {
      running_.push_back(std::move(child));
      return;
    }
    outcome.became = DocumentOutcome::Became::failed;
    outcome.exit = kNotWritten;
    outcome.errors = {outcome.in + ": no process could be begun for it: " + std::strerror(errno)};
    std::fprintf(stderr, "%s\n", outcome.errors[0].c_str());
  }

  // Whether any had ended.
  bool settle_ended() {
    const std::size_t before = running_.size();
    for (auto child = running_.begin(); child != running_.end();) {
      int status = 0;
      if (waitpid(child->pid, &status, WNOHANG) == 0) {
        ++child;
        continue;
      }
      settle(*child, status);
      child = running_.erase(child);
    }
    return running_.size() != before;
  }

  void settle(const Child& child, int status) {
    DocumentOutcome& outcome = made_[child.which];
    outcome.exit = WIFEXITED(status) ? WEXITSTATUS(status) : int(kBadInput);
    outcome.became = outcome.exit ? DocumentOutcome::Became::failed : DocumentOutcome::Became::made;
    std::vector<std::string> said = lines_of(text_of(child.err.get()));
    if (WIFSIGNALED(status)) said.push_back(ended_by(WTERMSIG(status)));
    for (std::string& line : said) {
      if (!line.starts_with("warning: ")) outcome.errors.push_back(line);
      if (!line.starts_with(outcome.in)) line = outcome.in + ": " + line;
    }
    if (!outcome.exit) outcome.errors.clear();
    outcome.report = text_of(child.report.get());
    command_.finish();
    std::fputs(text_of(child.out.get()).c_str(), stdout);
    std::fflush(stdout);
    for (const std::string& line : said) std::fprintf(stderr, "%s\n", line.c_str());
    show(outcome.in);
  }

  void show(const std::string& item) {
    ++done_;
    Progress& now = command_.run.now;
    now = {"documents", item, done_ - 1, int(each_.size()), 0};
    command_.run.report(double(next_ - running_.size() + 1) / double(each_.size()));
  }

  const Arguments& all_;
  std::vector<Arguments> each_;
  CommandRun command_;
  std::vector<DocumentOutcome> made_;
  std::list<Child> running_;
  std::size_t next_ = 0;
  int done_ = 0;
};

int print_all(const Arguments& a, const std::vector<DocumentOutcome>& outcomes, double seconds) {
  int counts[4] = {}, worst = kDone;
  for (const DocumentOutcome& outcome : outcomes) {
    ++counts[int(outcome.became)];
    if (outcome.became != DocumentOutcome::Became::failed) continue;
    worst = std::max(worst, outcome.exit);
    std::fprintf(stderr, "not made: %s\n", outcome.in.c_str());
  }
  const auto count = [&](DocumentOutcome::Became which) { return counts[int(which)]; };
  if (!a.quiet)
    std::printf("%s: %d documents: %d made, %d there already, %d failed, %d not begun, %s\n",
                a.out.c_str(), int(outcomes.size()), count(DocumentOutcome::Became::made),
                count(DocumentOutcome::Became::there_already),
                count(DocumentOutcome::Became::failed), count(DocumentOutcome::Became::not_begun),
                seconds_text(seconds).c_str());
  return CommandRun::asked_to_stop() ? int(kStopped) : worst;
}

}  // namespace

bool names_folder(const Arguments& a) {
  return a.documents.size() > 1 || a.out.ends_with('/');
}

int reconstruct_many(const Arguments& a) {
  if (const int status = judge_folders(a)) return status;
  Result<std::vector<Arguments>> each = placed(a);
  if (!each) return bad_command_line(each.error().text());
  if (const int status = judge_all_overwriting(a, *each)) return status;
  if (const int status = make_folders(a)) return status;
  const Clock::time_point began = Clock::now();
  Workshop workshop(a, std::move(*each));
  workshop.run();
  const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
  const int status = print_all(a, workshop.outcomes(), seconds);
  if (a.report.empty()) return status;
  const int written = write_all({{a.report, reports_text(workshop.outcomes())}});
  return std::max(status, written);
}

}  // namespace artisketch
