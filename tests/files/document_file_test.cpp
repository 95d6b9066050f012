#include "files/document_file.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "files/bytes.h"
#include "files/document_check.h"

namespace artisketch {
namespace {

const std::string kGolden = ARTISKETCH_SOURCE_DIR "/tests/golden/";

// A small document without fault; the tests below spoil it in one place.
const std::string kGood = R"({
  "artisketch": 1,
  "camera": { "type": "perspective", "focal_length": 900, "distance": 4 },
  "skeleton": { "joints": [
    { "name": "body", "parent": null, "offset": [0, 1, 0] },
    { "name": "arm.L", "parent": "body", "offset": [0.5, 0, 0], "mirror": "arm.R" },
    { "name": "arm.R", "parent": "body", "offset": [-0.5, 0, 0], "mirror": "arm.L" }
  ] },
  "frames": [ {
    "name": "side", "size": [640, 480], "image": "side.png",
    "pose": { "root_position": [0, 1, 0], "rotations": { "arm.L": [0, 0, 0, 1] } },
    "contours": [
      { "joint": "body", "points": [[10, 10], [50, 10], [30, 40]] },
      { "joint": "arm.L", "closed": false, "points": [[10, 10], [50, 10]] }
    ]
  } ],
  "calibration": { "max_rotation": 20, "locked": ["body"] },
  "spheres": { "body": { "radius": 0.5 } },
  "parts": { "body": { "fatness": 1.5 } },
  "animations": [ { "name": "wave", "keys": [
    { "time": 0, "pose": { "root_position": [0, 1, 0] } },
    { "time": 2, "pose": { "root_position": [0, 1, 0] } } ] } ],
  "settings": { "grid": 64, "method": "rays" }
})";

