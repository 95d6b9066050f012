// The whole run on the examples, as a user would have it.
#include <algorithm>

#include <gtest/gtest.h>

#include "files/document_file.h"
#include "model/stages.h"

namespace artisketch {
namespace {

Document example(const std::string& name) {
  Result<Document> document =
      read_document(ARTISKETCH_SOURCE_DIR "/assets/examples/" + name + "/" + name + ".artisketch");
  EXPECT_TRUE(document) << (document ? "" : document.error().text());
  return std::move(document).value();
}

void expect_sound(const Model& model) {
  const Topology t = topology(model.mesh);
  EXPECT_TRUE(t.manifold());
  EXPECT_EQ(t.components, 1);
  EXPECT_GT(signed_volume(model.mesh), 0);
  for (int v = 0; v < model.weights.weights.rows(); ++v)
    ASSERT_NEAR(model.weights.weights.row(v).sum(), 1, 1e-9);
}

class Pipeline : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, Pipeline, testing::Values(Method::paper, Method::rays),
                         [](const auto& info) { return kMethodNames[int(info.param)]; });

TEST_P(Pipeline, TwoCirclesGiveASphere) {
  PipelineOptions options;
  options.method = GetParam();
  artisketch::Run run;
  const auto result = reconstruct(example("circles"), options, run);
  ASSERT_TRUE(result);
  expect_sound(result->model);
  const Box3 box = bounds(result->model.mesh.V);
  const double radius = box.sizes().mean() / 2;
  EXPECT_NEAR(signed_volume(result->model.mesh), 4.0 / 3 * kPi * std::pow(radius, 3),
              0.05 * 4.0 / 3 * kPi * std::pow(radius, 3));
  EXPECT_EQ(topology(result->model.mesh).genus(), 0);
}

TEST_P(Pipeline, TheHeartsShiftIsFound) {
  PipelineOptions options;
  options.method = GetParam();
  options.grid = 48;
  artisketch::Run run;
  const Document heart = example("heart");
  const auto result = reconstruct(heart, options, run);
  ASSERT_TRUE(result);
  expect_sound(result->model);
  // The second drawing stands 20 % of the heart's height too low.
  const Frame& front = heart.frames[0];
  const double height =
      bounds(std::span(&front.contours[0].line, 1)).sizes().y() / heart.camera.pixels_per_unit;
  const double moved =
      result->calibrated.frames[1].pose.root_position.y() - heart.frames[1].pose.root_position.y();
  // The paper's rays rest where they share a voxel: a pose is told as close as that, a pixel or
  // two.
  const double width = bounds(std::span(&front.contours[0].line, 1)).sizes().x() / height /
                       heart.camera.pixels_per_unit;
  const double voxel = 1.6 * std::hypot(1, width) / 96;  // of the heart's height
  EXPECT_NEAR(std::abs(moved) / height, 0.2, GetParam() == Method::paper ? voxel : 0.015);
  const double covered = GetParam() == Method::paper ? 0.9 : 0.999;
  for (const PartCoverage& c : result->calibration->coverage) EXPECT_GE(c.after, covered);
}

TEST_P(Pipeline, TheHerosSilhouettesFit) {
  PipelineOptions options;
  options.method = GetParam();
  artisketch::Run run;
  const auto result = reconstruct(example("hero"), options, run);
  ASSERT_TRUE(result);
  expect_sound(result->model);
  ASSERT_EQ(result->fits.size(), 3u);
  // The paper's calibration leaves joints some pixels off where ours leaves one.
  const double fits = GetParam() == Method::paper ? 0.88 : 0.95;
  for (const FrameFit& fit : result->fits) EXPECT_GE(fit.iou, fits);
}

TEST_P(Pipeline, APartOfOpenContoursAloneIsMadeOfThem) {
  PipelineOptions options;
  options.method = GetParam();
  options.grid = 32;
  artisketch::Run run;
  Document open = example("heart");
  const auto closed = reconstruct(open, options, run);
  for (Frame& frame : open.frames)
    for (Contour& contour : frame.contours) contour.line.closed = false;
  const auto made = reconstruct(open, options, run);
  ASSERT_TRUE(closed && made) << made.error().text();
  EXPECT_EQ(made->model.mesh.V, closed->model.mesh.V);
  EXPECT_FALSE(made->calibrated.frames[0].contours[0].line.closed) << "the drawing stays as it is";
}

TEST(Pipeline, TheDocumentsSettingsStandOverTheDefaultsWhereTheySayAnything) {
  PipelineOptions usual;
  usual.grid = 64;
  EXPECT_EQ(with_settings(usual, {}).grid, 64);
  EXPECT_EQ(with_settings(usual, {}).method, kDefaultMethod);
  DocumentSettings settings;
  settings.grid = 32;
  settings.method = "paper";
  settings.mirror = false;
  settings.triangles = 500;
  settings.texture = false;
  const PipelineOptions options = with_settings(usual, settings);
  EXPECT_EQ(options.grid, 32);
  EXPECT_EQ(options.method, Method::paper);
  EXPECT_FALSE(options.mirror);
  EXPECT_EQ(options.triangles, 500);
  EXPECT_FALSE(options.texture);
}

TEST(Pipeline, IsDeterministic) {
  PipelineOptions options;
  options.grid = 32;
  artisketch::Run a, b;
  const auto one = reconstruct(example("heart"), options, a),
             two = reconstruct(example("heart"), options, b);
  ASSERT_TRUE(one && two);
  EXPECT_EQ(one->model.mesh.V, two->model.mesh.V);
  EXPECT_EQ(one->model.mesh.F, two->model.mesh.F);
}

// Two drawings' worth of calibration, parts at once and their trace, by either method.
TEST_P(Pipeline, AnyNumberOfThreadsMakesTheSame) {
  const Document document = example(GetParam() == Method::paper ? "heart" : "robot");
  PipelineOptions options;
  options.method = GetParam();
  options.grid = 24;
  const auto made_by = [&](int threads, Trace& trace) {
    artisketch::Run run;
    run.threads = threads;
    run.trace = &trace;
    double last = 0;
    run.on_progress = [&](const Progress& now) {
      EXPECT_GE(now.fraction, last);
      last = now.fraction;
    };
    return reconstruct(document, options, run);
  };
  Trace trace_of_one;
  const auto one = made_by(1, trace_of_one);
  ASSERT_TRUE(one);
  for (const int threads : {2, 5}) {
    Trace trace;
    const auto several = made_by(threads, trace);
    ASSERT_TRUE(several);
    EXPECT_EQ(one->model.mesh.V, several->model.mesh.V);
    EXPECT_EQ(one->model.mesh.F, several->model.mesh.F);
    EXPECT_EQ(one->model.weights.weights, several->model.weights.weights);
    EXPECT_EQ(one->warnings, several->warnings);
    EXPECT_EQ(one->calibration->iterations, several->calibration->iterations);
    for (std::size_t f = 0; f < one->fits.size(); ++f) {
      EXPECT_EQ(one->fits[f].iou, several->fits[f].iou);
      ASSERT_EQ(one->fits[f].parts.size(), several->fits[f].parts.size());
      for (std::size_t p = 0; p < one->fits[f].parts.size(); ++p)
        EXPECT_EQ(one->fits[f].parts[p].distance, several->fits[f].parts[p].distance);
    }
    ASSERT_EQ(trace.entries.size(), trace_of_one.entries.size());
    for (std::size_t i = 0; i < trace.entries.size(); ++i)
      EXPECT_EQ(trace.entries[i].name, trace_of_one.entries[i].name);
  }
}

TEST(Pipeline, EveryStageTellsItsTimesAndMemory) {
  PipelineOptions options;
  options.grid = 24;
  artisketch::Run run;
  const auto made = reconstruct(example("heart"), options, run);
  ASSERT_TRUE(made);
  double peak = 0, cpu = 0;
  for (const StageTime& stage : made->stages) {
    EXPECT_GE(stage.seconds, 0) << stage.stage;
    EXPECT_GE(stage.cpu_seconds, 0) << stage.stage;
    EXPECT_GE(stage.peak_bytes, peak) << stage.stage;  // so far
    peak = stage.peak_bytes;
    cpu += stage.cpu_seconds;
  }
  EXPECT_GT(cpu, 0);
  EXPECT_GT(peak, 1e6);
}

TEST(Pipeline, HasTheTrianglesAskedForOrSaysWhyNot) {
  PipelineOptions options;
  options.grid = 32;
  for (const int wanted : {500, 4000, 120000, 4}) {
    options.triangles = wanted;
    artisketch::Run run;
    const auto result = reconstruct(example("heart"), options, run);
    ASSERT_TRUE(result);
    const double made = double(result->model.mesh.F.rows());
    const bool met = std::abs(made - wanted) <= 0.02 * wanted;
    EXPECT_EQ(met, wanted != 4) << made;
    const auto says = [](const std::string& w) { return w.find(" triangles") != w.npos; };
    EXPECT_EQ(std::count_if(result->warnings.begin(), result->warnings.end(), says), met ? 0 : 1);
  }
  // As few as half a pixel allows: more for a finer drawing, and no number to miss.
  options.triangles = 0;
  artisketch::Run run;
  const auto result = reconstruct(example("heart"), options, run);
  ASSERT_TRUE(result);
  EXPECT_GT(result->model.mesh.F.rows(), 200);
  EXPECT_LT(result->model.mesh.F.rows(), 6000);
  for (const FrameFit& fit : result->fits) EXPECT_GE(fit.iou, 0.96);
}

// A hole of a pixel in one outline would pierce the part, and dent what is smoothed over it.
TEST(Pipeline, SpecksOfAPixelAreNoHoles) {
  PipelineOptions options;
  options.grid = 48;
  const Document clean = example("circles");
  Document specked = clean;
  Contour speck = specked.frames[0].contours[0];
  Vec2 middle = Vec2::Zero();
  for (const Vec2& p : speck.line.points) middle += p / double(speck.line.points.size());
  for (const Vec2& at : {Vec2(middle), Vec2(middle.x(), 3)}) {  // in it, and beside it
    speck.line.points = {at, at + Vec2(1, 0), at + Vec2(1, 1), at + Vec2(0, 1)};
    specked.frames[0].contours.push_back(speck);
  }
  artisketch::Run a, b;
  const auto one = reconstruct(clean, options, a), two = reconstruct(specked, options, b);
  ASSERT_TRUE(one && two);
  EXPECT_EQ(topology(two->model.mesh).genus(), 0);
  const double volume = signed_volume(one->model.mesh);
  EXPECT_NEAR(signed_volume(two->model.mesh), volume, 0.002 * volume);
  const auto says = [](const std::string& w) { return w.find("2 specks") != w.npos; };
  EXPECT_EQ(std::count_if(two->warnings.begin(), two->warnings.end(), says), 1);
  EXPECT_EQ(one->warnings.size() + 1, two->warnings.size());
}

TEST(Pipeline, StopsWhenAsked) {
  const std::atomic<bool> stop = true;
  artisketch::Run run;
  run.cancel = &stop;
  const auto result = reconstruct(example("heart"), {}, run);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, Error::Kind::cancelled);
}

// A new drawing has the pose of the one before it, until somebody gives it its own: outlined
// already, it would carve the body from a wrong side.
TEST(PipelineAlone, ADrawingWithoutAPoseShapesNothing) {
  PipelineOptions options;
  options.grid = 32;
  options.triangles = 2000;
  artisketch::Run run;
  const Document hero = example("hero");
  Document without = hero;
  without.frames[2].contours.clear();
  const auto two = reconstruct(without, options, run);
  ASSERT_TRUE(two);

  Document unposed = hero;
  unposed.frames[2].posed = false;
  unposed.frames[2].pose = unposed.frames[1].pose;
  const auto made = reconstruct(unposed, options, run);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->model.mesh.V, two->model.mesh.V);
  EXPECT_EQ(made->model.mesh.F, two->model.mesh.F);
  EXPECT_EQ(made->calibrated.frames[2].contours.size(), hero.frames[2].contours.size());
  const auto told = std::count_if(
      made->warnings.begin(), made->warnings.end(),
      [](const std::string& words) { return words.find("isn't posed yet") != words.npos; });
  EXPECT_EQ(told, 1);
}

}  // namespace
}  // namespace artisketch
