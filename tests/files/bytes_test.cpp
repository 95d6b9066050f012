#include "files/bytes.h"

#include <filesystem>

#include <gtest/gtest.h>
#include <sys/stat.h>
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
