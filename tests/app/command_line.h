// The command line in the tests' own process, with a folder that goes afterwards.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "app/cli.h"

namespace artisketch {

namespace fs = std::filesystem;

inline const std::string kCircles =
    ARTISKETCH_SOURCE_DIR "/assets/examples/circles/circles.artisketch";
inline const std::string kHero = ARTISKETCH_SOURCE_DIR "/assets/examples/hero/hero.artisketch";

class CommandLine : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("artisketch-cli-" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
    return path(name);
  }
  // Runs the command; its exit status, and what it said in `out` and `err`.
  int run(const std::vector<std::string>& arguments) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int status = run_cli(arguments);
    out = testing::internal::GetCapturedStdout();
    err = testing::internal::GetCapturedStderr();
    return status;
  }

  fs::path folder_;
  std::string out, err;
};

}  // namespace artisketch
