#include <gtest/gtest.h>

#include "base/self_intersection.h"
#include "model/solid_parts.h"

namespace artisketch {
namespace {

using namespace figures;

Result<Mesh> united(const Figure& figure, std::vector<std::string>& warnings, int cells = 40) {
  Document document;
  document.skeleton = figure.skeleton;
  Run run;
  return consolidate(document, surfaces_of(figure, cells), {}, warnings, run);
}

void expect_one_clean_skin(const Figure& figure, int genus = 0) {
  SCOPED_TRACE(figure.name);
  std::vector<std::string> warnings;
  const Result<Mesh> mesh = united(figure, warnings);
  ASSERT_TRUE(mesh) << mesh.error().text();
  const Topology t = topology(*mesh);
  EXPECT_TRUE(t.manifold());
  EXPECT_EQ(t.components, 1);
  EXPECT_EQ(t.genus(), genus);
  EXPECT_GT(signed_volume(*mesh), 0);
  EXPECT_TRUE(self_intersections(*mesh).empty());
}

TEST(Consolidate, MakesOneCleanSkinOfEveryFigure) {
  expect_one_clean_skin(human(0));
  expect_one_clean_skin(human(1));
  expect_one_clean_skin(quadruped(0));
  expect_one_clean_skin(robot(0));
  expect_one_clean_skin(capsule_arm());
}

TEST(JointSpheres, AreSixtyPercentOfTheLimbsDiameter) {
  const Figure arm = capsule_arm();
  Document document;
  document.skeleton = arm.skeleton;
  const std::vector<PartSurface> parts = surfaces_of(arm, 40);
  const std::vector<JointSphere> spheres = joint_spheres(document, parts);
  ASSERT_EQ(spheres.size(), 2);  // elbow and wrist; the shoulder has nothing above it
  for (const JointSphere& sphere : spheres) {
    EXPECT_EQ(sphere.centre, rest_positions(arm.skeleton)[sphere.joint]);
    // The limb's own radius at the joint, by its exact distance.
    const double radius = -distance(arm.parts[sphere.joint], sphere.centre);
    EXPECT_NEAR(sphere.radius, 1.2 * radius, 0.25 * radius);
  }
  document.spheres[spheres[0].joint] = {.radius = 0.5, .offset = {0, 0.1, 0}, .unknown = {}};
  const std::vector<JointSphere> tweaked = joint_spheres(document, parts);
  EXPECT_EQ(tweaked[0].radius, 0.5);
  EXPECT_EQ(tweaked[0].centre, spheres[0].centre + Vec3(0, 0.1, 0));
  EXPECT_EQ(tweaked[1].radius, spheres[1].radius);
}

}  // namespace
}  // namespace artisketch
