#include "files/inside_images.h"

#include <filesystem>

#include "files/bytes.h"
#include "files/document_file.h"
#include "files/image_file.h"

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
    const std::string whose = path + ": the image of frame '" + frame.name + "'";
    if (leaves_folder(frame.image))
      return bad_input(whose + " lies outside the document's folder: " + frame.image +
                       "; put it beside the document, or add it to the drawings here");
    const std::filesystem::path beside = std::filesystem::path(path).parent_path() / frame.image;
    const Result<std::string> image = read_file(beside.string());
    if (!image) return image.error();
    // Nothing but pictures goes into a document that may be sent on.
    if (const Result<Image> decoded = decode_image(*image, whose); !decoded) return decoded.error();
    frame.image = data_uri(*image);
  }
  return document_text(*document);
}

}  // namespace artisketch
