// The two sparse solves, the weights' and volume reduction's, beside Eigen's plain SimplicialLDLT,
// a column at a time, on the same systems: those of the hero's skin and of its largest part. Both
// in one run; `ratio` is plain / ours, `factor` what both have in common; `theirs` is CHOLMOD's
// supernodal factorisation and solve, where that is installed.
#include <algorithm>
#include <chrono>
#include <limits>
#include <string>

#include <benchmark/benchmark.h>

#ifdef ARTISKETCH_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include "files/document_file.h"
#include "model/rig/heat.h"
#include "model/surface/bending.h"

namespace artisketch {
namespace {

struct System {
  SparseMatrix A;
  Columns right;
};

Result<Document> hero() {
  return read_document(ARTISKETCH_SOURCE_DIR "/assets/examples/hero/hero.artisketch");
}

Result<System> heat() {
  const Result<Document> document = hero();
  if (!document) return document.error();
  Run run;
  const Result<Reconstruction> made = reconstruct(*document, {}, run);
  if (!made) return made.error();
  Result<HeatSystem> system = heat_system(made->calibrated, made->parts, made->model.mesh, run);
  if (!system) return system.error();
  return System{std::move(system->A), std::move(system->right)};
}

// Held by the largest part's rims.
Result<System> bending() {
  const Result<Document> document = hero();
  if (!document) return document.error();
  Run run;
  System largest;
  for (const Part& part : parts_of(*document)) {
    const Result<PartSurface> surface = reconstruct_part(part, {}, run);
    if (!surface) return surface.error();
    const Mesh& mesh = surface->mesh;
    if (mesh.V.rows() <= largest.right.rows()) continue;
    const Result<std::vector<Rim>> rims = rim_paths(part, mesh, run);
    if (!rims) return rims.error();
    Eigen::VectorXd weights = Eigen::VectorXd::Constant(mesh.V.rows(), 1e-8);
    for (const Rim& rim : *rims)
      for (const int v : rim.vertices) weights[v] = std::numeric_limits<double>::infinity();
    BendingSystem system = bending_system(bi_laplacian(mesh), weights, mesh.V);
    largest = {std::move(system.A), std::move(system.right)};
  }
  return largest;
}

template <class Work>
double milliseconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

void time_solve(benchmark::State& state, Result<System> (*make)()) {
  const Result<System> system = make();
  if (!system) return state.SkipWithError(system.error().text().c_str());
  double factor = 0, plain = 0, ours = 0, theirs = 0, apart = 0;
  for (auto _ : state) {
    Eigen::SimplicialLDLT<SparseMatrix> factors;
    const double common = milliseconds([&] { factors.compute(system->A); });
    if (factors.info() != Eigen::Success) return state.SkipWithError("not positive definite");
    Eigen::MatrixXd one_by_one(system->right.rows(), system->right.cols());
    const double plain_solve = milliseconds([&] {
      for (Eigen::Index c = 0; c < one_by_one.cols(); ++c)
        one_by_one.col(c) = factors.solve(system->right.col(c));
    });
    Columns at_once;
    const double our_solve = milliseconds([&] { at_once = solve(factors, system->right); });
    apart = std::max(apart, (at_once - one_by_one).cwiseAbs().maxCoeff());
#ifdef ARTISKETCH_WITH_CHOLMOD
    theirs += milliseconds([&] {
      Eigen::CholmodSupernodalLLT<SparseMatrix> cholmod(system->A);
      const Eigen::MatrixXd solved = cholmod.solve(Eigen::MatrixXd(system->right));
      apart = std::max(apart, (solved - one_by_one).cwiseAbs().maxCoeff());
    });
#endif
    factor += common;
    plain += common + plain_solve;
    ours += common + our_solve;
  }
  const auto mean = [](double sum) {
    return benchmark::Counter(sum, benchmark::Counter::kAvgIterations);
  };
  state.counters["unknowns"] = double(system->right.rows());
  state.counters["columns"] = double(system->right.cols());
  state.counters["factor"] = mean(factor);
  state.counters["plain"] = mean(plain);
  state.counters["ours"] = mean(ours);
  state.counters["ratio"] = plain / ours;
  if (theirs > 0) state.counters["theirs"] = mean(theirs);
  state.counters["apart"] = apart;
}

BENCHMARK_CAPTURE(time_solve, heat, heat)
    ->Name("peers/heat of the hero's skin/CHOLMOD")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(time_solve, bending, bending)
    ->Name("peers/bi-Laplacian of the hero's largest part/CHOLMOD")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace artisketch
