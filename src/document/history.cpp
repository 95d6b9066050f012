#include "document/history.h"

#include <cassert>

namespace artisketch {

History::History(Document start) {
  steps_.push_back({"", std::make_shared<const Document>(std::move(start)), 0});
}

void History::commit(std::string name, Document next) {
  steps_.resize(at_ + 1);
  steps_.push_back(
      {std::move(name), std::make_shared<const Document>(std::move(next)), ++last_revision_});
  ++at_;
}

void History::amend(Document next) {
  assert(at_ > 0 && !can_redo());
  steps_[at_].document = std::make_shared<const Document>(std::move(next));
  steps_[at_].revision = ++last_revision_;
}

void History::undo() {
  assert(can_undo());
  --at_;
}

void History::redo() {
  assert(can_redo());
  ++at_;
}

}  // namespace artisketch
