// Every stage of the paper (Levi & Gotsman, "ArtiSketch: A System for Articulated Sketch
// Modeling", Eurographics 2013): its input, options and result, in the order they run.
//
//   Document → Poses → PartSurface per joint → one Mesh → Weights → Model
//
// Each stage is a function on plain structs, deterministic, and never reads a later one's data.
// Signed distances are in units, negative inside.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/distance_field.h"
#include "base/grid.h"
#include "base/image.h"
#include "base/mesh.h"
#include "base/result.h"
#include "document/document.h"
#include "model/run.h"

namespace artisketch {

enum class Method {
  paper,  // every step as the paper describes it
  rays,   // the same inputs and outputs by rays and interpolants, as each stage's file tells
};
inline constexpr Method kDefaultMethod = Method::rays;
inline constexpr const char* kMethodNames[] = {"paper", "rays"};  // by Method
// The method of that name; otherwise what is given.
Method method_named(const std::string& name, Method otherwise);

// ---------------------------------------------------------------- calibration (section 2)

struct CalibrateOptions {
  Method method = kDefaultMethod;
};

struct PartCoverage {
  int joint = 0, frame = 0;
  // Share of the contour's pixels whose ray meets the part's visual hull: 1 where every silhouette
  // is explained by the others.
  double before = 1, after = 1;
};

struct Calibration {
  std::vector<Pose> poses;  // one per frame; the first root is the user's unless free_first_frame
  std::vector<double> scales;  // one per frame: the frame's scale (orthographic), else as it was
  double energy_before = 0, energy_after = 0;  // pixels², the method's own energy
  int iterations = 0;
  double largest_rotation = 0;  // radians, against the user's pose
  int largest_rotation_joint = -1;
  double largest_translation = 0;         // units, of a root
  std::vector<PartCoverage> coverage;     // every part and frame with a closed contour
  std::vector<std::string> undetermined;  // angles that the silhouettes leave open, in words
  std::vector<std::string> warnings;      // in words a person can act on
};

// Refines the user's poses until the parts' silhouettes agree between frames, within the document's
// limits. Fails only if cancelled.
Result<Calibration> calibrate(const Document& document, const CalibrateOptions& options, Run& run);
Result<Calibration> calibrate_paper(const Document& document, Run& run);
Result<Calibration> calibrate_rays(const Document& document, Run& run);

// The document with the calibrated poses and scales in place of the user's.
Document with_poses(const Document& document, const Calibration& calibration);

// ---------------------------------------------------------------- a part's views

// The virtual camera of one part in one frame: the real camera seen through the part's motion.
struct PartView {
  int frame = 0;
  bool mirrored = false;  // another joint's contours, reflected
  FrameCamera camera;
  Transform to_world = Transform::Identity();  // rest space → world in this frame
  std::vector<Polyline> contours;
  PolygonDistance outline;  // signed distance to the closed contours, pixels; empty without any

