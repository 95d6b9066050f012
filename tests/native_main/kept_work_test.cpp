#include "native_main/kept_work.h"

#include <chrono>
#include <fstream>
#include <memory>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "files/bytes.h"

namespace artisketch {
namespace {
namespace fs = std::filesystem;

bool whole(const std::string& text) {
  return text.starts_with("whole");
}

class Kept : public testing::Test {
 protected:
  Kept() {
    std::string name = (fs::temp_directory_path() / "artisketch-kept-XXXXXX").string();
    folder = ::mkdtemp(name.data());
  }
  ~Kept() override { fs::remove_all(folder); }

  void put(const std::string& name, const std::string& bytes, int minutes_ago) {
    std::ofstream(folder / name) << bytes;
    fs::last_write_time(folder / name,
                        fs::file_time_type::clock::now() - std::chrono::minutes(minutes_ago));
  }
  // What a window that died kept.
  void leave(const std::string& bytes) {
    const pid_t child = ::fork();
    if (child == 0) {
      KeptWork work(folder);
      ::_exit(work.keep(bytes) ? 0 : 1);
    }
    int status = 1;
    ::waitpid(child, &status, 0);
    ASSERT_EQ(status, 0);
  }

  fs::path folder;
};

TEST_F(Kept, WhatADeadWindowLeftIsFoundUntilItIsForgotten) {
  leave("whole work");
  {
    KeptWork next(folder);
    EXPECT_EQ(next.left_behind(whole), "whole work");
    ASSERT_TRUE(next.keep("whole new work"));  // before the person has answered
  }
  KeptWork after(folder);
  EXPECT_EQ(after.left_behind(whole), "whole new work");
  after.forget_left();
  EXPECT_EQ(after.left_behind(whole), "whole work");
  after.forget_left();
  EXPECT_EQ(after.left_behind(whole), "");
}

TEST_F(Kept, TheNewestThatIsWholeIsTaken) {
  put("autosave-999998", "whole, older", 20);
  put("autosave-999999", "whole, newer", 10);
  put("autosave-999999.part-999999", "who", 5);  // as an earlier version left half of one
  put("autosave-999997", "who", 1);              // damaged
  KeptWork work(folder);
  EXPECT_EQ(work.left_behind(whole), "whole, newer");
  EXPECT_TRUE(fs::exists(folder / "autosave-999997"));
}

// Process 1 always lives, and has long been another one than the window that kept this.
TEST_F(Kept, ANumberThatAnotherProcessHasNowHidesNothing) {
  put("autosave-1", "whole", 10);
  put("autosave-1.lock", "", 10);
  EXPECT_EQ(KeptWork(folder).left_behind(whole), "whole");
}

TEST_F(Kept, WhatALivingWindowKeepsIsItsOwn) {
  auto one = std::make_unique<KeptWork>(folder);
  ASSERT_TRUE(one->keep("whole one"));
  KeptWork two(folder);
  ASSERT_TRUE(two.keep("whole two"));
  EXPECT_EQ(two.left_behind(whole), "");
  one.reset();
  EXPECT_EQ(two.left_behind(whole), "whole one");
}

TEST_F(Kept, WhatIsForgottenIsGone) {
  KeptWork work(folder);
  ASSERT_TRUE(work.keep("whole"));
  ASSERT_TRUE(work.keep(""));
  EXPECT_EQ(KeptWork(folder).left_behind(whole), "");
}

TEST_F(Kept, AFolderThatCantBeHadIsSaidWhenSomethingIsKept) {
  put("file", "", 0);
  KeptWork work(folder / "file" / "kept");
  EXPECT_EQ(work.left_behind(whole), "");
  EXPECT_FALSE(work.keep("whole"));
}

}  // namespace
}  // namespace artisketch
