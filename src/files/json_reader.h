// From JSON values to the program's own: each is checked, and one that is wrong becomes a fault
// that says what would be right.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "files/json.h"

namespace artisketch {

// The numbers from `low` to `high` that a field allows.
struct Range {
  double low, high;
  const char* words;       // "a number of degrees from 0 to 180"
  bool above_low = false;  // low itself is outside
};

// One object's fields: those that were asked for are known, the rest is kept. A fault where the
// value is no object; it then has no fields.
class Fields {
 public:
  Fields(const Json& object, const JsonPath& path, Faults& faults);  // all must outlive this
  const Json* find(const char* name);
  // A fault where there is none; `right` says what it should be.
  const Json* need(const char* name, const std::string& right);
  // The fields that nobody asked for, as the text of a JSON object; empty where there are none.
  std::string unknown() const;

 private:
  const Json& object_;
  const JsonPath& path_;
  Faults& faults_;
  std::vector<std::string_view> known_;
};

// Each function reads one value into `out` and is true, or reports a fault and leaves `out` alone.
class JsonReader {
 public:
  explicit JsonReader(Faults& faults) : faults_(faults) {}
  bool number(const Json& value, const JsonPath& at, const Range& range, double& out);
  bool whole(const Json& value, const JsonPath& at, const Range& range, int& out);
  bool boolean(const Json& value, const JsonPath& at, bool& out);
  bool text(const Json& value, const JsonPath& at, std::string& out, bool may_be_empty = false);
  // As many numbers as `out` has; `right` says which.
  template <class Vector>
  bool numbers(const Json& value, const JsonPath& at, const char* right, const Range& range,
               Vector& out) {
    if (!value.is_array() || value.size() != std::size_t(out.size()))
      return wrong(at, value, right);
    Vector read;
    bool good = true;
    for (std::size_t i = 0; i < value.size(); ++i)
      good &= number(value[i], at / i, range, read[int(i)]);
    if (good) out = read;
    return good;
  }
  // Whether there is a value, and it is an array of at most `most`.
  bool is_list(const Json* value, const JsonPath& at, std::size_t most);
  // Reports the value as wrong, unless that was done when the text was read. Always false.
  bool wrong(const JsonPath& at, const Json& value, const std::string& right);

 protected:
  Faults& faults_;
};

}  // namespace artisketch