  Vec2 project(const Vec3& rest) const { return camera.project(to_world * rest); }
  // Ray through a pixel, in rest space.
  Ray ray(const Vec2& pixel) const;
  // Pixels that a unit takes at a rest-space point.
  double pixels_per_unit(const Vec3& rest) const {
    return camera.pixels_per_unit((to_world * rest).z());
  }
  bool seen() const { return !outline.empty(); }  // has a closed contour
};

struct Part {
  int joint = 0;
  std::string name;
  std::vector<PartView> views;    // frames in which the joint has contours
  std::vector<PartView> mirrors;  // its mirror image's contours, reflected: candidates (mirror.h)
  std::vector<Bone> bones;        // of this joint; empty for a leaf
  Vec3 origin = Vec3::Zero();     // the joint's rest position
  double fatness = 1;
};

// The view's outline, from its contours.
PolygonDistance outline_of(const std::vector<Polyline>& contours);

// The drawn parts of a document at its poses, in joint order.
std::vector<Part> parts_of(const Document& document);

// ---------------------------------------------------------------- part surfaces (sections 3, 4)

struct SurfaceOptions {
  Method method = kDefaultMethod;
  int grid = 100;            // cells along the longest side of the part's grid, 16 … 512
  bool visual_hull = false;  // stop after carving
};

// A closed path of mesh vertices on which one view sees the surface's outline.
struct Rim {
  int frame = 0;
  std::vector<int> vertices;  // neighbours in the mesh, the last beside the first
};

struct PartSurface {
  int joint = 0;
  Mesh mesh;              // closed, oriented 2-manifold in rest space
  Grid3<float> distance;  // signed distance to it on the part's grid (rays: 200 cells at most): to
                          // first order, within a cell or so; cut off a few cells below the surface
  std::vector<Rim> rims;
  std::vector<std::string> warnings;
};

// Visual hull (Laurentini 1994): the largest signed distance over the views, on a grid that holds
// it with a margin of two cells: `cells` along its longest side. A part seen from one direction
// only is as deep as its narrow side is wide, about its bone. A part that its views leave nothing
// of gets their consensus, and a warning: the hull of the contours widened until they meet. Fails
// where no view has a closed contour.
Result<Grid3<float>> visual_hull(const Part& part, int cells, std::vector<std::string>& warnings,
                                 Run& run);

struct LevelSetOptions {
  int iterations = 40;
  double region = 1;  // weight of the Chan–Vese term
  double edge = 1;    // weight of the geodesic active contour
  double band = 3;    // half-width of the narrow band, cells
  double grown = 0;   // cells given to the hull and the contours, so that a thin part stays whole
};
// Section 3 and appendix: evolves the hull's zero set under the region and edge terms of all views.
Result<Grid3<float>> level_set(const Part& part, const Grid3<float>& hull,
                               const LevelSetOptions& options, Run& run);

// The zero set of a sampled field as a closed, oriented 2-manifold (marching cubes with consistent
// faces); the largest piece alone. Fails where nothing is negative.
Result<Mesh> isosurface(const Grid3<float>& field);

// Section 4: for every view with a closed contour a closed vertex path on the mesh whose projection
// follows it, by dynamic programming over the five costs (silhouette, proximity, geodesic,
// barycentre, normal).
Result<std::vector<Rim>> rim_paths(const Part& part, const Mesh& mesh, Run& run);

struct ReduceOptions {
  bool soft_anchors = false;  // weigh the rims instead of fixing them
};
// Section 4, eq. 1: Δ²x = 0 with the rims as anchors. Same faces, new positions.
Result<Mesh> reduce_volume(const Part& part, const Mesh& mesh, std::span<const Rim> rims,
                           const ReduceOptions& options, Run& run);

// All of the above for one part, by the chosen method.
Result<PartSurface> reconstruct_part(const Part& part, const SurfaceOptions& options, Run& run);
// Each part's, in their order, on up to run.threads threads. One that fails leaves the others to be
// made.
std::vector<Result<PartSurface>> reconstruct_parts(std::span<const Part> parts,
                                                   const SurfaceOptions& options, Run& run);
Result<PartSurface> surface_paper(const Part& part, const SurfaceOptions& options, Run& run);
Result<PartSurface> surface_rays(const Part& part, const SurfaceOptions& options, Run& run);

// ---------------------------------------------------------------- one skin (section 5)

struct ConsolidateOptions {
  bool blend = true;  // joint spheres, and fairing inside them; off: the plain union
  int triangles = 0;  // that the surface shall have at least; 0: as the grid gives
};

struct JointSphere {
  int joint = 0;
  Vec3 centre = Vec3::Zero();  // rest space
  double radius = 0;           // units
};
// Radius 60 % of the diameter of the surface around the joint's bone, unless the document says
// otherwise. Joints between two drawn parts only.
std::vector<JointSphere> joint_spheres(const Document& document,
                                       std::span<const PartSurface> parts);

// Union of parts and spheres, blended inside the spheres: one closed, oriented 2-manifold of one
// component, everything outside the spheres within half a cell of its part. Fails without parts.
Result<Mesh> consolidate(const Document& document, std::span<const PartSurface> parts,
                         const ConsolidateOptions& options, std::vector<std::string>& warnings,
                         Run& run);

// The same closed surface with `triangles` triangles, denser where it bends: more where fewer would
// fold it or move it by more than about `error` units. Same genus and components.
Mesh simplified(const Mesh& mesh, int triangles, double error);

// At most four influences a vertex, largest first; unused ones are joint 0 with weight 0.
struct Weights {
  Eigen::Matrix<int, Eigen::Dynamic, 4, Eigen::RowMajor> joints;      // #V×4
  Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor> weights;  // #V×4, rows sum to 1
};

// Heat diffusion on the surface (Baran and Popović 2007, section 5, "Pinocchio"). Joints without a
// part get none.
Result<Weights> skin(const Document& document, std::span<const PartSurface> parts, const Mesh& mesh,
                     Run& run);

// Linear blend skinning: #V×3 positions of the mesh in a pose.
Points3 posed_vertices(const Points3& V, const Weights& weights, const Skeleton& skeleton,
                       const Pose& pose);

// ---------------------------------------------------------------- the model

// A clip of poses over time; times strictly increase.
struct Clip {
  std::string name;
  std::vector<double> times;  // seconds
  std::vector<Pose> poses;
};

// Clip `frames`, one key a second at the document's poses, then the document's own animations.
std::vector<Clip> clips_of(const Document& document);

struct Model {
  std::string name;
  Skeleton skeleton;
  Mesh mesh;  // rest space
  Weights weights;
  std::vector<Vec2> texcoords;  // one per vertex, or empty
  std::optional<Image> texture;
  std::vector<Clip> clips;  // `frames` first
};

// The model with the drawings' colours: every triangle from the drawing that shows it best in its
// own pose, else from a drawing of its mirror image, else from what surrounds it. Seams of the
// texture split vertices; welded() is the same closed surface as before. The model as it is where
// no drawing shows it.
//   drawings  decoded, one per frame, of its size; empty ones are left out
// Fails only if cancelled.
//   shares    if asked for: per frame, the share of the surface that shows its colours
Result<Model> textured(const Document& calibrated, std::span<const Image> drawings,
                       const Model& model, Run& run, std::vector<double>* shares = nullptr);

// ---------------------------------------------------------------- the whole

struct PipelineOptions {
  Method method = kDefaultMethod;
  int grid = 100;
  bool calibrate = true;
  bool visual_hull = false;  // plain hulls of the parts, united without blending
  int triangles = 15000;     // of the model; 0: as few as half a pixel allows
  bool mirror = true;        // joints see their mirror images' contours, where these agree
  bool texture = true;       // colour the model with the drawings
  // Decoded, to colour the model with: one per frame or empty, of its size or as it is worked on
  // (working_scale.h); without any the model stays plain. Not copied: they must outlive the run.
  std::span<const Image> drawings;
};

// The options as the document's settings have them, where they say anything.
PipelineOptions with_settings(PipelineOptions options, const DocumentSettings& settings);

struct StageTime {
  std::string stage;
  double seconds = 0;
  double cpu_seconds = 0;  // of all threads
  double peak_bytes = 0;   // the most memory that the process had held when it ended; 0: unknown
  std::vector<std::pair<std::string, double>> sizes;  // "cells", "vertices", "unknowns" …
};

struct FrameFit {  // of the posed, skinned result against the drawn contours
  double iou = 0;  // silhouette against the union of the closed contours
  struct PartFit {
    int joint = 0;
    double distance = 0;  // symmetric mean contour distance of the part alone, pixels
  };
  std::vector<PartFit> parts;
};

struct Reconstruction {
  Model model;
  Document calibrated;  // the document at the poses that were used
  std::optional<Calibration> calibration;
  std::vector<PartSurface> parts;
  std::vector<FrameFit> fits;  // one per frame
  std::vector<double>
      coloured;  // per frame, the surface's share with its colours; empty: untextured
  std::vector<StageTime> stages;
  std::vector<std::string> warnings;
};

Result<Reconstruction> reconstruct(const Document& document, const PipelineOptions& options,
                                   Run& run);

// How well a posed model fits the drawings (rasterised twice as finely, to 1024 samples a side).
std::vector<FrameFit> measure_fit(const Document& calibrated, const Model& model,
                                  std::span<const PartSurface> parts, int threads = 1);

// The symmetric mean contour distance of a part's mesh in each of its views, fast: at half the
// sketch's resolution. Pixels; +infinity where there is nothing to compare.
std::vector<double> view_distances(const Part& part, const Mesh& mesh);

}  // namespace artisketch
