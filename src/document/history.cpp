#include "document/history.h"

#include <atomic>

#include "base/ensure.h"

namespace artisketch {
namespace {

long next_revision() {
  static std::atomic<long> last = 0;
  return ++last;
}

}  // namespace

History::History(Document start) {
  steps_.push_back({"", std::make_shared<const Document>(std::move(start)), next_revision()});
}

void History::commit(std::string name, Document next) {
  steps_.resize(at_ + 1);
  steps_.push_back(
      {std::move(name), std::make_shared<const Document>(std::move(next)), next_revision()});
  ++at_;
}

void History::amend(Document next) {
  ensure(at_ > 0 && !can_redo(), "an edit to take back");
  steps_[at_].document = std::make_shared<const Document>(std::move(next));
  steps_[at_].revision = next_revision();
}

void History::undo() {
  ensure(can_undo(), "an edit to undo");
  --at_;
}

void History::redo() {
  ensure(can_redo(), "an edit to redo");
  ++at_;
}

}  // namespace artisketch
