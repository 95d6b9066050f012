// Rigid solids as smooth unions of simple blobs: what the parts of a figure are made of. They know
// their exact outline before a camera and their exact inside, which is what makes them a truth to
// measure against.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "base/mesh.h"
#include "document/camera.h"
#include "document/contour.h"

namespace artisketch::figures {

struct Blob {
  enum class Kind { limb, ellipsoid, box };
  Kind kind = Kind::ellipsoid;
  Vec3 a = Vec3::Zero();         // centre; of a limb, one end
  Vec3 b = Vec3::Zero();         // a limb's other end
  double radius_a = 0;           // a limb's radius at a; a box's rounding
  double radius_b = 0;           // a limb's radius at b
  Vec3 radii = Vec3::Ones();     // of an ellipsoid; a box's half sizes, rounding included
  Quat turn = Quat::Identity();  // of an ellipsoid or box about its centre
  unsigned colour = 0xcccccc;    // 0xRRGGBB

  Blob in(unsigned rgb) const {
    Blob blob = *this;
    blob.colour = rgb;
    return blob;
  }
};

Blob ball(const Vec3& centre, double radius);
Blob limb(const Vec3& a, double radius_a, const Vec3& b, double radius_b);  // a round cone
Blob ellipsoid(const Vec3& centre, const Vec3& radii, const Quat& turn = Quat::Identity());
Blob box(const Vec3& centre, const Vec3& half, double rounding,
         const Quat& turn = Quat::Identity());

// Signed distance to a blob: exact for limbs, and outside boxes; of first order near an ellipsoid.
double distance(const Blob& blob, const Vec3& p);

struct Solid {
  std::vector<Blob> blobs;  // in rest space, united smoothly
  double blend = 0;         // units over which two blobs melt into one another
  std::vector<Blob> paint;  // colour what lies inside them, the last one on top

  bool empty() const { return blobs.empty(); }
};

// Negative inside, with the right sign everywhere and of first order near the surface. +infinity
// for an empty solid.
double distance(const Solid& solid, const Vec3& p);
double blended(const std::vector<const Blob*>& blobs, double blend, const Vec3& p);
Vec3 normal(const Solid& solid, const Vec3& p);  // unit length, outward

// The blob or paint that colours the surface at p: its index among the paints counted from
// blobs.size(), or among the blobs.
int colour_index(const Solid& solid, const Vec3& p);
unsigned colour_at(const Solid& solid, int index);

// A sphere that holds a blob, or a solid.
struct Ball {
  Vec3 centre = Vec3::Zero();
  double radius = 0;
};
Ball bounding_ball(const Blob& blob);
Ball bounding_ball(const Solid& solid);
Box3 bounds(const Solid& solid);

// The closed lines around the solid's silhouette in pixels, the solid moved by to_world: exact to
// a few hundredths of a pixel, a point about every two pixels; holes run the other way round.
// Features under two pixels may be missed. The solid must lie before the camera.
std::vector<Polyline> outline(const Solid& solid, const Transform& to_world,
                              const FrameCamera& camera);

// Finds where rays meet a solid, blobs that they pass aside left out of the sums. The solid must
// outlive it.
class Caster {
 public:
  explicit Caster(const Solid& solid);
  const Ball& ball() const { return ball_; }
  // The nearest point of the solid on the ray, if they meet: its depth along the ray.
  std::optional<double> hit(const Ray& ray) const;

 private:
  const Solid& solid_;
  Ball ball_;
  std::vector<Ball> balls_;  // around each blob
};

// The zero set of a function, sampled at steps of `cell`, as a closed oriented manifold (marching
// tetrahedra). The function must change by no more than twice the way between two points.
Mesh polygonise(const std::function<double(const Vec3&)>& distance, const Box3& box, double cell);
Mesh mesh_of(const Solid& solid, double cell);

}  // namespace artisketch::figures
