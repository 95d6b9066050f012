#include "app/job.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "files/bytes.h"
#include "files/document_file.h"
#include "files/gltf.h"

namespace artisketch {
namespace {

using Kind = JobRequest::Kind;

std::string example_text(const std::string& name) {
  const auto text =
      read_file(ARTISKETCH_SOURCE_DIR "/assets/examples/" + name + "/" + name + ".artisketch");
  EXPECT_TRUE(text);
  return *text;
}

JobRequest heart(Kind kind = Kind::reconstruct) {
  JobRequest request;
  request.kind = kind;
  request.document = example_text("heart");
  request.options.grid = 32;
  return request;
}

TEST(Job, MakesWhatReconstructMakes) {
  const JobRequest request = heart();
  artisketch::Run run, other;
  const auto job = run_job(request, run);
  ASSERT_TRUE(job);
  const auto document = parse_document(request.document, "heart");
  const auto direct = reconstruct(*document, request.options, other);
  ASSERT_TRUE(direct);
  EXPECT_EQ(job->glb, *glb_bytes(direct->model));
  EXPECT_EQ(job->document, document_text(direct->calibrated));
  ASSERT_EQ(job->fits.size(), direct->fits.size());
  EXPECT_EQ(job->fits[1].iou, direct->fits[1].iou);
  EXPECT_EQ(job->coverage.size(), direct->calibration->coverage.size());
  EXPECT_EQ(job->undetermined, direct->calibration->undetermined);
  EXPECT_EQ(job->warnings, direct->warnings);
  EXPECT_NE(job->report.find("\"stages\""), std::string::npos);
}

TEST(Job, SpritesAreThoseOfTheModelAndMayBeStopped) {
  artisketch::Run run;
  JobRequest request;
  request.kind = Kind::sprites;
  request.glb = run_job(heart(), run)->glb;
  request.sprites.directions = 4;
  request.sprites.size = 32;
  request.sprites.clip = read_glb(request.glb, "heart")->clips.at(0).name;
  request.name = "heart";
  double last = 0;
  run.on_progress = [&](const Progress& now) { last = now.fraction; };
  const auto job = run_job(request, run);
  ASSERT_TRUE(job) << job.error().text();
  EXPECT_EQ(job->sprites, *sprite_zip(*read_glb(request.glb, "heart"), request.sprites, "heart"));
  EXPECT_GT(last, 0.5);
  const std::atomic<bool> stop = true;
  run.cancel = &stop;
  const auto stopped = run_job(request, run);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, Error::Kind::cancelled);
  request.sprites.clip = "none of these";
  EXPECT_FALSE(run_job(request, run));
}

TEST(Job, PartsAloneComeAsTheyWereAskedForAndSayHowTheyFit) {
  const Document document = *parse_document(example_text("hero"), "hero");
  JobRequest request;
  request.kind = Kind::parts;
  request.parts = parts_of(document);
  std::swap(request.parts.front(), request.parts.back());
  request.options.grid = 32;
  artisketch::Run run;
  run.threads = 3;  // they come in order all the same
  const auto job = run_job(request, run);
  ASSERT_TRUE(job);
  EXPECT_TRUE(job->glb.empty());
  ASSERT_EQ(job->parts.size(), request.parts.size());
  for (std::size_t p = 0; p < job->parts.size(); ++p) {
    const Part& wanted = request.parts[p];
    const PartMesh& made = job->parts[p];
    EXPECT_EQ(made.joint, wanted.joint);
    const auto whole = reconstruct_part(wanted, {kDefaultMethod, 32, false}, run);
    ASSERT_TRUE(whole);
    EXPECT_GT(made.mesh.F.rows(), 0);
    EXPECT_LT(made.mesh.F.rows(), 0.7 * whole->mesh.F.rows());
    ASSERT_EQ(made.distances.size(), wanted.views.size());
    const std::vector<double> before = view_distances(wanted, whole->mesh);
    for (std::size_t v = 0; v < wanted.views.size(); ++v) {
      EXPECT_EQ(made.frames[v], wanted.views[v].frame);
      EXPECT_NEAR(made.distances[v], before[v], 0.3) << "pixels";
    }
  }
}

TEST(Job, APartThatFailsIsLeftEmptyWithAWarning) {
  JobRequest request = heart(Kind::parts);
  Document document = *parse_document(request.document, "heart");
  document.skeleton.joints.push_back({"lost", 0, Vec3(0, 0.1, 0), -1, ""});
  for (Frame& frame : document.frames) frame.pose.rotations.push_back(Quat::Identity());
  document.frames[0].contours.push_back({1, {{{10, 10}, {20, 10}, {20, 20}}, false}, ""});
  request.parts = parts_of(document);
  artisketch::Run run;
  const auto job = run_job(request, run);
  ASSERT_TRUE(job);
  ASSERT_EQ(job->parts.size(), 2u);
  EXPECT_GT(job->parts[0].mesh.F.rows(), 0);
  EXPECT_EQ(job->parts[1].joint, 1);
  EXPECT_EQ(job->parts[1].mesh.F.rows(), 0);
  EXPECT_TRUE(job->parts[1].distances.empty());
  EXPECT_FALSE(job->warnings.empty());
}

TEST(Job, CalibrationGivesPosesAndNoModel) {
  const JobRequest request = heart(Kind::calibrate);
  artisketch::Run run, other;
  const auto job = run_job(request, run);
  ASSERT_TRUE(job);
  const auto document = parse_document(request.document, "heart");
  const auto direct = calibrate(*document, {}, other);
  EXPECT_EQ(job->document, document_text(with_poses(*document, *direct)));
  EXPECT_NE(job->document, document_text(*document)) << "the heart's second pose is off";
  EXPECT_TRUE(job->glb.empty());
  EXPECT_TRUE(job->fits.empty());
}

TEST(Job, SpheresAreThoseThatJoinTheParts) {
  JobRequest request;
  request.document = example_text("robot");
  request.options.grid = 24;
  artisketch::Run run;
  const auto job = run_job(request, run);
  ASSERT_TRUE(job);
  EXPECT_FALSE(job->spheres.empty());
  for (const JointSphere& sphere : job->spheres) EXPECT_GT(sphere.radius, 0);
  EXPECT_EQ(job->fits.size(), 2u);
}

TEST(Job, SpheresComeAloneWhereTheyAreAskedFor) {
  JobRequest request;
  request.document = example_text("robot");
  request.options.grid = 24;
  artisketch::Run run, other;
  const auto whole = run_job(request, run);
  ASSERT_TRUE(whole);
  request.kind = Kind::spheres;
  request.document = whole->document;  // at the poses that the model was made at
  const auto alone = run_job(request, other);
  ASSERT_TRUE(alone);
  EXPECT_TRUE(alone->glb.empty());
  ASSERT_FALSE(alone->spheres.empty());
  ASSERT_EQ(alone->spheres.size(), whole->spheres.size());
  for (std::size_t i = 0; i < alone->spheres.size(); ++i) {
    EXPECT_EQ(alone->spheres[i].joint, whole->spheres[i].joint);
    EXPECT_EQ(alone->spheres[i].centre, whole->spheres[i].centre);
    EXPECT_NEAR(alone->spheres[i].radius, whole->spheres[i].radius, 0.1 * whole->spheres[i].radius);
  }
}

TEST(Job, FaultsOfTheDocumentComeInWords) {
  JobRequest request = heart();
  request.document = R"({"artisketch": 1})";
  artisketch::Run run;
  const auto job = run_job(request, run);
  ASSERT_FALSE(job);
  EXPECT_EQ(job.error().kind, Error::Kind::bad_input);
  EXPECT_NE(job.error().text().find("camera"), std::string::npos) << job.error().text();
}

TEST(Job, ProgressRisesToOneAndNamesParts) {
  artisketch::Run run;
  std::vector<Progress> seen;
  run.on_progress = [&seen](const Progress& now) { seen.push_back(now); };
  ASSERT_TRUE(run_job(heart(), run));
  ASSERT_FALSE(seen.empty());
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end(), [](const Progress& a, const Progress& b) {
    return a.fraction < b.fraction;
  }));
  EXPECT_EQ(seen.back().fraction, 1);
  EXPECT_TRUE(std::any_of(seen.begin(), seen.end(), [](const Progress& p) {
    return p.stage == "surfaces" && !p.item.empty();
  }));
}

