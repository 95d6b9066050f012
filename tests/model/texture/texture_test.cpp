#include <array>

#include <gtest/gtest.h>

#include "model/stages.h"

namespace artisketch {
namespace {

constexpr int kSize = 120;
constexpr double kScale = 40;  // pixels per unit

struct Colour {
  int r, g, b;
};
constexpr Colour kRed{200, 40, 40}, kBlue{40, 40, 200}, kInk{10, 10, 10};

Pose turned(const Skeleton& skeleton, double degrees) {
  Pose pose = rest_pose(skeleton);
  pose.rotations[0] = Quat(Eigen::AngleAxisd(radians(degrees), Vec3::UnitY()));
  return pose;
}

// A document of frames that are the rest pose turned by so many degrees.
Document document_of(const Skeleton& skeleton, const std::vector<double>& turns) {
  Document document;
  document.camera.pixels_per_unit = kScale;
  document.skeleton = skeleton;
  for (const double turn : turns) {
    Frame frame;
    frame.width = frame.height = kSize;
    frame.pose = turned(skeleton, turn);
    document.frames.push_back(frame);
  }
  return document;
}

// A disc about the picture's middle, with a line of ink round it, on nothing.
Image disc(const Colour& colour, double radius = kScale) {
  constexpr double kLine = 3;
  Image picture(kSize, kSize, 0);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const double r = (Vec2(x + 0.5, y + 0.5) - Vec2::Constant(kSize / 2.0)).norm();
      const Colour c = r > radius - kLine ? kInk : colour;
      std::uint8_t* p = picture.at(x, y);
      p[0] = c.r, p[1] = c.g, p[2] = c.b, p[3] = r < radius + 1 ? 255 : 0;
    }
  return picture;
}

Model model_of(Skeleton skeleton, Mesh mesh) {
  Model model;
  model.skeleton = std::move(skeleton);
  model.mesh = std::move(mesh);
  model.weights.joints.setZero(model.mesh.V.rows(), 4);
  model.weights.weights.setZero(model.mesh.V.rows(), 4);
  model.weights.weights.col(0).setOnes();
  return model;
}

Model ball() {
  Skeleton one;
  one.joints = {{"body", -1, Vec3::Zero(), -1, ""}};
  return model_of(one, icosphere(Vec3::Zero(), 1, 4));
}

Colour texel(const Model& model, int vertex) {
  const Image& t = *model.texture;
  const Vec2 p = model.texcoords[vertex].cwiseProduct(Vec2(t.width, t.height));
  const std::uint8_t* c = t.at(int(p.x()), int(p.y()));
  return {c[0], c[1], c[2]};
}
bool is(const Colour& a, const Colour& b, int within) {
  return std::abs(a.r - b.r) <= within && std::abs(a.g - b.g) <= within &&
         std::abs(a.b - b.b) <= within;
}

Model painted(const Document& document, const std::vector<Image>& drawings, const Model& model) {
  artisketch::Run run;
  Result<Model> result = textured(document, drawings, model, run);
  EXPECT_TRUE(result);
  return std::move(result).value();
}

TEST(Texture, TheSurfaceStaysAsItWas) {
  const Model plain = ball();
  const Model model = painted(document_of(plain.skeleton, {0}), {disc(kRed)}, plain);
  ASSERT_TRUE(model.texture);
  ASSERT_EQ(Eigen::Index(model.texcoords.size()), model.mesh.V.rows());
  EXPECT_EQ(model.weights.joints.rows(), model.mesh.V.rows());
  for (const Vec2& uv : model.texcoords) {
    EXPECT_GE(uv.minCoeff(), 0);
    EXPECT_LE(uv.maxCoeff(), 1);
  }
  const Mesh whole = welded(model.mesh);
  EXPECT_EQ(whole.V.rows(), plain.mesh.V.rows());
  EXPECT_TRUE(topology(whole).manifold());
  EXPECT_NEAR(signed_volume(whole), signed_volume(plain.mesh), 1e-12);
}

TEST(Texture, InkStaysOutlineAndTheFarSideTakesWhatSurroundsIt) {
  const Model plain = ball();
  const Model model = painted(document_of(plain.skeleton, {0}), {disc(kRed)}, plain);
  for (int v = 0; v < model.mesh.V.rows(); ++v)
    ASSERT_TRUE(is(texel(model, v), kRed, 6)) << model.mesh.V.row(v);
}

// A marker's layer at 40 % under opaque lines, on nothing: its colour as it looks on paper.
TEST(Texture, WhatIsHalfTransparentIsPaintedAsItLooksOnPaper) {
  constexpr int kAlpha = 102;
  const Model plain = ball();
  Image drawing = disc(kRed);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x)
      if (std::uint8_t* p = drawing.at(x, y); p[0] == kRed.r && p[3] > 0) p[3] = kAlpha;
  const auto pale = [](int c) { return (c * kAlpha + 255 * (255 - kAlpha)) / 255; };
  const Model model = painted(document_of(plain.skeleton, {0}), {drawing}, plain);
  for (int v = 0; v < model.mesh.V.rows(); ++v)
    ASSERT_TRUE(is(texel(model, v), {pale(kRed.r), pale(kRed.g), pale(kRed.b)}, 6))
        << model.mesh.V.row(v);
}

