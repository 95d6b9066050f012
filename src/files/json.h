// JSON as this program reads and writes it: strict, every fault with its place, a layout that reads
// well and diffs line by line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/result.h"

namespace artisketch {

// Fields keep their order.
using Json = nlohmann::ordered_json;

// Where a value stands in its text: a chain of fields and indices that lives on the stack, so that
// it costs nothing until a fault needs the words. A link must outlive what is chained to it.
class JsonPath {
 public:
  JsonPath() = default;
  JsonPath operator/(std::string_view field) const& { return {this, field, -1}; }
  JsonPath operator/(std::size_t index) const& { return {this, {}, long(index)}; }
  JsonPath operator/(std::string_view field) const&& = delete;
  JsonPath operator/(std::size_t index) const&& = delete;
  std::string pointer() const;  // RFC 6901

 private:
  JsonPath(const JsonPath* up, std::string_view field, long index)
      : up_(up), field_(field), index_(index) {}
  const JsonPath* up_ = nullptr;
  std::string_view field_;
  long index_ = -1;  // −1: a field
};

// The faults of one file, a line each. Keeps the first hundred and counts the rest.
class Faults {
 public:
  explicit Faults(std::string file) : file_(std::move(file)) {}
  void add(const JsonPath& where, const std::string& what) { add(where.pointer(), what); }
  void add(const std::string& where, const std::string& what);  // "FILE: where: what"
  bool none() const { return count_ == 0; }
  Error error() const;  // of Kind::bad_input, with "… and N more" at the end where lines were left

 private:
  std::string file_;
  std::vector<std::string> lines_;
  std::size_t count_ = 0;
};

// Text between single quotes for a fault: one line, short, no control characters.
std::string in_quotes(std::string_view text);

// What stands there, in words: "null", "-3", "'abc'", "an array of 3 values", "an object".
std::string in_words(const Json& value);

// Reads RFC 8259 JSON (a byte order mark is skipped). Nothing, and faults with line and column,
// where the text is no JSON. Repeated fields, NaN, Infinity and numbers too large for a double are
// faults with a JSON pointer; the rest is still read, and in place of such a number stands a
// discarded value (is_discarded()). Values may nest kDeepestJson deep. "-0" is read as −0.0.
inline constexpr int kDeepestJson = 64;
std::optional<Json> parse_json(std::string_view text, Faults& faults);

// Appends a field that the object is known not to have: operator[] looks through all of them first,
// which takes quadratic time on objects of many fields.
Json& append_field(Json& object, std::string name, Json value);

// A whole number without a fraction, anything else so that reading gives the same double.
Json json_number(double value);

// Laid out with two spaces a level: what fits stands on one line of at most 100 columns, arrays of
// numbers (and of such arrays) always do. Ends with a newline.
std::string json_text(const Json& value);

}  // namespace artisketch
