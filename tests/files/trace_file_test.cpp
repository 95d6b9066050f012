#include "files/trace_file.h"

#include <cstring>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

TEST(TraceFile, NamesFilesInTheOrderTheyWereMade) {
  Trace trace;
  trace.add("arm.L/hull", Grid3<float>(Vec3::Zero(), 1, Index3(2, 2, 2)));
  trace.add("a \"b\"\n", Curves());
  trace.add("skin", Mesh());
  const std::vector<NamedFile> files = trace_files(trace);
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[0].name, "001 arm.L hull.nrrd");
  EXPECT_EQ(files[1].name, "002 a  b  .obj");
  EXPECT_EQ(files[2].name, "003 skin.ply");
}

TEST(TraceFile, AFieldKeepsItsSamplesAndItsPlace) {
  Grid3<float> field(Vec3(1, -2, 0.5), 0.25, Index3(4, 3, 2), 0.0f);
  for (std::size_t i = 0; i < field.values.size(); ++i) field.values[i] = float(i) - 3.5f;
  Trace trace;
  trace.add("field", field);
  const std::string bytes = trace_files(trace)[0].bytes;
  const std::size_t body = bytes.find("\n\n") + 2;
  const std::string head = bytes.substr(0, body);
  EXPECT_EQ(head.rfind("NRRD0004\n", 0), 0u);
  for (const char* line : {"sizes: 4 3 2\n", "space origin: (1,-2,0.5)\n",
                           "space directions: (0.25,0,0) (0,0.25,0) (0,0,0.25)\n"})
    EXPECT_NE(head.find(line), std::string::npos) << head;
  ASSERT_EQ(bytes.size() - body, field.values.size() * sizeof(float));
  EXPECT_EQ(std::memcmp(&bytes[body], field.values.data(), bytes.size() - body), 0);
}

TEST(TraceFile, CurvesBecomeLinesThatCountTheirPointsOn) {
  Trace trace;
  trace.add(
      "rims",
      Curves{{Vec3(0, 0, 1), Vec3(0, 1, 0)}, {Vec3(5, 5, 5)}, {Vec3(1, 0, 0), Vec3(2, 0, 0)}});
  EXPECT_EQ(trace_files(trace)[0].bytes,
            "v 0 0 1\nv 0 1 0\nl 1 2\nv 5 5 5\nv 1 0 0\nv 2 0 0\nl 4 5\n");
}

TEST(TraceFile, MeshesArePly) {
  Mesh triangle;
  triangle.V = Points3::Identity(3, 3);
  triangle.F.resize(1, 3);
  triangle.F << 0, 1, 2;
  Trace trace;
  trace.add("skin", triangle);
  const std::string bytes = trace_files(trace)[0].bytes;
  EXPECT_EQ(bytes.rfind("ply\n", 0), 0u);
  EXPECT_NE(bytes.find("element vertex 3\n"), std::string::npos);
  EXPECT_EQ(bytes.find("property uchar red"), std::string::npos);
}

}  // namespace
}  // namespace artisketch