// A line a few pixels inside the outline would be smeared over what turns away there.
TEST(Texture, LinesOfInkStayWhereTheyAreSeenSquarely) {
  const Model plain = ball();
  Image drawing = disc(kRed);
  const auto ring = [&](double radius) {
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const double r = (Vec2(x + 0.5, y + 0.5) - Vec2::Constant(kSize / 2.0)).norm();
        std::uint8_t* p = drawing.at(x, y);
        const bool here = radius < 0.6 * kScale || (x % 24 < 6 && y < kSize / 2);  // dashes
        if (std::abs(r - radius) < 1.5 && here) p[0] = kInk.r, p[1] = kInk.g, p[2] = kInk.b;
      }
  };
  ring(0.5 * kScale);
  ring(0.9 * kScale);
  const Model model = painted(document_of(plain.skeleton, {0}), {drawing}, plain);
  int inked = 0;
  for (int v = 0; v < model.mesh.V.rows(); ++v) {
    const double z = model.mesh.V(v, 2), r = std::sqrt(1 - z * z);
    const Colour c = texel(model, v);
    if (z < 0.45) {
      EXPECT_TRUE(is(c, kRed, 6)) << model.mesh.V.row(v) << ": " << c.r;
    } else if (z > 0 && std::abs(r - 0.5) < 0.02) {
      inked += is(c, kInk, 30);
    }
  }
  EXPECT_GT(inked, 10);
}

// Hair and a face, drawn with a line between them, meet on the surface without it; the line round
// what is small, as an eye, draws that and stays.
TEST(Texture, LinesThatOnlyPartColoursAreInk) {
  constexpr double kSpot = 3.5;  // pixels
  const Vec2 spot(kSize / 2.0, kSize / 2.0 - 18);
  const Model plain = ball();
  Image drawing = disc(kRed);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      std::uint8_t* p = drawing.at(x, y);
      if (p[0] != kRed.r) continue;
      const auto paint = [&](const Colour& c) { p[0] = c.r, p[1] = c.g, p[2] = c.b; };
      if (y > kSize / 2) paint(kBlue);
      if (std::abs(y - kSize / 2) <= 1) paint(kInk);
      const double r = (Vec2(x + 0.5, y + 0.5) - spot).norm();
      if (r < kSpot) paint(kBlue);
      if (r >= kSpot && r < kSpot + 3) paint(kInk);
    }
  const Model model = painted(document_of(plain.skeleton, {0}), {drawing}, plain);
  int border = 0, ring = 0;
  for (int v = 0; v < model.mesh.V.rows(); ++v) {
    if (model.mesh.V(v, 2) < 0.6) continue;
    const bool dark = is(texel(model, v), kInk, 40);
    const Vec2 pixel =
        Vec2(kSize / 2.0 + kScale * model.mesh.V(v, 0), kSize / 2.0 - kScale * model.mesh.V(v, 1));
    if (std::abs(pixel.y() - kSize / 2.0) < 3) border += dark ? -1000 : 1;
    if (std::abs((pixel - spot).norm() - kSpot - 1.5) < 1) ring += dark;
  }
  EXPECT_GT(border, 20);
  EXPECT_GT(ring, 5);
}