std::string spoilt(const std::string& from, const std::string& to) {
  std::string text = kGood;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

std::vector<std::string> faults_of(const std::string& text) {
  const Result<Document> read = parse_document(text, "F");
  if (!read) return read.error().faults;
  const Result<Done> sound = check_document(*read, "F");
  return sound ? std::vector<std::string>{} : sound.error().faults;
}

// With one thing spoilt there is exactly one fault, and it reads like this.
void expect_fault(const std::string& from, const std::string& to, const std::string& fault) {
  const std::vector<std::string> faults = faults_of(spoilt(from, to));
  ASSERT_EQ(faults.size(), 1u) << to << "\n" << Error{{}, faults}.text();
  EXPECT_EQ(faults[0], "F: " + fault);
}

bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

TEST(DocumentFile, GoldenDocumentsComeBackByteForByte) {
  for (const char* name : {"version1.artisketch", "version1-perspective.artisketch"}) {
    const Result<std::string> bytes = read_file(kGolden + name);
    ASSERT_TRUE(bytes);
    const Result<Document> document = parse_document(*bytes, name);
    ASSERT_TRUE(document) << document.error().text();
    EXPECT_EQ(document_text(*document), *bytes);
  }
}

TEST(DocumentFile, EveryFieldOfVersion1IsRead) {
  const Result<Document> read = read_document(kGolden + "version1.artisketch");
  ASSERT_TRUE(read);
  const Document& d = *read;
  EXPECT_EQ(d.name, "every field of version 1 \"ünïcødé\"");
  EXPECT_EQ(d.camera.type, Camera::Type::orthographic);
  EXPECT_EQ(d.camera.pixels_per_unit, 187.7);
  EXPECT_EQ(d.camera_unknown, R"({"lens":"kept"})");
  ASSERT_EQ(d.skeleton.size(), 4);
  EXPECT_EQ(d.skeleton.joints[0].parent, -1);
  EXPECT_EQ(d.skeleton.joints[0].mirror, 0);
  EXPECT_TRUE(std::signbit(d.skeleton.joints[0].offset.z()));
  EXPECT_EQ(d.skeleton.joints[1].offset.x(), 5e-324);
  EXPECT_EQ(d.skeleton.joints[1].mirror, -1);
  EXPECT_EQ(d.skeleton.joints[3].parent, 1);
  EXPECT_EQ(d.skeleton.joints[3].mirror, 2);
  ASSERT_EQ(d.frames.size(), 2u);
  const Frame& front = d.frames[0];
  EXPECT_EQ(front.name, "front");
  EXPECT_EQ(front.width, 640);
  EXPECT_EQ(front.height, 480);
  EXPECT_EQ(front.image, "front.png");
  EXPECT_EQ(front.principal_point, Vec2(320.5, 239.75));
  EXPECT_EQ(front.scale, 1.25);
  EXPECT_EQ(front.pose.root_position, Vec3(0, 1, 0));
  EXPECT_EQ(front.pose.rotations[3].coeffs(), Quat::Identity().coeffs());
  EXPECT_EQ(front.unknown, R"({"note":null})");
  ASSERT_EQ(front.contours.size(), 3u);
  EXPECT_EQ(front.contours[0].joint, 1);
  EXPECT_TRUE(front.contours[0].line.closed);
  EXPECT_EQ(front.contours[0].line.points[3], Vec2(0.30000000000000004, 1e-7));
  EXPECT_FALSE(front.contours[1].line.closed);
  EXPECT_EQ(front.contours[1].unknown, R"({"pen":"soft"})");
  EXPECT_EQ(d.frames[1].image.rfind("data:image/png;base64,", 0), 0u);
  EXPECT_FALSE(d.frames[1].principal_point);
  EXPECT_EQ(d.frames[1].pose.rotations[3].coeffs(), Eigen::Vector4d(-0.5, 0.5, -0.5, 0.5));
  EXPECT_EQ(*d.calibration.max_rotation, radians(33.3));
  EXPECT_EQ(*d.calibration.max_translation, 0.2);
  EXPECT_EQ(d.calibration.locked, (std::vector<int>{0, 2}));
  EXPECT_TRUE(d.calibration.free_first_frame);
  EXPECT_TRUE(d.calibration.scale);
  EXPECT_EQ(*d.spheres.at(1).radius, 0.15);
  EXPECT_EQ(d.spheres.at(1).offset, Vec3(0, 0.01, 0));
  EXPECT_FALSE(d.spheres.at(2).radius);
  EXPECT_EQ(d.parts.at(1).fatness, 1.2);
  ASSERT_EQ(d.animations.size(), 1u);
  EXPECT_EQ(d.animations[0].name, "wave");
  EXPECT_EQ(d.animations[0].keys[1].time, 0.5);
  EXPECT_EQ(d.animations[0].keys[1].pose.rotations[2].coeffs(), Eigen::Vector4d(0, 0, 0.6, 0.8));
  EXPECT_EQ(d.settings.grid, 100);
  EXPECT_EQ(d.settings.method, "rays");
  EXPECT_EQ(d.settings.mirror, true);
  EXPECT_EQ(d.settings.triangles, 20000);
  EXPECT_EQ(d.settings.texture, false);
}

TEST(DocumentFile, CoordinatesSurviveBitForBit) {
  Document document = *parse_document(kGood, "F");
  std::mt19937_64 random(7);
  std::vector<Vec2>& points = document.frames[0].contours[1].line.points;
  points.clear();
  const auto any = [&] {  // any double of at most 1e6: most exponents, both signs
    for (;;) {
      const std::uint64_t bits = random();
      double x;
      std::memcpy(&x, &bits, sizeof x);
      if (std::abs(x) <= 1e6) return x;
    }
  };
  for (int i = 0; i < 2000; ++i) points.emplace_back(any(), any());
  const Result<Document> again = parse_document(document_text(document), "F");
  ASSERT_TRUE(again) << again.error().text();
  const std::vector<Vec2>& read = again->frames[0].contours[1].line.points;
  ASSERT_EQ(read.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_TRUE(same_bits(points[i].x(), read[i].x()) && same_bits(points[i].y(), read[i].y()));
}

TEST(DocumentFile, MinusZeroIsKeptHoweverItIsWritten) {
  for (const char* zero : {"-0", "-0.0", "-0e3"}) {
    const auto document =
        parse_document(spoilt("[0.5, 0, 0]", std::string("[0.5, ") + zero + ", 0]"), "F");
    ASSERT_TRUE(document);
    EXPECT_TRUE(std::signbit(document->skeleton.joints[1].offset.y())) << zero;
  }
}

TEST(DocumentFile, DegreesOfUpTo15DigitsComeBackAsTheyWereGiven) {
  for (const char* angle : {"0.1", "12.3456789012345", "20", "33.3", "57.2957795130823", "90",
                            "179.999999999999", "1e-07"}) {
    const std::string once = document_text(*parse_document(
        spoilt("\"max_rotation\": 20", std::string("\"max_rotation\": ") + angle), "F"));
    EXPECT_NE(once.find(std::string("\"max_rotation\": ") + angle), once.npos) << once;
    EXPECT_EQ(document_text(*parse_document(once, "F")), once);
  }
}

TEST(DocumentFile, RotationsAreKeptOrNormalised) {
  const auto with = [](const std::string& q) {
    return parse_document(spoilt("\"arm.L\": [0, 0, 0, 1]", "\"arm.L\": " + q), "F");
  };
  const auto near = with("[0, 0, 0.7071068, 0.7071068]");
  ASSERT_TRUE(near);
  EXPECT_EQ(near->frames[0].pose.rotations[1].z(), 0.7071068);
  const auto off = with("[0, 0, 0.7075, 0.7075]");
  ASSERT_TRUE(off);
  EXPECT_NEAR(off->frames[0].pose.rotations[1].norm(), 1, 1e-15);
  EXPECT_FALSE(with("[0, 0, 0.71, 0.71]"));
  EXPECT_FALSE(with("[0, 0, 0, 0]"));
}

TEST(DocumentFile, WhoPosedADrawingIsKept) {
  auto document = parse_document(spoilt("\"pose\":", R"("posed": false,
      "set_joints": ["arm.L", "body", "arm.L"], "pose":)"),
                                 "F");
  ASSERT_TRUE(document) << document.error().text();
  const Frame& frame = document->frames[0];
  EXPECT_FALSE(frame.posed);
  EXPECT_EQ(frame.set_joints, (std::vector<int>{0, 1}));
  const auto again = parse_document(document_text(*document), "F");
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_FALSE(again->frames[0].posed);
  EXPECT_EQ(again->frames[0].set_joints, frame.set_joints);
  for (const char* wrong : {R"("posed": 1, "pose":)", R"("set_joints": ["nobody"], "pose":)"})
    EXPECT_FALSE(parse_document(spoilt("\"pose\":", wrong), "F")) << wrong;
}

TEST(DocumentFile, WhatAPartIsIsKept) {
  const std::string held =
      spoilt(R"("parts": { "body": { "fatness": 1.5 } })",
             R"("parts": { "arm.L": { "role": "held" }, "arm.R": { "role": "apart" } })");
  const Result<Document> read = parse_document(held, "F");
  ASSERT_TRUE(read);
  EXPECT_EQ(role_of(*read, 0), Role::body);
  EXPECT_EQ(role_of(*read, 1), Role::held);
  EXPECT_EQ(role_of(*read, 2), Role::apart);
  const Result<Document> again = parse_document(document_text(*read), "F");
  ASSERT_TRUE(again);
  EXPECT_EQ(role_of(*again, 1), Role::held);
  EXPECT_EQ(role_of(*again, 2), Role::apart);
}

TEST(DocumentFile, AMotionsJointsAreMappedInOrder) {
  const std::string with = spoilt(
      "\"animations\":",
      R"("motion": { "joints": { "Spine": "arm.L", "Hips": "body" }, "still": ["arm.R"], "x": 1 },
             "animations":)");
  const auto document = parse_document(with, "F");
  ASSERT_TRUE(document) << document.error().text();
  ASSERT_EQ(document->motion.joints.size(), 3u);
  EXPECT_EQ(document->motion.joints[2].first, "");  // nobody
  EXPECT_EQ(document->skeleton.joints[document->motion.joints[2].second].name, "arm.R");
  EXPECT_EQ(document->motion.joints[0].first, "Spine");
  EXPECT_EQ(document->skeleton.joints[document->motion.joints[0].second].name, "arm.L");
  const auto again = parse_document(document_text(*document), "F");
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(again->motion.joints, document->motion.joints);
  EXPECT_EQ(again->motion.unknown, document->motion.unknown);
  for (const char* wrong : {R"({ "joints": { "a": "nobody" } })", R"({ "joints": ["body"] })",
                            R"({ "joints": { "a": "body", "b": "body" } })",
                            R"({ "still": ["nobody"] })", R"({ "still": ["body", "body"] })",
                            R"({ "joints": { "a": "body" }, "still": ["body"] })"}) {
    const auto refused = parse_document(
        spoilt("\"animations\":", std::string("\"motion\": ") + wrong + ", \"animations\":"), "F");
    ASSERT_FALSE(refused) << wrong;
    EXPECT_NE(refused.error().text().find("/motion/"), std::string::npos);
  }
}

TEST(DocumentFile, RepeatedPointsAreDropped) {
  const auto document =
      parse_document(spoilt("[[10, 10], [50, 10], [30, 40]]",
                            "[[10, 10], [10, 10], [50, 10], [30, 40], [30, 40], [10, 10]]"),
                     "F");
  ASSERT_TRUE(document) << document.error().text();
  EXPECT_EQ(document->frames[0].contours[0].line.points,
            (std::vector<Vec2>{{10, 10}, {50, 10}, {30, 40}}));
}

TEST(DocumentFile, RepeatedPointsAreNotWritten) {
  Document document = *read_document(kGolden + "version1.artisketch");
  Contour& contour = document.frames[0].contours[0];
  contour.line = {{{0, 0}, {0, 0}, {9, 0}, {9, 9}, {9, 9}, {0, 0}}, true};
  const std::string text = document_text(document);
  const Result<Document> again = parse_document(text, "x");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->frames[0].contours[0].line.points.size(), 3u);
  EXPECT_EQ(document_text(*again), text);
}

TEST(DocumentFile, AFaultSaysWhereAndWhatWouldBeRight) {
  ASSERT_TRUE(parse_document(kGood, "F")) << parse_document(kGood, "F").error().text();
  expect_fault("\"artisketch\": 1", "\"artisketch\": 2",
               "/artisketch: is version 2, which is newer than this program; should be 1, or get a "
               "newer program");
  expect_fault("\"artisketch\": 1,", "",
               "/artisketch: is missing; should be 1, the version of the format");
  expect_fault("900", "-900", "/camera/focal_length: is -900; should be a number from 1e-9 to 1e9");
  expect_fault("\"perspective\"", "\"fisheye\"",
               "/camera/type: is 'fisheye'; should be 'orthographic' or 'perspective'");
  expect_fault("\"distance\": 4", "\"distance\": NaN",
               "/camera/distance: is NaN; should be a finite number");
  expect_fault(
      "[0.5, 0, 0]", "[0.5, 0]",
      "/skeleton/joints/1/offset: is an array of 2 values; should be three numbers [x, y, z]");
  expect_fault("[0.5, 0, 0]", "[0.5, 1e999, 0]",
               "/skeleton/joints/1/offset/1: is 1e999; should be a finite number");
  expect_fault("[0.5, 0, 0]", "[0.5, null, 0]",
               "/skeleton/joints/1/offset/1: is null; should be a number from -1e9 to 1e9");
  expect_fault(
      "\"parent\": \"body\"", "\"parent\": \"spine\"",
      "/skeleton/joints/1/parent: names 'spine', which is no earlier joint; parents should "
      "stand before their children");
  expect_fault(
      "\"parent\": \"body\"", "\"parent\": \"arm.L\"",
      "/skeleton/joints/1/parent: names 'arm.L', which is no earlier joint; parents should "
      "stand before their children");
  expect_fault(
      "\"parent\": \"body\"", "\"parent\": null",
      "/skeleton/joints/1/parent: is null, a second root; should be the name of an earlier joint");
  expect_fault("\"parent\": null", "\"parent\": \"body\"",
               "/skeleton/joints/0/parent: is 'body'; should be null: the first joint is the root");
  expect_fault(", \"mirror\": \"arm.L\"", "",
               "/skeleton/joints/1/mirror: names 'arm.R', whose mirror is not given; should be "
               "mutual: give 'arm.R' the mirror 'arm.L'");
  expect_fault("640", "0",
               "/frames/0/size/0: is 0; should be a whole number of pixels from 1 to 16384");
  expect_fault("640", "640.5",
               "/frames/0/size/0: is 640.5; should be a whole number of pixels from 1 to 16384");
  expect_fault("side.png", "/side.png",
               "/frames/0/image: is '/side.png'; should be a path relative to the document, or a "
               "data:image/png;base64 or data:image/jpeg;base64 URI");
  expect_fault("\"image\": \"side.png\"", "\"scale\": 2",
               "/frames/0/scale: is given for a perspective camera; should be left out: only "
               "orthographic frames have a scale");
  expect_fault("\"arm.L\": [0, 0, 0, 1]", "\"leg\": [0, 0, 0, 1]",
               "/frames/0/pose/rotations/leg: is no joint; should be a name in /skeleton/joints");
  expect_fault(
      "\"arm.L\": [0, 0, 0, 1]", "\"arm.L\": [0, 0, 0, 0]",
      "/frames/0/pose/rotations/arm.L: has length 0; should be a unit quaternion, of length 1");
  expect_fault("\"joint\": \"body\"", "\"joint\": \"leg\"",
               "/frames/0/contours/0/joint: names 'leg', which is no joint; should be a name in "
               "/skeleton/joints");
  expect_fault("\"closed\": false", "\"closed\": 0",
               "/frames/0/contours/1/closed: is 0; should be true or false");
  expect_fault("[50, 10], [30, 40]", "[50, 10]",
               "/frames/0/contours/0/points: frame 1 'side': the contour of 'body' has 2 different "
               "points; should have at least 3, as a closed line");
  expect_fault("[50, 10], [30, 40]", "[30, 40], [30, 10], [10, 40]",
               "/frames/0/contours/0/points: frame 1 'side': the contour of 'body' crosses itself "
               "near (20, 25); should go round once without crossing");
  expect_fault("[50, 10], [30, 40]", "[50, 50], [30, 30]",
               "/frames/0/contours/0/points: frame 1 'side': the contour of 'body' encloses "
               "nothing; should go round an area, or have \"closed\": false");
  expect_fault("\"max_rotation\": 20", "\"max_rotation\": 181",
               "/calibration/max_rotation: is 181; should be a number of degrees from 0 to 180");
  expect_fault("[\"body\"]", "[\"leg\"]",
               "/calibration/locked/0: names 'leg', which is no joint; should be a name in "
               "/skeleton/joints");
  expect_fault("\"radius\": 0.5", "\"radius\": 0",
               "/spheres/body/radius: is 0; should be a number from 1e-9 to 1e9");
  expect_fault("\"fatness\": 1.5", "\"fatness\": 11",
               "/parts/body/fatness: is 11; should be a number above 0, at most 10");
  expect_fault("\"fatness\": 1.5", "\"role\": \"hat\"",
               R"(/parts/body/role: is 'hat'; should be "body", "held" or "apart")");
  expect_fault(
      "\"time\": 2", "\"time\": 0",
      "/animations/0/keys/1/time: is 0, not after the key before (0); times should increase");
  expect_fault("\"grid\": 64", "\"grid\": 12",
               "/settings/grid: is 12; should be a whole number of cells from 16 to 512");
  expect_fault("\"rays\"", "\"magic\"",
               "/settings/method: is 'magic'; should be 'paper' or 'rays'");
  expect_fault("\"grid\": 64", "\"grid\": 64, \"grid\": 65",
               "/settings/grid: stands more than once; give each field once");
  expect_fault("[0, 1, 0], \"rotations\"", "[0, 1, 5], \"rotations\"",
               "/frames/0/pose: frame 1 'side': 'body' stands at or behind the camera; should have "
               "z below the camera's distance: move root_position away");
}

TEST(DocumentFile, NamesAreUniqueAndNotEmpty) {
  for (const auto& [name, words] :
       {std::pair{"body", "is 'body' like that of joint 0; each name should stand once"},
        std::pair{"", "is ''; should be a text that is not empty"}}) {
    // The names that others refer to it by are missing then, too.
    const auto faults =
        faults_of(spoilt("\"name\": \"arm.R\"", std::string("\"name\": \"") + name + "\""));
    ASSERT_FALSE(faults.empty());
    EXPECT_EQ(faults[0], std::string("F: /skeleton/joints/2/name: ") + words);
  }
}

TEST(DocumentFile, EveryFaultIsNamedInOnePass) {
  std::string text = spoilt("\"artisketch\": 1", "\"artisketch\": 3");
  for (const auto& [from, to] : {std::pair{"\"distance\": 4", "\"distance\": -Infinity"},
                                 std::pair{"\"parent\": \"body\"", "\"parent\": \"gone\""},
                                 std::pair{"[50, 10], [30, 40]", "[50, 10]"},
                                 std::pair{"\"grid\": 64", "\"grid\": \"fine\""}})
    text.replace(text.find(from), std::strlen(from), to);
  const auto faults = faults_of(text);
  for (const char* pointer : {"/artisketch", "/camera/distance", "/skeleton/joints/1/parent",
                              "/frames/0/contours/0/points", "/settings/grid"})
    EXPECT_EQ(std::count_if(faults.begin(), faults.end(),
                            [&](const std::string& f) {
                              return f.rfind(std::string("F: ") + pointer + ": ", 0) == 0;
                            }),
              1)
        << pointer;
  EXPECT_EQ(faults.size(), 5u);
}

TEST(DocumentFile, MissingPartsAreAllNamed) {
  EXPECT_EQ(faults_of("{}").size(), 4u);
  EXPECT_EQ(faults_of("[]"),
            std::vector<std::string>{"F: is an array of 0 values; should be an object"});
  EXPECT_EQ(faults_of("null").size(), 1u);
  expect_fault(
      kGood.substr(kGood.find("[ {\n    \"name\": \"side\""),
                   kGood.find(",\n  \"calibration\"") - kGood.find("[ {\n    \"name\": \"side\"")),
      "[]", "/frames: is empty; should have at least one frame");
}

TEST(DocumentFile, MoreFaultsThanAnybodyReadsAreCounted) {
  std::string points;
  for (int i = 0; i < 250; ++i) points += "[1, \"x\"], ";
  const auto faults = faults_of(spoilt("[50, 10], [30, 40]", points + "[30, 40]"));
  ASSERT_EQ(faults.size(), 101u);
  EXPECT_EQ(faults.back(), "F: … and 150 more");
}

TEST(DocumentFile, TextThatIsNoJsonSaysWhere) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "F: line 1, column 1: the text is empty; should be a JSON object"},
      {" \n ", "F: line 1, column 1: the text is empty; should be a JSON object"},
      {"{\n  \"ä\": 1,\n}", "F: line 3, column 1: "},
      {"{ \"ä\": 01 }", "F: line 1, column 9: "},
      {"{ \"a\": \"\xff\" }", "F: line 1, column 9: "},
      {"\xff\xfe{\0", "F: line 1, column 1: the text is UTF-16; should be saved as UTF-8"},
      {"{} {}", "F: line 1, column 4: "},
      {"{ \"a\": nothing }", "F: line 1, column 9: "},
  };
  for (const auto& [text, start] : cases) {
    const auto faults = faults_of(text);
    ASSERT_EQ(faults.size(), 1u) << text;
    EXPECT_EQ(faults[0].substr(0, start.size()), start);
  }
  EXPECT_TRUE(parse_document("\xef\xbb\xbf" + kGood, "F"));
}

