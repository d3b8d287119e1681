#include "options.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cover/files.hpp>
#include <cover/option_table.hpp>
#include <cover/text.hpp>

#include "arrays.hpp"
#include "raise.hpp"

namespace py = pybind11;

namespace cover::python {
namespace {

[[noreturn]] void refuse_option(std::string message) {
  raise(Error{ErrorCode::bad_option, std::move(message), {}, {}});
}

/// The options of some tables as keywords.
template <class... Tables>
std::vector<std::string> keywords_of(const Tables&... tables) {
  std::vector<std::string> keywords;
  const auto add = [&](std::string_view name) {
    keywords.emplace_back(name);
    std::replace(keywords.back().begin(), keywords.back().end(), '-', '_');
  };
  const auto add_all = [&](const auto& table) {
    for (const auto& entry : table) add(entry.name);
  };
  (add_all(tables), ...);
  return keywords;
}

/// How a picture is drawn.
constexpr std::array kPictureKeywords{"title", "width", "color"};

std::vector<std::string> with_picture_keywords(std::vector<std::string> keywords) {
  keywords.insert(keywords.end(), kPictureKeywords.begin(), kPictureKeywords.end());
  return keywords;
}

[[noreturn]] void refuse_keyword(const std::string& key, const std::vector<std::string>& known) {
  refuse_option("unexpected option '" + key + "'" + did_you_mean(key, known));
}

/// numpy's numbers and arrays as Python's numbers and lists; all else as it is.
py::object plain(const py::handle& value) {
  refuse_masked(value, "an option");
  const bool is_numpy = py::hasattr(value, "dtype") && py::hasattr(value, "tolist");
  return is_numpy ? py::object(value.attr("tolist")()) : py::reinterpret_borrow<py::object>(value);
}

bool is_bytes(const py::handle& value) {
  return PyBytes_Check(value.ptr()) != 0 || PyByteArray_Check(value.ptr()) != 0 ||
         PyMemoryView_Check(value.ptr()) != 0;
}

/// As `cover render` takes it.
int width_of(const py::handle& value) {
  constexpr int kLeast = 200, kMost = 20000;
  const py::object given = plain(value);
  if (py::isinstance<py::bool_>(given) || PyIndex_Check(given.ptr()) == 0)
    refuse_option("width: " + shown(value) + " is not a whole number");
  int overflow = 0;
  const long width = PyLong_AsLongAndOverflow(py::int_(given).ptr(), &overflow);
  if (overflow != 0 || width < kLeast || width > kMost)
    refuse_option("width: " + shown(value) + " is not in 200..20000");
  return static_cast<int>(width);
}

/// What is expected, for whoever gave something of another type.
template <class Target>
std::string expected(const OptionOf<Target>& entry) {
  switch (entry.kind) {
    case OptionKind::flag:
      return "True or False";
    case OptionKind::word:
    case OptionKind::words: {
      std::string text = entry.kind == OptionKind::word ? "one of" : "some of";
      for (const std::string_view word : entry.words()) text += " " + std::string(word);
      return text;
    }
    case OptionKind::whole:
      return "a whole number";
    case OptionKind::number:
      return "a number";
    case OptionKind::angle:
      return "a number of degrees";
    case OptionKind::text:
      break;
  }
  return "text or a number: " + std::string(entry.help);
}

/// A keyword argument as texts for the table.
template <class Target>
class Value {
 public:
  Value(std::string key, const OptionOf<Target>& entry) : key_(std::move(key)), entry_(entry) {}

  std::vector<std::string> texts(const py::handle& given) const {
    const py::object value = plain(given);
    if (value.is_none()) return {};
    if (is_bytes(value)) refuse_type(value);  // Python iterates over them as numbers
    if (py::isinstance<py::dict>(value) || py::hasattr(value, "items")) return sizes(value);
    const bool is_text = py::isinstance<py::str>(value) || py::hasattr(value, "__fspath__");
    if (entry_.name == "window" && !is_text && py::isinstance<py::iterable>(value))
      return {joined(value)};
    if (entry_.repeats && !is_text && py::isinstance<py::iterable>(value)) {
      std::vector<std::string> all;
      for (const py::handle& item : value)
        all.push_back(is_pair_of_sides(item) ? pair_of_sides(item) : text(item));
      return all;
    }
    return split(text(value));
  }

  [[noreturn]] void refuse(Error error) const {
    error.message = key_ + ": " + error.message;
    raise(error);
  }

 private:
  [[noreturn]] void refuse_type(const py::handle& value) const {
    if (PyCallable_Check(value.ptr()) != 0 && key_.starts_with("size"))
      refuse_option(key_ + ": a function of x and y is given as size_field");
    refuse_option(key_ + ": " + shown(value) + " is not " + expected(entry_));
  }

