#include <cmath>

#include <gtest/gtest.h>

#include "base/self_intersection.h"
#include "model/consolidate/consolidated.h"
#include "model/consolidate/part_tree.h"
#include "model/solid_parts.h"

namespace artisketch {
namespace {

using namespace figures;

Document document_of(const Figure& figure) {
  Document document;
  document.skeleton = figure.skeleton;
  return document;
}

struct Made {
  Mesh mesh;
  std::vector<std::string> warnings;
};

Made consolidated(const Document& document, const std::vector<PartSurface>& parts,
                  const ConsolidateOptions& options = {}) {
  Made made;
  artisketch::Run run;
  const Result<Mesh> mesh = consolidate(document, parts, options, made.warnings, run);
  EXPECT_TRUE(mesh) << (mesh ? "" : mesh.error().text());
  if (mesh) made.mesh = *mesh;
  return made;
}

void expect_one_clean_skin(const Mesh& mesh, int genus = 0) {
  const Topology t = topology(mesh);
  EXPECT_TRUE(t.manifold());
  EXPECT_EQ(t.components, 1);
  EXPECT_EQ(t.genus(), genus);
  EXPECT_GT(signed_volume(mesh), 0);
  EXPECT_TRUE(self_intersections(mesh).empty());
}

// A bar with two legs below it, their axes `apart` units apart, each 0.1 thick.
Figure fork(double apart) {
  Figure figure;
  figure.name = "fork";
  figure.skeleton.joints.resize(3);
  for (int leg = 1; leg <= 2; ++leg) {
    Joint& joint = figure.skeleton.joints[leg];
    joint.name = leg == 1 ? "left" : "right";
    joint.parent = 0;
    joint.offset = {(leg == 1 ? 0.5 : -0.5) * apart, -0.1, 0};
  }
  figure.skeleton.joints[0].name = "bar";
  figure.parts.resize(3);
  figure.parts[0].blobs = {limb({-0.2, 0, 0}, 0.12, {0.2, 0, 0}, 0.12)};
  for (int leg = 1; leg <= 2; ++leg) {
    const Vec3 top = figure.skeleton.joints[leg].offset;
    figure.parts[leg].blobs = {limb(top, 0.1, top - Vec3(0, 0.8, 0), 0.1)};
  }
  return figure;
}

// Distances end four cells from a part's surface: what lies deeper still counts for its width.
TEST(PartTree, KnowsHowWideAPartIsBeyondItsDistances) {
  constexpr double kCell = 0.02;
  for (const double radius : {0.05, 0.2, 0.5}) {
    Document document;
    document.skeleton.joints.emplace_back().name = "rod";
    std::vector<PartSurface> parts(1);
    Grid3<float>& g = parts[0].distance;
    const Vec3 half(0.8, radius + 2 * kCell, radius + 2 * kCell);  // a rod along x
    g = Grid3<float>(-half, kCell, (2 * half / kCell).array().ceil().cast<int>());
    for (int k = 0; k < g.size.z(); ++k)
      for (int j = 0; j < g.size.y(); ++j)
        for (int i = 0; i < g.size.x(); ++i) {
          const Vec3 p = g.position(i, j, k);
          const double d = std::max(std::hypot(p.y(), p.z()) - radius, std::abs(p.x()) - 0.7);
          g(i, j, k) = float(std::clamp(d, -4 * kCell, 4 * kCell));
        }
    EXPECT_NEAR(part_tree(document, parts).nodes[0].width, 2 * radius, 0.2 * radius + kCell);
  }
}

TEST(Consolidate, MakesOneCleanSkinOfEveryFigure) {
  for (const Figure& figure : {human(0), human(1), quadruped(0), robot(0), capsule_arm()}) {
    SCOPED_TRACE(figure.name);
    const Made made = consolidated(document_of(figure), surfaces_of(figure, 40));
    expect_one_clean_skin(made.mesh);
    EXPECT_TRUE(made.warnings.empty());
  }
}

// Views from nearly one side leave a part's depth open: its grid ends before it does.
TEST(Consolidate, EndsAPartWhereItsGridCutsItOff) {
  for (int axis = 0; axis < 3; ++axis)
    for (const bool low : {false, true}) {
      Document document;
      document.skeleton.joints.emplace_back().name = "beam";
      std::vector<PartSurface> parts(1);
      Grid3<float>& g = parts[0].distance;
      g = Grid3<float>(Vec3(-1, -1, -1), 0.05, Index3::Constant(41), 1);
      for (int k = 0; k < 41; ++k)
        for (int j = 0; j < 41; ++j)
          for (int i = 0; i < 41; ++i) {
            const Vec3 p = g.position(i, j, k);
            const double along = low ? -p[axis] : p[axis];
            Vec3 across = p;
            across[axis] = std::min(along + 0.5, 0.0);  // endless beyond -0.5
            g(i, j, k) = float(across.norm() - 0.3);
          }
      const Made made = consolidated(document, parts);
      expect_one_clean_skin(made.mesh);
      const Box3 box = bounds(made.mesh.V);
      EXPECT_LT((low ? -1 : 1) * (low ? box.min() : box.max())[axis], 1.01);
      EXPECT_GT((low ? -1 : 1) * (low ? box.min() : box.max())[axis], 0.9);
    }
}

TEST(Consolidate, StaysOnThePartsOutsideTheSpheres) {
  const Figure figure = human(0);
  const Document document = document_of(figure);
  const std::vector<PartSurface> parts = surfaces_of(figure, 64);
  const Mesh mesh = consolidated(document, parts).mesh;
  const std::vector<JointSphere> spheres = joint_spheres(document, parts);
  double edge = 0;
  for (int f = 0; f < mesh.F.rows(); ++f)
    edge += (mesh.V.row(mesh.F(f, 0)) - mesh.V.row(mesh.F(f, 1))).norm() / double(mesh.F.rows());
  int outside = 0;
  for (int v = 0; v < mesh.V.rows(); ++v) {
    const Vec3 p = mesh.V.row(v).transpose();
    bool in_sphere = false;
    for (const JointSphere& s : spheres) in_sphere |= (p - s.centre).norm() < s.radius;
    if (in_sphere) continue;
    ++outside;
    // Legs that touch keep a gap of two cells.
    const double d = distance(figure, p);
    EXPECT_LT(d, edge / 2);
    if (std::abs(p.x()) > 2 * edge) {
      EXPECT_GT(d, -edge / 2) << p.transpose();
    }
  }
  EXPECT_GT(outside, mesh.V.rows() / 2);
}

TEST(Consolidate, RoundsTheCreaseAtAnElbow) {
  const Figure arm = capsule_arm();
  const Document document = document_of(arm);
  const std::vector<PartSurface> parts = surfaces_of(arm, 40);
  const auto sharpest = [&](const Mesh& mesh, const JointSphere& sphere) {
    const Points3 N = vertex_normals(mesh);
    double least = 1;
    for (int f = 0; f < mesh.F.rows(); ++f)
      for (int c = 0; c < 3; ++c) {
        const int a = mesh.F(f, c), b = mesh.F(f, (c + 1) % 3);
        if ((mesh.V.row(a).transpose() - sphere.centre).norm() < 0.9 * sphere.radius)
          least = std::min(least, N.row(a).dot(N.row(b)));
      }
    return std::acos(least);
  };
  const Mesh blended = consolidated(document, parts).mesh;
  const Mesh plain = consolidated(document, parts, {.blend = false}).mesh;
  for (const JointSphere& sphere : joint_spheres(document, parts)) {
    EXPECT_LT(sharpest(blended, sphere), radians(25));
    EXPECT_LE(sharpest(blended, sphere), sharpest(plain, sphere) + 1e-9);
  }
  EXPECT_NEAR(signed_volume(blended), signed_volume(plain), 0.01 * signed_volume(plain));
}

TEST(Consolidate, KeepsAPartsOwnHole) {
  Figure ring;
  ring.skeleton.joints.resize(1);
  const auto torus = [](const Vec3& p) {
    return std::hypot(std::hypot(p.x(), p.y()) - 0.4, p.z()) - 0.1;
  };
  const Box3 box(Vec3(-0.6, -0.6, -0.2), Vec3(0.6, 0.6, 0.2));
  PartSurface part;
  part.mesh = polygonise(torus, box, 0.03);
  part.distance = Grid3<float>(box.min(), 0.03, Index3(41, 41, 14));
  for (int k = 0; k < 14; ++k)
    for (int j = 0; j < 41; ++j)
      for (int i = 0; i < 41; ++i)
        part.distance(i, j, k) = float(torus(part.distance.position(i, j, k)));
  expect_one_clean_skin(consolidated(document_of(ring), {part}).mesh, 1);
}

TEST(Consolidate, FillsTheGapBetweenPartsThatMeet) {
  // Two boxes face to face, a slit between them that five studs bridge: handles, but for a filling.
  Figure figure;
  figure.skeleton.joints.resize(2);
  figure.skeleton.joints[1].parent = 0;
  figure.parts.resize(2);
  figure.parts[0].blobs = {box({-0.26, 0, 0}, {0.25, 0.2, 0.2}, 0.02)};
  figure.parts[1].blobs = {box({0.26, 0, 0}, {0.25, 0.2, 0.2}, 0.02)};
  for (const Vec3& at : {Vec3(0, 0, 0), Vec3(0, 0.12, 0.12), Vec3(0, -0.12, 0.12),
                         Vec3(0, 0.12, -0.12), Vec3(0, -0.12, -0.12)})
    figure.parts[1].blobs.push_back(ball(at, 0.03));
  expect_one_clean_skin(consolidated(document_of(figure), surfaces_of(figure, 60)).mesh);
}

TEST(Consolidate, KeepsNonAdjacentPartsApart) {
  for (const double apart : {0.15, 0.19, 0.2, 0.21}) {  // 0.2: the legs just touch
    SCOPED_TRACE(apart);
    const Figure figure = fork(apart);
    const Document document = document_of(figure);
    const std::vector<PartSurface> parts = surfaces_of(figure, 48);
    const Made made = consolidated(document, parts);
    expect_one_clean_skin(made.mesh);
    EXPECT_TRUE(made.warnings.empty());
    // Spread, no triangle spans from leg to leg.
    artisketch::Run run;
    const Result<Weights> weights = skin(document, parts, made.mesh, run);
    ASSERT_TRUE(weights);
    Pose spread = rest_pose(figure.skeleton);
    spread.rotations[1] = about_z(40);
    spread.rotations[2] = about_z(-40);
    const Points3 V = posed_vertices(made.mesh.V, *weights, figure.skeleton, spread);
    for (int f = 0; f < made.mesh.F.rows(); ++f)
      for (int c = 0; c < 3; ++c)
        EXPECT_LT((V.row(made.mesh.F(f, c)) - V.row(made.mesh.F(f, (c + 1) % 3))).norm(), 0.1);
  }
}

TEST(Consolidate, TiesUpAPartThatTouchesNothing) {
  const Figure figure = human(0);
  std::vector<PartSurface> parts = surfaces_of(figure, 40);
  const int forearm = figure.skeleton.find("forearm.L");
  std::erase_if(parts, [&](const PartSurface& part) { return part.joint == forearm; });
  const Made made = consolidated(document_of(figure), parts);
  expect_one_clean_skin(made.mesh);
  ASSERT_EQ(made.warnings.size(), 1);
  EXPECT_NE(made.warnings[0].find("'hand.L'"), std::string::npos) << made.warnings[0];
  EXPECT_NE(made.warnings[0].find("'upper_arm.L'"), std::string::npos) << made.warnings[0];
}

TEST(Consolidate, SaysWhatItCannotDo) {
  const Figure figure = capsule_arm();
  std::vector<std::string> warnings;
  artisketch::Run run;
  EXPECT_FALSE(consolidate(document_of(figure), {}, {}, warnings, run));
  std::vector<PartSurface> hollow(1);
  hollow[0].distance = Grid3<float>(Vec3::Zero(), 0.1, Index3(8, 8, 8), 1.0f);
  EXPECT_FALSE(consolidate(document_of(figure), hollow, {}, warnings, run));
  const std::atomic<bool> stop = true;
  run.cancel = &stop;
  const auto stopped = consolidate(document_of(figure), surfaces_of(figure, 40), {}, warnings, run);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, Error::Kind::cancelled);
}

TEST(Consolidate, SurvivesSmallPartsFarApart) {
  Figure figure;
  figure.skeleton.joints.resize(2);
  figure.skeleton.joints[1].parent = 0;
  figure.skeleton.joints[1].offset = {100, 0, 0};
  figure.parts.resize(2);
  figure.parts[0].blobs = {ball({0, 0, 0}, 0.5)};
  figure.parts[1].blobs = {ball({100, 30, 2}, 0.5)};
  const Made made = consolidated(document_of(figure), surfaces_of(figure, 24));
  EXPECT_TRUE(topology(made.mesh).manifold());
  EXPECT_EQ(topology(made.mesh).components, 1);
  EXPECT_EQ(made.warnings.size(), 1);
}

TEST(JointSpheres, AreSixtyPercentOfTheLimbsDiameter) {
  const Figure arm = capsule_arm();
  Document document = document_of(arm);
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

// A bent arm's skin with its elbow's sphere `times` as large as it comes by itself.
Mesh with_elbow(double times, SphereUse use) {
  const Figure arm = capsule_arm();
  Document document = document_of(arm);
  const std::vector<PartSurface> parts = surfaces_of(arm, 40);
  const JointSphere elbow = joint_spheres(document, parts)[0];
  if (times != 1) document.spheres[elbow.joint].radius = times * elbow.radius;
  std::vector<std::string> warnings;
  artisketch::Run run;
  const Result<Mesh> mesh =
      artisketch::consolidated(document, parts, {}, 20000, warnings, run, use);
  EXPECT_TRUE(mesh);
  return mesh ? *mesh : Mesh{};
}

TEST(JointSpheres, OneThatTheArtistMadeOtherwiseIsSeenInTheSkin) {
  for (const SphereUse use : {SphereUse::closing, SphereUse::united}) {
    const Mesh plain = with_elbow(1, use), large = with_elbow(2, use);
    expect_one_clean_skin(large);
    EXPECT_GT(std::abs(signed_volume(large) / signed_volume(plain) - 1), 0.03) << int(use);
  }
  // As thick as the limb was, times two: the ball itself stands out.
  const Figure arm = capsule_arm();
  const std::vector<PartSurface> parts = surfaces_of(arm, 40);
  const JointSphere elbow = joint_spheres(document_of(arm), parts)[0];
  const Mesh large = with_elbow(2, SphereUse::closing);
  double out = 0;
  for (int v = 0; v < large.V.rows(); ++v)
    out = std::max(out, distance(arm, large.V.row(v).transpose()));
  EXPECT_NEAR(out, elbow.radius / 1.2, 0.15 * elbow.radius);
}

TEST(JointSpheres, ArePartOfTheSkinByThePaperAlone) {
  const Mesh ours = with_elbow(1, SphereUse::closing), papers = with_elbow(1, SphereUse::united);
  const Figure arm = capsule_arm();
  const auto farthest = [&](const Mesh& mesh) {
    double out = 0;
    for (int v = 0; v < mesh.V.rows(); ++v)
      out = std::max(out, std::abs(distance(arm, mesh.V.row(v).transpose())));
    return out;
  };
  EXPECT_GT(farthest(papers), 2 * farthest(ours));
  expect_one_clean_skin(papers);
}

TEST(JointSpheres, OfAnySizeEndInASkin) {
  for (const double times : {1e-6, 50.0, 1e9})
    for (const SphereUse use : {SphereUse::closing, SphereUse::united}) {
      const Mesh mesh = with_elbow(times, use);
      EXPECT_TRUE(topology(mesh).manifold()) << times;
      EXPECT_EQ(topology(mesh).components, 1) << times;
    }
}

}  // namespace
}  // namespace artisketch
