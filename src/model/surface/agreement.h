// How well the views of a part explain each other: an outline's ray that no depth brings inside all
// other outlines says that some view is wrong there.
#pragma once

#include <vector>

#include "model/surface/carving.h"
#include "model/surface/ray_rims.h"

namespace artisketch {

// Where a ray passes what `others` allow by the least, and by how many pixels; negative where it
// comes inside them. No nearer place is sought than one within `enough` pixels.
struct Miss {
  double distance;
  Vec3 point;
};
Miss miss(const Ray& ray, const std::vector<const Silhouette*>& others, const Box3& room,
          double enough);

// The carving's outlines but one; without `mirrored`, the part's own of them.
std::vector<const Silhouette*> all_but(const Carving& carving, const Silhouette& out,
                                       bool mirrored = true);

// visit(ray), of the rays that stand for an outline wherever outlines are held against each other.
template <class Visit>
void each_ray(const Silhouette& outline, const Visit& visit) {
  constexpr int kRays = 64;
  for (const RayRim& line : outline_rays(outline, kRays))
    for (const RimRay& ray : line.rays) visit(ray.ray);
}

// Share of an outline's rays that miss the others by no more than `tolerance` pixels.
double coverage(const Silhouette& outline, const std::vector<const Silhouette*>& others,
                const Box3& room, double tolerance);

// Wobbly outlines cut each other: every intersection of them is smaller than what was drawn. Swells
// each outline by the few pixels, just where they are lacking, that let the others' rays meet the
// hull; by at most kMostSwelling of its size, as views that disagree by more are wrong in their
// pose. Returns by how much they contradict each other: how far their rays missed on average, as a
// share of the carving's radius.
double swell_until_covered(Carving& carving);
// The same for the mirrored outlines alone, and the own outlines' rays: what is drawn stays, and a
// mirrored outline gives way where its side differs.
void swell_mirrored(Carving& carving);

}  // namespace artisketch