  /// "bound,max-angle" as on the command line.
  [[nodiscard]] std::vector<std::string> split(std::string text) const {
    std::vector<std::string> parts;
    std::size_t comma = text.find(',');
    while (entry_.kind == OptionKind::words && comma != std::string::npos) {
      parts.push_back(text.substr(0, comma));
      text.erase(0, comma + 1);
      comma = text.find(',');
    }
    parts.push_back(std::move(text));
    return parts;
  }

  /// ("left", "right"), as JSON has it, of periodic sides.
  [[nodiscard]] bool is_pair_of_sides(const py::handle& item) const {
    return entry_.name == "periodic" &&
           (py::isinstance<py::tuple>(item) || py::isinstance<py::list>(item)) &&
           py::len(item) == 2;
  }

  [[nodiscard]] std::string pair_of_sides(const py::handle& item) const {
    PeriodicRule rule;
    rule.from = text(item[py::int_(0)]);
    rule.to = text(item[py::int_(1)]);
    Options options;
    options.periodic = {std::move(rule)};
    return find_option("periodic")->get(*find_option("periodic"), options).front();
  }

  /// (0, 0, 2, 1) as "0,0,2,1".
  [[nodiscard]] std::string joined(const py::handle& values) const {
    std::string all;
    for (const py::handle& item : values) all += (all.empty() ? "" : ",") + text(item);
    return all;
  }

  /// Lengths by the name of what has them; the empty name is everywhere.
  [[nodiscard]] std::vector<std::string> sizes(const py::handle& value) const {
    if (!entry_.repeats || entry_.kind != OptionKind::text) refuse_type(value);
    std::vector<std::string> all;
    for (const py::handle& item : value.attr("items")()) {
      const auto pair = py::reinterpret_borrow<py::tuple>(item);
      const std::string name = bytes_of(py::str(pair[0]));
      all.push_back((name.empty() ? "" : key_of(name) + "=") + text(pair[1]));
    }
    return all;
  }

  /// Of layers, a name with an equals sign in quotation marks, which tell it from the values;
  /// LINE@REGION stays what it is.
  [[nodiscard]] std::string key_of(const std::string& name) const {
    if (entry_.name != "layers" || name.find('=') == std::string::npos ||
        name.find('"') != std::string::npos)
      return name;
    const std::size_t at = name.find('@');
    const std::string line = '"' + name.substr(0, at) + '"';
    return at == std::string::npos ? line : line + "@\"" + name.substr(at + 1) + '"';
  }

  [[nodiscard]] std::string text(const py::handle& given) const {
    const py::object value = plain(given);
    const bool is_list = py::isinstance<py::tuple>(value) || py::isinstance<py::list>(value);
    if (entry_.kind == OptionKind::text && is_list) {
      std::string all;  // several numbers
      for (const py::handle& part : value) {
        std::string one = text(part);
        // An array has one kind of number: of counts, too, 2 is 2.0.
        if (PyFloat_Check(part.ptr()) != 0 && one.ends_with(".0")) one.erase(one.size() - 2);
        all += (all.empty() ? "" : ",") + one;
      }
      return all;
    }
    const bool is_bool = py::isinstance<py::bool_>(value);
    if (entry_.kind == OptionKind::flag) {
      if (!is_bool) refuse_type(value);
      return value.ptr() == Py_True ? "true" : "false";
    }
    if (is_bool) {
      if (entry_.alone.empty()) refuse_type(value);
      return std::string(entry_.alone);
    }
    if (py::isinstance<py::str>(value)) return bytes_of(value);
    if (py::hasattr(value, "__fspath__"))
      return py::module_::import("os").attr("fsencode")(value).cast<std::string>();
    if (PyIndex_Check(value.ptr()) != 0) return py::str(py::int_(value));
    if (PyNumber_Check(value.ptr()) == 0 || PyComplex_Check(value.ptr()) != 0) refuse_type(value);
    return py::repr(py::float_(value));
  }

  std::string key_;
  const OptionOf<Target>& entry_;
};

/// The option that a keyword names, and whether the keyword says the opposite of it.
template <class Target>
struct Named {
  const OptionOf<Target>* entry = nullptr;
  bool opposite = false;

  /// In the table that `find` looks into. `lines=False` is `no_lines=True` where there is that one.
  static Named in(const OptionOf<Target>* (*find)(std::string_view), const std::string& key) {
    if (key.find('-') != std::string::npos) return {};
    if (const OptionOf<Target>* entry = find(key)) return {entry};
    const OptionOf<Target>* entry = find("no_" + key);
    return {entry, entry != nullptr};
  }

