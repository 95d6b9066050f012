// Each struct's fields are named once, in a field() that both the writer and the reader walk: the
// writer over what is const, so that nothing is copied but into its bytes.
#include "app/job_bytes.h"

#include <concepts>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace artisketch {
namespace {

class Writer {
 public:
  static constexpr bool kReads = false;
  std::string bytes;
  void raw(const void* from, std::size_t size) {
    bytes.append(static_cast<const char*>(from), size);
  }
  std::size_t count(std::size_t have, std::size_t) {
    const std::uint64_t size = have;
    raw(&size, sizeof size);
    return have;
  }
};

class Reader {
 public:
  static constexpr bool kReads = true;
  explicit Reader(std::string_view bytes) : left_(bytes) {}
  bool good() const { return good_; }
  bool done() const { return good_ && left_.empty(); }
  void refuse() { good_ = false; }
  void raw(void* to, std::size_t size) {
    if (size > left_.size()) good_ = false;
    if (!good_ || size == 0) return;
    std::memcpy(to, left_.data(), size);
    left_.remove_prefix(size);
  }
  // How many elements follow, of at least `least` bytes each: a damaged count allocates nothing.
  std::size_t count(std::size_t, std::size_t least) {
    std::uint64_t size = 0;
    raw(&size, sizeof size);
    if (size > left_.size() / least) good_ = false;
    return good_ ? std::size_t(size) : 0;
  }

