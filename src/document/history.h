// Unlimited undo and redo: named snapshots of the document, and of nothing else.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "document/document.h"

namespace artisketch {

class History {
 public:
  explicit History(Document start = {});

  const Document& now() const { return *steps_[at_].document; }
  // The present state itself, for what is derived from it (derived.h).
  const std::shared_ptr<const Document>& state() const { return steps_[at_].document; }
  // The next state; what had been undone is gone. name: what undo will be called, "Draw Hand R".
  void commit(std::string name, Document next);
  // Puts a new state in place of the present one, under its name: the next piece of one gesture.
  void amend(Document next);

  bool can_undo() const { return at_ > 0; }
  bool can_redo() const { return at_ + 1 < steps_.size(); }
  const std::string& undo_name() const { return steps_[at_].name; }
  const std::string& redo_name() const { return steps_[at_ + 1].name; }
  void undo();  // needs can_undo()
  void redo();  // needs can_redo()

  // Names the present state: equal again when undo and redo lead back to it, and otherwise never
  // used twice, by no other history either.
  long revision() const { return steps_[at_].revision; }

 private:
  struct Step {
    std::string name;
    std::shared_ptr<const Document> document;
    long revision = 0;
  };
  std::vector<Step> steps_;
  std::size_t at_ = 0;
};

}  // namespace artisketch