// A line drawn with soft edges leaves none of its mixtures along the border that it parts.
TEST(Texture, SoftEdgesOfInkGoWithIt) {
  constexpr double kHalfLine = 1.3;  // pixels
  constexpr int kFine = 8;           // samples along a pixel
  const Colour skin{247, 203, 165}, hair{138, 74, 43};
  const Vec2 across = Vec2(-0.35, 1).normalized();
  const auto beyond = [&](double x, double y) {
    return across.dot(Vec2(x, y) - Vec2::Constant(kSize / 2.0));
  };
  const Model plain = ball();
  Image drawing = disc(skin);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      std::uint8_t* p = drawing.at(x, y);
      if (p[0] != skin.r) continue;
      Vec3 sum = Vec3::Zero();
      for (int v = 0; v < kFine; ++v)
        for (int u = 0; u < kFine; ++u) {
          const double d = beyond(x + (u + 0.5) / kFine, y + (v + 0.5) / kFine);
          const Colour& c = std::abs(d) < kHalfLine ? kInk : d > 0 ? skin : hair;
          sum += Vec3(c.r, c.g, c.b);
        }
      for (int k = 0; k < 3; ++k) p[k] = std::uint8_t(sum[k] / (kFine * kFine) + 0.5);
    }
  const Model model = painted(document_of(plain.skeleton, {0}), {drawing}, plain);
  const Image& texture = *model.texture;
  int near = 0, darker = 0;
  for (int f = 0; f < model.mesh.F.rows(); ++f) {
    const Vec3 weights = Vec3::Constant(1.0 / 3);
    Vec3 at = Vec3::Zero();
    Vec2 texel = Vec2::Zero();
    for (int k = 0; k < 3; ++k) {
      at += weights[k] * model.mesh.V.row(model.mesh.F(f, k)).transpose();
      texel += weights[k] * model.texcoords[model.mesh.F(f, k)];
    }
    const double d = beyond(kSize / 2.0 + kScale * at.x(), kSize / 2.0 - kScale * at.y());
    if (at.z() < 0.5 || std::abs(d) > 4) continue;
    const std::uint8_t* c =
        texture.at(int(texel.x() * texture.width), int(texel.y() * texture.height));
    ++near;
    darker += c[0] < hair.r - 6 || (d > 1.5 && c[0] < skin.r - 12);
  }
  EXPECT_GT(near, 50);
  EXPECT_EQ(darker, 0);
}

// A red disc, as a ball's drawing, with a blue spot wherever a place of the ball is blue.
template <class Blue>
Image spotted(const Blue& blue) {
  Image drawing = disc(kRed);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const Vec2 p = (Vec2(x + 0.5, y + 0.5) - Vec2::Constant(kSize / 2.0)) / kScale;
      const double front = 1 - p.squaredNorm();
      if (front < 0 || !blue(Vec3(p.x(), -p.y(), std::sqrt(front)))) continue;
      std::uint8_t* c = drawing.at(x, y);
      c[0] = kBlue.r, c[1] = kBlue.g, c[2] = kBlue.b;
    }
  return drawing;
}
constexpr double kSpot = 0.13;  // radians
bool within_spot(const Vec3& place, double azimuth) {
  return place.dot(Vec3(std::sin(radians(azimuth)), 0, std::cos(radians(azimuth)))) >=
         std::cos(kSpot);
}
// How many vertices are blue near a place of the equator.
int blue_at(const Model& model, double azimuth) {
  int blue = 0;
  for (int v = 0; v < model.mesh.V.rows(); ++v)
    blue += within_spot(model.mesh.V.row(v).normalized().transpose(), azimuth) &&
            is(texel(model, v), kBlue, 60);
  return blue;
}

// Two drawings of a ball with one dark spot, which the second has 17° from where the first has it:
// as where a model's depth is a little off.
TEST(Texture, ADetailIsPaintedOnce) {
  const Model plain = ball();
  const auto with_spot = [](double azimuth) {
    return spotted([&](const Vec3& place) { return within_spot(place, azimuth); });
  };
  const double turn = -75;
  const Model model =
      painted(document_of(plain.skeleton, {0, turn}), {with_spot(57), with_spot(74 + turn)}, plain);
  const int first = blue_at(model, 57), second = blue_at(model, 74);
  EXPECT_GT(std::max(first, second), 5);
  EXPECT_EQ(std::min(first, second), 0);
}

// An eye lies in a hollow that no outline shows: drawings from the front and from the side lay it
// on places that only one of them sees, and their rays meet where it is.
TEST(Texture, ADetailInAHollowIsPaintedOnce) {
  const Model plain = ball();
  constexpr double kDeep = 0.42;  // x and z of the eye
  const double front = degrees(std::asin(kDeep)), side = 90 - front;
  const auto with_spot = [](double azimuth) {
    return spotted([&](const Vec3& place) { return within_spot(place, azimuth); });
  };
  const Model model = painted(document_of(plain.skeleton, {0, -90}),
                              {with_spot(front), with_spot(side - 90)}, plain);
  EXPECT_GT(blue_at(model, front), 5);
  EXPECT_EQ(blue_at(model, side), 0);
}

// Spots round a ball are as many as they are, though each drawing shows one beside where the other
// shows another.
TEST(Texture, DetailsThatAreAlikeAllStay) {
  const Model plain = ball();
  constexpr int kSpots = 12;
  const auto all = [](double turn) {
    return spotted([&](const Vec3& place) {
      for (int i = 0; i < kSpots; ++i)
        if (within_spot(place, 360.0 * i / kSpots + turn)) return true;
      return false;
    });
  };
  const Model model = painted(document_of(plain.skeleton, {0, -90}), {all(0), all(-90)}, plain);
  for (const double azimuth : {-30, 0, 30, 60, 90, 120})
    EXPECT_GT(blue_at(model, azimuth), 5) << azimuth;
}

