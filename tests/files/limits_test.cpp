// docs/FORMAT.md's table of limits: what lies at one is read, what lies beyond is refused in words.
#include <filesystem>
#include <functional>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "files/bvh_file.h"
#include "files/bytes.h"
#include "files/document_file.h"

namespace artisketch {
namespace {

// `count` pieces, with commas between them.
std::string list(int count, const std::function<std::string(int)>& piece) {
  std::string all;
  for (int i = 0; i < count; ++i) all += (i ? "," : "") + piece(i);
  return all;
}
std::string list(int count, const std::string& piece) {
  return list(count, [&](int) { return piece; });
}

struct Numbers {
  int joints = 1, frames = 1, contours = 1, points = 3, keys = 1, side = 100;
  std::string coordinate = "0", length = "0", scale = "100", grid = "100", triangles = "1000";
};

std::string document(const Numbers& n) {
  const std::string pose = R"("pose":{"root_position":[0,0,0]})";
  const std::string points = list(n.points, [&](int i) {
    return "[" + (i ? std::to_string(i) : n.coordinate) + "," + std::to_string(i % 2) + "]";
  });
  const std::string contours =
      list(n.contours, R"({"joint":"j0","closed":false,"points":[)" + points + "]}");
  const std::string side = std::to_string(n.side);
  return R"({"artisketch":1,"camera":{"type":"orthographic","pixels_per_unit":)" + n.scale +
         R"(},"skeleton":{"joints":[)" +
         list(n.joints,
              [&](int j) {
                const std::string name = std::to_string(j);
                return R"({"name":"j)" + name + R"(","parent":)" + (j ? "\"j0\"" : "null") +
                       R"(,"offset":[0,0,)" + n.length + "]}";
              }) +
         R"(]},"frames":[)" +
         list(n.frames, R"({"size":[)" + side + "," + side + "]," + pose + R"(,"contours":[)" +
                            contours + "]}") +
         R"(],"animations":[{"name":"a","keys":[)" +
         list(n.keys, [&](int k) { return R"({"time":)" + std::to_string(k) + "," + pose + "}"; }) +
         R"(]}],"settings":{"grid":)" + n.grid + R"(,"triangles":)" + n.triangles + "}}";
}

struct Limit {
  const char* what;
  std::function<void(Numbers&)> at, beyond;
  const char* said;
};

TEST(Limits, OfADocumentAreKeptAndSaid) {
  const Limit limits[] = {
      {"joints", [](Numbers& n) { n.joints = 1000; }, [](Numbers& n) { n.joints = 1001; },
       "/skeleton/joints: is an array of 1001 values; should be one of at most 1000"},
      {"frames", [](Numbers& n) { n.frames = 1000; }, [](Numbers& n) { n.frames = 1001; },
       "/frames: is an array of 1001 values; should be one of at most 1000"},
      {"contours", [](Numbers& n) { n.contours = 20000; }, [](Numbers& n) { n.contours = 20001; },
       "/frames/0/contours: is an array of 20001 values; should be one of at most 20000"},
      {"points", [](Numbers& n) { n.points = 20000; }, [](Numbers& n) { n.points = 20001; },
       "/points: is an array of 20001 values; should be one of at most 20000"},
      {"keys", [](Numbers& n) { n.keys = 10000; }, [](Numbers& n) { n.keys = 10001; },
       "/animations/0/keys: is an array of 10001 values; should be one of at most 10000"},
      {"a side", [](Numbers& n) { n.side = 16384; }, [](Numbers& n) { n.side = 16385; },
       "should be a whole number of pixels from 1 to 16384"},
      {"pixels", [](Numbers& n) { n.coordinate = "-1e6"; },
       [](Numbers& n) { n.coordinate = "-1000001"; }, "from -1e6 to 1e6"},
      {"units", [](Numbers& n) { n.length = "1e9"; }, [](Numbers& n) { n.length = "1.1e9"; },
       "from -1e9 to 1e9"},
      {"a small scale", [](Numbers& n) { n.scale = "1e-9"; },
       [](Numbers& n) { n.scale = "1e-300"; }, "from 1e-9 to 1e9"},
      {"a large scale", [](Numbers& n) { n.scale = "1e9"; }, [](Numbers& n) { n.scale = "1e10"; },
       "from 1e-9 to 1e9"},
      {"a coarse grid", [](Numbers& n) { n.grid = "16"; }, [](Numbers& n) { n.grid = "15"; },
       "from 16 to 512"},
      {"a fine grid", [](Numbers& n) { n.grid = "512"; }, [](Numbers& n) { n.grid = "513"; },
       "from 16 to 512"},
      {"triangles", [](Numbers& n) { n.triangles = "10000000"; },
       [](Numbers& n) { n.triangles = "10000001"; }, "to 1e7"},
  };
  for (const Limit& limit : limits) {
    SCOPED_TRACE(limit.what);
    Numbers at, beyond;
    limit.at(at);
    limit.beyond(beyond);
    const Result<Document> read = parse_document(document(at), "F");
    EXPECT_TRUE(read) << read.error().text();
    const Result<Document> refused = parse_document(document(beyond), "F");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text().find(limit.said), std::string::npos) << refused.error().text();
  }
}

TEST(Limits, JsonIsNestedSoDeepAndNoDeeper) {
  const auto nested = [](int levels) {
    std::string text = document({});
    text.pop_back();
    return text + ",\"own\":" + std::string(levels, '[') + std::string(levels, ']') + "}";
  };
  const Result<Document> read = parse_document(nested(63), "F");
  EXPECT_TRUE(read) << read.error().text();
  const Result<Document> refused = parse_document(nested(64), "F");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().text().find("nested more than 64 levels deep"), std::string::npos);
}

