#include "files/inside_images.h"

#include <filesystem>

#include "files/bytes.h"
#include "files/document_file.h"

namespace artisketch {

std::string data_uri(std::string_view image) {
  const bool png = image.starts_with("\x89PNG");
  return std::string("data:image/") + (png ? "png" : "jpeg") + ";base64," + base64(image);
}

Result<std::string> with_images_inside(std::string_view text, const std::string& path) {
  Result<Document> document = parse_document(text, path);
  if (!document) return document.error();
  for (Frame& frame : document->frames) {
    if (frame.image.empty() || frame.image.starts_with("data:")) continue;
    const std::filesystem::path beside = std::filesystem::path(path).parent_path() / frame.image;
    const Result<std::string> image = read_file(beside.string());
    if (!image) return image.error();
    frame.image = data_uri(*image);
  }
  return document_text(*document);
}

}  // namespace artisketch
