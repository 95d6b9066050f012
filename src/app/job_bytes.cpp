// Each struct's fields are named once, in a field() that both the writer and the reader walk: the
// writer over what is const, so that nothing is copied but into its bytes. What a field may hold is
// asked of the reader alone: no NaN, no index and no choice that there isn't reaches a stage.
#include "app/job_bytes.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "files/document_file.h"

namespace artisketch {
namespace {

class Writer {
 public:
  static constexpr bool kReads = false;
  std::string bytes;
  void must(bool) {}
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
  void must(bool holds) { good_ &= holds; }
  void raw(void* to, std::size_t size) {
    if (size == 0) return;
    if (size > left_.size()) good_ = false;
    if (!good_) {
      std::memset(to, 0, size);  // what is asked of it next is asked of something
      return;
    }
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

// Far beyond what a document's limits let arise, and a square that stays finite.
constexpr double kMostNumber = 1e15;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kMostInt = std::numeric_limits<int>::max();

// Each choice from the first to the last of them is one.
constexpr JobRequest::Kind last_choice(JobRequest::Kind) {
  return JobRequest::Kind::sprites;
}
constexpr Light last_choice(Light) {
  return Light::toon;
}
constexpr SheetLayout last_choice(SheetLayout) {
  return SheetLayout::hash;
}
constexpr Method last_choice(Method) {
  return Method(std::size(kMethodNames) - 1);
}
constexpr Camera::Type last_choice(Camera::Type) {
  return Camera::Type::perspective;
}
constexpr Error::Kind last_choice(Error::Kind) {
  return Error::Kind::crashed;
}

// NaN lies between no bounds.
template <class Archive, class T>
void between(Archive& a, T& value, double low, double high) {
  a.raw(&value, sizeof value);
  a.must(double(value) >= low && double(value) <= high);
}

template <class Archive, class T>
void joint_index(Archive& a, T& joint) {
  between(a, joint, 0, kMostJoints - 1);
}

template <class Archive, class T>
void frame_index(Archive& a, T& frame) {
  between(a, frame, 0, kMostFrames - 1);
}

// Not raw: a byte that is neither 0 nor 1 is no bool, and what it then does is undefined.
template <class Archive, Is<bool> T>
void field(Archive& a, T& value) {
  std::uint8_t byte = value;
  a.raw(&byte, 1);
  a.must(byte <= 1);
  if constexpr (Archive::kReads) value = byte == 1;
}

template <class Archive, Is<double> T>
void field(Archive& a, T& value) {
  between(a, value, -kMostNumber, kMostNumber);
}

template <class Archive, class T>
requires std::is_enum_v<T>
void field(Archive& a, T& value) {
  a.raw(&value, sizeof value);
  a.must(value >= T() && value <= last_choice(value));
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
  for (auto& x : v) field(a, x);
}

template <class Archive, class T>
requires Is<T, Points3> || Is<T, Triangles>
void rows_of(Archive& a, T& rows, double low, double high) {
  const std::size_t row = 3 * sizeof(*rows.data()), count = a.count(std::size_t(rows.rows()), row);
  if constexpr (Archive::kReads) rows.resize(Eigen::Index(count), 3);
  a.raw(rows.data(), count * row);
  if constexpr (Archive::kReads)
    a.must(std::all_of(rows.data(), rows.data() + rows.size(),
                       [&](auto x) { return double(x) >= low && double(x) <= high; }));
}

template <class Archive, class T, class Walk>
void each(Archive& a, T& all, const Walk& walk) {
  const std::size_t count = a.count(all.size(), 1);
  if constexpr (Archive::kReads) all.resize(count);
  for (auto& one : all) walk(one);
}

template <class Archive, class T>
requires Is<T, std::vector<typename T::value_type, typename T::allocator_type>>
void field(Archive& a, T& all) {
  each(a, all, [&](auto& one) { field(a, one); });
}

template <class Archive, Is<Bone> T>
void field(Archive& a, T& bone) {
  joint_index(a, bone.joint), joint_index(a, bone.child), field(a, bone.a), field(a, bone.b);
}

template <class Archive, Is<Polyline> T>
void field(Archive& a, T& line) {
  field(a, line.points), field(a, line.closed);
  a.must(!line.points.empty());
  constexpr double kMostPixels = 1e7;  // of a document's, reflected about one another
  for (const Vec2& p : line.points) a.must(p.cwiseAbs().maxCoeff() <= kMostPixels);
}

// Turns, reflections and moves: what has an inverse that is as large.
template <class Archive, Is<Transform> T>
void field(Archive& a, T& transform) {
  constexpr double kRigid = 1e-2;  // a thousand rotations on one another, each 1e-6 off unit length
  auto& matrix = transform.matrix();
  for (auto& x : matrix.reshaped()) field(a, x);
  const Mat3 turn = transform.linear();
  a.must((turn.transpose() * turn - Mat3::Identity()).cwiseAbs().maxCoeff() <= kRigid);
  a.must(matrix.row(3) == Eigen::RowVector4d(0, 0, 0, 1));
}

template <class Archive, Is<PartView> T>
void field(Archive& a, T& view) {
  constexpr double kLeast = 1e-12;  // of a camera's sizes: a document's least, and of a scale
  frame_index(a, view.frame), field(a, view.mirrored);
  auto& camera = view.camera.camera;
  field(a, camera.type), between(a, camera.pixels_per_unit, kLeast, kMostNumber);
  between(a, camera.focal_length, kLeast, kMostNumber);
  between(a, camera.distance, kLeast, kMostNumber);
  field(a, view.camera.principal_point), between(a, view.camera.scale, kLeast, kMostNumber);
  field(a, view.to_world), field(a, view.contours);
  if constexpr (Archive::kReads) view.outline = outline_of(view.contours);
}

template <class Archive, Is<Part> T>
void field(Archive& a, T& part) {
  joint_index(a, part.joint), field(a, part.name), field(a, part.views), field(a, part.mirrors);
  field(a, part.bones), field(a, part.origin), between(a, part.fatness, 0, kMostNumber);
}

template <class Archive, Is<PipelineOptions> T>
void field(Archive& a, T& o) {
  field(a, o.method), between(a, o.grid, kFewestCells, kMostCells);
  field(a, o.calibrate), field(a, o.visual_hull);
  between(a, o.triangles, 0, kMostInt), field(a, o.mirror), field(a, o.texture);
}

template <class Archive, Is<SpriteOptions> T>
void field(Archive& a, T& o) {
  field(a, o.clip), between(a, o.directions, 1, 16), between(a, o.size, 8, 1024);
  a.must(o.directions > 0 && 16 % o.directions == 0);
  between(a, o.rate, 1, 60), between(a, o.padding, 0, 64), field(a, o.pitch), field(a, o.light);
  field(a, o.ink), between(a, o.pixels, 0, 16), field(a, o.normals), field(a, o.depth);
  field(a, o.layout);
}

template <class Archive, Is<JobRequest> T>
void field(Archive& a, T& r) {
  field(a, r.kind), field(a, r.document), field(a, r.parts), field(a, r.options);
  field(a, r.glb), field(a, r.sprites), field(a, r.name);
}

template <class Archive, Is<Progress> T>
void field(Archive& a, T& p) {
  constexpr double kRounding = 1e-9;  // of shares that are added up
  field(a, p.stage), field(a, p.item), between(a, p.part, 0, kMostInt);
  between(a, p.parts, 0, kMostInt), between(a, p.fraction, 0, 1 + kRounding);
}

// Infinite where there is nothing to compare.
template <class Archive, class T>
void distance(Archive& a, T& pixels) {
  between(a, pixels, 0, kInfinity);
}

template <class Archive, Is<FrameFit::PartFit> T>
void field(Archive& a, T& fit) {
  joint_index(a, fit.joint), distance(a, fit.distance);
}

template <class Archive, Is<FrameFit> T>
void field(Archive& a, T& fit) {
  field(a, fit.iou), field(a, fit.parts);
}

template <class Archive, Is<PartCoverage> T>
void field(Archive& a, T& part) {
  joint_index(a, part.joint), frame_index(a, part.frame);
  field(a, part.before), field(a, part.after);
}

template <class Archive, Is<JointSphere> T>
void field(Archive& a, T& sphere) {
  joint_index(a, sphere.joint), field(a, sphere.centre);
  between(a, sphere.radius, 0, kMostNumber);
}

template <class Archive, Is<Mesh> T>
void field(Archive& a, T& mesh) {
  rows_of(a, mesh.V, -kMostNumber, kMostNumber);
  rows_of(a, mesh.F, 0, double(mesh.V.rows()) - 1);
}

template <class Archive, Is<PartMesh> T>
void field(Archive& a, T& part) {
  joint_index(a, part.joint), field(a, part.mesh);
  each(a, part.frames, [&](auto& frame) { frame_index(a, frame); });
  each(a, part.distances, [&](auto& pixels) { distance(a, pixels); });
  a.must(part.frames.size() == part.distances.size());
}

template <class Archive, Is<JobResult> T>
void field(Archive& a, T& r) {
  field(a, r.document), field(a, r.glb), field(a, r.report), field(a, r.fits);
  field(a, r.coverage), field(a, r.spheres), field(a, r.undetermined), field(a, r.warnings);
  field(a, r.parts), field(a, r.sprites);
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
