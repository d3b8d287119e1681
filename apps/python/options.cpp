#include "options.hpp"

#include <map>
#include <string>

#include <pybind11/stl.h>

namespace py = pybind11;

namespace cover::python {
namespace {

template <class Enum>
Enum word(const std::string& key, const py::handle& value,
          const std::map<std::string, Enum>& words) {
  const auto at = words.find(value.cast<std::string>());
  if (at != words.end()) return at->second;
  std::string known;
  for (const auto& [name, ignored] : words) known += (known.empty() ? "" : ", ") + name;
  throw py::value_error(key + " must be one of " + known);
}

void add_sizes(Options& options, const py::handle& value, bool at) {
  for (const auto& [name, size] : value.cast<std::map<std::string, double>>())
    options.sizes.push_back({name, size, at});
}

/// `None` or False: no; True: 90 degrees; or degrees.
std::optional<Angle> split_angle(const py::handle& value) {
  if (value.is_none() || value.ptr() == Py_False) return std::nullopt;
  return Angle::degrees(value.ptr() == Py_True ? 90 : value.cast<double>());
}

/// `None` or "auto", "off" or 0, or a number.
std::optional<double> weld(const py::handle& value) {
  if (value.is_none()) return std::nullopt;
  if (!py::isinstance<py::str>(value)) return value.cast<double>();
  const auto text = value.cast<std::string>();
  if (text == "off") return 0;
  if (text == "auto") return std::nullopt;
  throw py::value_error("weld must be auto, off or a number");
}

void set(Options& options, const std::string& key, const py::handle& value) {
  if (key == "method") {
    options.method = word<Method>(key, value,
                                  {{"quality", Method::quality},
                                   {"almond", Method::almond},
                                   {"nonobtuse", Method::nonobtuse}});
  } else if (key == "fill") {
    options.fill = word<Fill>(key, value, {{"refine", Fill::refine}, {"disks", Fill::disks}});
  } else if (key == "overlap") {
    options.overlap = word<Overlap>(
        key, value,
        {{"last", Overlap::last}, {"first", Overlap::first}, {"error", Overlap::error}});
  } else if (key == "max_angle") {
    options.max_angle = Angle::degrees(value.cast<double>());
  } else if (key == "min_angle") {
    options.min_angle = Angle::degrees(value.cast<double>());
  } else if (key == "growth") {
    options.growth = value.cast<double>();
  } else if (key == "sizes") {
    add_sizes(options, value, false);
  } else if (key == "sizes_at") {
    add_sizes(options, value, true);
  } else if (key == "split_interfaces") {
    options.split_interfaces = split_angle(value);
  } else if (key == "weld") {
    options.weld = weld(value);
  } else if (key == "strict") {
    options.strict = value.cast<bool>();
  } else if (key == "merge_materials") {
    options.merge_materials = value.cast<bool>();
  } else if (key == "hull") {
    options.hull = value.cast<bool>();
  } else if (key == "threads") {
    options.threads = value.cast<unsigned>();
  } else {
    throw py::type_error("unexpected option '" + key + "'");
  }
}

}  // namespace

Options options_from(const py::dict& keywords) {
  Options options;
  for (const auto& [key, value] : keywords) set(options, py::str(key), value);
  return options;
}

WriteOptions write_options_from(const py::dict& keywords) {
  WriteOptions options;
  for (const auto& [name, value] : keywords) {
    const std::string key = py::str(name);
    if (key == "order") {
      options.order = value.cast<int>();
    } else if (key == "inner_lines") {
      options.inner_lines = value.cast<bool>();
    } else if (key == "lines") {
      options.lines = value.cast<bool>();
    } else if (key == "msh") {
      options.msh = py::str(value);
    } else if (key == "inp_element") {
      options.inp_element = py::str(value);
    } else {
      throw py::type_error("unexpected option '" + key + "'");
    }
  }
  return options;
}

}  // namespace cover::python
