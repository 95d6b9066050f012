// The union of closed surfaces by CGAL, for the bench: union_by_cgal PLY... prints the CPU seconds
// that uniting one after the other took, and how many vertices came of it.
#include <cstdio>
#include <ctime>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>

namespace PMP = CGAL::Polygon_mesh_processing;
using Surface = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

int main(int count, char** paths) {
  Surface all;
  std::clock_t took = 0;
  for (int i = 1; i < count; ++i) {
    Surface next, both;
    if (!PMP::IO::read_polygon_mesh(paths[i], next)) {
      std::fprintf(stderr, "%s can't be read\n", paths[i]);
      return 1;
    }
    const std::clock_t began = std::clock();
    if (i > 1 && !PMP::corefine_and_compute_union(all, next, both)) {
      std::fprintf(stderr, "no union with %s\n", paths[i]);
      return 1;
    }
    all = i > 1 ? both : next;
    took += std::clock() - began;
  }
  std::printf("SECONDS %.3f %zu\n", double(took) / CLOCKS_PER_SEC,
              std::size_t(all.number_of_vertices()));
}