// The model may reach a few pixels beyond the figure, onto paper that isn't transparent.
TEST(Texture, PaperBesideTheOutlinesIsNoColour) {
  const Model plain = ball();
  Image drawing = disc(kRed, 0.9 * kScale);
  for (std::size_t i = 0; i < drawing.rgba.size(); i += 4)
    if (drawing.rgba[i + 3] == 0) std::fill_n(&drawing.rgba[i], 4, (unsigned char)(255));
  for (const double radius : {0.9, 1.0}) {  // of the outline
    Polyline outline;
    for (int i = 0; i < 64; ++i) {
      const double angle = i * 2 * kPi / 64;
      outline.points.push_back(Vec2::Constant(kSize / 2.0) +
                               radius * kScale * Vec2(std::cos(angle), std::sin(angle)));
    }
    Document document = document_of(plain.skeleton, {0});
    document.frames[0].contours = {{0, outline, ""}};
    const Model model = painted(document, {drawing}, plain);
    for (int v = 0; v < model.mesh.V.rows(); ++v)
      ASSERT_TRUE(is(texel(model, v), kRed, 6)) << radius << ": " << model.mesh.V.row(v);
  }
}

Polyline circle(double radius) {
  Polyline outline;
  for (int i = 0; i < 64; ++i) {
    const double angle = i * 2 * kPi / 64;
    outline.points.push_back(Vec2::Constant(kSize / 2.0) +
                             radius * kScale * Vec2(std::cos(angle), std::sin(angle)));
  }
  return outline;
}

// What a cut-out figure leaves outside its outlines is ink alone: that is no paper, and a leg in a
// stocking as dark as ink keeps it.
TEST(Texture, DarkPlacesOfACutOutFigureStay) {
  constexpr double kThin = 0.1, kLine = 2;  // pixels of ink
  constexpr Colour kDark{24, 20, 20};
  Model leg = ball();
  leg.mesh.V.col(0) *= kThin;
  Document document = document_of(leg.skeleton, {0});
  Polyline outline = circle(1);
  for (Vec2& p : outline.points) p.x() = kSize / 2.0 + kThin * (p.x() - kSize / 2.0);
  document.frames[0].contours = {{0, outline, ""}};
  Image drawing(kSize, kSize, 0);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const Vec2 p = Vec2(x + 0.5, y + 0.5) - Vec2::Constant(kSize / 2.0);
      const auto within = [&](double more) {
        return p.cwiseQuotient(Vec2(kThin * kScale + more, kScale + more)).norm() < 1;
      };
      const Colour c = !within(0) ? kInk : p.y() > 0 ? kDark : kRed;
      std::uint8_t* to = drawing.at(x, y);
      to[0] = c.r, to[1] = c.g, to[2] = c.b, to[3] = within(kLine) ? 255 : 0;
    }
  const Model model = painted(document, {drawing}, leg);
  int dark = 0;
  for (int v = 0; v < model.mesh.V.rows(); ++v)
    if (model.mesh.V(v, 1) < -0.3) {
      EXPECT_LT(texel(model, v).r, (kDark.r + kRed.r) / 2) << model.mesh.V.row(v);
      ++dark;
    }
  EXPECT_GT(dark, 100);
}

// A drawing in which most of a part has no outline doesn't paint it with the colour of the rest.
TEST(Texture, ColoursDontRunOverWhatADrawingDoesNotShow) {
  const Model plain = ball();
  Document document = document_of(plain.skeleton, {0, 180});
  document.frames[0].contours = {{0, circle(0.3), ""}};
  document.frames[1].contours = {{0, circle(1), ""}};
  const Model model = painted(document, {disc(kRed, 0.3 * kScale), disc(kBlue)}, plain);
  int middle = 0, rim = 0;
  for (int v = 0; v < model.mesh.V.rows(); ++v) {
    const double z = model.mesh.V(v, 2);
    if (z > 0.98) middle += is(texel(model, v), kRed, 6) ? 1 : -1000;
    if (z > 0.05 && z < 0.3) rim += texel(model, v).b > texel(model, v).r ? 1 : -1000;
  }
  EXPECT_GT(middle, 5);
  EXPECT_GT(rim, 100);
}

TEST(Texture, EachSideComesFromTheDrawingThatShowsIt) {
  const Model plain = ball();
  // Turned by −90° the model's +x side faces the camera.
  const Model model =
      painted(document_of(plain.skeleton, {0, -90}), {disc(kRed), disc(kBlue)}, plain);
  int red = 0, blue = 0;
  for (int v = 0; v < model.mesh.V.rows(); ++v) {
    if (model.mesh.V(v, 2) > 0.95) red += is(texel(model, v), kRed, 6) ? 1 : -1000;
    if (model.mesh.V(v, 0) > 0.95) blue += is(texel(model, v), kBlue, 6) ? 1 : -1000;
  }
  EXPECT_GT(red, 20);
  EXPECT_GT(blue, 20);
}

