// A browser as the editor's place. What only JavaScript can do is in page.js, the other end of
// every call here; answers come back through the functions below, which page_main.cpp exports to
// it.
#pragma once

#include <map>

#include "editor/session/platform.h"

namespace artisketch {

class Browser : public Platform {
 public:
  Browser(std::vector<ExampleCard> examples, std::vector<Recent> recents, std::string language)
      : examples_(std::move(examples)),
        recents_(std::move(recents)),
        language_(std::move(language)) {}

  bool has_dialogs() override { return true; }
  void open_files(Kind kind, Opened then) override;
  void save_file(const std::string& name, const std::string& place, std::string bytes,
                 std::function<void(Result<Saved>)> then) override;
  std::vector<Recent> recents() override { return recents_; }
  void open_recent(const std::string& place, Opened then) override;
  void store(const std::string& key, std::string bytes) override;
  void load(const std::string& key, std::function<void(std::string)> then) override;
  std::vector<ExampleCard> examples() override { return examples_; }
  void load_example(const std::string& name, std::function<void(Result<Example>)> then) override;
  void load_example_picture(const std::string& name,
                            std::function<void(std::string)> then) override;
  std::string language() override { return language_; }
  void load_words(const std::string& code, std::function<void(std::string)> then) override;
  bool has_guide() override;
  void show_guide() override;
  void set_title(const std::string& title, bool unsaved) override;
  bool prefers_dark() override;
  int default_grid() override { return 64; }
  void request_frame() override;
  bool mac_keys() override;

  // Answers, by the number that the question went out with. Numbers that nothing waits for any more
  // are ignored.
  void opened(int question, Result<std::vector<NamedBytes>> files);
  void saved(int question, Result<Saved> where);
  void loaded(int question, std::string bytes);
  void example_loaded(int question, Result<Example> example);

 private:
  std::map<int, Opened> opening_;
  std::map<int, std::function<void(Result<Saved>)>> saving_;
  std::map<int, std::function<void(std::string)>> loading_;
  std::map<int, std::function<void(Result<Example>)>> fetching_;
  std::vector<ExampleCard> examples_;
  std::vector<Recent> recents_;
  std::string language_;
  int questions_ = 0;
  std::string title_;
  bool unsaved_ = false;
};

}  // namespace artisketch
