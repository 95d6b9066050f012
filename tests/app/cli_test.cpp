#include "app/cli.h"

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/command_line.h"
#include "app/progress_line.h"
#include "files/bytes.h"
#include "files/document_file.h"
#include "files/image_file.h"
#include "model/working_scale.h"

namespace artisketch {
namespace {

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
    for (const auto& [verb, to] :
         {std::pair("reconstruct", "out.glb"), std::pair("calibrate", "out.artisketch")}) {
      EXPECT_EQ(run({verb, in, "-o", path(to)}), 1) << c.text;
      EXPECT_NE(err.find(c.says), std::string::npos) << err;
      EXPECT_NE(err.find("bad.artisketch"), std::string::npos) << err;
      EXPECT_FALSE(fs::exists(path(to)));
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
  EXPECT_NE(err.find(".glb, .vrm, .obj, .stl or .ply"), std::string::npos) << err;
  EXPECT_FALSE(fs::exists(path("c.fbx")));
  for (const char* ending : {"obj", "stl", "ply"})
    EXPECT_EQ(run({"reconstruct", kCircles, "-o", path(std::string("c.") + ending), "--grid", "16",
                   "--no-texture"}),
              0)
        << err;
  EXPECT_EQ(read_file(path("c.ply"))->substr(0, 4), "ply\n");
}

TEST_F(CommandLine, ATraceShowsEachStepOfEitherMethod) {
  for (const std::string method : {"paper", "rays"}) {
    const std::string folder = path("trace-" + method);
    ASSERT_EQ(run({"reconstruct", kCircles, "-o", path("c.glb"), "--grid", "16", "--method", method,
                   "--trace", folder}),
              0)
        << err;
    std::vector<std::string> names;
    for (const auto& file : fs::directory_iterator(folder)) names.push_back(file.path().filename());
    const auto any = [&](const std::string& part) {
      return std::any_of(names.begin(), names.end(),
                         [&](const std::string& name) { return name.find(part) != name.npos; });
    };
    EXPECT_TRUE(any("surface.ply") && any(".nrrd") && any("skin.ply")) << method;
    EXPECT_EQ(any("rims.obj"), method == "paper");
  }
  // Once more into the same folder, and into none.
  EXPECT_EQ(run({"reconstruct", kCircles, "-o", path("c.glb"), "--grid", "16", "--trace",
                 path("trace-rays")}),
            0);
  EXPECT_EQ(run({"reconstruct", kCircles, "-o", path("c.glb"), "--trace", path("none/trace")}), 3);
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

TEST_F(CommandLine, WhatIsReadIsNeverReplaced) {
  const fs::path circles = folder_ / "circles";
  fs::copy(fs::path(kCircles).parent_path(), circles);
  const std::string in = (circles / "circles.artisketch").string();
  std::string drawing;
  for (const fs::directory_entry& entry : fs::directory_iterator(circles))
    if (entry.path().extension() == ".png") drawing = entry.path().string();
  ASSERT_FALSE(drawing.empty());
  fs::create_symlink(drawing, path("link.png"));
  const std::string before = *read_file(drawing), document_before = *read_file(in);
  for (const std::string& preview : {drawing, path("link.png")}) {
    EXPECT_EQ(run({"reconstruct", in, "-o", path("x.glb"), "--preview", preview}), 2);
    EXPECT_NE(err.find("would replace what is read"), std::string::npos) << err;
  }
  EXPECT_EQ(run({"reconstruct", in, "-o", path("x.glb"), "--calibrated", in}), 2);
  EXPECT_EQ(run({"calibrate", in, "-o", in}), 2);
  EXPECT_EQ(
      run({"reconstruct", in, "-o", path("x.glb"), "--report", path("r"), "--preview", path("r")}),
      2);
  EXPECT_NE(err.find("is the file of --report, too"), std::string::npos) << err;
  EXPECT_EQ(*read_file(drawing), before);
  EXPECT_EQ(*read_file(in), document_before);
  EXPECT_FALSE(fs::exists(path("x.glb")));
}

TEST_F(CommandLine, AnEndingOfAnotherKindIsRefused) {
  const std::vector<std::vector<std::string>> wrong = {
      {"reconstruct", kCircles, "-o", path("c.glb"), "--preview", path("p.jpg")},
      {"reconstruct", kCircles, "-o", path("c.glb"), "--report", path("r.glb")},
      {"reconstruct", kCircles, "-o", path("c.glb"), "--calibrated", path("c.PNG")},
      {"calibrate", kCircles, "-o", path("c.glb")},
      {"render", kCircles, "-o", path("r.jpg")}};
  for (const auto& arguments : wrong) {
    EXPECT_EQ(run(arguments), 2);
    EXPECT_NE(err.find("wanted a file that ends in"), std::string::npos) << err;
  }
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(CommandLine, AWrongWordIsAnsweredWithTheRightOne) {
  const struct {
    std::vector<std::string> arguments;
    const char* says;
  } cases[] = {
      {{"recon", "x.artisketch"}, "no such verb; did you mean reconstruct?"},
      {{"chekc", "x"}, "did you mean check?"},
      {{"paint"}, "The verbs are reconstruct, calibrate, check, render, sprites and skeleton"},
      {{kCircles}, "reconstruct "},
      {{"version"}, "did you mean artisketch --version?"},
      {{"reconstruct", kCircles, "-o", "x.glb", "--gird", "64"},
       "no option --gird; did you mean --grid?"},
      {{"reconstruct", kCircles, "--outptu", "x.glb"}, "did you mean --output?"},
      {{"check", kCircles, kHero}, "what is to be done with"},
  };
  for (const auto& c : cases) {
    EXPECT_EQ(run(c.arguments), 2) << c.says;
    EXPECT_NE(err.find(c.says), std::string::npos) << err;
  }
  const std::string picture = write("front.png", "\x89PNG\r\n\x1a\n and so on");
  EXPECT_EQ(run({"check", picture}), 1);
  EXPECT_NE(err.find("is a PNG picture, no sketch document"), std::string::npos) << err;
  EXPECT_EQ(run({"check", fs::path(kHero).parent_path().string()}), 1);
  EXPECT_NE(err.find("hero.artisketch"), std::string::npos) << err;
}

TEST_F(CommandLine, AnglesAreNumbers) {
  for (const char* angle : {"nan", "inf", "-inf", "1e400", "east", ""})
    for (const char* option : {"--yaw", "--pitch"})
      EXPECT_EQ(run({"render", "x.glb", "-o", path("r.png"), option, angle}), 2) << angle;
}

// What reconstruct can't work on, check says; but both read it: half a drawing is a document.
TEST_F(CommandLine, CheckFindsWhatReconstructFailsAt) {
  const std::string outline = "[[10,10],[90,10],[50,90]]";
  const std::string one = R"({"joint":"body","points":)" + outline + "}";
  const std::string line = R"({"joint":"body","closed":false,"points":)" + outline + "}";
  const std::string flat = R"({"joint":"body","closed":false,"points":[[10,10],[90,10]]})";
  const std::string flat_tip = R"({"joint":"tip","closed":false,"points":[[10,10],[90,10]]})";
  const std::string turned = R"({"joint":"body","points":[[50,90],[10,10],[90,10]]})";
  const auto with = [&](const std::string& contours) {
    return document(
        "1", R"("body")", "",
        R"([{"name":"front","size":[100,100],"pose":{"root_position":[0,0,0]},"contours":[)" +
            contours + "]}]");
  };
  const struct {
    std::string contours;
    const char* says;
  } cases[] = {{"", "no closed contour"},
               {flat, "no closed contour"},
               {one + "," + one, "cancel out"},
               {one + "," + turned, "cancel out"}};
  for (const auto& c : cases) {
    const std::string in = write("odd.artisketch", with(c.contours));
    EXPECT_EQ(run({"check", in}), 1);
    EXPECT_NE(err.find(c.says), std::string::npos) << err;
    EXPECT_NE(err.find("odd.artisketch: /frames"), std::string::npos) << err;
    EXPECT_EQ(run({"reconstruct", in, "-o", path("x.glb")}), 1);
    EXPECT_NE(err.find(c.says), std::string::npos) << err;
  }
  EXPECT_EQ(run({"check", write("good.artisketch", with(one + "," + line))}), 0) << err;
  EXPECT_NE(err.find("frame 1 'front': an open contour of 'body' shapes nothing"), err.npos) << err;
  std::string tip = line;
  tip.replace(tip.find("body"), 4, "tip");
  EXPECT_EQ(run({"check", write("tip.artisketch", with(one + "," + tip))}), 0) << err;
  EXPECT_NE(err.find("'tip' has open contours alone: they are closed by"), err.npos) << err;
  EXPECT_EQ(run({"check", write("tip.artisketch", with(one + "," + flat_tip))}), 0) << err;
  EXPECT_NE(err.find("none goes round an area: no part is made of it"), err.npos) << err;
  for (const std::string& more : {line, flat_tip}) {
    for (const auto& [contours, to] :
         {std::pair(one, "a.ply"), std::pair(one + "," + more, "b.ply")})
      EXPECT_EQ(run({"reconstruct", write("c.artisketch", with(contours)), "-o", path(to), "--grid",
                     "16"}),
                0)
          << err;
    EXPECT_EQ(*read_file(path("a.ply")), *read_file(path("b.ply"))) << more;
  }
}

// A body and an arm in two drawings, whose unit is so many pixels.
std::string two_views(const std::string& pixels_per_unit) {
  const auto frame = [](const std::string& turned, const std::string& x0, const std::string& x1) {
    return R"({"size":[256,256],"pose":{"root_position":[0,0,0],"rotations":{"body":)" + turned +
           R"(}},"contours":[{"joint":"body","points":[[)" + x0 + ",78],[" + x1 + ",78],[" + x1 +
           ",178],[" + x0 + R"(,178]]},{"joint":"arm","points":[[118,90],[138,90],[138,110]]}]})";
  };
  return R"({"artisketch":1,"camera":{"type":"orthographic","pixels_per_unit":)" + pixels_per_unit +
         R"(},"skeleton":{"joints":[{"name":"body","parent":null,"offset":[0,0,0]},)"
         R"({"name":"arm","parent":"body","offset":[0.2,0.28,0]}]},"frames":[)" +
         frame("[0,0,0,1]", "108", "148") + "," +
         frame("[0,0.7071067811865476,0,0.7071067811865476]", "113", "143") + "]}";
}

TEST_F(CommandLine, ScenesOfAnySizeEndInAModelOrAnErrorThatNamesTheFile) {
  for (const char* scale : {"1e-300", "1e-9", "1e-3", "200000", "1e9"}) {
    SCOPED_TRACE(scale);
    const std::string in = write("scale.artisketch", two_views(scale));
    const int status = run({"reconstruct", in, "-o", path("x.glb"), "--grid", "16", "--quiet"});
    EXPECT_TRUE(status == 0 || err.find(in + ": ") != err.npos) << err;
    EXPECT_TRUE(status == 0 || status == 1) << status;
  }
}

// Whose part has no rims then.
TEST_F(CommandLine, ACameraInTheMidstOfWhatIsDrawnIsNoWantOfMemory) {
  std::string text = two_views("100");
  const std::string camera = R"("orthographic","pixels_per_unit":100)";
  text.replace(text.find(camera), camera.size(),
               R"("perspective","focal_length":1.04,"distance":0.004)");
  text.replace(text.find("0.2,0.28,0"), 10, "0.2,0.28,-1");
  const std::string in = write("near.artisketch", text);
  run({"reconstruct", in, "-o", path("x.glb"), "--grid", "16", "--quiet"});
  EXPECT_EQ(err.find("memory"), err.npos) << err;
}

TEST_F(CommandLine, MotionIsSaidToBeLeftOutOfASurface) {
  EXPECT_EQ(run({"reconstruct", kCircles, "-o", path("c.obj"), "--motion", "walk.bvh", "--grid",
                 "16", "--no-texture"}),
            0)
      << err;
  EXPECT_NE(err.find("--motion walk.bvh: is left out"), std::string::npos) << err;
}

TEST_F(CommandLine, CompressedModelsAreTheSameInFewerBytes) {
  const auto make = [&](const std::string& name, std::vector<std::string> more) {
    std::vector<std::string> words{"reconstruct", kCircles, "-o", path(name), "--grid", "16"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  };
  EXPECT_EQ(make("c.glb", {}), 0) << err;
  EXPECT_EQ(make("small.glb", {"--compress"}), 0) << err;
  EXPECT_LT(fs::file_size(path("small.glb")), fs::file_size(path("c.glb")) / 2);
  EXPECT_EQ(run({"render", path("small.glb"), "-o", path("small.png")}), 0) << err;
  EXPECT_EQ(make("c.obj", {"--compress"}), 2);
  EXPECT_NE(err.find("--compress: there is nothing to pack in a .obj"), std::string::npos) << err;
}

TEST_F(CommandLine, AFailedRunLeavesTheSideOutputsToo) {
  write("r.json", "precious");
  write("p.png", "precious");
  fs::create_symlink("/dev/full", path("c.glb"));
  EXPECT_EQ(run({"reconstruct", kCircles, "-o", path("c.glb"), "--grid", "16", "--no-texture",
                 "--report", path("r.json"), "--preview", path("p.png")}),
            3);
  EXPECT_EQ(*read_file(path("r.json")), "precious");
  EXPECT_EQ(*read_file(path("p.png")), "precious");
}

TEST_F(Limited, AFileThatMayNotGrowIsAnError) {
  EXPECT_EQ(
      run_with(RLIMIT_FSIZE, 10000,
               {"reconstruct", kCircles, "-o", path("c.glb"), "--grid", "24", "--no-texture"}),
      3);
  EXPECT_NE(err.find("c.glb: cannot be written: File too large"), std::string::npos) << err;
  EXPECT_TRUE(fs::is_empty(folder_));
}

#if !defined(__SANITIZE_ADDRESS__)  // which takes terabytes of addresses
// docs/FORMAT.md's formula, where parts, the grid or the drawings take the most.
TEST_F(Limited, MemoryStaysWithinWhatTheFormatSays) {
  constexpr int kLarger = 6;
  Result<Document> hero = read_document(kHero);
  ASSERT_TRUE(hero);
  double pixels = 0, larger_pixels = 0;
  Document larger = scaled(*hero, kLarger);
  for (std::size_t f = 0; f < larger.frames.size(); ++f) {
    Frame& frame = larger.frames[f];
    const Result<Image> drawing = load_frame_image(hero->frames[f], kHero);
    ASSERT_TRUE(drawing);
    pixels += double(drawing->width) * drawing->height;
    larger_pixels += double(frame.width) * frame.height;
    ASSERT_TRUE(write_file(path(frame.image), png_bytes(scaled(*drawing, kLarger))));
  }
  ASSERT_TRUE(write_file(path("larger.artisketch"), document_text(larger)));
  const int parts = int(drawn_joints(*hero).size());
  const struct {
    std::string in;
    int parts, grid;
    double pixels;
  } cases[] = {{kHero, parts, 100, pixels},
               {kCircles, 1, 300, 0},
               {path("larger.artisketch"), parts, 48, larger_pixels}};
  for (const auto& one : cases) {
    ASSERT_EQ(run_with(RLIMIT_AS, 8ull << 30,
                       {"reconstruct", one.in, "-o", path("h.glb"), "--grid",
                        std::to_string(one.grid), "--quiet"}),
              0)
        << err;
    EXPECT_LT(most_memory, 250e6 + one.parts * 6 * std::pow(one.grid + 5, 3) + 8 * one.pixels)
        << one.in;
  }
}

TEST_F(Limited, TooLittleMemoryIsAnErrorThatSaysWhatToDo) {
  EXPECT_EQ(run_with(RLIMIT_AS, 120 << 20,
                     {"reconstruct", kHero, "-o", path("h.glb"), "--grid", "400", "--no-texture",
                      "--no-calibrate", "--quiet"}),
            1);
  EXPECT_NE(err.find("not enough memory for a grid of 400; try 266"), std::string::npos) << err;
  EXPECT_TRUE(fs::is_empty(folder_));
}

// FORMAT.md, "Limits": 250 MB, and per part 6 bytes times (grid + 5)³; the drawings are left out.
TEST_F(Limited, MemoryStaysWithinWhatFormatPromises) {
  const double grid = 64, parts = 15;
  const double bound = 250e6 + 6 * parts * std::pow(grid + 5, 3);
  EXPECT_EQ(run_with(RLIMIT_AS, rlim_t(bound),
                     {"reconstruct", kHero, "-o", path("h.glb"), "--grid", "64", "--no-texture",
                      "--no-calibrate", "--quiet"}),
            0)
      << err;
}
#endif

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

// As Files.ASaveThatIsKilledLeavesOldOrNew; ARTISKETCH_KILLS says how often.
TEST_F(CommandLine, AnExportThatIsKilledLeavesOldOrNew) {
  const std::string glb = path("c.glb"), report = path("c.json");
  const auto export_to = [&](const std::string& model) {
    return std::vector<std::string>{"reconstruct", kCircles,  "-o",       model,  "--grid",
                                    "16",          "--quiet", "--report", report, "--no-texture"};
  };
  ASSERT_EQ(run(export_to(glb)), 0) << err;
  const std::string whole = *read_file(glb), old = "precious";
  const char* asked = std::getenv("ARTISKETCH_KILLS");
  const int kills = asked ? std::atoi(asked) : 12;
  std::mt19937 random(1);
  for (int i = 0; i < kills; ++i) {
    ASSERT_TRUE(write_file(glb, old));
    const pid_t child = fork();
    if (child == 0) {
      std::vector<std::string> words = export_to(glb);
      words.insert(words.begin(), "artisketch");
      std::vector<char*> argv;
      for (std::string& word : words) argv.push_back(word.data());
      argv.push_back(nullptr);
      execv(ARTISKETCH_CLI, argv.data());
      _exit(127);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 600));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const std::string left = *read_file(glb);
    ASSERT_TRUE(left == old || left == whole) << left.size();
  }
}

TEST_F(CommandLine, AMotionFromElsewhereAndClipsOfTheLibrary) {
  const std::string wave =
      write("wave.bvh",
            "HIERARCHY\nROOT mixamorig:Hips\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition "
            "Yposition Zposition Zrotation Xrotation Yrotation\nJOINT "
            "mixamorig:LeftArm\n{\nOFFSET 20 50 0\nCHANNELS 3 Zrotation Xrotation "
            "Yrotation\nJOINT mixamorig:LeftForeArm\n{\nOFFSET 30 0 0\nCHANNELS "
            "0\n}\n}\n}\nMOTION\nFrames: 3\nFrame Time: 0.1\n"
            "0 90 0 0 0 0 0 0 0\n0 90 0 0 0 0 45 0 0\n");
  EXPECT_EQ(run({"reconstruct", kHero, "-o", path("h.glb"), "--no-calibrate", "--grid", "24",
                 "--no-texture", "--motion", wave, "--clip", "walk:stride=0.8", "--clip", "idle",
                 "--report", path("r.json")}),
            0)
      << err;
  EXPECT_NE(err.find("says that it has 3 frames"), std::string::npos) << err;
  EXPECT_NE(err.find("moves nothing of"), std::string::npos) << err;
  EXPECT_NE(out.find("motion wave:"), std::string::npos) << out;
  const std::string report = *read_file(path("r.json"));
  EXPECT_NE(report.find("\"by\": \"mixamorig:LeftArm\""), std::string::npos);
  EXPECT_NE(report.find("\"how\": \"named\""), std::string::npos);
  EXPECT_EQ(run({"sprites", path("h.glb"), "-o", path("s.png"), "--clip", "walk", "--directions",
                 "4", "--size", "32", "--rate", "4"}),
            0)
      << err;
  EXPECT_TRUE(fs::exists(path("s.png")));
  EXPECT_NE(read_file(path("s.json"))->find("\"image\": \"s.png\""), std::string::npos);
  EXPECT_EQ(run({"sprites", path("h.glb"), "-o", path("s.png"), "--clip", "fly"}), 1);
  EXPECT_NE(err.find("frames, wave, walk, idle"), std::string::npos) << err;
  EXPECT_EQ(run({"reconstruct", kHero, "-o", path("h.glb"), "--clip", "trot"}), 2);
  EXPECT_NE(err.find("there are idle, walk, run, jump, wave, sit"), std::string::npos) << err;
  EXPECT_EQ(run({"reconstruct", kHero, "-o", path("h.glb"), "--clip", "walk:pace=2"}), 2);
}

TEST_F(CommandLine, ARigOfOnesOwnBeginsADocument) {
  ASSERT_EQ(run({"reconstruct", kHero, "-o", path("h.glb"), "--grid", "16", "--no-texture"}), 0)
      << err;
  ASSERT_EQ(run({"skeleton", path("h.glb"), "-o", path("own.artisketch")}), 0) << err;
  const Result<Document> own = read_document(path("own.artisketch")), hero = read_document(kHero);
  ASSERT_TRUE(own) << own.error().text();
  ASSERT_TRUE(hero);
  ASSERT_EQ(own->skeleton.size(), hero->skeleton.size());
  for (int j = 0; j < own->skeleton.size(); ++j) {
    EXPECT_EQ(own->skeleton.joints[j].name, hero->skeleton.joints[j].name);
    EXPECT_EQ(own->skeleton.joints[j].mirror, hero->skeleton.joints[j].mirror);
    EXPECT_LT((own->skeleton.joints[j].offset - hero->skeleton.joints[j].offset).norm(), 1e-5);
  }
  EXPECT_EQ(run({"skeleton", kHero, "-o", path("no.artisketch")}), 1);
  EXPECT_FALSE(fs::exists(path("no.artisketch")));
}

TEST_F(CommandLine, AnAvatarWantsAPersonAndSomebodyWhoMadeIt) {
  const std::string kept = path("a.vrm");
  EXPECT_EQ(run({"reconstruct", kHero, "-o", kept}), 1);
  EXPECT_NE(err.find("/about: is missing"), std::string::npos) << err;
  EXPECT_EQ(run({"reconstruct", kHero, "-o", kept, "--rig", "unity"}), 2);
  std::string text = document();
  text.insert(text.find("\"camera\""), R"("about":{"authors":["Ann"]},)");
  text.replace(text.find(R"("parent":null,"offset":[0,1,0])"), 13, R"("parent":"body")");
  EXPECT_EQ(run({"reconstruct", write("blob.artisketch", text), "-o", kept}), 1);
  EXPECT_NE(err.find("no person"), std::string::npos) << err;
  EXPECT_FALSE(fs::exists(kept));
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
