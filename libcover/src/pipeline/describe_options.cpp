// Tested by tests/unit/pipeline/describe_options_test.cpp.
#include "pipeline/describe_options.hpp"

#include <fmt/core.h>

#include "base/describe.hpp"

namespace cover {
namespace {

const char* name_of(Method method) {
  switch (method) {
    case Method::quality:
      return "quality";
    case Method::almond:
      return "almond";
    case Method::nonobtuse:
      break;
  }
  return "nonobtuse";
}

const char* name_of(Overlap overlap) {
  switch (overlap) {
    case Overlap::last:
      return "last";
    case Overlap::first:
      return "first";
    case Overlap::error:
      break;
  }
  return "error";
}

/// Collects settings that differ from their defaults.
class Settings {
 public:
  std::vector<Provenance::Setting> list;

  void add(const char* name, std::string value) { list.push_back({name, std::move(value)}); }
  void add_flag(const char* name, bool value) {
    if (value) add(name, "true");
  }
  void add_number(const char* name, double value, double by_default) {
    if (value != by_default) add(name, describe(value));
  }
  void add_angle(const char* name, Angle value, Angle by_default) {
    if (value != by_default) add(name, degrees(value));
  }
  /// As it was given: degrees are kept as radians, which costs the last digits.
  static std::string degrees(Angle angle) { return fmt::format("{:.12g}", angle.in_degrees()); }
};

void add_size(const SizeRule& rule, Settings& settings) {
  const std::string value =
      rule.name.empty() ? describe(rule.size) : fmt::format("{}={}", rule.name, rule.size);
  settings.add(rule.at ? "size-at" : "size", value);
}

}  // namespace

std::vector<Provenance::Setting> describe_options(const Options& options) {
  const Options defaults;
  Settings settings;
  settings.add("method", name_of(options.method));
  if (options.fill != defaults.fill) settings.add("fill", "disks");
  settings.add_flag("paper", options.paper);
  settings.add_number("pieces", options.pieces, defaults.pieces);
  settings.add_flag("hull", options.hull);
  settings.add_angle("max-angle", options.max_angle, defaults.max_angle);
  settings.add_angle("min-angle", options.min_angle, defaults.min_angle);
  for (const SizeRule& rule : options.sizes) add_size(rule, settings);
  settings.add_flag("no-input-sizes", !options.input_sizes);
  if (options.size_field) settings.add("size-field", options.size_field_name);
  if (options.growth) settings.add("growth", describe(*options.growth));
  if (options.split_interfaces)
    settings.add("split-interfaces", Settings::degrees(*options.split_interfaces));
  if (options.overlap != defaults.overlap) settings.add("overlap", name_of(options.overlap));
  if (options.weld) settings.add("weld", describe(*options.weld));
  settings.add_flag("strict", options.strict);
  settings.add_flag("merge-materials", options.merge_materials);
  return std::move(settings.list);
}

}  // namespace cover