// The file has a gigabyte on paper alone: a size is asked for before anything is read.
TEST(Limits, AFileOfMoreThanAGigabyteIsNotRead) {
  namespace fs = std::filesystem;
  const fs::path file =
      fs::temp_directory_path() / ("artisketch-large-" + std::to_string(getpid()));
  ASSERT_TRUE(write_file(file.string(), "{"));
  fs::resize_file(file, (std::uintmax_t(1) << 30) + 1);
  const Result<std::string> read = read_file(file.string());
  fs::remove(file);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().text().find("is larger than 1 GB"), std::string::npos);
}

// A chain of joints so deep, and the others beside its end, each with one channel and an end, which
// counts as a joint; at rest for so many frames.
std::string motion(int joints, int deep, int frames) {
  std::string text = "HIERARCHY\nROOT j\n{\nOFFSET 0 0 0\nCHANNELS 1 Zrotation\n";
  int open = 1;
  for (int j = 1; j < joints; ++j) {
    text += "JOINT j" + std::to_string(j) + "\n{\nOFFSET 0 1 0\nCHANNELS 1 Zrotation\n";
    if (open < deep)
      ++open;
    else
      text += "End Site\n{\nOFFSET 0 1 0\n}\n}\n";
  }
  text += "End Site\n{\nOFFSET 0 1 0\n}\n";
  for (; open > 0; --open) text += "}\n";
  text += "MOTION\nFrames: " + std::to_string(frames) + "\nFrame Time: 0.04\n";
  for (int f = 0; f < std::min(frames, 3); ++f)
    for (int j = 0; j < joints; ++j) text += j + 1 < joints ? "0 " : "0\n";
  return text;
}

TEST(Limits, OfAMotionAreKeptAndSaid) {
  const Result<Motion> many = parse_bvh(motion(500, 100, 1), "m", "F");
  EXPECT_TRUE(many) << many.error().text();
  const auto refused = [](const std::string& text) {
    const Result<Motion> read = parse_bvh(text, "m", "F");
    EXPECT_FALSE(read);
    return read ? std::string() : read.error().text();
  };
  EXPECT_NE(refused(motion(600, 100, 1)).find("thousand joints"), std::string::npos);
  EXPECT_NE(refused(motion(300, 300, 1)).find("200"), std::string::npos);
  EXPECT_NE(refused(motion(20, 10, 900000)).find("10 million numbers"), std::string::npos);
}

}  // namespace
}  // namespace artisketch
