#include "files/inside_images.h"

#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "files/bytes.h"
#include "files/document_file.h"
#include "files/image_file.h"

namespace artisketch {
namespace {

namespace fs = std::filesystem;

std::string document_naming(const std::string& image) {
  return R"({"artisketch":1,"camera":{"type":"orthographic","pixels_per_unit":50},)"
         R"("skeleton":{"joints":[{"name":"body","parent":null,"offset":[0,0,0]}]},)"
         R"("frames":[{"name":"front","size":[4,3],"image":")" +
         image + R"(","pose":{"root_position":[0,0,0]},"contours":[]}]})";
}

// Whatever a document names, nothing but pictures out of its own folder goes into it: it may be
// sent on.
TEST(InsideImages, TakesPicturesBesideTheDocumentAlone) {
  const fs::path folder =
      fs::temp_directory_path() / ("artisketch-inside-" + std::to_string(getpid()));
  fs::create_directories(folder / "sub");
  const std::string png = png_bytes(Image(4, 3));
  ASSERT_TRUE(write_file((folder / "a.png").string(), png));
  ASSERT_TRUE(write_file((folder / "sub" / "b.png").string(), png));
  ASSERT_TRUE(write_file((folder / "sub" / "secret.png").string(), "root:x:0:0:"));
  const auto inside = [&](const char* image) {
    return with_images_inside(document_naming(image), (folder / "sub" / "d.artisketch").string());
  };
  const Result<std::string> good = inside("b.png");
  ASSERT_TRUE(good) << good.error().text();
  EXPECT_EQ(parse_document(*good, "d")->frames[0].image, data_uri(png));
  for (const char* image : {"../a.png", "x/../../a.png", "secret.png", "none.png"}) {
    const Result<std::string> refused = inside(image);
    ASSERT_FALSE(refused) << image;
    EXPECT_EQ(refused.error().text().find("root:"), std::string::npos);
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace artisketch