TEST(Job, CancelledBeforeItBegins) {
  const std::atomic<bool> cancel = true;
  artisketch::Run run;
  run.cancel = &cancel;
  for (const Kind kind : {Kind::reconstruct, Kind::calibrate}) {
    const auto job = run_job(heart(kind), run);
    ASSERT_FALSE(job);
    EXPECT_EQ(job.error().kind, Error::Kind::cancelled);
  }
}

TEST(Job, WhatIsThrownBecomesWords) {
  artisketch::Run run;
  run.on_progress = [](const Progress&) { throw std::bad_alloc(); };
  const auto starved = run_job(heart(), run);
  ASSERT_FALSE(starved);
  EXPECT_EQ(starved.error().kind, Error::Kind::out_of_memory);
  run.on_progress = [](const Progress&) { throw std::runtime_error("the roof fell in"); };
  const auto broken = run_job(heart(), run);
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().kind, Error::Kind::crashed);
  EXPECT_NE(broken.error().text().find("the roof fell in"), std::string::npos);
}

TEST(Job, LackOfMemorySuggestsACoarserGridWhileThereIsOne) {
  EXPECT_NE(out_of_memory(96).text().find("try 64"), std::string::npos);
  EXPECT_NE(out_of_memory(32).text().find("try smaller drawings"), std::string::npos);
  EXPECT_EQ(out_of_memory({}).text().find("grid"), std::string::npos);
}

}  // namespace
}  // namespace artisketch
