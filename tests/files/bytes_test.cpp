#include "files/bytes.h"

#include <chrono>
#include <csignal>
#include <filesystem>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace artisketch {
namespace {

namespace fs = std::filesystem;

class Files : public ::testing::Test {
 protected:
  Files() { fs::create_directory(folder); }
  ~Files() override { fs::remove_all(folder); }
  std::string path(const std::string& name) const { return folder + "/" + name; }
  int entries() const {
    return int(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }
  const std::string folder =
      ::testing::TempDir() + "artisketch_bytes_" + std::to_string(::getpid());
};

TEST_F(Files, WhatIsWrittenIsRead) {
  const std::string bytes("a\0b\r\n\xff", 6);
  ASSERT_TRUE(write_file(path("x"), bytes));
  EXPECT_EQ(*read_file(path("x")), bytes);
  ASSERT_TRUE(write_file(path("x"), ""));
  EXPECT_EQ(*read_file(path("x")), "");
  EXPECT_EQ(entries(), 1);
}

TEST_F(Files, AFailedWriteLeavesNothingBehind) {
  EXPECT_FALSE(write_file(path("no/such/folder"), "x"));
  EXPECT_FALSE(write_file(folder, "x"));
  EXPECT_EQ(entries(), 0);
  EXPECT_EQ(write_file(folder, "x").error().kind, Error::Kind::io);
}

TEST_F(Files, AReplacedFileKeepsItsModeAndItsLinks) {
  ASSERT_TRUE(write_file(path("real"), "old"));
  ::chmod(path("real").c_str(), 0640);
  fs::create_symlink("real", path("link"));
  ASSERT_TRUE(write_file(path("link"), "new"));
  EXPECT_EQ(*read_file(path("real")), "new");
  EXPECT_TRUE(fs::is_symlink(path("link")));
  struct stat s;
  ASSERT_EQ(::stat(path("real").c_str(), &s), 0);
  EXPECT_EQ(s.st_mode & 0777, 0640u);
}

TEST_F(Files, ADeviceIsWrittenToAndStaysADevice) {
  ASSERT_TRUE(write_file("/dev/null", "x"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Files, SeveralAreWrittenAllOrNone) {
  ASSERT_TRUE(write_file(path("a"), "old"));
  const NewFile good[] = {{path("a"), "new"}, {path("b"), "new"}};
  const NewFile bad[] = {{path("a"), "worse"}, {path("no/such/folder"), "x"}, {path("c"), "worse"}};
  EXPECT_FALSE(write_files(bad));
  EXPECT_EQ(*read_file(path("a")), "old");
  EXPECT_EQ(entries(), 1);
  const NewFile full[] = {{path("a"), "worse"}, {"/dev/full", "x"}};
  EXPECT_FALSE(write_files(full));
  EXPECT_EQ(*read_file(path("a")), "old");
  ASSERT_TRUE(write_files(good));
  EXPECT_EQ(*read_file(path("a")), "new");
  EXPECT_EQ(*read_file(path("b")), "new");
  EXPECT_EQ(entries(), 2);
}

TEST_F(Files, ANameAsLongAsNamesCanBeIsWritten) {
  const std::string name(255, 'n');
  ASSERT_TRUE(write_file(path(name), "x"));
  EXPECT_EQ(*read_file(path(name)), "x");
}

// Killed at any moment a save leaves the old file or the new one, whole.
TEST_F(Files, ASaveThatIsKilledLeavesOldOrNew) {
  const std::string old(300000, 'a'), fresh(500000, 'b');
  ASSERT_TRUE(write_file(path("x"), old));
  for (int moment = 0; moment < 200; ++moment) {
    const pid_t child = ::fork();
    if (child == 0) {
      for (;;) {
        (void)write_file(path("x"), fresh).ok();
        (void)write_file(path("x"), old).ok();
      }
    }
    ::usleep(useconds_t(500 + 177 * moment % 7000));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::string left = *read_file(path("x"));
    ASSERT_TRUE(left == old || left == fresh) << left.size();
  }
  // What such ends leave beside the file goes once it is old.
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    fs::last_write_time(entry.path(), fs::file_time_type::clock::now() - std::chrono::hours(2));
  ASSERT_TRUE(write_file(path("x"), old));
  EXPECT_EQ(entries(), 1);
}

TEST_F(Files, WhatALivingProcessWritesIsLeftAlone) {
  const std::string other = path(".artisketch-" + std::to_string(::getppid()) + "-1.part");
  ASSERT_TRUE(write_file(other, "x"));
  fs::last_write_time(other, fs::file_time_type::clock::now() - std::chrono::hours(2));
  ASSERT_TRUE(write_file(path("y"), "x"));
  EXPECT_EQ(entries(), 2);
}

TEST_F(Files, APipeThatNobodyWritesToIsNotWaitedFor) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const auto nothing = read_file(path("pipe"));
  ASSERT_FALSE(nothing);
  EXPECT_NE(nothing.error().text().find("nobody writes"), std::string::npos);
  const pid_t child = ::fork();
  if (child == 0) {
    const int out = ::open(path("pipe").c_str(), O_WRONLY);
    ::usleep(20000);
    _exit(::write(out, "late", 4) == 4 ? 0 : 1);
  }
  EXPECT_EQ(*read_file(path("pipe")), "late");
  ::waitpid(child, nullptr, 0);
}

TEST_F(Files, OneFileIsKnownByAllItsNames) {
  ASSERT_TRUE(write_file(path("x"), "x"));
  fs::create_symlink("x", path("link"));
  fs::create_hard_link(path("x"), path("hard"));
  fs::create_directory(path("in"));
  for (const char* name : {"x", "link", "hard", "in/../x", "./x"})
    EXPECT_TRUE(same_file(path("x"), path(name))) << name;
  EXPECT_TRUE(same_file(path("new"), path("in/../new")));
  EXPECT_FALSE(same_file(path("x"), path("new")));
  EXPECT_FALSE(same_file(path("new"), path("in/new")));
  EXPECT_FALSE(same_file("/dev/null", "/dev/null"));
}

TEST_F(Files, AFolderNamesTheDocumentInIt) {
  ASSERT_TRUE(write_file(path("hero.artisketch"), "x"));
  EXPECT_NE(read_file(folder).error().text().find("is a folder; name the file in it that you mean, "
                                                  "like " +
                                                  path("hero.artisketch")),
            std::string::npos);
}

TEST_F(Files, AMissingFileSaysSo) {
  const auto missing = read_file(path("missing"));
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().text().find("missing: cannot be read: No such file"),
            std::string::npos);
  EXPECT_FALSE(read_file(folder));
}

TEST(Base64, RoundTripsEveryLength) {
  std::string bytes;
  for (int i = 0; i < 300; ++i) {
    EXPECT_EQ(*from_base64(base64(bytes)), bytes);
    bytes += char(i * 7);
  }
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
}

TEST(Base64, RefusesWhatIsNotBase64) {
  for (const char* text :
       {"Zg=", "Zg", "Zh==", "Zm9=", "Z===", "Zm 9", "====", "Zg==Zg==", "Zm9\n"})
    EXPECT_FALSE(from_base64(text)) << text;
}

}  // namespace
}  // namespace artisketch
