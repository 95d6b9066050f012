#include "app/many_documents.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <sys/wait.h>

#include "app/command_line.h"
#include "files/bytes.h"

namespace artisketch {
namespace {

class ManyDocuments : public Limited {
 protected:
  // The circles, which take no time, under another name; their drawings beside them.
  std::string circles(const std::string& name, const std::string& in_folder = "in") {
    const fs::path folder = path(in_folder);
    fs::copy(fs::path(kCircles).parent_path(), folder,
             fs::copy_options::recursive | fs::copy_options::skip_existing);
    fs::remove(folder / "circles.artisketch");
    std::string text = *read_file(kCircles);
    text.insert(text.find("\"skeleton\""), R"("settings":{"grid":16},)");
    return write(in_folder + "/" + name + ".artisketch", text);
  }
  int reconstruct(std::vector<std::string> words) {
    words.insert(words.begin(), "reconstruct");
    words.push_back("--no-texture");
    return run(words);
  }
  nlohmann::json report() { return nlohmann::json::parse(*read_file(path("all.json"))); }
};

TEST_F(ManyDocuments, BecomeWhatEachBecomesByItself) {
  const std::string a = circles("a"), b = circles("b"), c = circles("c");
  ASSERT_EQ(reconstruct({a, b, c, "-o", path("models/"), "--jobs", "2", "--report",
                         path("all.json"), "--calibrated", path("posed/")}),
            0)
      << err;
  fs::create_directory(path("apart"));
  ASSERT_EQ(reconstruct({a, "-o", path("apart/a.glb"), "--calibrated", path("apart/a.artisketch")}),
            0)
      << err;
  for (const std::string name : {"a", "b", "c"}) {
    EXPECT_EQ(*read_file(path("models/" + name + ".glb")), *read_file(path("apart/a.glb")));
    EXPECT_EQ(*read_file(path("posed/" + name + ".artisketch")),
              *read_file(path("apart/a.artisketch")));
  }
  const nlohmann::json all = report()["documents"];
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[1]["in"], b) << "in the order in which they were named";
  EXPECT_EQ(all[1]["out"], path("models/b.glb"));
  EXPECT_EQ(all[1]["became"], "made");
  EXPECT_GT(all[1]["report"]["frames"][0]["iou"], 0.9);
}

TEST_F(ManyDocuments, OnesFaultLeavesTheOthersAndIsTheStatus) {
  const std::string good = circles("good"), bad = write("bad.artisketch", "{"),
                    gone = path("gone.artisketch");
  EXPECT_EQ(reconstruct({bad, good, gone, "-o", path("models/"), "--report", path("all.json")}), 1);
  EXPECT_TRUE(fs::exists(path("models/good.glb")));
  EXPECT_NE(err.find(bad + ": line 1"), err.npos) << err;
  EXPECT_NE(err.find("not made: " + gone), err.npos) << err;
  EXPECT_NE(out.find("3 documents: 1 made, 0 there already, 2 failed"), out.npos) << out;
  const nlohmann::json all = report()["documents"];
  EXPECT_EQ(all[0]["became"], "failed");
  EXPECT_EQ(all[0]["exit"], 1);
  EXPECT_NE(all[0]["errors"][0].get<std::string>().find("line 1"), std::string::npos);
  EXPECT_TRUE(all[0]["report"].is_null());
  EXPECT_EQ(all[1]["became"], "made");
}

TEST_F(ManyDocuments, WhatIsThereCanBeLeftOut) {
  const std::string a = circles("a"), b = circles("b");
  fs::create_directory(path("models"));
  write("models/a.glb", "precious");
  EXPECT_EQ(
      reconstruct({a, b, "-o", path("models"), "--skip-existing", "--report", path("all.json")}), 0)
      << err;
  EXPECT_EQ(*read_file(path("models/a.glb")), "precious");
  EXPECT_TRUE(fs::exists(path("models/b.glb")));
  EXPECT_EQ(report()["documents"][0]["became"], "there already");
  EXPECT_EQ(reconstruct({a, "-o", path("models/a.glb"), "--skip-existing"}), 0);
  EXPECT_EQ(*read_file(path("models/a.glb")), "precious");
  EXPECT_EQ(reconstruct({a, b, "-o", path("models")}), 0) << err;
  EXPECT_NE(*read_file(path("models/a.glb")), "precious");
}

TEST_F(ManyDocuments, OneNameTwiceAndWhatWouldReplaceInputsIsRefusedBeforeAnyWork) {
  const std::string a = circles("a"), b = circles("b"), other = circles("a", "other");
  EXPECT_EQ(reconstruct({a, b, other, "-o", path("models/")}), 2);
  EXPECT_NE(err.find(other + ": would become " + path("models/a.glb")), err.npos) << err;
  EXPECT_EQ(reconstruct({b, a, "-o", path("models/"), "--calibrated", path("in/")}), 2);
  EXPECT_NE(err.find("would replace what is read from"), err.npos) << err;
  // One document's picture would take the place of another's drawing, front.png.
  EXPECT_EQ(reconstruct({a, circles("front"), "-o", path("models/"), "--preview", path("in/")}), 2);
  EXPECT_NE(err.find("would replace what is read from " + path("in/front.png")), err.npos) << err;
  EXPECT_EQ(reconstruct({a, b, "-o", path("one.glb")}), 2);
  EXPECT_NE(err.find("2 documents go to a folder"), err.npos) << err;
  EXPECT_EQ(reconstruct({a, b, "-o", path("models/"), "--preview", path("p.png")}), 2);
  EXPECT_EQ(reconstruct({a, b, "-o", path("no/models/")}), 3);
  EXPECT_EQ(reconstruct({a, b, "-o", path("models/"), "--jobs", "0"}), 2);
  EXPECT_FALSE(fs::exists(path("models")));
}

TEST_F(ManyDocuments, AClipTakesNoDocumentForAnother) {
  const std::string a = circles("a"), b = circles("b");
  EXPECT_EQ(
      reconstruct({"--clip", "dance", a, b, "-o", path("models/"), "--report", path("all.json")}),
      2);
  EXPECT_EQ(report()["documents"].size(), 2u);
}

TEST_F(ManyDocuments, OneThatIsKilledLeavesTheOthers) {
  std::string large = *read_file(kHero);
  large.insert(large.find("\"skeleton\""), R"("settings":{"grid":400,"method":"paper"},)");
  const std::string a = circles("a"), killed = write("in/killed.artisketch", large),
                    z = circles("z");
  constexpr rlim_t kSeconds = 1;  // of computing, for each process
  EXPECT_EQ(run_with(RLIMIT_CPU, kSeconds,
                     {"reconstruct", a, killed, z, "-o", path("models/"), "--no-texture",
                      "--report", path("all.json")}),
            1);
  const nlohmann::json all = report()["documents"];
  EXPECT_EQ(all[0]["became"], "made");
  EXPECT_EQ(all[1]["became"], "failed");
  EXPECT_NE(all[1]["errors"].dump().find("ended by a signal"), std::string::npos) << all[1];
  EXPECT_EQ(all[2]["became"], "made");
  EXPECT_FALSE(fs::exists(path("models/killed.glb")));
}

TEST_F(ManyDocuments, AskedToStopTheyAllDo) {
  fs::copy(fs::path(kHero).parent_path(), path("in"));
  for (const char* name : {"in/b.artisketch", "in/c.artisketch"}) fs::copy_file(kHero, path(name));
  const std::string hero = path("in/hero.artisketch"), b = path("in/b.artisketch"),
                    c = path("in/c.artisketch"), models = path("models/"),
                    report_path = path("all.json");
  const pid_t child = fork();
  if (child == 0) {
    execl(ARTISKETCH_CLI, "artisketch", "reconstruct", hero.c_str(), b.c_str(), c.c_str(), "-o",
          models.c_str(), "--method", "paper", "--grid", "200", "--quiet", "--jobs", "2",
          "--report", report_path.c_str(), nullptr);
    _exit(127);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  kill(child, SIGTERM);  // the program alone, and not what it began
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_TRUE(fs::is_empty(models));
  const nlohmann::json all = report()["documents"];
  EXPECT_EQ(all[0]["exit"], 130);
  EXPECT_EQ(all[2]["became"], "not begun");
}

}  // namespace
}  // namespace artisketch
