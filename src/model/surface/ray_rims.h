// Where a surface touches the rays of its outlines. In each view the rim, the curve on which the
// surface turns away from the camera, projects to the drawn outline: it lies on the outline's own
// rays, and only a depth per ray is left to find.
#pragma once

#include <vector>

#include "model/surface/carving.h"
#include "model/surface/hermite_surface.h"

namespace artisketch {

struct RimRay {
  Vec2 pixel;
  Vec2 outward;      // unit, in the image
  Ray ray;           // in rest space
  double depth = 0;  // along the ray
  double sheet = 0;  // the depth at which it meets the part's middle sheet (inflate.h)
};

// A ray between two of a rim's, as deep as these are.
struct TipRay {
  RimRay ray;        // depth unset
  int after = 0;     // the ray before it
  double share = 0;  // 0 … 1: of the way from there to the next one
};

// One closed line of one view.
struct RayRim {
  int view = 0;              // index into the carving's views
  double doubt = 0;          // 0 … 1: how much the other views leave the depths open
  std::vector<RimRay> rays;  // in order around the line; the last is next to the first
  std::vector<TipRay> tips;  // where the line turns round a tip, which the rays pass by
};

// The rays of an outline's closed lines, about `count` in all, at equal steps along the lines;
// depths and view unset.
std::vector<RayRim> outline_rays(const Silhouette& silhouette, int count);

// Chooses the depths: a closed dynamic programme that keeps each ray's point inside the other
// views' outlines, deep rather than at their edge, and near its neighbours' depths. Views in the
// rim's own direction say nothing of depth and are left out. Views near it leave long intervals,
// with the truth at an end of them: the more `doubt`, the more the middle sheet counts.
void choose_depths(const Carving& carving, const Box3& box, RayRim& rim);

// Moves the points to where f is least along their rays inside the other views' outlines: there the
// surface that f describes is nearest to touching the ray. Neighbours keep together where f hardly
// tells one depth from another.
void detect_depths(const Carving& carving, const Box3& box, const HermiteSurface& f, RayRim& rim);

// Every stride-th of the rims' points, and without a stride those at tips, with the outlines'
// normals, back-projected; of more than kMostSurfacePoints so many, evenly: a dozen drawings have
// fewer, and the surface through them is found from a dense system.
inline constexpr std::size_t kMostSurfacePoints = 1200;
std::vector<SurfacePoint> surface_points(const Carving& carving, const std::vector<RayRim>& rims,
                                         int stride = 1);

}  // namespace artisketch
