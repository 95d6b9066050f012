#include "app/job_bytes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "files/document_file.h"
#include "model/part_inputs.h"

namespace artisketch {
namespace {

// Where two values' bytes differ.
std::size_t difference(const std::string& a, const std::string& b) {
  return std::size_t(std::mismatch(a.begin(), a.end(), b.begin()).first - a.begin());
}

JobResult full_result() {
  JobResult result;
  result.document = "a document";
  result.glb = std::string("glTF\0\1\2", 7);
  result.report = "{}";
  result.fits = {{0.75, {{3, 1.5}, {4, 2.5}}}, {0.5, {}}};
  result.coverage = {{1, 2, 0.25, 0.875}};
  result.spheres = {{2, Vec3(1, 2, 3), 0.125}};
  result.undetermined = {"twist"};
  result.warnings = {"one", "two"};
  Mesh triangle;
  triangle.V = Points3::Identity(3, 3);
  triangle.F.resize(1, 3);
  triangle.F << 0, 1, 2;
  result.parts = {{5, triangle, {0, 2}, {1.5, 2.5}}};
  return result;
}

TEST(JobBytes, RequestSurvives) {
  JobRequest request;
  request.kind = JobRequest::Kind::calibrate;
  request.document = std::string("text with \0 in it", 17);
  request.options.method = Method::paper;
  request.options.grid = 64;
  request.options.calibrate = false;
  request.options.visual_hull = true;
  request.options.triangles = 1234;
  request.options.mirror = false;
  request.options.texture = false;
  const auto back = read_job_request(job_bytes(request));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->kind, request.kind);
  EXPECT_EQ(back->document, request.document);
  EXPECT_EQ(back->options.method, Method::paper);
  EXPECT_EQ(back->options.grid, 64);
  EXPECT_FALSE(back->options.calibrate);
  EXPECT_TRUE(back->options.visual_hull);
  EXPECT_EQ(back->options.triangles, 1234);
  EXPECT_FALSE(back->options.mirror);
  EXPECT_FALSE(back->options.texture);
}

TEST(JobBytes, PartsOfARequestSurvive) {
  Part part;
  part.joint = 3;
  part.name = "hand.R";
  part.bones = {{3, 4, Vec3(1, 2, 3), Vec3(4, 5, 6)}};
  part.origin = Vec3(7, 8, 9);
  part.fatness = 1.25;
  PartView view;
  view.frame = 2;
  view.camera = {{Camera::Type::perspective, 90, 800, 7}, Vec2(300, 200), 1.5};
  view.to_world.translate(Vec3(0.5, 0, 0)).rotate(Eigen::AngleAxisd(0.3, Vec3::UnitY()));
  view.contours = {{{{10, 10}, {90, 20}, {40, 70}}, true}, {{{0, 0}, {5, 5}}, false}};
  view.outline = outline_of(view.contours);
  part.views = {view};
  view.mirrored = true;
  part.mirrors = {view};
  JobRequest request;
  request.kind = JobRequest::Kind::parts;
  request.parts = {part};
  const auto back = read_job_request(job_bytes(request));
  ASSERT_TRUE(back);
  ASSERT_EQ(back->parts.size(), 1u);
  EXPECT_EQ(surface_inputs(back->parts[0], {}), surface_inputs(part, {}));
  const Vec2 at(35, 30);
  EXPECT_EQ(back->parts[0].views[0].outline.distance(at), part.views[0].outline.distance(at));
}

TEST(JobBytes, WhatIsWantedOfSpritesSurvives) {
  JobRequest request;
  request.kind = JobRequest::Kind::sprites;
  request.glb = std::string("glTF\0\1", 6);
  request.sprites = {"walk",      16,    64, 8,    3,    0.5,
                     Light::toon, false, 2,  true, true, SheetLayout::hash};
  request.name = "fox";
  const auto back = read_job_request(job_bytes(request));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->glb, request.glb);
  EXPECT_EQ(back->name, "fox");
  EXPECT_EQ(back->sprites.clip, "walk");
  EXPECT_EQ(back->sprites.directions, 16);
  EXPECT_EQ(back->sprites.light, Light::toon);
  EXPECT_EQ(back->sprites.layout, SheetLayout::hash);
  EXPECT_TRUE(back->sprites.normals && back->sprites.depth && !back->sprites.ink);
  for (const int directions : {0, 3, 17, -4}) {
    request.sprites.directions = directions;
    EXPECT_FALSE(read_job_request(job_bytes(request))) << directions;
  }
}

