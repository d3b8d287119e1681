// Paths are not carried along while reading: the one error there can be is found again by the
// address of its value.
// Tested by tests/unit/io/input/drawings/read_json_test.cpp.
#include "io/text/json/json_reader.hpp"

#include <fmt/core.h>

#include <iterator>
#include <utility>
#include <vector>

#include <cover/text.hpp>

namespace cover {
namespace {

/// The path of `wanted` in `document`, as `regions[2].material`. Documents may be nested as deep as
/// they are long, so the walk keeps its own stack.
std::string path_of(const Json& document, const Json& wanted) {
  struct Frame {
    const Json* value;
    Json::const_iterator next;
    std::size_t index = 0;
  };
  std::vector<Frame> stack{{&document, document.cbegin()}};
  while (!stack.empty() && stack.back().value != &wanted) {
    Frame& top = stack.back();
    if (!top.value->is_structured() || top.next == top.value->cend()) {
      stack.pop_back();
      if (!stack.empty()) {
        ++stack.back().next;
        ++stack.back().index;
      }
      continue;
    }
    const Json& child = *top.next;
    stack.push_back({&child, child.cbegin()});
  }
  std::string path;
  for (std::size_t k = 0; k + 1 < stack.size(); ++k) {
    const Frame& frame = stack[k];
    if (frame.value->is_array())
      path += fmt::format("[{}]", frame.index);
    else
      path += (path.empty() ? "" : ".") + frame.next.key();
  }
  return path;
}

/// The value as it stands in the file, cut short.
std::string shown(const Json& value) {
  if (value.is_structured()) return value.is_array() ? "an array" : "an object";
  std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  return text.size() <= 40 ? text : text.substr(0, 37) + "...";
}

/// Fills a document. Unlike the library's own, this one leaves nothing in hands that ask for memory
/// when they give it back: see take_apart().
class DocumentFiller : public nlohmann::json_sax<Json> {
 public:
  explicit DocumentFiller(Json& root) : root_(root) {}