// Two balls, one behind the other in the only drawing.
Model pair_of_balls(bool mirrors) {
  Skeleton skeleton;
  skeleton.joints = {{"root", -1, Vec3::Zero(), 0, ""},
                     {"ball.L", 0, {1.5, 0, 0}, mirrors ? 2 : -1, ""},
                     {"ball.R", 0, {-1.5, 0, 0}, mirrors ? 1 : -1, ""}};
  Mesh left = icosphere({1.5, 0, 0}, 1, 3), both = left;
  const Mesh right = icosphere({-1.5, 0, 0}, 1, 3);
  const auto n = left.V.rows();
  both.V.conservativeResize(2 * n, 3);
  both.V.bottomRows(n) = right.V;
  both.F.conservativeResize(2 * left.F.rows(), 3);
  both.F.bottomRows(left.F.rows()) = right.F.array() + int(n);
  Model model = model_of(skeleton, both);
  for (int v = 0; v < 2 * n; ++v) model.weights.joints(v, 0) = v < n ? 1 : 2;
  return model;
}

TEST(Texture, WhatIsHiddenIsPaintedLikeItsMirrorImage) {
  // Red in front, where x is positive, with a blue middle; the ball behind is never seen.
  Image drawing = disc(kRed);
  const Image spot = disc(kBlue, 14);
  for (int i = 0; i < kSize * kSize; ++i) {
    const double r = (Vec2(i % kSize + 0.5, i / kSize + 0.5) - Vec2::Constant(kSize / 2.0)).norm();
    if (r < 10) std::copy_n(&spot.rgba[4 * i], 4, &drawing.rgba[4 * i]);
  }
  for (const bool mirrors : {true, false}) {
    const Model plain = pair_of_balls(mirrors);
    const Model model = painted(document_of(plain.skeleton, {-90}), {drawing}, plain);
    int spots = 0;
    for (int v = 0; v < model.mesh.V.rows(); ++v)
      if (model.mesh.V(v, 0) < -2.48) spots += is(texel(model, v), kBlue, 6);
    EXPECT_EQ(spots > 0, mirrors);
    // Of what hangs together with nothing that is seen nothing is known: it is no darker than that.
    for (int v = 0; v < model.mesh.V.rows(); ++v)
      if (!mirrors && model.mesh.V(v, 0) < 0) {
        ASSERT_TRUE(is(texel(model, v), kRed, 6)) << model.mesh.V.row(v);
      }
  }
}

// A hand before a body, drawn a few pixels from where the model has it: what its outline holds is
// the hand, also where the model shows the body beside it.
TEST(Texture, WhatStandsBeforeAPartIsNotPaintedOnIt) {
  constexpr double kHand = 0.3, kOff = 0.12;  // units
  Skeleton skeleton;
  skeleton.joints = {{"body", -1, Vec3::Zero(), -1, ""}, {"hand", 0, {0, 0, 1.5}, -1, ""}};
  Mesh mesh = icosphere(Vec3::Zero(), 1, 4);
  const Mesh hand = icosphere({0, 0, 1.5}, kHand, 3);
  const Eigen::Index n = mesh.V.rows(), m = mesh.F.rows();
  mesh.V.conservativeResize(n + hand.V.rows(), 3);
  mesh.V.bottomRows(hand.V.rows()) = hand.V;
  mesh.F.conservativeResize(m + hand.F.rows(), 3);
  mesh.F.bottomRows(hand.F.rows()) = hand.F.array() + int(n);
  Model model = model_of(skeleton, mesh);
  for (Eigen::Index v = n; v < mesh.V.rows(); ++v) model.weights.joints(v, 0) = 1;
  Image drawing = disc(kRed);
  const Vec2 middle = Vec2::Constant(kSize / 2.0) + Vec2(kOff * kScale, 0);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x)
      if ((Vec2(x + 0.5, y + 0.5) - middle).norm() < kHand * kScale) {
        std::uint8_t* p = drawing.at(x, y);
        p[0] = kBlue.r, p[1] = kBlue.g, p[2] = kBlue.b;
      }
  Document document = document_of(skeleton, {0});
  Polyline round_hand = circle(kHand);
  for (Vec2& p : round_hand.points) p.x() += kOff * kScale;
  document.frames[0].contours = {{0, circle(1), ""}, {1, round_hand, ""}};
  const Model made = painted(document, {drawing}, model);
  int body = 0, blue = 0;
  for (int v = 0; v < made.mesh.V.rows(); ++v) {
    const Colour c = texel(made, v);
    if (made.weights.joints(v, 0) == 0) {
      EXPECT_TRUE(is(c, kRed, 8)) << made.mesh.V.row(v) << ": " << c.r;
      ++body;
    } else {
      blue += is(c, kBlue, 8);
    }
  }
  EXPECT_GT(body, int(n) - 1);
  EXPECT_GT(blue, int(hand.V.rows()) / 2);
}