 private:
  std::string_view left_;
  bool good_ = true;
};

// T is U, or a const U.
template <class T, class U>
concept Is = std::same_as<std::remove_const_t<T>, U>;
template <class T>
concept Plain = (std::is_arithmetic_v<T> && !Is<T, bool>) || std::is_enum_v<T>;

// Not raw: a byte that is neither 0 nor 1 is no bool, and what it then does is undefined.
template <class Archive, Is<bool> T>
void field(Archive& a, T& value) {
  std::uint8_t byte = value;
  a.raw(&byte, 1);
  if constexpr (Archive::kReads) {
    if (byte > 1) a.refuse();
    value = byte == 1;
  }
}

template <class Archive, Plain T>
void field(Archive& a, T& value) {
  a.raw(&value, sizeof value);
}

template <class Archive, Is<std::string> T>
void field(Archive& a, T& text) {
  const std::size_t count = a.count(text.size(), 1);
  if constexpr (Archive::kReads) text.resize(count);
  a.raw(text.data(), count);
}

template <class Archive, class T>
requires Is<T, Vec2> || Is<T, Vec3>
void field(Archive& a, T& v) {
  a.raw(v.data(), v.size() * sizeof(double));
}

template <class Archive, class T>
requires Is<T, Points3> || Is<T, Triangles>
void field(Archive& a, T& rows) {
  const std::size_t row = 3 * sizeof(*rows.data()), count = a.count(std::size_t(rows.rows()), row);
  if constexpr (Archive::kReads) rows.resize(Eigen::Index(count), 3);
  a.raw(rows.data(), count * row);
}

template <class Archive, class T>
requires Is<T, std::vector<typename T::value_type, typename T::allocator_type>>
void field(Archive& a, T& all) {
  const std::size_t count = a.count(all.size(), 1);
  if constexpr (Archive::kReads) all.resize(count);
  for (auto& one : all) field(a, one);
}

template <class Archive, Is<Bone> T>
void field(Archive& a, T& bone) {
  field(a, bone.joint), field(a, bone.child), field(a, bone.a), field(a, bone.b);
}

template <class Archive, Is<Polyline> T>
void field(Archive& a, T& line) {
  field(a, line.points), field(a, line.closed);
}

template <class Archive, Is<PartView> T>
void field(Archive& a, T& view) {
  field(a, view.frame), field(a, view.mirrored);
  auto& camera = view.camera.camera;
  field(a, camera.type), field(a, camera.pixels_per_unit), field(a, camera.focal_length);
  field(a, camera.distance), field(a, view.camera.principal_point), field(a, view.camera.scale);
  a.raw(view.to_world.data(), 16 * sizeof(double));
  field(a, view.contours);
  if constexpr (Archive::kReads) view.outline = outline_of(view.contours);
}

template <class Archive, Is<Part> T>
void field(Archive& a, T& part) {
  field(a, part.joint), field(a, part.name), field(a, part.views), field(a, part.mirrors);
  field(a, part.bones), field(a, part.origin), field(a, part.fatness);
}

template <class Archive, Is<PipelineOptions> T>
void field(Archive& a, T& o) {
  field(a, o.method), field(a, o.grid), field(a, o.calibrate), field(a, o.visual_hull);
  field(a, o.triangles), field(a, o.mirror), field(a, o.texture);
}

template <class Archive, Is<JobRequest> T>
void field(Archive& a, T& r) {
  field(a, r.kind), field(a, r.document), field(a, r.parts), field(a, r.options);
}

template <class Archive, Is<Progress> T>
void field(Archive& a, T& p) {
  field(a, p.stage), field(a, p.item), field(a, p.part), field(a, p.parts), field(a, p.fraction);
}

template <class Archive, Is<FrameFit::PartFit> T>
void field(Archive& a, T& fit) {
  field(a, fit.joint), field(a, fit.distance);
}

template <class Archive, Is<FrameFit> T>
void field(Archive& a, T& fit) {
  field(a, fit.iou), field(a, fit.parts);
}

template <class Archive, Is<PartCoverage> T>
void field(Archive& a, T& part) {
  field(a, part.joint), field(a, part.frame), field(a, part.before), field(a, part.after);
}

template <class Archive, Is<JointSphere> T>
void field(Archive& a, T& sphere) {
  field(a, sphere.joint), field(a, sphere.centre), field(a, sphere.radius);
}

template <class Archive, Is<Mesh> T>
void field(Archive& a, T& mesh) {
  field(a, mesh.V), field(a, mesh.F);
}

template <class Archive, Is<PartMesh> T>
void field(Archive& a, T& part) {
  field(a, part.joint), field(a, part.mesh), field(a, part.frames), field(a, part.distances);
}

template <class Archive, Is<JobResult> T>
void field(Archive& a, T& r) {
  field(a, r.document), field(a, r.glb), field(a, r.report), field(a, r.fits);
  field(a, r.coverage), field(a, r.spheres), field(a, r.undetermined), field(a, r.warnings);
  field(a, r.parts);
}

template <class Archive, Is<Error> T>
void field(Archive& a, T& error) {
  field(a, error.kind), field(a, error.faults);
}

template <class T>
std::string written(const T& value, std::string begun = {}) {
  Writer writer;
  writer.bytes = std::move(begun);
  field(writer, value);
  return std::move(writer.bytes);
}

Error damaged() {
  return broke_off("its message was damaged on the way");
}

template <class T>
Result<T> read(std::string_view bytes) {
  Reader reader(bytes);
  T value;
  field(reader, value);
  if (!reader.done()) return damaged();
  return value;
}

}  // namespace

std::string job_bytes(const JobRequest& request) {
  return written(request);
}

std::string job_bytes(const Progress& progress) {
  return written(progress);
}

std::string job_bytes(const Result<JobResult>& outcome) {
  return outcome ? written(*outcome, "r") : written(outcome.error(), "e");
}

Result<JobRequest> read_job_request(std::string_view bytes) {
  return read<JobRequest>(bytes);
}

Result<Progress> read_job_progress(std::string_view bytes) {
  return read<Progress>(bytes);
}

Result<JobResult> read_job_outcome(std::string_view bytes) {
  if (bytes.empty()) return damaged();
  if (bytes[0] == 'r') return read<JobResult>(bytes.substr(1));
  Reader reader(bytes.substr(1));
  Error error;
  field(reader, error);
  return reader.done() ? error : damaged();
}

}  // namespace artisketch
