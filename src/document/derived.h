// What is computed from a document and kept until the document is another one.
#pragma once

#include <memory>
#include <tuple>
#include <utility>

#include "document/document.h"

namespace artisketch {

// A value made of one state of a document, and of `Also`: whatever else it depends on, comparable
// with ==. It holds on to that very state: neither an edit, nor undo, nor another document that
// happens to look alike or to stand at the same count of edits is taken for it.
template <class T, class... Also>
class Derived {
 public:
  // The value for `document`, made by make() where it is not there yet.
  template <class Make>
  const T& of(const std::shared_ptr<const Document>& document, const Also&... also, Make&& make) {
    if (made_of_ != document || std::tie(also...) != also_) {
      value_ = make();
      made_of_ = document;
      also_ = std::tie(also...);
    }
    return value_;
  }

  // Makes it anew the next time: something changed that is not in its key.
  void forget() { made_of_.reset(); }

 private:
  std::shared_ptr<const Document> made_of_;  // null: nothing was made
  std::tuple<Also...> also_;
  T value_{};
};

}  // namespace artisketch