TEST(JobBytes, ProgressSurvives) {
  const auto back = read_job_progress(job_bytes(Progress{"surfaces", "forearm.L", 7, 15, 0.625}));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->stage, "surfaces");
  EXPECT_EQ(back->item, "forearm.L");
  EXPECT_EQ(back->part, 7);
  EXPECT_EQ(back->parts, 15);
  EXPECT_EQ(back->fraction, 0.625);
}

TEST(JobBytes, ResultSurvives) {
  const JobResult made = full_result();
  const auto back = read_job_outcome(job_bytes(Result<JobResult>(made)));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->document, made.document);
  EXPECT_EQ(back->glb, made.glb);
  EXPECT_EQ(back->report, made.report);
  ASSERT_EQ(back->fits.size(), 2u);
  EXPECT_EQ(back->fits[0].iou, 0.75);
  ASSERT_EQ(back->fits[0].parts.size(), 2u);
  EXPECT_EQ(back->fits[0].parts[1].joint, 4);
  EXPECT_EQ(back->fits[0].parts[1].distance, 2.5);
  ASSERT_EQ(back->coverage.size(), 1u);
  EXPECT_EQ(back->coverage[0].frame, 2);
  EXPECT_EQ(back->coverage[0].after, 0.875);
  ASSERT_EQ(back->spheres.size(), 1u);
  EXPECT_EQ(back->spheres[0].centre, Vec3(1, 2, 3));
  EXPECT_EQ(back->spheres[0].radius, 0.125);
  EXPECT_EQ(back->undetermined, made.undetermined);
  EXPECT_EQ(back->warnings, made.warnings);
  ASSERT_EQ(back->parts.size(), 1u);
  EXPECT_EQ(back->parts[0].joint, 5);
  EXPECT_EQ(back->parts[0].mesh.V, made.parts[0].mesh.V);
  EXPECT_EQ(back->parts[0].mesh.F, made.parts[0].mesh.F);
  EXPECT_EQ(back->parts[0].frames, made.parts[0].frames);
  EXPECT_EQ(back->parts[0].distances, made.parts[0].distances);
}

TEST(JobBytes, ErrorKeepsItsKindAndFaults) {
  for (const Error& error :
       {Error{Error::Kind::bad_input, {"first", "second"}}, cancelled(), out_of_memory(100)}) {
    const auto back = read_job_outcome(job_bytes(Result<JobResult>(error)));
    ASSERT_FALSE(back);
    EXPECT_EQ(back.error().kind, error.kind);
    EXPECT_EQ(back.error().faults, error.faults);
  }
}

TEST(JobBytes, AByteThatIsNoTruthIsRefused) {
  JobRequest request;
  request.options.calibrate = false;
  std::string bytes = job_bytes(request);
  request.options.calibrate = true;
  const std::string other = job_bytes(request);
  ASSERT_EQ(bytes.size(), other.size());
  const std::size_t at = difference(bytes, other);
  ASSERT_LT(at, bytes.size());
  bytes[at] = char(245);
  EXPECT_FALSE(read_job_request(bytes));
}

JobRequest request_with_a_view() {
  PartView view;
  view.contours = {{{{10, 10}, {90, 20}, {40, 70}}, true}};
  Part part;
  part.views = {view};
  part.bones = {{0, 1, Vec3::Zero(), Vec3::UnitY()}};
  JobRequest request;
  request.kind = JobRequest::Kind::parts;
  request.parts = {part};
  return request;
}

