#include "files/json_reader.h"

#include <algorithm>
#include <cmath>

namespace artisketch {

Fields::Fields(const Json& object, const JsonPath& path, Faults& faults)
    : object_(object), path_(path), faults_(faults) {
  JsonReader reader(faults);
  if (!object.is_object()) reader.wrong(path, object, "an object");
}

const Json* Fields::find(const char* name) {
  known_.push_back(name);
  if (!object_.is_object()) return nullptr;
  const auto found = object_.find(name);
  return found == object_.end() ? nullptr : &*found;
}

const Json* Fields::need(const char* name, const std::string& right) {
  const Json* found = find(name);
  if (!found && object_.is_object()) faults_.add(path_ / name, "is missing; should be " + right);
  return found;
}

std::string Fields::unknown() const {
  if (!object_.is_object()) return "";
  Json rest = Json::object();
  for (const auto& [name, value] : object_.get_ref<const Json::object_t&>())
    if (std::find(known_.begin(), known_.end(), name) == known_.end())
      append_field(rest, name, value);
  return rest.empty() ? "" : rest.dump();
}

bool JsonReader::number(const Json& value, const JsonPath& at, const Range& range, double& out) {
  if (!value.is_number()) return wrong(at, value, range.words);
  const double x = value.get<double>();
  if (x < range.low || x > range.high || (range.above_low && x == range.low))
    return wrong(at, value, range.words);
  out = x;
  return true;
}

bool JsonReader::whole(const Json& value, const JsonPath& at, const Range& range, int& out) {
  double x = 0;
  if (value.is_number() && value.get<double>() != std::trunc(value.get<double>()))
    return wrong(at, value, range.words);
  if (!number(value, at, range, x)) return false;
  out = int(x);
  return true;
}

bool JsonReader::boolean(const Json& value, const JsonPath& at, bool& out) {
  if (!value.is_boolean()) return wrong(at, value, "true or false");
  out = value.get<bool>();
  return true;
}

bool JsonReader::text(const Json& value, const JsonPath& at, std::string& out, bool may_be_empty) {
  if (!value.is_string() || (!may_be_empty && value.get_ref<const std::string&>().empty()))
    return wrong(at, value, may_be_empty ? "a text" : "a text that is not empty");
  out = value.get<std::string>();
  return true;
}

bool JsonReader::is_list(const Json* value, const JsonPath& at, std::size_t most) {
  if (!value) return false;
  if (!value->is_array()) return wrong(at, *value, "an array");
  return value->size() <= most || wrong(at, *value, "one of at most " + std::to_string(most));
}

bool JsonReader::wrong(const JsonPath& at, const Json& value, const std::string& right) {
  if (!value.is_discarded()) faults_.add(at, "is " + in_words(value) + "; should be " + right);
  return false;
}

}  // namespace artisketch
