#include "files/report_file.h"

#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace artisketch {
namespace {

Document two_frames() {
  Document document;
  document.name = "two";
  document.skeleton.joints = {{"hips", -1, {0, 0, 0}, -1, ""}, {"arm \"L\"", 0, {1, 0, 0}, -1, ""}};
  document.frames.resize(2);
  document.frames[0].name = "front";
  return document;
}

Calibration some_calibration() {
  Calibration calibration;
  calibration.scales = {1, 1.25};
  calibration.energy_before = 200.5;
  calibration.energy_after = 3;
  calibration.iterations = 12;
  calibration.largest_rotation = radians(7.5);
  calibration.largest_rotation_joint = 1;
  calibration.largest_translation = 0.25;
  calibration.coverage = {{1, 0, 0.5, 0.99}, {0, 1, 0.75, 1}};
  calibration.undetermined = {"twist of 'hips'"};
  return calibration;
}

void expect_calibration(const nlohmann::json& read) {
  EXPECT_EQ(read["energy_before"], 200.5);
  EXPECT_EQ(read["energy_after"], 3);
  EXPECT_EQ(read["iterations"], 12);
  EXPECT_EQ(read["largest_rotation"]["joint"], "arm \"L\"");
  EXPECT_NEAR(read["largest_rotation"]["degrees"].get<double>(), 7.5, 1e-12);
  EXPECT_EQ(read["largest_translation"], 0.25);
  EXPECT_EQ(read["scales"], nlohmann::json::array({1, 1.25}));
  ASSERT_EQ(read["coverage"].size(), 2u);
  EXPECT_EQ(read["coverage"][0],
            nlohmann::json::parse(
                R"({"joint": "arm \"L\"", "frame": "front", "before": 0.5, "after": 0.99})"));
  EXPECT_EQ(read["coverage"][1]["frame"], 2);  // it has no name
  EXPECT_EQ(read["undetermined"], nlohmann::json::array({"twist of 'hips'"}));
}

TEST(ReportFile, ARunTellsStagesFitsAndCalibration) {
  Reconstruction result;
  result.stages = {{"hull", 0.5, 0.75, 2e6, {{"cells", 1000000}, {"vertices", 8000}}},
                   {"skin", 0.25, 0.25, 0, {}}};
  result.fits.resize(2);
  result.fits[0] = {0.97, {{0, 1.5}, {1, std::numeric_limits<double>::quiet_NaN()}}};
  result.coloured = {0.75, 0.25};
  result.calibration = some_calibration();
  result.warnings = {"'hips' was seen once"};
  const auto report = nlohmann::json::parse(report_text(two_frames(), result));
  EXPECT_EQ(report["document"], "two");
  EXPECT_EQ(report["stages"][0]["stage"], "hull");
  EXPECT_EQ(report["stages"][0]["seconds"], 0.5);
  EXPECT_EQ(report["stages"][0]["cpu_seconds"], 0.75);
  EXPECT_EQ(report["stages"][0]["peak_bytes"], 2e6);
  EXPECT_FALSE(report["stages"][1].contains("peak_bytes"));  // unknown, not nothing
  EXPECT_EQ(report["frames"][1]["coloured"], 0.25);
  EXPECT_EQ(report["stages"][0]["sizes"]["cells"], 1000000);
  ASSERT_EQ(report["frames"].size(), 2u);
  EXPECT_EQ(report["frames"][0]["frame"], "front");
  EXPECT_EQ(report["frames"][0]["iou"], 0.97);
  EXPECT_EQ(report["frames"][0]["parts"][0]["joint"], "hips");
  EXPECT_EQ(report["frames"][0]["parts"][0]["contour_distance"], 1.5);
  EXPECT_TRUE(report["frames"][0]["parts"][1]["contour_distance"].is_null());
  expect_calibration(report["calibration"]);
  EXPECT_EQ(report["model"]["triangles"], 0);
  EXPECT_EQ(report["warnings"][0], "'hips' was seen once");
}

TEST(ReportFile, ARunWithoutCalibrationSaysSo) {
  const auto report = nlohmann::json::parse(report_text(two_frames(), Reconstruction()));
  EXPECT_TRUE(report.contains("calibration"));
  EXPECT_TRUE(report["calibration"].is_null());
}

TEST(ReportFile, CalibrationAloneIsOneStage) {
  const auto report = nlohmann::json::parse(
      report_text(two_frames(), some_calibration(), {"calibrate", 1.75, 1.5, 1e6, {}}));
  ASSERT_EQ(report["stages"].size(), 1u);
  EXPECT_EQ(report["stages"][0]["seconds"], 1.75);
  EXPECT_EQ(report["stages"][0]["cpu_seconds"], 1.5);
  expect_calibration(report["calibration"]);
}

}  // namespace
}  // namespace artisketch
