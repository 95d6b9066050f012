// Every document that passes its checks ends in a closed, bound mesh or in an error with words,
// whatever its strokes look like. The bytes choose a small chain of joints, frames that turn it,
// and contours on a coarse lattice, where degenerate shapes are frequent.
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <string>

#include <fuzzer/FuzzedDataProvider.h>

#include "files/document_file.h"
#include "files/gltf.h"
#include "model/stages.h"

using namespace artisketch;

namespace {

Vec3 small_integers(FuzzedDataProvider& bytes) {
  const int x = bytes.ConsumeIntegralInRange(-5, 5);
  const int y = bytes.ConsumeIntegralInRange(-5, 5);
  const int z = bytes.ConsumeIntegralInRange(-5, 5);
  return Vec3(x, y, z);
}

Quat rotation_from(FuzzedDataProvider& bytes) {
  const Vec3 turn = small_integers(bytes);
  if (turn.isZero()) return Quat::Identity();
  return Quat(Eigen::AngleAxisd(turn.norm() * std::numbers::pi / 6, turn.normalized()));
}

Contour contour_from(FuzzedDataProvider& bytes, int joints) {
  Contour contour;
  contour.joint = bytes.ConsumeIntegralInRange(0, joints - 1);
  contour.line.closed = bytes.ConsumeIntegralInRange(0, 7) != 0;
  const int count = bytes.ConsumeIntegralInRange(2, 12);
  for (int i = 0; i < count; ++i) {
    const int x = bytes.ConsumeIntegralInRange(0, 32);
    const int y = bytes.ConsumeIntegralInRange(0, 32);
    contour.line.points.emplace_back(4 * x, 4 * y);
  }
  return contour;
}

Document document_from(FuzzedDataProvider& bytes) {
  Document document;
  document.name = "fuzz";
  document.camera.type =
      bytes.ConsumeBool() ? Camera::Type::orthographic : Camera::Type::perspective;
  document.camera.pixels_per_unit = 50;
  document.camera.focal_length = 200;
  document.camera.distance = 4;
  const int joints = bytes.ConsumeIntegralInRange(1, 3);
  for (int j = 0; j < joints; ++j) {
    Joint joint;
    joint.name = "joint" + std::to_string(j);
    joint.parent = j - 1;
    joint.offset = 0.1 * small_integers(bytes);
    document.skeleton.joints.push_back(joint);
  }
  const int frames = bytes.ConsumeIntegralInRange(1, 3);
  for (int f = 0; f < frames; ++f) {
    Frame frame;
    frame.name = "frame" + std::to_string(f);
    frame.width = frame.height = 128;
    frame.pose = rest_pose(document.skeleton);
    for (Quat& rotation : frame.pose.rotations) rotation = rotation_from(bytes);
    const int contours = bytes.ConsumeIntegralInRange(0, 4);
    for (int c = 0; c < contours; ++c) frame.contours.push_back(contour_from(bytes, joints));
    document.frames.push_back(frame);
  }
  return document;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes(data, size);
  PipelineOptions options;
  options.method = bytes.ConsumeBool() ? Method::paper : Method::rays;
  options.calibrate = bytes.ConsumeBool();
  options.grid = 16;
  const Result<Document> document = parse_document(document_text(document_from(bytes)), "fuzz");
  if (!document) return 0;
  Run run;
  const Result<Reconstruction> result = reconstruct(*document, options, run);
  if (!result) {
    if (result.error().faults.empty()) std::abort();
    return 0;
  }
  if (!topology(result->model.mesh).closed() || !glb_bytes(result->model)) std::abort();
  return 0;
}
