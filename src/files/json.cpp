#include "files/json.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "base/words.h"

namespace artisketch {
namespace {

constexpr std::size_t kMostFaults = 100;
constexpr std::size_t kLongestQuote = 60;  // bytes
constexpr std::size_t kLineWidth = 100;

// Stands at the front of a string that takes the place of a number JSON has no words for.
constexpr char kMark = '\0';

bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

// One line that any terminal can show, at most `longest` bytes.
std::string printable(std::string_view text, std::size_t longest) {
  std::string out;
  for (const char c : text) {
    if (out.size() >= longest && !is_continuation(c)) return out + "…";
    out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  }
  return out;
}

void append_token(std::string& pointer, std::string_view field) {
  pointer += '/';
  for (const char c : field) {
    if (c == '~')
      pointer += "~0";
    else if (c == '/')
      pointer += "~1";
    else
      pointer += c;
  }
}

// Builds the tree from the parser's events: nlohmann's own builder lets a repeated field win
// silently and takes quadratic time on objects of many fields.
class Builder : public nlohmann::json_sax<Json> {
 public:
  explicit Builder(bool marked) : marked_(marked) {}

  bool null() override { return put(nullptr); }
  bool boolean(bool value) override { return put(value); }
  bool number_unsigned(number_unsigned_t value) override { return put(value); }
  bool number_float(number_float_t value, const string_t&) override { return put(value); }
  bool string(string_t& value) override {
    if (value.empty() || value[0] != kMark || !marked_) return put(std::move(value));
    put(Json(Json::value_t::discarded));
    faults.emplace_back(pointer(), "is " + value.substr(1) + "; should be a finite number");
    return true;
  }
  bool number_integer(number_integer_t value) override {
    // A signed zero can only have been "-0".
    return value == 0 ? put(-0.0) : put(value);
  }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_array() override {
    open_.pop_back();
    return true;
  }
  bool key(string_t& name) override {
    append_field(*open_.back(), std::move(name), nullptr);
    return true;
  }
  bool end_object() override {
    std::vector<std::string_view> names;
    for (const auto& [name, value] : open_.back()->get_ref<const Json::object_t&>())
      names.push_back(name);
    std::sort(names.begin(), names.end());
    open_.pop_back();
    for (std::size_t i = 1; i < names.size(); ++i) {
      if (names[i] != names[i - 1] || (i > 1 && names[i] == names[i - 2])) continue;
      std::string where = pointer();
      append_token(where, names[i]);
      faults.emplace_back(where, "stands more than once; give each field once");
    }
    return true;
  }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    error_at = position;
    error_words = error.what();
    return false;
  }

  Json root;
  std::vector<std::pair<std::string, std::string>> faults;  // pointer, words
  bool too_deep = false;
  std::size_t error_at = 0;  // the byte, counted from 1; 0: no syntax error
  std::string error_words;

 private:
  Json* place(Json value) {
    if (open_.empty()) return &(root = std::move(value));
    Json& in = *open_.back();
    if (in.is_array()) return &in.get_ref<Json::array_t&>().emplace_back(std::move(value));
    return &(in.get_ref<Json::object_t&>().back().second = std::move(value));
  }
  bool put(Json value) {
    place(std::move(value));
    return true;
  }
  bool open(Json value) {
    Json* placed = place(std::move(value));
    if (open_.size() == kDeepestJson) {
      too_deep = true;
      faults.emplace_back(pointer(), "is nested more than " + std::to_string(kDeepestJson) +
                                         " levels deep; no sketch document is");
      return false;
    }
    open_.push_back(placed);
    return true;
  }
  // Of the value read last.
  std::string pointer() const {
    std::string all;
    for (const Json* in : open_) {
      if (in->is_array())
        append_token(all, std::to_string(in->size() - 1));
      else
        append_token(all, in->get_ref<const Json::object_t&>().back().first);
    }
    return all;
  }

  const bool marked_;  // the text comes from mark_non_finite
  std::vector<Json*> open_;
};

// The text with every NaN, Infinity and overflowing number replaced by a marked string. Programs
// do write them, and a person wants to read which field it is.
std::string mark_non_finite(std::string_view text) {
  std::string out;
  const auto is_one_of = [](char c, const char* set) { return c && std::strchr(set, c); };
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    if (text[i] == '"') {
      while (end < text.size() && text[end] != '"') end += text[end] == '\\' ? 2 : 1;
      end = std::min(end + 1, text.size());
      out += text.substr(i, end - i);
    } else if (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '-') {
      while (end < text.size() &&
             (std::isalnum(static_cast<unsigned char>(text[end])) || is_one_of(text[end], "+-.")))
        ++end;
      const std::string token(text.substr(i, end - i));
      char* stop = nullptr;
      const double value = std::strtod(token.c_str(), &stop);
      if (*stop == '\0' && !std::isfinite(value))
        out += "\"\\u0000" + printable(token, kLongestQuote) + '"';
      else
        out += token;
    } else {
      out += text[i];
    }
    i = end;
  }
  return out;
}