TEST(JobBytes, NumbersThatAStageCannotBearAreRefused) {
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  const auto refused = [](const auto& change, const auto& value) {
    JobRequest request = request_with_a_view();
    change(request.parts[0], value);
    const auto back = read_job_request(job_bytes(request));
    EXPECT_FALSE(back);
    return !back && back.error().kind == Error::Kind::crashed && back.error().faults.size() == 1;
  };
  const auto bears = [](const auto& change, const auto& value) {
    JobRequest request = request_with_a_view();
    change(request.parts[0], value);
    return bool(read_job_request(job_bytes(request)));
  };
  using Change = std::function<void(Part&, double)>;
  const std::vector<Change> numbers = {
      [](Part& p, double x) { p.views[0].contours[0].points[1].y() = x; },
      [](Part& p, double x) { p.views[0].camera.camera.pixels_per_unit = x; },
      [](Part& p, double x) { p.views[0].camera.camera.focal_length = x; },
      [](Part& p, double x) { p.views[0].camera.camera.distance = x; },
      [](Part& p, double x) { p.views[0].camera.principal_point.x() = x; },
      [](Part& p, double x) { p.views[0].camera.scale = x; },
      [](Part& p, double x) { p.views[0].to_world.translation().z() = x; },
      [](Part& p, double x) { p.bones[0].b.y() = x; },
      [](Part& p, double x) { p.origin.x() = x; },
      [](Part& p, double x) { p.fatness = x; },
  };
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_TRUE(bears(numbers[i], 2.0));
    for (const double wrong : {nan, infinite, -infinite, 1e300})
      EXPECT_TRUE(refused(numbers[i], wrong)) << wrong;
  }
  const std::vector<std::function<void(Part&, int)>> indices = {
      [](Part& p, int i) { p.joint = i; },
      [](Part& p, int i) { p.bones[0].child = i; },
      [](Part& p, int i) { p.views[0].frame = i; },
  };
  for (const auto& index : indices) {
    EXPECT_TRUE(bears(index, 999));
    EXPECT_TRUE(refused(index, -1));
    EXPECT_TRUE(refused(index, 1000));
  }
  // No motion is flat: it has an inverse.
  EXPECT_TRUE(refused([](Part& p, double x) { p.views[0].to_world.linear()(1, 1) = x; }, 0.0));
  EXPECT_TRUE(bears([](Part& p, double x) { p.views[0].to_world.linear()(1, 1) = x; }, -1.0));
}

TEST(JobBytes, ChoicesThatThereAreNotAreRefused) {
  using Kind = JobRequest::Kind;
  const JobRequest plain = request_with_a_view();
  JobRequest other = plain;
  other.kind = Kind::spheres;
  const std::string bytes = job_bytes(plain);
  for (const int choice : {5, -1, 1 << 30}) {
    std::string wrong = bytes;
    std::memcpy(wrong.data() + difference(bytes, job_bytes(other)), &choice, sizeof choice);
    EXPECT_FALSE(read_job_request(wrong)) << choice;
  }
  for (const int grid : {kFewestCells - 1, kMostCells + 1, -5}) {
    JobRequest request = plain;
    request.options.grid = grid;
    EXPECT_FALSE(read_job_request(job_bytes(request))) << grid;
  }
}

TEST(JobBytes, MeshesNameVerticesThatTheyHave) {
  const auto outcome_with = [](int index, double x) {
    JobResult result = full_result();
    result.parts[0].mesh.F(0, 1) = index;
    result.parts[0].mesh.V(2, 2) = x;
    return read_job_outcome(job_bytes(Result<JobResult>(result)));
  };
  EXPECT_TRUE(outcome_with(2, 1));
  EXPECT_FALSE(outcome_with(3, 1));
  EXPECT_FALSE(outcome_with(-1, 1));
  EXPECT_FALSE(outcome_with(2, std::nan("")));
}

TEST(JobBytes, NothingToCompareIsInfinitelyFarAndComesBackSo) {
  JobResult result = full_result();
  const double infinite = std::numeric_limits<double>::infinity();
  result.parts[0].distances[1] = result.fits[0].parts[1].distance = infinite;
  const auto back = read_job_outcome(job_bytes(Result<JobResult>(result)));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->parts[0].distances[1], infinite);
  EXPECT_EQ(back->fits[0].parts[1].distance, infinite);
  result.parts[0].distances[1] = std::nan("");
  EXPECT_FALSE(read_job_outcome(job_bytes(Result<JobResult>(result))));
}

TEST(JobBytes, WhatIsCutShortOrTooLongIsRefused) {
  const std::string bytes = job_bytes(Result<JobResult>(full_result()));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const auto back = read_job_outcome(std::string_view(bytes).substr(0, size));
    ASSERT_FALSE(back) << size;
    EXPECT_EQ(back.error().kind, Error::Kind::crashed);
  }
  EXPECT_FALSE(read_job_outcome(bytes + "x"));
  EXPECT_FALSE(read_job_request(""));
  EXPECT_FALSE(read_job_progress(std::string(200, '\xff')));
}

}  // namespace
}  // namespace artisketch
