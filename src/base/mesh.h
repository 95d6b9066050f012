// Triangle meshes, and what can be said of them. Data on a mesh (weights, rims, colours) lives
// beside it, never in it.
#pragma once

#include <span>
#include <vector>

#include "base/types.h"

namespace artisketch {

struct Mesh {
  Points3 V;    // #V×3 positions, in units
  Triangles F;  // #F×3 indices into V, counter-clockwise seen from outside
};

// Facts about a mesh as a surface. Vertices are compared by index: weld first where seams split
// them.
struct Topology {
  int boundary_edges = 0;     // edges of one triangle
  int nonmanifold_edges = 0;  // edges of three or more
  int misoriented_edges = 0;  // edges that both neighbours run through the same way
  int pinched_vertices = 0;   // vertices whose triangles form more than one fan
  int degenerate_faces = 0;   // faces that name a vertex twice
  int components = 0;
  int euler = 0;  // #V − #E + #F over used vertices
  bool closed() const {
    return !boundary_edges && !nonmanifold_edges && !misoriented_edges && !degenerate_faces;
  }
  bool manifold() const { return closed() && !pinched_vertices; }
  int genus() const {
    return (2 * components - euler) / 2;
  }  // of a closed mesh, over all components
};
Topology topology(const Mesh& mesh);

// #V×3 unit normals, weighted by the angle at each corner (Thürmer and Wüthrich 1998). A vertex
// without area gets +y.
Points3 vertex_normals(const Mesh& mesh);
// The same as if vertices at exactly the same place were one: they don't break where texture seams
// split vertices.
Points3 seamless_normals(const Mesh& mesh);

double signed_volume(const Mesh& mesh);  // positive for closed, outward-facing meshes
double surface_area(const Mesh& mesh);
Box3 bounds(const Points3& points);

// The step, a power of two, to which positions are rounded in files: 2⁻¹⁶ to 2⁻¹⁵ of the points'
// extent, a hundredth of a pixel. points: not empty.
double position_step(const Points3& points);

// The vertices next to each vertex: those of v are neighbours[offsets[v] .. offsets[v + 1]).
struct Adjacency {
  std::vector<int> offsets;  // #V + 1
  std::vector<int> neighbours;
  std::span<const int> of(int v) const {
    return {neighbours.data() + offsets[v], std::size_t(offsets[v + 1] - offsets[v])};
  }
};
Adjacency vertex_adjacency(const Mesh& mesh);

// Index of the connected component of every vertex, 0 … count − 1.
std::vector<int> vertex_components(const Mesh& mesh, int* count = nullptr);

Mesh largest_component(const Mesh& mesh);        // by |volume|
Mesh without_unused_vertices(const Mesh& mesh);  // keeps the order
Mesh welded(const Mesh& mesh);                   // vertices at exactly the same place become one

// Per vertex, the first one at exactly the same place.
std::vector<int> first_at_place(const Mesh& mesh);

// Primitives, for tests, joint spheres and previews.
Mesh icosphere(const Vec3& centre, double radius, int subdivisions);

}  // namespace artisketch