// "line 3, column 7: what", from nlohmann's words.
void add_syntax_fault(std::string_view text, const Builder& builder, Faults& faults) {
  if (text.find_first_not_of(" \t\r\n") == text.npos)
    return faults.add("line 1, column 1", "the text is empty; should be a JSON object");
  if (text.substr(0, 2) == "\xff\xfe" || text.substr(0, 2) == "\xfe\xff")
    return faults.add("line 1, column 1", "the text is UTF-16; should be saved as UTF-8");
  std::size_t start = 0;  // of the line
  int line = 1;
  const std::size_t at = std::min(std::max<std::size_t>(builder.error_at, 1) - 1, text.size());
  for (std::size_t i = 0; i < at; ++i)
    if (text[i] == '\n') {
      ++line;
      start = i + 1;
    }
  const std::string_view before = text.substr(start, at - start);
  const auto column =
      1 + std::count_if(before.begin(), before.end(), [](char c) { return !is_continuation(c); });

  // "[json.exception.parse_error.101] parse error at line 1, column 2: WORDS; last read: 'TOKEN'"
  std::string words = builder.error_words;
  if (const std::size_t colon = words.find(": "); colon != words.npos) words.erase(0, colon + 2);
  if (const std::size_t last = words.find("; last read: '"); last != words.npos) {
    const std::size_t close = words.rfind('\'');
    words.erase(last, close - last + 1);
  }
  words = printable(words, 200);
  if (at >= text.size()) words += "; the text is cut off here: give the whole file";
  faults.add("line " + std::to_string(line) + ", column " + std::to_string(column), words);
}

bool is_numeric(const Json& value) {
  return value.is_number() ||
         (value.is_array() && std::all_of(value.begin(), value.end(), is_numeric));
}

std::string scalar_text(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Appends the value on one line; gives up, and says so, where that takes more than `most` bytes.
bool write_line(const Json& value, std::size_t most, std::string& out) {
  const std::size_t start = out.size();
  if (!value.is_structured() || value.empty()) {
    out += scalar_text(value);
  } else {
    const bool object = value.is_object();
    out += object ? "{ " : "[";
    bool first = true;
    for (const auto& item : value.items()) {
      if (!first) out += ", ";
      first = false;
      if (object) out += scalar_text(item.key()) + ": ";
      if (out.size() - start > most || !write_line(item.value(), most - (out.size() - start), out))
        return false;
    }
    out += object ? " }" : "]";
  }
  return out.size() - start <= most;
}

// `margin`: columns already taken on the line that the value starts on.
void write_laid_out(const Json& value, int level, std::size_t margin, std::string& out) {
  const std::size_t start = out.size();
  const std::size_t most = is_numeric(value) || !value.is_structured() ? std::string::npos
                           : kLineWidth > margin                       ? kLineWidth - margin
                                                                       : 0;
  if (write_line(value, most, out)) return;
  out.resize(start);
  const std::string indent(2 * (level + 1), ' ');
  out += value.is_object() ? '{' : '[';
  bool first = true;
  for (const auto& item : value.items()) {
    out += first ? "\n" : ",\n";
    first = false;
    const std::size_t line = out.size();
    out += indent;
    if (value.is_object()) out += scalar_text(item.key()) + ": ";
    write_laid_out(item.value(), level + 1, out.size() - line + 1, out);  // 1: a comma
  }
  out += '\n' + std::string(2 * level, ' ') + (value.is_object() ? '}' : ']');
}

}  // namespace

std::string JsonPath::pointer() const {
  if (!up_) return "";
  std::string all = up_->pointer();
  append_token(all, index_ < 0 ? std::string(field_) : std::to_string(index_));
  return all;
}

void Faults::add(const std::string& where, const std::string& what) {
  ++count_;
  if (lines_.size() < kMostFaults)
    lines_.push_back(file_ + ": " + (where.empty() ? "" : printable(where, 300) + ": ") +
                     printable(what, 1000));
}

Error Faults::error() const {
  Error error{Error::Kind::bad_input, lines_};
  if (count_ > lines_.size())
    error.faults.push_back(file_ + ": … and " + std::to_string(count_ - lines_.size()) + " more");
  return error;
}

std::string in_quotes(std::string_view text) {
  return "'" + printable(text, kLongestQuote) + "'";
}

std::string in_words(const Json& value) {
  if (value.is_string()) return in_quotes(value.get_ref<const std::string&>());
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array of " + counted(value.size(), "value");
  return scalar_text(value);
}

std::optional<Json> parse_json(std::string_view text, Faults& faults) {
  const auto read = [&](std::string_view from, Builder& builder) {
    const bool done = Json::sax_parse(from.begin(), from.end(), &builder);
    if (done || builder.too_deep)
      for (const auto& [where, what] : builder.faults) faults.add(where, what);
    return done;
  };
  Builder plain(false);
  if (read(text, plain)) return std::move(plain.root);
  if (plain.too_deep) return std::nullopt;
  if (const std::string marked = mark_non_finite(text); marked != text) {
    Builder again(true);
    if (read(marked, again)) return std::move(again.root);
    if (again.too_deep) return std::nullopt;
  }
  add_syntax_fault(text, plain, faults);
  return std::nullopt;
}

Json& append_field(Json& object, std::string name, Json value) {
  auto& fields = static_cast<Json::object_t::Container&>(object.get_ref<Json::object_t&>());
  return fields.emplace_back(std::move(name), std::move(value)).second;
}

Json json_number(double value) {
  constexpr double kExact = 9007199254740992.0;  // 2^53
  if (std::abs(value) < kExact && value == std::trunc(value) &&
      !(value == 0 && std::signbit(value)))
    return Json(static_cast<long long>(value));
  return Json(value);
}

std::string json_text(const Json& value) {
  std::string out;
  write_laid_out(value, 0, 0, out);
  return out + '\n';
}

}  // namespace artisketch
