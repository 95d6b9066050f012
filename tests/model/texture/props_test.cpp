// Things that stand before the character: what they shape, and what they paint.
#include "model/texture/props.h"

#include <gtest/gtest.h>

#include "base/raster.h"
#include "document/edit.h"
#include "document/skeleton_edit.h"
#include "figures.h"
#include "model/stages.h"

namespace artisketch {
namespace {

constexpr int kPicture = 240;
constexpr std::uint8_t kSkin[3] = {190, 160, 120}, kPink[3] = {255, 0, 200};

// A figure from the front and from its side, and a card before its chest in the first drawing.
struct Carded {
  Document document;
  int chest = -1, card = -1;
  std::vector<Image> drawings;
};

Polyline card_line(const Document& document, int chest) {
  Box2 box;
  const std::vector<std::vector<Vec2>> outlines = closed_contours(document.frames[0], chest);
  for (const Vec2& p : outlines.at(0)) box.extend(p);
  const Vec2 middle = box.center(), half = 0.3 * box.sizes();
  Polyline line;
  line.closed = true;
  for (const Vec2& at : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
    line.points.push_back(middle + at.cwiseProduct(half));
  return line;
}

Carded carded(Role role) {
  const figures::Figure figure = figures::human(1);
  const std::vector<figures::View> views = {
      figures::view(figure, "front", Quat::Identity()),
      figures::view(figure, "side", Quat(Eigen::AngleAxisd(kPi / 2, Vec3::UnitY())))};
  const Camera camera =
      figures::fitting_camera(figure, Camera::Type::orthographic, kPicture, kPicture);
  Carded out;
  out.document = figures::draw(figure, views, camera, kPicture, kPicture).truth;
  out.chest = out.document.skeleton.find("chest");
  EXPECT_GE(out.chest, 0);
  const Polyline line = card_line(out.document, out.chest);
  out.document = with_thing_added(std::move(out.document), out.chest);
  out.card = out.document.skeleton.size() - 1;
  out.document = with_role(std::move(out.document), out.card, role);
  // Where nobody sees it in the model: what the drawing shows counts.
  out.document.skeleton.joints[out.card].offset = Vec3(0, 0, -0.6);
  out.document = with_contour(std::move(out.document), 0, {out.card, line, ""});
  out.drawings.assign(2, Image(kPicture, kPicture));
  Mask card(kPicture, kPicture);
  const std::vector<std::vector<Vec2>> polygon = {line.points};
  add_polygons(polygon, card);
  for (int f = 0; f < 2; ++f)
    for (std::size_t p = 0; p < card.in.size(); ++p)
      for (int c = 0; c < 3; ++c)
        out.drawings[f].rgba[4 * p + c] = f == 0 && card.in[p] ? kPink[c] : kSkin[c];
  return out;
}

Reconstruction made_of(const Carded& carded) {
  PipelineOptions options;
  options.grid = 32;
  options.triangles = 3000;
  options.calibrate = false;
  options.drawings = carded.drawings;
  artisketch::Run run;
  Result<Reconstruction> made = reconstruct(carded.document, options, run);
  EXPECT_TRUE(made);
  return std::move(*made);
}

// Faces of a joint whose middle is painted more pink than skin.
int pink_faces(const Model& model, int joint) {
  const Image& texture = *model.texture;
  int pink = 0;
  for (int f = 0; f < model.mesh.F.rows(); ++f) {
    Vec2 at = Vec2::Zero();
    bool own = true;
    for (int k = 0; k < 3; ++k) {
      const int v = model.mesh.F(f, k);
      at += model.texcoords[std::size_t(v)] / 3;
      own = own && model.weights.joints(v, 0) == joint;
    }
    const std::uint8_t* p = texture.at(std::min(int(at.x() * texture.width), texture.width - 1),
                                       std::min(int(at.y() * texture.height), texture.height - 1));
    pink += own && p[1] < 80;
  }
  return pink;
}

TEST(Props, WhatIsNoPartOfTheFigureShapesAndPaintsNothing) {
  Carded with = carded(Role::apart);
  const Reconstruction made = made_of(with);
  EXPECT_EQ(pink_faces(made.model, with.chest), 0);
  for (const PartSurface& part : made.parts) EXPECT_NE(part.joint, with.card);
  with.document =
      without_contour(with.document, 0, int(with.document.frames[0].contours.size()) - 1);
  const Reconstruction without = made_of(with);
  ASSERT_EQ(made.parts.size(), without.parts.size());
  for (std::size_t p = 0; p < made.parts.size(); ++p)
    EXPECT_EQ(made.parts[p].mesh.V, without.parts[p].mesh.V);
  EXPECT_GT(pink_faces(without.model, with.chest), 20) << "unmarked, it would be painted on";
}

TEST(Props, NoBoneLeadsToAThing) {
  const Carded with = carded(Role::held);
  const Document without = *without_joint(with.document, with.card, false);
  const std::vector<Part> parts = parts_of(with.document), bare = parts_of(without);
  for (const Part& part : parts)
    if (part.joint == with.chest)
      for (const Part& other : bare)
        if (other.joint == with.chest) {
          EXPECT_EQ(part.bones.size(), other.bones.size());
        }
}

TEST(Props, WhatIsHeldPaintsNothingElse) {
  const Carded body = carded(Role::body), held = carded(Role::held);
  EXPECT_GT(pink_faces(made_of(body).model, body.chest), 20) << "or there is nothing to tell";
  const Reconstruction made = made_of(held);
  EXPECT_EQ(pink_faces(made.model, held.chest), 0);
  bool part = false;
  for (const PartSurface& surface : made.parts) part = part || surface.joint == held.card;
  EXPECT_TRUE(part) << "it is a part of its own";
}

TEST(Props, WhatIsOutlinedAfterAThingStandsBeforeIt) {
  Carded given = carded(Role::held);
  Frame& front = given.document.frames[0];
  const Vec2 middle = centroid(std::span(&front.contours.back().line, 1));
  const std::size_t at = std::size_t(middle.y()) * kPicture + std::size_t(middle.x());
  EXPECT_EQ(held_things(given.document, 0)[at], given.card);
  EXPECT_TRUE(held_things(given.document, 1).empty());
  std::rotate(front.contours.begin(), front.contours.end() - 1, front.contours.end());
  EXPECT_EQ(held_things(given.document, 0)[at], -1) << "the chest is before it now";
}

}  // namespace
}  // namespace artisketch
