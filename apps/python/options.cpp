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
    for (const auto& [name, size] : value.cast<std::map<std::string, double>>())
      options.sizes.push_back({name, size, false});
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

}  // namespace cover::python