// A belt goes on round the back, and no colour there is a mixture.
// A belt across the middle.
constexpr int kHalf = 10;  // pixels: of its height
Image belted_disc() {
  Image drawing = disc(kRed);
  for (int y = kSize / 2 - kHalf; y < kSize / 2 + kHalf; ++y)
    for (int x = 0; x < kSize; ++x) {
      std::uint8_t* p = drawing.at(x, y);
      if (p[0] == kRed.r) p[0] = kBlue.r, p[1] = kBlue.g, p[2] = kBlue.b;
    }
  return drawing;
}

TEST(Texture, WhatNoDrawingShowsHasThePartsColoursUnmixed) {
  const Model plain = ball();
  const Model model = painted(document_of(plain.skeleton, {0}), {belted_disc()}, plain);
  int round = 0, belt = 0, mixed = 0, back = 0;
  for (int v = 0; v < model.mesh.V.rows(); ++v) {
    if (model.mesh.V(v, 2) > -0.2) continue;
    const Colour c = texel(model, v);
    const double height = std::abs(model.mesh.V(v, 1));
    ++back;
    mixed += !is(c, kRed, 30) && !is(c, kBlue, 30);
    if (height < 0.1) {
      ++round;
      belt += is(c, kBlue, 30);
    }
    if (height > 0.6) {
      EXPECT_TRUE(is(c, kRed, 8)) << model.mesh.V.row(v);
    }
  }
  EXPECT_GT(round, 50);
  EXPECT_GT(belt, 0.8 * round);
  EXPECT_LT(mixed, back / 5);  // the soft step between the two
}

// Bones that lead to all sides, as those of a body with arms and legs on it, have no direction of
// their own: what is left of them by chance would lay belts askew behind.
TEST(Texture, BeltsLieLevelOnPartsWhoseBonesLeadToAllSides) {
  Model plain = ball();
  plain.skeleton.joints.push_back({"arm.L", 0, {1.3, 0.1, 0}, -1, ""});
  plain.skeleton.joints.push_back({"arm.R", 0, {-1.1, 0.1, 0}, -1, ""});
  const Model model = painted(document_of(plain.skeleton, {0}), {belted_disc()}, plain);
  int round = 0, belt = 0, others = 0, red = 0;
  for (int v = 0; v < model.mesh.V.rows(); ++v) {
    if (model.mesh.V(v, 2) > -0.2) continue;
    const double height = std::abs(model.mesh.V(v, 1));
    const Colour c = texel(model, v);
    if (height < 0.1) ++round, belt += is(c, kBlue, 30);
    if (height > 0.45) ++others, red += is(c, kRed, 30);
  }
  EXPECT_GT(belt, 0.9 * round);
  EXPECT_GT(red, 0.95 * others);
}

// Red in front, blue behind: at the sides, which no drawing shows, the two meet along a line, and
// neither runs into the other in bars.
TEST(Texture, ColoursMeetAlongALineAtSidesThatNoDrawingShows) {
  Model plain = ball();
  plain.mesh = icosphere(Vec3::Zero(), 1, 5);
  plain = model_of(plain.skeleton, plain.mesh);
  const Model model =
      painted(document_of(plain.skeleton, {0, 180}), {disc(kRed), disc(kBlue)}, plain);
  int beside = 0, strayed = 0;
  for (int v = 0; v < model.mesh.V.rows(); ++v) {
    const double depth = model.mesh.V(v, 2);
    if (std::abs(depth) > 0.3 || std::abs(depth) < 0.06) continue;
    ++beside;
    strayed += !is(texel(model, v), depth > 0 ? kRed : kBlue, 60);
  }
  EXPECT_GT(beside, 500);
  EXPECT_LT(strayed, 0.02 * beside) << beside;
}

// In the texture, under a place in a triangle.
Colour texel_within(const Model& model, int face, const Vec3& weights) {
  Vec2 at = Vec2::Zero();
  for (int k = 0; k < 3; ++k) at += weights[k] * model.texcoords[model.mesh.F(face, k)];
  const Image& t = *model.texture;
  const std::uint8_t* c = t.at(int(at.x() * t.width), int(at.y() * t.height));
  return {c[0], c[1], c[2]};
}

// Hardly to be seen, and no pixel art any more, whose colours are never mixed.
void soften(Image& drawing) {
  drawing.at(0, 0)[3] = 20;
}

