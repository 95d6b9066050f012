// Outlines straight into each stage that takes them, whatever they look like: crossing, spiralling,
// flat, doubled, less than a pixel, of very many points.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>

#include <fuzzer/FuzzedDataProvider.h>

#include "base/distance_field.h"
#include "base/distance_raster.h"
#include "base/raster.h"
#include "document/edit.h"
#include "document/mend.h"
#include "model/stages.h"

using namespace artisketch;

namespace {

using Bytes = FuzzedDataProvider;

Polyline spiral(Bytes& bytes) {
  Polyline line;
  const int count = bytes.ConsumeIntegralInRange(3, 3000);
  const double turns = bytes.ConsumeIntegralInRange(-20, 20);
  const double radius = bytes.ConsumeIntegralInRange(0, 60);
  for (int i = 0; i < count; ++i) {
    const double t = double(i) / count, angle = 2 * kPi * turns * t;
    line.points.emplace_back(64 + radius * t * std::cos(angle), 64 + radius * t * std::sin(angle));
  }
  return line;
}

Polyline polygon(Bytes& bytes) {
  constexpr double kSteps[] = {4, 1, 1e-3, 1e-7, 1e4};
  const double step = kSteps[bytes.ConsumeIntegralInRange(0, 4)];
  Polyline line;
  line.points.resize(bytes.ConsumeIntegralInRange(3, 24));
  for (Vec2& p : line.points) {
    p.x() = step * bytes.ConsumeIntegralInRange(0, 32);
    p.y() = step * bytes.ConsumeIntegralInRange(0, 32);
  }
  return line;
}

Polyline outline(Bytes& bytes) {
  Polyline line = bytes.ConsumeIntegralInRange(0, 5) ? polygon(bytes) : spiral(bytes);
  line.closed = bytes.ConsumeIntegralInRange(0, 7) != 0;
  return line;
}

void flat_stages(const Polyline& line, Bytes& bytes) {
  if (line.closed) {
    const Polyline whole = mended(line);
    if (whole.closed && whole.points.size() > 2 && self_crossing(whole)) std::abort();
    const Vec2 a(bytes.ConsumeIntegralInRange(-8, 136), bytes.ConsumeIntegralInRange(-8, 136));
    const Vec2 b(bytes.ConsumeIntegralInRange(-8, 136), bytes.ConsumeIntegralInRange(-8, 136));
    (void)cut_outline(line, a, b, 0.2);
    (void)with_stretch_redrawn(line, std::vector<Vec2>{a, b});
    const std::vector<std::vector<Vec2>> polygons{line.points};
    const Box2 box = bounds(std::span<const Polyline>(&line, 1));
    const double step = std::max(box.sizes().maxCoeff(), 1e-6) / 40;
    const DistanceRaster raster(polygons, step, 6 * step);
    if (std::isnan(raster.distance(a))) std::abort();
    Mask mask(64, 64);
    add_polygons(polygons, mask);
  }
  (void)outline_of_stroke(line.points, {});
  (void)resampled(line, 1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  Document document;
  document.camera.pixels_per_unit = 50;
  document.skeleton.joints.resize(2);
  document.skeleton.joints[0].name = "body";
  document.skeleton.joints[1].name = "tip";
  document.skeleton.joints[1].parent = 0;
  document.skeleton.joints[1].offset = {0, 0.5, 0};
  const int frames = bytes.ConsumeIntegralInRange(1, 3);
  for (int f = 0; f < frames; ++f) {
    Frame frame;
    frame.width = frame.height = 128;
    frame.pose = rest_pose(document.skeleton);
    frame.pose.rotations[0] =
        Quat(Eigen::AngleAxisd(radians(15 * bytes.ConsumeIntegralInRange(-12, 12)), Vec3::UnitY()));
    const int outlines = bytes.ConsumeIntegralInRange(1, 3);
    for (int c = 0; c < outlines; ++c) {
      frame.contours.push_back({0, outline(bytes), ""});
      flat_stages(frame.contours.back().line, bytes);
    }
    document.frames.push_back(std::move(frame));
  }
  for (const Part& part : parts_of(document))
    for (const Method method : {Method::rays, Method::paper}) {
      Run run;
      const Result<PartSurface> surface = reconstruct_part(part, {method, 16, false}, run);
      if (!surface && surface.error().faults.empty()) std::abort();
      if (surface && !topology(surface->mesh).closed()) std::abort();
    }
  return 0;
}