  bool null() override { return put(nullptr); }
  bool boolean(bool value) override { return put(value); }
  bool number_integer(number_integer_t value) override { return put(value); }
  bool number_unsigned(number_unsigned_t value) override { return put(value); }
  bool number_float(number_float_t value, const string_t&) override { return put(value); }
  bool string(string_t& value) override { return put(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // there is none in text
  bool start_object(std::size_t) override { return open(Json::value_t::object); }
  bool start_array(std::size_t) override { return open(Json::value_t::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& key) override {
    Json& object = *open_.back();
    if (object.contains(key) && repeated_.empty()) repeated_ = key;
    member_ = &object[key];
    take_apart(*member_);
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const Json::exception& error) override {
    what_ = error.what();
    return false;
  }

  /// The first key that was given twice; empty if there is none.
  [[nodiscard]] const std::string& repeated() const { return repeated_; }
  /// What was wrong.
  [[nodiscard]] const std::string& what() const { return what_; }

 private:
  template <class Value>
  Json* add(Value&& value) {
    if (open_.empty()) return &(root_ = Json(std::forward<Value>(value)));
    if (member_ != nullptr)
      return &(*std::exchange(member_, nullptr) = Json(std::forward<Value>(value)));
    return &open_.back()->get_ref<Json::array_t&>().emplace_back(std::forward<Value>(value));
  }
  template <class Value>
  bool put(Value&& value) {
    add(std::forward<Value>(value));
    return true;
  }
  bool open(Json::value_t type) {
    open_.push_back(add(type));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  Json& root_;
  std::vector<Json*> open_;  ///< arrays and objects, from the outermost on
  Json* member_ = nullptr;   ///< of the innermost object: what its last key is for
  std::string repeated_;
  std::string what_;
};

bool has_children(const Json& value) { return value.is_structured() && !value.empty(); }

/// REQUIRES: has_children(value)
Json& last_child(Json& value) {
  if (value.is_array()) return value.get_ref<Json::array_t&>().back();
  return value.get_ref<Json::object_t&>().rbegin()->second;
}

void drop_last_child(Json& value) {
  if (value.is_array()) return value.get_ref<Json::array_t&>().pop_back();
  auto& object = value.get_ref<Json::object_t&>();
  object.erase(std::prev(object.end()));
}

}  // namespace

// Moved and erased in place, values throw nothing.
void take_apart(Json& value) noexcept {  // NOLINT(bugprone-exception-escape)
  // On the way down a parent waits in the place that its last child had in its last child.
  Json here = std::move(value), parent;
  bool has_parent = false;
  for (;;) {
    if (has_children(here)) {
      Json child = std::move(last_child(here));
      if (!has_children(child)) {
        drop_last_child(here);
        continue;
      }
      last_child(here) = has_parent ? std::move(parent) : Json();
      parent = std::move(here);
      has_parent = true;
      here = std::move(child);
      continue;
    }
    if (!has_parent) return;
    here = std::move(parent);
    parent = std::move(last_child(here));
    has_parent = has_children(parent);
    drop_last_child(here);
  }
}

namespace {

/// What helps against what the library tells, for the end of a message.
std::string_view advice_for(std::string_view what) {
  if (what.find("ill-formed UTF-8") != std::string_view::npos)
    return "; JSON is in UTF-8: 'iconv -f LATIN1 -t UTF-8 FILE' writes it so, if it is in Latin-1";
  if (what.find("unexpected '{'; expected end of input") != std::string_view::npos)
    return "; one document is read, not one in each line: 'jq -s' puts them in a list, and of "
           "GeoJSON 'ogr2ogr OUT.geojson GeoJSONSeq:FILE' makes one";
  return "";
}

}  // namespace

Result<JsonDocument> parse_json_text(std::string_view text, const std::string& source) {
  JsonDocument document;
  DocumentFiller filler(document.root());
  if (!Json::sax_parse(text.begin(), text.end(), &filler)) {
    // The library's message reads "[json.exception...] parse error at line 3, column 7: ...".
    std::string_view what = filler.what();
    if (const auto end = what.find("] "); end != std::string_view::npos)
      what.remove_prefix(end + 2);
    return Error{
        ErrorCode::syntax, fmt::format("{}: {}{}", source, what, advice_for(what)), {}, {}};
  }
  if (!filler.repeated().empty())
    return Error{
        ErrorCode::syntax,
        fmt::format("{}: the key \"{}\" is given twice in one object", source, filler.repeated()),
        {},
        {}};
  return document;
}

void JsonReader::fail(const Json& at, const std::string& what, ErrorCode code) {
  if (error_) return;
  const std::string path = path_of(document_, at);
  error_ =
      Error{code, fmt::format("{}: {}{}", source_, path.empty() ? "" : path + ": ", what), {}, {}};
}

bool JsonReader::expect_keys(const Json& object, const std::vector<std::string_view>& keys,
                             const std::vector<std::string_view>& free) {
  if (!object.is_object()) {
    fail(object, "expected an object, found " + shown(object));
    return false;
  }
  for (const auto& [key, value] : object.items()) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) {
      if (!value.is_null() || std::find(free.begin(), free.end(), key) != free.end()) continue;
      fail(value, "null says nothing here: give a value, or leave the key out if it is not needed");
      return false;
    }
    const std::vector<std::string> known(keys.begin(), keys.end());
    const std::optional<std::string> meant = closest(key, known);
    fail(value, "unknown key (" + (meant ? "did you mean \"" + *meant + "\"?)"
                                         : "known are \"" + listed(known, "\", \"") + "\")"));
    return false;
  }
  return true;
}

const Json* JsonReader::member(const Json& object, std::string_view key) {
  if (!object.is_object()) return nullptr;
  const auto at = object.find(key);
  return at == object.end() || at->is_null() ? nullptr : &*at;
}

const Json& JsonReader::required(const Json& object, std::string_view key) {
  static const Json nothing;
  if (const Json* value = member(object, key)) return *value;
  fail(object, fmt::format("the key \"{}\" is missing", key));
  return nothing;
}

const Json& JsonReader::array(const Json& value, std::string_view of_what) {
  static const Json none = Json::array();
  if (value.is_array()) return value;
  fail(value, fmt::format("expected an array of {}, found {}", of_what, shown(value)));
  return none;
}

double JsonReader::number(const Json& value) {
  if (value.is_number()) return value.get<double>();
  fail(value, "expected a number, found " + shown(value));
  return 0;
}

double JsonReader::positive(const Json& value) {
  const double d = number(value);
  if (d > 0) return d;
  fail(value, "expected a number above zero, found " + shown(value));
  return 1;
}

long JsonReader::integer(const Json& value) {
  if (value.is_number_integer() && !(value.is_number_unsigned() && value > INT64_MAX))
    return value.get<long>();
  fail(value, "expected an integer, found " + shown(value));
  return 0;
}

bool JsonReader::boolean(const Json& value) {
  if (value.is_boolean()) return value.get<bool>();
  fail(value, "expected true or false, found " + shown(value));
  return false;
}

std::string JsonReader::text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  fail(value, "expected a string, found " + shown(value));
  return {};
}

std::string JsonReader::name(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_integer()) return value.dump();
  fail(value, "expected a name or an integer, found " + shown(value));
  return {};
}

Point JsonReader::point(const Json& value, bool more_allowed) {
  if (value.is_array() && (value.size() == 2 || (more_allowed && value.size() > 2)))
    return {number(value[0]), number(value[1])};
  fail(value, value.is_array() ? "expected a point [x, y], found " + counted(value.size(), "number")
                               : "expected a point [x, y], found " + shown(value));
  return {};
}

}  // namespace cover