// Behind, a belt ends along a line, as it does in front: not from triangle to triangle, and not in
// a haze.
TEST(Texture, EdgesGoOnStraightWhereNoDrawingShowsThem) {
  const Model plain = ball();
  Image drawing = belted_disc();
  soften(drawing);
  const Model model = painted(document_of(plain.skeleton, {0}), {drawing}, plain);
  int near = 0, hazy = 0;
  for (int f = 0; f < model.mesh.F.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const Vec3 weights = Vec3::Constant(0.2) + 0.4 * Vec3::Unit(k);
      Vec3 place = Vec3::Zero();
      for (int i = 0; i < 3; ++i) place += weights[i] * model.mesh.V.row(model.mesh.F(f, i));
      if (place.z() > -0.5 || std::abs(place.y()) > 2 * kHalf / kScale) continue;
      const Colour c = texel_within(model, f, weights);
      ++near;
      hazy += !is(c, kRed, 12) && !is(c, kBlue, 12);
    }
  EXPECT_GT(near, 100);
  EXPECT_LT(hazy, 0.15 * near);
}

// Half of each ball lies in a shade that both have in common: it belongs to the light. Where one
// ball alone has a darker half that is a colour.
TEST(Texture, ShadeInFlatColoursIsNoColour) {
  const auto shaded = [](int value, double by) { return std::uint8_t(std::lround(value * by)); };
  for (const bool common : {true, false}) {
    const Model plain = pair_of_balls(false);
    Document document = document_of(plain.skeleton, {0});
    document.camera.pixels_per_unit = 20;
    Image drawing(kSize, kSize, 0);
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x)
        for (const double middle : {-1.5, 1.5}) {
          const Vec2 p = (Vec2(x + 0.5, y + 0.5) - Vec2::Constant(kSize / 2.0)) / 20;
          if ((p - Vec2(middle, 0)).norm() > 1) continue;
          const Colour& c = middle > 0 ? kRed : kBlue;
          const bool dark = p.x() < middle && (common || middle > 0);
          std::uint8_t* to = drawing.at(x, y);
          to[0] = shaded(c.r, dark ? 0.82 : 1), to[1] = shaded(c.g, dark ? 0.71 : 1);
          to[2] = shaded(c.b, dark ? 0.77 : 1), to[3] = (x + y) % 40 ? 255 : 254;  // no pixel art
        }
    const Model model = painted(document, {drawing}, plain);
    int dark = 0;
    for (int v = 0; v < model.mesh.V.rows(); ++v)
      if (model.mesh.V(v, 0) > 0 && model.mesh.V(v, 2) > 0.3)
        dark += texel(model, v).r < (kRed.r * 0.82 + kRed.r) / 2;
    EXPECT_EQ(dark > 0, !common) << dark;
  }
}

// One colour and a darker tone, in two drawings from sides 90° apart: shade where both have it on
// their right, a colour where both have it below.
TEST(Texture, WhatIsDarkInOneDrawingAndLightInAnotherIsShade) {
  for (const bool below : {false, true}) {
    const Model plain = ball();
    Image drawing(kSize, kSize, 0);
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const Vec2 p = (Vec2(x + 0.5, y + 0.5) - Vec2::Constant(kSize / 2.0)) / kScale;
        if (p.norm() > 1) continue;
        const double shade = (below ? p.y() : p.x()) > 0.4 ? 0.75 : 1;
        std::uint8_t* to = drawing.at(x, y);
        to[0] = std::uint8_t(shade * kRed.r), to[1] = std::uint8_t(shade * kRed.g);
        to[2] = std::uint8_t(shade * kRed.b), to[3] = 255;
      }
    soften(drawing);
    const Model model = painted(document_of(plain.skeleton, {0, -90}), {drawing, drawing}, plain);
    int dark = 0;
    for (int v = 0; v < model.mesh.V.rows(); ++v) dark += texel(model, v).r < 0.87 * kRed.r;
    if (below)
      EXPECT_GT(dark, 100);
    else
      EXPECT_EQ(dark, 0);
  }
}

