// Each struct's fields are named once, in a fields() that both the writer and the reader walk.
#include "app/job_bytes.h"

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace artisketch {
namespace {

class Writer {
 public:
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
  explicit Reader(std::string_view bytes) : left_(bytes) {}
  bool good() const { return good_; }
  bool done() const { return good_ && left_.empty(); }
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

template <class T>
constexpr bool kPlain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

template <class Archive, class T>
std::enable_if_t<kPlain<T>> field(Archive& a, T& value) {
  a.raw(&value, sizeof value);
}

template <class Archive>
void field(Archive& a, std::string& text) {
  text.resize(a.count(text.size(), 1));
  a.raw(text.data(), text.size());
}

template <class Archive>
void field(Archive& a, Vec3& v) {
  a.raw(v.data(), 3 * sizeof(double));
}

template <class Archive, class Scalar>
void field(Archive& a, Eigen::Matrix<Scalar, Eigen::Dynamic, 3, Eigen::RowMajor>& rows) {
  const std::size_t count = a.count(std::size_t(rows.rows()), 3 * sizeof(Scalar));
  rows.resize(Eigen::Index(count), 3);
  a.raw(rows.data(), count * 3 * sizeof(Scalar));
}

template <class Archive>
void field(Archive& a, Vec2& v) {
  a.raw(v.data(), 2 * sizeof(double));
}

template <class Archive, class T>
void field(Archive& a, std::vector<T>& all);

template <class Archive>
void field(Archive& a, Bone& bone) {
  field(a, bone.joint), field(a, bone.child), field(a, bone.a), field(a, bone.b);
}

template <class Archive>
void field(Archive& a, Polyline& line) {
  field(a, line.points), field(a, line.closed);
}

template <class Archive>
void field(Archive& a, PartView& view) {
  field(a, view.frame), field(a, view.mirrored);
  Camera& camera = view.camera.camera;
  field(a, camera.type), field(a, camera.pixels_per_unit), field(a, camera.focal_length);
  field(a, camera.distance), field(a, view.camera.principal_point), field(a, view.camera.scale);
  a.raw(view.to_world.data(), 16 * sizeof(double));
  field(a, view.contours);
  if constexpr (std::is_same_v<Archive, Reader>) view.outline = outline_of(view.contours);
}

template <class Archive>
void field(Archive& a, Part& part) {
  field(a, part.joint), field(a, part.name), field(a, part.views), field(a, part.mirrors);
  field(a, part.bones), field(a, part.origin), field(a, part.fatness);
}

template <class Archive>
void fields(Archive& a, PipelineOptions& o) {
  field(a, o.method), field(a, o.grid), field(a, o.calibrate), field(a, o.visual_hull);
  field(a, o.triangles), field(a, o.mirror);
}

template <class Archive>
void fields(Archive& a, JobRequest& r) {
  field(a, r.kind), field(a, r.document), field(a, r.parts), fields(a, r.options),
      field(a, r.trace);
}

template <class Archive>
void fields(Archive& a, Progress& p) {
  field(a, p.stage), field(a, p.item), field(a, p.part), field(a, p.parts), field(a, p.fraction);
}

template <class Archive>
void field(Archive& a, FrameFit::PartFit& fit) {
  field(a, fit.joint), field(a, fit.distance);
}

template <class Archive>
void field(Archive& a, FrameFit& fit) {
  field(a, fit.iou), field(a, fit.parts);
}

template <class Archive>
void field(Archive& a, PartCoverage& part) {
  field(a, part.joint), field(a, part.frame), field(a, part.before), field(a, part.after);
}

template <class Archive>
void field(Archive& a, JointSphere& sphere) {
  field(a, sphere.joint), field(a, sphere.centre), field(a, sphere.radius);
}

template <class Archive>
void field(Archive& a, Mesh& mesh) {
  field(a, mesh.V), field(a, mesh.F);
}

template <class Archive>
void field(Archive& a, PartMesh& part) {
  field(a, part.joint), field(a, part.mesh), field(a, part.frames), field(a, part.distances);
}

template <class Archive>
void field(Archive& a, Trace::Entry& entry) {
  field(a, entry.name);
  bool mesh = std::holds_alternative<Mesh>(entry.what);
  field(a, mesh);
  if (mesh) {
    if (!std::holds_alternative<Mesh>(entry.what)) entry.what = Mesh();
    field(a, std::get<Mesh>(entry.what));
  } else {
    if (!std::holds_alternative<Curves>(entry.what)) entry.what = Curves();
    field(a, std::get<Curves>(entry.what));
  }
}

template <class Archive, class T>
void field(Archive& a, std::vector<T>& all) {
  all.resize(a.count(all.size(), 1));
  for (T& one : all) field(a, one);
}

template <class Archive>
void fields(Archive& a, JobResult& r) {
  field(a, r.document), field(a, r.glb), field(a, r.report), field(a, r.fits);
  field(a, r.coverage), field(a, r.spheres), field(a, r.undetermined), field(a, r.warnings);
  field(a, r.parts), field(a, r.trace.entries);
}

template <class Archive>
void fields(Archive& a, Error& error) {
  field(a, error.kind), field(a, error.faults);
}

template <class T>
std::string written(T value) {
  Writer writer;
  fields(writer, value);
  return std::move(writer.bytes);
}

Error damaged() {
  return broke_off("its message was damaged on the way");
}

template <class T>
Result<T> read(std::string_view bytes) {
  Reader reader(bytes);
  T value;
  fields(reader, value);
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
  const char kind = outcome.ok() ? 'r' : 'e';
  if (!outcome) return kind + written(outcome.error());
  JobResult result = *outcome;
  std::erase_if(result.trace.entries, [](const Trace::Entry& entry) {
    return std::holds_alternative<Grid3<float>>(entry.what);
  });
  return kind + written(std::move(result));
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
  fields(reader, error);
  return reader.done() ? error : damaged();
}

}  // namespace artisketch
