// Images: PNG, JPEG and GIF in, PNG out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/image.h"
#include "base/result.h"
#include "document/document.h"

namespace artisketch {

// The image as it is to be seen: turned as its Exif orientation says, 8 bits a channel. Fails on
// what is no PNG or JPEG, is damaged (or inflates to more than its size can need), or has more than
// 16384 pixels a side or 100 million in all. `name` is used in the error only.
Result<Image> decode_image(std::string_view bytes, const std::string& name);

// The same for several: a GIF's frames as they are seen, one after the other; else the one image.
Result<std::vector<Image>> decode_images(std::string_view bytes, const std::string& name);
bool is_gif(std::string_view bytes);

// The name of an image's colour profile where that isn't sRGB; empty without one.
std::string colour_profile(std::string_view bytes);

// The image must have pixels. Alpha is left out where all is opaque.
std::string png_bytes(const Image& image);

// A frame's drawing: a path relative to the document's folder, or a data: URI; every `side` by
// `side` pixels as one (mean_of_blocks). An empty image where the frame has none. Fails, naming the
// frame and what to do, where it cannot be read, is not of the frame's size, or lies outside the
// document's folder.
Result<Image> load_frame_image(const Frame& frame, const std::string& document_path, int side = 1);

// "640 × 800"
std::string size_words(long long width, long long height);

// Whether a frame's image is a path that climbs out of its document's folder.
bool leaves_folder(const std::string& image);

// What a person should know of a document's drawings: colour profiles that are not used.
std::vector<std::string> drawing_words(const Document& document, const std::string& document_path);

// The drawings of all frames, as large as their parts are worked on where that is smaller than they
// are (model/working_scale.h): an empty one, and the reason in `warnings`, where one cannot be read
// or all before it have 250 million pixels. An image that several frames name is decoded once.
std::vector<Image> load_drawings(const Document& document, const std::string& document_path,
                                 std::vector<std::string>& warnings);

}  // namespace artisketch
