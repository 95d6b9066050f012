#include "native_main/seen_files.h"

#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "files/bytes.h"

namespace artisketch {
namespace {
namespace fs = std::filesystem;

class Seen : public testing::Test {
 protected:
  Seen() {
    std::string name = (fs::temp_directory_path() / "artisketch-seen-XXXXXX").string();
    folder = ::mkdtemp(name.data());
    path = (folder / "a.artisketch").string();
  }
  ~Seen() override { fs::remove_all(folder); }

  void save(SeenFiles& window, const std::string& bytes) {
    ASSERT_TRUE(write_file(path, bytes));
    window.saw(path, bytes);
  }

  fs::path folder;
  std::string path;
};

TEST_F(Seen, TheSecondOfTwoWindowsIsTold) {
  SeenFiles one, two;
  save(one, "first");
  two.saw(path, "first");  // opened there
  EXPECT_FALSE(one.changed(path));
  EXPECT_FALSE(two.changed(path));
  save(one, "by the one");
  EXPECT_FALSE(one.changed(path));
  EXPECT_TRUE(two.changed(path));
  two.forget(path);  // told, and saves all the same
  EXPECT_FALSE(two.changed(path));
  save(two, "by the other");
  EXPECT_TRUE(one.changed(path));
}

// What counts is what a file holds, not when it was written: a clock may go back, and a copy that
// is as before is as before.
TEST_F(Seen, ClocksDontMatter) {
  SeenFiles window;
  save(window, "first");
  fs::last_write_time(path, fs::file_time_type::clock::now() + std::chrono::hours(9));
  EXPECT_FALSE(window.changed(path));
  ASSERT_TRUE(write_file(path, "other"));
  fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(9));
  EXPECT_TRUE(window.changed(path));
}

TEST_F(Seen, OneFileIsOneByAllItsNames) {
  SeenFiles window;
  save(window, "first");
  fs::create_symlink("a.artisketch", folder / "link");
  EXPECT_FALSE(window.changed((folder / "link").string()));
  ASSERT_TRUE(write_file(path, "other"));
  EXPECT_TRUE(window.changed((folder / "link").string()));
}

TEST_F(Seen, WhatIsGoneOrWasNeverSeenHasNothingToLose) {
  SeenFiles window;
  EXPECT_FALSE(window.changed(path));
  save(window, "first");
  fs::remove(path);
  EXPECT_FALSE(window.changed(path));
}

}  // namespace
}  // namespace artisketch
