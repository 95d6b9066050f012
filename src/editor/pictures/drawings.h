// The drawings' pixels, kept once however many states of the document undo remembers: inside the
// editor a frame's `image` is a short key into this store.
#pragma once

#include <map>
#include <string>

#include "base/result.h"
#include "document/document.h"
#include "editor/pictures/graphics.h"
#include "files/image_file.h"

namespace artisketch {

struct Drawing {
  Image image;           // straight alpha
  std::string uri;       // as the document's file holds it
  unsigned texture = 0;  // premultiplied alpha
  bool pale = false;     // clear about a figure whose edge is as light as paper
  bool full = false;     // the figure goes on to the picture's edge
};

class Drawings {
 public:
  explicit Drawings(Graphics& graphics) : graphics_(graphics) {}  // which outlives it
  Drawings(const Drawings&) = delete;
  Drawings& operator=(const Drawings&) = delete;
  ~Drawings();

  // Keeps a PNG or JPEG; gives its key. Fails where it cannot be read; `name` is for the error.
  Result<std::string> add(std::string bytes, const std::string& name);
  // Moves the data: URIs of a document into the store, leaving keys.
  Result<Done> take(Document& document);
  // The document with its drawings inside, as it is written.
  Document whole(Document document) const;

  const Drawing* of(const Frame& frame) const { return at(frame.image); }
  const Drawing* at(const std::string& key) const;  // null where it has none

 private:
  Graphics& graphics_;
  std::map<std::string, Drawing> kept_;
};

}  // namespace artisketch
