#include "desktop.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include <SDL.h>
#include <stdio.h>

#include "editor/ui/words.h"
#include "files/bytes.h"
#include "files/document_file.h"
#include "files/inside_images.h"

namespace artisketch {
namespace fs = std::filesystem;
namespace {

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

bool runs(const char* program) {
  return std::system((std::string("command -v ") + program + " >/dev/null 2>&1").c_str()) == 0;
}

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

fs::path kept_folder() {
  const std::string state = environment("XDG_STATE_HOME"), home = environment("HOME");
  const fs::path root = !state.empty()  ? fs::path(state)
                        : !home.empty() ? fs::path(home) / ".local/state"
                                        : fs::temp_directory_path();
  return root / "artisketch";
}

// A document comes with its drawings inside, so that the editor needs no folder.
Result<NamedBytes> read_named(const std::string& path, SeenFiles& seen) {
  Result<std::string> bytes = read_file(path);
  if (!bytes) return bytes.error();
  seen.saw(path, *bytes);
  NamedBytes file{fs::path(path).filename().string(), std::move(*bytes), path};
  if (fs::path(path).extension() == ".artisketch") {
    Result<std::string> whole = with_images_inside(file.bytes, path);
    if (!whole) return whole.error();
    file.bytes = std::move(*whole);
  }
  return file;
}

Result<std::vector<NamedBytes>> read_all(const std::vector<std::string>& paths, SeenFiles& seen) {
  std::vector<NamedBytes> files;
  for (const std::string& path : paths) {
    Result<NamedBytes> file = read_named(path, seen);
    if (!file) return file.error();
    files.push_back(std::move(*file));
  }
  return files;
}

constexpr int kRecents = 12;
constexpr const char *kAutosave = "autosave", *kLeft = "left";  // the editor's keys

}  // namespace

Desktop::Desktop(fs::path assets)
    : examples_(assets / "examples"),
      gallery_(assets / "gallery"),
      guide_(assets / "guide" / "index.html"),
      languages_(assets / "languages"),
      kept_(kept_folder()),
      work_(kept_) {}

Desktop::~Desktop() {
  if (asking_.joinable()) asking_.join();
}

void Desktop::deliver() {
  std::vector<std::function<void()>> news;
  {
    const std::lock_guard lock(mutex_);
    news.swap(news_);
  }
  for (const auto& piece : news) piece();
}

bool Desktop::has_dialogs() {
  static const bool has = runs("zenity") || runs("kdialog");
  return has;
}

void Desktop::ask(std::string command, std::function<void(std::vector<std::string>)> then) {
  if (asking_.joinable()) asking_.join();
  asking_ = std::thread([this, command = std::move(command), then = std::move(then)] {
    std::vector<std::string> lines;
    if (FILE* pipe = popen(command.c_str(), "r")) {
      std::string all;
      char part[4096];
      while (std::size_t got = fread(part, 1, sizeof part, pipe)) all.append(part, got);
      if (pclose(pipe) != 0) all.clear();
      for (std::size_t at = 0; at < all.size();) {
        const std::size_t end = std::min(all.find('\n', at), all.size());
        if (end > at) lines.push_back(all.substr(at, end - at));
        at = end + 1;
      }
    }
    if (lines.empty()) return;
    const std::lock_guard lock(mutex_);
    news_.push_back([then, lines = std::move(lines)] { then(lines); });
    request_frame();
  });
}

void Desktop::open_files(Kind kind, Opened then) {
  const bool document = kind == Kind::document;
  const char* patterns =
      document ? "*.artisketch *.bvh *.glb" : "*.png *.jpg *.jpeg *.PNG *.JPG *.JPEG";
  const std::string title = tr(document ? "Open a document" : "Add drawings");
  std::string command;
  if (runs("zenity")) {
    command = "zenity --file-selection --separator='\n' --title=" + quoted(title) +
              " --file-filter=" + quoted(patterns) + (document ? "" : " --multiple");
  } else {
    command = std::string("kdialog --title ") + quoted(title) +
              (document ? "" : " --multiple --separate-output") + " --getopenfilename . " +
              quoted(patterns);
  }
  ask(std::move(command), [this, document, then](std::vector<std::string> paths) {
    if (document) remember(paths.front());
    then(read_all(paths, seen_));
  });
}

void Desktop::save_file(const std::string& name, const std::string& place, std::string bytes,
                        std::function<void(Result<Saved>)> then) {
  const auto write = [this, then](const std::string& path, const std::string& bytes) {
    const Result<Done> done = write_file(path, bytes);
    if (!done) return then(done.error());
    seen_.saw(path, bytes);
    if (fs::path(path).extension() == ".artisketch") remember(path);
    then(Saved{fs::path(path).filename().string(), path});
  };
  if (!place.empty() && seen_.changed(place)) {
    seen_.forget(place);
    return then(io_error(fs::path(place).filename().string() +
                         " was saved by another program since it was opened here. Save as keeps "
                         "both; saving once more replaces it"));
  }
  if (!place.empty()) return write(place, bytes);
  const std::string command =
      runs("zenity")
          ? "zenity --file-selection --save --confirm-overwrite --title=" + quoted(tr("Save")) +
                " --filename=" + quoted(name)
          : "kdialog --title " + quoted(tr("Save")) + " --getsavefilename " + quoted(name);
  ask(command, [write, bytes = std::move(bytes)](std::vector<std::string> paths) {
    write(paths.front(), bytes);
  });
}

std::vector<Platform::Recent> Desktop::recents() {
  std::vector<Recent> result;
  const Result<std::string> list = read_file((kept_ / "recents").string());
  if (!list) return result;
  for (std::size_t at = 0; at < list->size();) {
    const std::size_t end = std::min(list->find('\n', at), list->size());
    const std::string path = list->substr(at, end - at);
    std::error_code ignored;
    if (!path.empty() && fs::exists(path, ignored))
      result.push_back({fs::path(path).stem().string(), path});
    at = end + 1;
  }
  return result;
}

void Desktop::remember(const std::string& place) {
  std::error_code ignored;
  const std::string whole = fs::absolute(place, ignored).string();
  std::string list = whole + "\n";
  int count = 1;
  for (const Recent& recent : recents())
    if (recent.place != whole && ++count <= kRecents) list += recent.place + "\n";
  store("recents", std::move(list));
}

void Desktop::open_recent(const std::string& place, Opened then) {
  Result<std::vector<NamedBytes>> files = read_all({place}, seen_);
  if (files && fs::path(place).extension() == ".artisketch") remember(place);
  then(std::move(files));
}

void Desktop::store(const std::string& key, std::string bytes) {
  if (key == kAutosave) return (void)work_.keep(bytes).ok();
  if (key == kLeft) return work_.forget_left();
  const fs::path path = kept_ / key;
  std::error_code ignored;
  if (bytes.empty()) {
    fs::remove(path, ignored);
    return;
  }
  // What can't be kept is lost with the session alone; the document itself is saved elsewhere.
  (void)write_file(path.string(), bytes).ok();
}

void Desktop::load(const std::string& key, std::function<void(std::string)> then) {
  const auto whole = [](const std::string& text) { return parse_document(text, "").ok(); };
  if (key == kLeft) return then(work_.left_behind(whole));
  const Result<std::string> bytes = read_file((kept_ / key).string());
  then(bytes ? *bytes : std::string());
}

std::vector<ExampleCard> Desktop::examples() {
  using enum ExampleCard::Shelf;
  std::vector<ExampleCard> cards;
  std::error_code ignored;
  for (const auto& [folder, shelf] : {std::pair(examples_, first_screen), {gallery_, gallery}})
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
      const std::string name = entry.path().filename().string();
      const Result<Document> document =
          read_document((entry.path() / (name + ".artisketch")).string());
      if (document) cards.push_back({name, int(document->frames.size()), shelf});
    }
  // The hero greets; then those with the most drawings; the gallery by name.
  const auto order = [](const ExampleCard& card) {
    return std::tuple(card.shelf, card.name != "hero", card.shelf == gallery ? 0 : -card.drawings,
                      card.name);
  };
  std::sort(cards.begin(), cards.end(),
            [&](const ExampleCard& a, const ExampleCard& b) { return order(a) < order(b); });
  return cards;
}