  /// The values that it is given.
  [[nodiscard]] std::vector<std::string> texts(const Value<Target>& argument,
                                               const py::handle& value) const {
    std::vector<std::string> all = argument.texts(value);
    if (opposite)
      for (std::string& text : all) text = text == "true" ? "false" : "true";
    return all;
  }
};

/// Sets what a keyword names in a table without rules between its options; false if it is not
/// there.
template <class Target>
bool set_in(const OptionOf<Target>* (*find)(std::string_view), const std::string& key,
            const py::handle& value, Given<Target>& given) {
  const auto named = Named<Target>::in(find, key);
  if (named.entry == nullptr) return false;
  const Value<Target> argument(key, *named.entry);
  for (const std::string& text : named.texts(argument, value)) {
    if (const Status status = named.entry->set(*named.entry, text, given.options); !status)
      argument.refuse(status.error());
    if (text != "false") given.entries.push_back(named.entry);
  }
  return true;
}

/// What is said of an option that was given and has no effect.
template <class Target>
std::string does_nothing(const OptionOf<Target>& entry) {
  return "the option " + std::string(entry.name) + " does nothing: it counts with " +
         std::string(entry.counts_with) + " only";
}

Named<Options> find_keyword(const std::string& key) {
  if (key == "sizes" || key == "sizes_at")
    return {find_option(key == "sizes" ? "size" : "size-at")};
  return Named<Options>::in(find_option, key);
}

}  // namespace

std::string shown(const py::handle& value) {
  constexpr std::size_t kMost = 60;
  std::string text = py::repr(value);
  if (text.size() <= kMost) return text;
  std::size_t size = kMost;
  while ((static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U) --size;  // whole letters
  return text.substr(0, size) + "...";
}

Keywords options_from(const py::dict& keywords, Options before) {
  OptionReader reader(std::move(before));
  for (const auto& [name, value] : keywords) {
    const std::string key = py::str(name);
    const Named<Options> named = find_keyword(key);
    if (named.entry == nullptr && Named<ReadOptions>::in(find_read_option, key).entry != nullptr)
      refuse_option("unexpected option '" + key + "': it counts where files are read");
    if (named.entry == nullptr && Named<WriteOptions>::in(find_write_option, key).entry != nullptr)
      refuse_option("unexpected option '" + key + "': it is an option of save()");
    if (named.entry == nullptr)
      refuse_keyword(key, keywords_of(option_table(), read_option_table()));
    const Value<Options> argument(key, *named.entry);
    if (value.ptr() == Py_False && !named.entry->alone.empty()) continue;
    for (const std::string& text : named.texts(argument, value)) {
      if (Status status = reader.set(*named.entry, text); !status) argument.refuse(status.error());
    }
  }
  Result<Options> options = reader.result();
  if (!options) raise(options.error());
  Keywords out{*std::move(options), {}};
  for (const OptionEntry* entry : reader.idle()) out.idle.push_back(does_nothing(*entry));
  return out;
}

Given<ReadOptions> take_read_options(py::dict& keywords) {
  Given<ReadOptions> given;
  py::dict rest;
  for (const auto& [name, value] : keywords) {
    const std::string key = py::str(name);
    if (!set_in(find_read_option, key, value, given)) rest[name] = value;
  }
  keywords = rest;
  return given;
}

Given<WriteOptions> write_options_from(const py::dict& keywords) {
  Given<WriteOptions> given;
  for (const auto& [name, value] : keywords) {
    const std::string key = py::str(name);
    if (!set_in(find_write_option, key, value, given))
      refuse_keyword(key, with_picture_keywords(keywords_of(write_option_table())));
  }
  return given;
}

PictureKeywords take_picture_options(py::dict& keywords) {
  PictureKeywords picture;
  for (const std::string key : kPictureKeywords) {
    if (!keywords.contains(key)) continue;
    const py::object value = keywords[py::str(key)];
    keywords.attr("pop")(key);
    if (value.is_none()) continue;
    picture.given.push_back(key);
    if (key == "width") {
      picture.options.width = width_of(value);
    } else if (py::isinstance<py::str>(value)) {
      (key == "title" ? picture.options.title : picture.options.color) = bytes_of(value);
    } else {
      refuse_option(key + ": " + shown(value) + " is not text");
    }
  }
  return picture;
}

std::vector<std::string> idle_picture_options(const PictureKeywords& picture,
                                              const std::string& extension) {
  std::vector<std::string> sentences;
  for (const std::string& key : picture.given)
    if (extension != ".svg" && extension != ".png")
      sentences.push_back("the option " + key + " does nothing: it counts with pictures only");
  return sentences;
}

std::vector<std::string> idle_read_options(const std::vector<const ReadOptionEntry*>& given,
                                           ReadOptions options,
                                           const std::vector<std::string>& paths) {
  const std::string format = options.format;
  std::vector<std::string> sentences;
  for (const ReadOptionEntry* entry : given) {
    const auto counts = [&](const std::string& path) {
      options.format = format.empty() ? extension_of(path) : format;
      return entry->counts == nullptr || entry->counts(options);
    };
    if (std::none_of(paths.begin(), paths.end(), counts)) sentences.push_back(does_nothing(*entry));
  }
  return sentences;
}

std::vector<std::string> idle_write_options(const std::vector<const WriteOptionEntry*>& given,
                                            const std::string& extension) {
  std::vector<std::string> sentences;
  for (const WriteOptionEntry* entry : given) {
    if (!counts_with(*entry, extension)) sentences.push_back(does_nothing(*entry));
  }
  return sentences;
}

}  // namespace cover::python
