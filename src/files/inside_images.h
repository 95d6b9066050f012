// Documents as one file, with their images inside.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace artisketch {

// The text of a document (FORMAT.md) whose images lie beside it at `path`, with data: URIs in their
// place. Fails where the document or an image cannot be read, where an image is no PNG or JPEG, and
// where its path leaves the document's folder.
Result<std::string> with_images_inside(std::string_view document, const std::string& path);

// The bytes of an image as a data: URI. PNG where they begin as one, else JPEG.
std::string data_uri(std::string_view image);

}  // namespace artisketch
