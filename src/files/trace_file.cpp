#include "files/trace_file.h"

#include <cstdio>
#include <cstring>

#include "files/mesh_file.h"

namespace artisketch {
namespace {

template <class... Numbers>
std::string line_of(const char* format, Numbers... numbers) {
  char line[256];
  std::snprintf(line, sizeof line, format, numbers...);
  return line;
}

NamedFile file_of(const Mesh& mesh) {
  return {".ply", ply_bytes(mesh)};
}

NamedFile file_of(const Curves& curves) {
  std::string text;
  int next = 1;
  for (const std::vector<Vec3>& curve : curves) {
    std::string joined = "l";
    for (const Vec3& p : curve) {
      text += line_of("v %.9g %.9g %.9g\n", p.x(), p.y(), p.z());
      joined += " " + std::to_string(next++);
    }
    if (curve.size() > 1) text += joined + "\n";
  }
  return {".obj", text};
}

// Source: the NRRD format's definition, https://teem.sourceforge.net/nrrd/format.html.
NamedFile file_of(const Grid3<float>& field) {
  const double cell = field.cell;
  const Vec3& o = field.origin;
  std::string bytes = "NRRD0004\ntype: float\ndimension: 3\nspace dimension: 3\n";
  bytes += line_of("sizes: %d %d %d\n", field.size.x(), field.size.y(), field.size.z());
  bytes += line_of("space directions: (%.9g,0,0) (0,%.9g,0) (0,0,%.9g)\n", cell, cell, cell);
  bytes += line_of("space origin: (%.9g,%.9g,%.9g)\n", o.x(), o.y(), o.z());
  bytes += "endian: little\nencoding: raw\n\n";
  bytes.append(reinterpret_cast<const char*>(field.values.data()),
               field.values.size() * sizeof(float));
  return {".nrrd", std::move(bytes)};
}

// Names hold what any system's files may be called by; others' characters become spaces.
std::string file_name(const std::string& name) {
  std::string out = name;
  for (char& c : out)
    if ((c >= 0 && c < ' ') || std::strchr("/\\:*?\"<>|", c)) c = ' ';
  return out;
}

}  // namespace

std::vector<NamedFile> trace_files(const Trace& trace) {
  std::vector<NamedFile> files;
  for (const Trace::Entry& entry : trace.entries) {
    NamedFile file = std::visit([](const auto& what) { return file_of(what); }, entry.what);
    file.name = line_of("%03d ", int(files.size()) + 1) + file_name(entry.name) + file.name;
    files.push_back(std::move(file));
  }
  return files;
}

}  // namespace artisketch
