#include "app/cli.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/progress_line.h"
#include "files/bytes.h"

namespace artisketch {
namespace {

namespace fs = std::filesystem;

const std::string kCircles = ARTISKETCH_SOURCE_DIR "/assets/examples/circles/circles.artisketch";
const std::string kHero = ARTISKETCH_SOURCE_DIR "/assets/examples/hero/hero.artisketch";

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

// A document of one joint with `fields` in place of what they name.
std::string document(const std::string& version = "1", const std::string& parent = "null",
                     const std::string& contour = "[[10,10],[90,10],[50,90]]",
                     const std::string& frames = "") {
  const std::string frame =
      R"({"name":"front","size":[100,100],"pose":{"root_position":[0,0,0]},"contours":[{"joint":"body","points":)" +
      contour + "}]}";
  return R"({"artisketch":)" + version +
         R"(,"name":"x","camera":{"type":"orthographic","pixels_per_unit":50},)" +
         R"("skeleton":{"joints":[{"name":"body","parent":null,"offset":[0,0,0]},{"name":"tip","parent":)" +
         parent + R"(,"offset":[0,1,0]}]},"frames":)" +
         (frames.empty() ? "[" + frame + "]" : frames) + "}";
}

TEST_F(CommandLine, EveryFaultOfADocumentIsNamedAndNothingIsWritten) {
  const std::string good = document("1", R"("body")");
  const struct {
    std::string text, says;
  } cases[] = {
      {document("1", R"("torso")"), "/skeleton/joints/1/parent"},
      {document("1", R"("body")", "[[10,10],[NaN,10],[50,90]]"), "is NaN"},
      {document("1", R"("body")", "[[10,10],[null,10],[50,90]]"), "/frames/0/contours/0/points/1"},
      {document("1", R"("body")", "[[10,10],[90,10]]"), "/frames/0/contours/0/points"},
      {document("1", R"("body")", "[[10,10],[90,90],[90,10],[10,90]]"),
       "crosses itself near (50, 50)"},
      {document("1", R"("body")", "", "[]"), "/frames"},
      {document("2", R"("body")"), "/artisketch"},
      {good.substr(0, good.size() / 2), "line 1"},
      {"", "line 1"},
  };
  for (const auto& c : cases) {
    const std::string in = write("bad.artisketch", c.text);
    for (const std::string verb : {"reconstruct", "calibrate"}) {
      EXPECT_EQ(run({verb, in, "-o", path("out.glb")}), 1) << c.text;
      EXPECT_NE(err.find(c.says), std::string::npos) << err;
      EXPECT_NE(err.find("bad.artisketch"), std::string::npos) << err;
      EXPECT_FALSE(fs::exists(path("out.glb")));
    }
    EXPECT_EQ(run({"check", in}), 1);
  }
  EXPECT_EQ(run({"check", write("good.artisketch", good)}), 0) << err;
}

TEST_F(CommandLine, AllFaultsComeInOnePass) {
  const std::string in = write("bad.artisketch", document("1", R"("torso")", "[[10,10],[90,10]]"));
  EXPECT_EQ(run({"check", in}), 1);
  EXPECT_NE(err.find("/skeleton/joints/1/parent"), std::string::npos) << err;
  EXPECT_NE(err.find("/frames/0/contours/0/points"), std::string::npos) << err;
}

TEST_F(CommandLine, ABadCommandLineIsStatusTwo) {
  EXPECT_EQ(run({}), 2);
  EXPECT_EQ(run({"reconstruct", kCircles}), 2);
  EXPECT_EQ(run({"reconstruct", kCircles, "-o", path("x.glb"), "--grid", "7"}), 2);
  EXPECT_EQ(run({"paint", kCircles}), 2);
  EXPECT_EQ(run({"--help"}), 0);
  EXPECT_EQ(run({"--version"}), 0);
  EXPECT_EQ(out.rfind("ArtiSketch ", 0), 0u);
}

TEST_F(CommandLine, TheOutputsEndingChoosesItsFormat) {
  EXPECT_EQ(run({"reconstruct", kCircles, "-o", path("c.fbx"), "--grid", "16"}), 2);
  EXPECT_NE(err.find(".glb, .obj, .stl or .ply"), std::string::npos) << err;
  EXPECT_FALSE(fs::exists(path("c.fbx")));
  for (const char* ending : {"obj", "stl", "ply"})
    EXPECT_EQ(run({"reconstruct", kCircles, "-o", path(std::string("c.") + ending), "--grid", "16",
                   "--no-texture"}),
              0)
        << err;
  EXPECT_EQ(read_file(path("c.ply"))->substr(0, 4), "ply\n");
}

TEST_F(CommandLine, AMissingFileAndAMissingFolderAreToldApart) {
  EXPECT_EQ(run({"reconstruct", path("none.artisketch"), "-o", path("x.glb")}), 1);
  EXPECT_EQ(run({"reconstruct", kCircles, "-o", path("none/x.glb")}), 3);
  EXPECT_NE(err.find("does not exist"), std::string::npos);
}

TEST_F(CommandLine, ReconstructsReportsPreviewsAndDraws) {
  ASSERT_EQ(run({"reconstruct", kCircles, "-o", path("c.glb"), "--grid", "32", "--report",
                 path("c.json"), "--preview", path("c.png"), "--calibrated", path("c.artisketch")}),
            0)
      << err;
  for (const char* file : {"c.glb", "c.json", "c.png", "c.artisketch"})
    EXPECT_TRUE(fs::exists(path(file))) << file;
  EXPECT_EQ(std::count(out.begin(), out.end(), '\n'), 4) << out;
  EXPECT_NE(out.find("from sides not drawn: good"), std::string::npos) << out;
  EXPECT_EQ(run({"check", path("c.artisketch")}), 0) << "its drawings are still found: " << err;
  EXPECT_EQ(run({"render", path("c.glb"), "-o", path("r.png"), "--frame", "2", "--size", "64x48"}),
            0)
      << err;
  EXPECT_EQ(
      run({"render", path("c.glb"), "-o", path("t.png"), "--turntable", "3", "--size", "64x64"}), 0)
      << err;
  EXPECT_EQ(run({"render", path("c.glb"), "-o", path("r.png"), "--frame", "9"}), 2);
  EXPECT_EQ(run({"render", path("c.glb"), "-o", path("r.png"), "--size", "big"}), 2);
  EXPECT_EQ(run({"render", kCircles, "-o", path("q.png")}), 1);
  EXPECT_FALSE(fs::exists(path("q.png")));
}

TEST_F(CommandLine, AFailedRunLeavesTheOldResult) {
  write("out.glb", "precious");
  EXPECT_EQ(run({"reconstruct", write("bad.artisketch", "{"), "-o", path("out.glb")}), 1);
  EXPECT_EQ(read_file(path("out.glb")).value(), "precious");
}

TEST_F(CommandLine, CtrlCStopsItAndLeavesNoFile) {
  const std::string out_path = path("hero.glb");
  const pid_t child = fork();
  if (child == 0) {
    execl(ARTISKETCH_CLI, "artisketch", "reconstruct", kHero.c_str(), "-o", out_path.c_str(),
          "--method", "paper", "--grid", "200", "--quiet", nullptr);
    _exit(127);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  kill(child, SIGINT);
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST(ProgressLine, SaysStagePartAndTimeLeft) {
  Progress p;
  p.stage = "surfaces";
  p.item = "forearm.L";
  p.part = 6;
  p.parts = 15;
  p.fraction = 0.5;
  const std::string text = progress_text(p, 12, 10);
  EXPECT_EQ(text, "surfaces: forearm.L (7 of 15) █████░░░░░ 50 %, 12 s left");
}

}  // namespace
}  // namespace artisketch
