// A value, or an error that a person can act on. Expected failures travel as a Result; a
// programmer's errors are asserts.
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace artisketch {

struct Error {
  enum class Kind {
    bad_input,      // the user's input is at fault
    io,             // a file could not be read or written
    cancelled,      // the user asked to stop
    out_of_memory,  // a smaller task may succeed
    crashed,        // the program is at fault
  };
  Kind kind = Kind::bad_input;
  std::vector<std::string> faults;  // one line each: what is wrong, where, what would be right

  std::string text() const {
    std::string all;
    for (const std::string& fault : faults) all += (all.empty() ? "" : "\n") + fault;
    return all;
  }
};

inline Error bad_input(std::string fault) {
  return {Error::Kind::bad_input, {std::move(fault)}};
}
inline Error io_error(std::string fault) {
  return {Error::Kind::io, {std::move(fault)}};
}
inline Error cancelled() {
  return {Error::Kind::cancelled, {"stopped"}};
}

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}
  Result(Error error) : state_(std::move(error)) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  T& value() & {
    assert(ok());
    return std::get<0>(state_);
  }
  const T& value() const& {
    assert(ok());
    return std::get<0>(state_);
  }
  T&& value() && {
    assert(ok());
    return std::get<0>(std::move(state_));
  }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const Error& error() const {
    assert(!ok());
    return std::get<1>(state_);
  }

 private:
  std::variant<T, Error> state_;
};

struct Done {};  // the value of a Result that has none

}  // namespace artisketch
