#include "model/part_inputs.h"

#include <type_traits>

namespace artisketch {
namespace {

class Bytes {
 public:
  template <class T>
  void add(const T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);  // no padding
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void add(const Vec2& p) {
    for (const double x : p) add(x);
  }
  void add(const Vec3& p) {
    for (const double x : p) add(x);
  }
  void add(const std::string& text) {
    add(text.size());
    bytes_ += text;
  }
  void add(const PartView& view) {
    add(view.frame);
    add(view.mirrored);
    add(view.camera.camera.type);
    add(view.camera.camera.pixels_per_unit);
    add(view.camera.camera.focal_length);
    add(view.camera.camera.distance);
    add(view.camera.principal_point);
    add(view.camera.scale);
    for (const double x : view.to_world.matrix().reshaped()) add(x);
    add(view.contours.size());
    for (const Polyline& line : view.contours) {
      add(line.closed);
      add(line.points.size());
      for (const Vec2& p : line.points) add(p);
    }
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

}  // namespace

std::string surface_inputs(const Part& part, const SurfaceOptions& options) {
  Bytes bytes;
  bytes.add(options.method);
  bytes.add(options.grid);
  bytes.add(options.visual_hull);
  bytes.add(part.joint);
  bytes.add(part.name);
  bytes.add(part.origin);
  bytes.add(part.fatness);
  bytes.add(part.bones.size());
  for (const Bone& bone : part.bones) {
    bytes.add(bone.a);
    bytes.add(bone.b);
  }
  for (const std::vector<PartView>* views : {&part.views, &part.mirrors}) {
    bytes.add(views->size());
    for (const PartView& view : *views) bytes.add(view);
  }
  return bytes.take();
}

}  // namespace artisketch