// Where a drawing shows the surface squarely there is a texel for each of its pixels, no two places
// share one, and little of the picture shows nothing.
TEST(Texture, TexelsAreAsFineAsTheDrawingAndFewAreWasted) {
  const Model plain = ball();
  const Model model =
      painted(document_of(plain.skeleton, {0, -90}), {disc(kRed), disc(kBlue)}, plain);
  const Vec2 size(model.texture->width, model.texture->height);
  std::vector<int> shown(std::size_t(size.prod()), -1);
  double used = 0;
  int square = 0;
  for (int f = 0; f < model.mesh.F.rows(); ++f) {
    std::array<Vec2, 3> at;
    std::array<Vec2, 3> drawn;
    double front = 1;
    for (int k = 0; k < 3; ++k) {
      const int v = model.mesh.F(f, k);
      at[k] = model.texcoords[v].cwiseProduct(size);
      drawn[k] = kScale * model.mesh.V.row(v).head<2>().transpose();
      front = std::min(front, model.mesh.V(v, 2));
    }
    const double area = std::abs(cross(at[1] - at[0], at[2] - at[0])) / 2;
    used += area;
    if (front > 0.9) {
      ++square;
      EXPECT_GT(area, 0.999 * std::abs(cross(drawn[1] - drawn[0], drawn[2] - drawn[0])) / 2);
    }
    for (int i = 1; i < 8; ++i)
      for (int j = 1; i + j < 8; ++j) {
        const Vec2 p = (i * at[0] + j * at[1] + (8 - i - j) * at[2]) / 8;
        int& here = shown[std::size_t(p.y()) * model.texture->width + std::size_t(p.x())];
        constexpr double kBeside = 0.35;  // units: triangles that meet within a texel
        if (here >= 0) {
          const auto first = [&](int face) { return model.mesh.V.row(model.mesh.F(face, 0)); };
          EXPECT_LT((first(f) - first(here)).norm(), kBeside) << f << ' ' << here;
        }
        here = f;
      }
  }
  EXPECT_GT(square, 20);
  EXPECT_GT(used, 0.5 * size.prod());
}

// Stairs of few colours: every texel has one of them.
TEST(Texture, PixelArtKeepsItsColours) {
  constexpr int kSquare = 6;  // pixels
  const Model plain = ball();
  Image drawing(kSize, kSize, 0);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const int i = x / kSquare, j = y / kSquare;
      const Vec2 p = Vec2(i + 0.5, j + 0.5) * kSquare - Vec2::Constant(kSize / 2.0);
      const Colour& c = (i + j) % 2 ? kRed : kBlue;
      std::uint8_t* to = drawing.at(x, y);
      to[0] = c.r, to[1] = c.g, to[2] = c.b, to[3] = p.norm() < kScale ? 255 : 0;
    }
  const Model model = painted(document_of(plain.skeleton, {0, -90}), {drawing, drawing}, plain);
  for (std::size_t i = 0; i < model.texture->rgba.size(); i += 4) {
    const std::uint8_t* c = &model.texture->rgba[i];
    const Colour texel{c[0], c[1], c[2]};
    ASSERT_TRUE(is(texel, kRed, 0) || is(texel, kBlue, 0)) << texel.r << ' ' << texel.b;
  }
}

TEST(Texture, WithoutDrawingsTheModelStaysPlain) {
  const Model plain = ball();
  const Document document = document_of(plain.skeleton, {0});
  for (const std::vector<Image>& drawings :
       {std::vector<Image>{}, std::vector<Image>{Image()}, std::vector<Image>{Image(2, 2)}}) {
    const Model model = painted(document, drawings, plain);
    EXPECT_FALSE(model.texture);
    EXPECT_EQ(model.mesh.V.rows(), plain.mesh.V.rows());
  }
}

TEST(Texture, TrianglesWithoutAreaHaveTheirPlace) {
  Model plain = ball();
  Mesh& mesh = plain.mesh;
  // An edge on the far side is split where one of its ends is.
  int back = 0;
  for (int f = 0; f < mesh.F.rows(); ++f)
    if (mesh.V.row(mesh.F(f, 0)).z() < mesh.V.row(mesh.F(back, 0)).z()) back = f;
  const Eigen::Index n = mesh.V.rows(), m = mesh.F.rows();
  const int a = mesh.F(back, 0), b = mesh.F(back, 1), c = mesh.F(back, 2), d = int(n);
  mesh.V.conservativeResize(n + 1, 3);
  mesh.V.row(d) = mesh.V.row(a);
  mesh.F.row(back) << d, b, c;
  mesh.F.conservativeResize(m + 2, 3);
  mesh.F.row(m) << a, b, d;
  mesh.F.row(m + 1) << a, d, c;
  plain = model_of(plain.skeleton, mesh);
  const Model model = painted(document_of(plain.skeleton, {0}), {disc(kRed)}, plain);
  for (const Vec2& uv : model.texcoords) {
    EXPECT_GE(uv.minCoeff(), 0);
    EXPECT_LE(uv.maxCoeff(), 1);
  }
}

TEST(Texture, TheSameTwice) {
  const Model plain = ball();
  const Document document = document_of(plain.skeleton, {0, -90});
  const Model a = painted(document, {disc(kRed), disc(kBlue)}, plain),
              b = painted(document, {disc(kRed), disc(kBlue)}, plain);
  EXPECT_EQ(a.texture->rgba, b.texture->rgba);
  EXPECT_EQ(a.mesh.F, b.mesh.F);
}

}  // namespace
}  // namespace artisketch