void Desktop::load_example(const std::string& name, std::function<void(Result<Example>)> then) {
  const std::string file = name + ".artisketch";
  const bool shelved = fs::exists(gallery_ / name / file);
  const Result<NamedBytes> document =
      read_named(((shelved ? gallery_ : examples_) / name / file).string(), seen_);
  if (!document) return then(document.error());
  if (shelved) return then(Example{document->bytes, ""});  // its model is made when it is opened
  const Result<std::string> glb = read_file((examples_ / name / (name + ".glb")).string());
  if (!glb) return then(glb.error());
  then(Example{document->bytes, *glb});
}

void Desktop::load_example_picture(const std::string& name, std::function<void(std::string)> then) {
  Result<std::string> png = read_file((examples_ / name / (name + ".png")).string());
  if (!png) png = read_file((gallery_ / name / "model.png").string());
  then(png ? *png : std::string());
}

// What gettext goes by where it is set, then what else there is.
std::string Desktop::language() {
  for (const char* name : {"LANGUAGE", "LC_ALL", "LC_MESSAGES", "LANG"})
    if (const std::string tag = environment(name); !tag.empty()) return tag;
  std::string tag;
  if (SDL_Locale* preferred = SDL_GetPreferredLocales()) {
    if (preferred->language) tag = preferred->language;
    SDL_free(preferred);
  }
  return tag;
}

void Desktop::load_words(const std::string& code, std::function<void(std::string)> then) {
  const Result<std::string> text = read_file((languages_ / (code + ".txt")).string());
  then(text ? *text : std::string());
}

bool Desktop::has_guide() {
  std::error_code ignored;
  return fs::exists(guide_, ignored);
}

void Desktop::show_guide() {
  std::error_code ignored;
  SDL_OpenURL(("file://" + fs::absolute(guide_, ignored).string()).c_str());
}

void Desktop::set_title(const std::string& title, bool unsaved) {
  SDL_SetWindowTitle(window_, ((unsaved ? "• " : "") + title).c_str());
}

void Desktop::request_frame() {
  SDL_Event wake{};
  wake.type = SDL_USEREVENT;
  SDL_PushEvent(&wake);
}

bool Desktop::mac_keys() {
  return std::string(SDL_GetPlatform()) == "Mac OS X";
}

}  // namespace artisketch
