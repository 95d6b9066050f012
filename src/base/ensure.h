// What must hold for memory to be safe, and for a result to mean anything: asked in every build.
#pragma once

#include <stdexcept>

namespace artisketch {

// The program is at fault, not what it was given. Jobs and the command line catch it and end the
// run with one error (Error::Kind::crashed).
class ProgramError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

namespace detail {
[[noreturn]] inline void broken(const char* promise) {
  throw ProgramError(promise);
}
}  // namespace detail

// `promise`: what holds, in words: "a key of the clip". For conditions whose breach would read or
// write where nothing is; a plain assert is for what would only look odd.
inline void ensure(bool holds, const char* promise) {
  if (!holds) [[unlikely]]
    detail::broken(promise);
}

}  // namespace artisketch
