// The same work by libraries that others use for it, one core each, in one run: `ours` and `theirs`
// are CPU milliseconds. Who isn't installed isn't there.
#include <ctime>
#include <limits>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#ifdef ARTISKETCH_WITH_OPENVDB
#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetSphere.h>
#include <openvdb/tools/VolumeToMesh.h>
#include <tbb/global_control.h>
#endif
#ifdef ARTISKETCH_WITH_ITK
#include <itkGeodesicActiveContourLevelSetImageFilter.h>
#include <itkImage.h>
#include <itkImageRegionIterator.h>
#include <itkMultiThreaderBase.h>
#endif

#include "files/document_file.h"
#include "model/stages.h"

namespace artisketch {
namespace {

template <class Work>
double cpu_milliseconds(Work&& work) {
  const std::clock_t began = std::clock();
  work();
  return 1000.0 * double(std::clock() - began) / CLOCKS_PER_SEC;
}

void tell(benchmark::State& state, double ours, double theirs) {
  const auto mean = [](double sum) {
    return benchmark::Counter(sum, benchmark::Counter::kAvgIterations);
  };
  state.counters["ours"] = mean(ours);
  state.counters["theirs"] = mean(theirs);
}

#ifdef ARTISKETCH_WITH_OPENVDB
// A ball's distances on a lattice of n³: ours from the whole of it, OpenVDB's from the narrow band
// that it keeps.
void isosurface_beside_openvdb(benchmark::State& state) {
  const int n = int(state.range(0));
  const double radius = 0.4 * n;
  Grid3<float> field(Vec3::Zero(), 1, Index3::Constant(n));
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        field(i, j, k) = float((Vec3(i, j, k) - Vec3::Constant(n / 2.0)).norm() - radius);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  openvdb::initialize();
  const openvdb::Vec3f middle(float(n) / 2);
  const auto ball =
      openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(float(radius), middle, 1.0f);
  double ours = 0, theirs = 0;
  for (auto _ : state) {
    ours += cpu_milliseconds([&] { benchmark::DoNotOptimize(isosurface(field)); });
    theirs += cpu_milliseconds([&] {
      std::vector<openvdb::Vec3s> points;
      std::vector<openvdb::Vec4I> quads;
      openvdb::tools::volumeToMesh(*ball, points, quads);
      benchmark::DoNotOptimize(points.data());
    });
  }
  tell(state, ours, theirs);
}
BENCHMARK(isosurface_beside_openvdb)
    ->Name("peers/isosurface of a ball/OpenVDB")
    ->Arg(100)
    ->Arg(200)
    ->Arg(400)
    ->Unit(benchmark::kMillisecond);
#endif

#ifdef ARTISKETCH_WITH_ITK
// The paper's level set of the hero's chest, its region and edge terms evaluated from the drawings
// at each step, and ITK's geodesic active contour from the same hull with the edges given.
void level_set_beside_itk(benchmark::State& state) {
  constexpr int kCells = 100, kSteps = 40;
  const Result<Document> document =
      read_document(ARTISKETCH_SOURCE_DIR "/assets/examples/hero/hero.artisketch");
  if (!document) return state.SkipWithError(document.error().text().c_str());
  const Part part = parts_of(*document)[1];
  Run run;
  std::vector<std::string> warnings;
  const Result<Grid3<float>> hull = visual_hull(part, kCells, warnings, run);
  if (!hull) return state.SkipWithError(hull.error().text().c_str());
  using Volume = itk::Image<float, 3>;
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(1);
  const auto copied = [&](auto value) {
    const auto volume = Volume::New();
    Volume::SizeType size;
    for (int a = 0; a < 3; ++a) size[a] = std::size_t(hull->size[a]);
    volume->SetRegions(size);
    volume->Allocate();
    itk::ImageRegionIterator<Volume> at(volume, volume->GetLargestPossibleRegion());
    for (std::size_t i = 0; !at.IsAtEnd(); ++at, ++i) at.Set(value(i));
    return volume;
  };
  double ours = 0, theirs = 0;
  for (auto _ : state) {
    LevelSetOptions options;
    options.iterations = kSteps;
    ours +=
        cpu_milliseconds([&] { benchmark::DoNotOptimize(level_set(part, *hull, options, run)); });
    const auto from = copied([&](std::size_t i) { return hull->values[i]; });
    const auto edges = copied([](std::size_t) { return 1.0f; });
    theirs += cpu_milliseconds([&] {
      const auto filter = itk::GeodesicActiveContourLevelSetImageFilter<Volume, Volume>::New();
      filter->SetInput(from);
      filter->SetFeatureImage(edges);
      filter->SetPropagationScaling(0);
      filter->SetCurvatureScaling(1);
      filter->SetAdvectionScaling(1);
      filter->SetMaximumRMSError(0);
      filter->SetNumberOfIterations(kSteps);
      filter->Update();
    });
  }
  tell(state, ours, theirs);
}
BENCHMARK(level_set_beside_itk)
    ->Name("peers/40 steps of the hero's chest/ITK")
    ->Unit(benchmark::kMillisecond);
#endif

}  // namespace
}  // namespace artisketch
