// The desktop as the editor's place: files by path, dialogs by zenity or kdialog where there is
// one.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <thread>

#include "editor/session/platform.h"
#include "kept_work.h"
#include "seen_files.h"

struct SDL_Window;

namespace artisketch {

class Desktop : public Platform {
 public:
  // assets: folder of examples/NAME/NAME.artisketch, NAME.glb and NAME.png, of
  // gallery/NAME/NAME.artisketch and model.png, of guide/index.html, and of
  // languages/CODE.txt.
  explicit Desktop(std::filesystem::path assets);
  ~Desktop() override;

  void attach(SDL_Window* window) { window_ = window; }
  // Hands over what dialogs brought; on the drawing thread, between two frames.
  void deliver();

  bool has_dialogs() override;
  void open_files(Kind kind, Opened then) override;
  void save_file(const std::string& name, const std::string& place, std::string bytes,
                 std::function<void(Result<Saved>)> then) override;
  std::vector<Recent> recents() override;
  void open_recent(const std::string& place, Opened then) override;
  void store(const std::string& key, std::string bytes) override;
  void load(const std::string& key, std::function<void(std::string)> then) override;
  std::vector<ExampleCard> examples() override;
  void load_example(const std::string& name, std::function<void(Result<Example>)> then) override;
  void load_example_picture(const std::string& name,
                            std::function<void(std::string)> then) override;
  std::string language() override;
  void load_words(const std::string& code, std::function<void(std::string)> then) override;
  bool has_guide() override;
  void show_guide() override;
  void set_title(const std::string& title, bool unsaved) override;
  bool prefers_dark() override { return true; }
  int default_grid() override { return 100; }
  void request_frame() override;
  bool mac_keys() override;

 private:
  // Runs a dialog's command; the lines that it prints come to `then` through deliver().
  void ask(std::string command, std::function<void(std::vector<std::string>)> then);
  void remember(const std::string& place);

  std::filesystem::path examples_, gallery_, guide_, languages_, kept_;
  KeptWork work_;
  SeenFiles seen_;
  SDL_Window* window_ = nullptr;
  std::thread asking_;
  std::mutex mutex_;
  std::vector<std::function<void()>> news_;
};

}  // namespace artisketch