TEST(DocumentFile, TextCutOffAnywhereIsRefused) {
  for (std::size_t n = 0; n < kGood.size(); ++n) {
    const auto faults = faults_of(kGood.substr(0, n));
    ASSERT_EQ(faults.size(), 1u) << n;
    EXPECT_EQ(faults[0].rfind("F: line ", 0), 0u) << faults[0];
  }
  EXPECT_NE(faults_of(kGood.substr(0, 700))[0].find("cut off"), std::string::npos);
}

TEST(DocumentFile, HostileShapesAreRefusedQuickly) {
  EXPECT_EQ(faults_of(std::string(1000000, '[')).size(), 1u);
  std::string nested;
  for (int i = 0; i < 100000; ++i) nested += "{\"a\":";
  EXPECT_EQ(faults_of(nested).size(), 1u);
  std::string wide = "{";
  for (int i = 0; i < 100000; ++i) wide += "\"" + std::to_string(i) + "\":0,";
  EXPECT_EQ(faults_of(wide + "\"x\":0}").size(), 4u);
  // A thousand joints would make each of many empty poses large.
  std::string keys;
  for (int i = 0; i < 20000; ++i) keys += "{},";
  expect_fault("{ \"time\": 0, \"pose\": { \"root_position\": [0, 1, 0] } },", keys,
               "/animations/0/keys: is an array of 20001 values; should be one of at most 10000");
}

TEST(DocumentFile, FaultsStayOnOneShortLine) {
  const auto faults = faults_of(spoilt(
      "\"joint\": \"body\"", "\"joint\": \"a\\nb\\u001b[31m" + std::string(100000, 'x') + "\""));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].find('\n'), std::string::npos);
  EXPECT_EQ(faults[0].find('\033'), std::string::npos);
  EXPECT_LT(faults[0].size(), 300u);
}

TEST(DocumentFile, WhatIsWrittenIsReadFromDisk) {
  const std::string path = ::testing::TempDir() + "artisketch_document_test.artisketch";
  const Document document = *parse_document(kGood, "F");
  ASSERT_TRUE(write_document(path, document));
  const auto read = read_document(path);
  std::remove(path.c_str());
  ASSERT_TRUE(read);
  EXPECT_EQ(document_text(*read), document_text(document));
  EXPECT_EQ(read_document(path).error().kind, Error::Kind::io);
}

}  // namespace
}  // namespace artisketch
