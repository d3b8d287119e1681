#include "commands/check/own_run.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/core.h>

#include <cover/option_table.hpp>
#include <cover/options.hpp>
#include <cover/read_option_table.hpp>
#include <cover/text.hpp>

namespace cover::app {
namespace {

/// A value as a shell takes it for one word. It comes from a file, which anybody may have written.
std::string shell_word(std::string_view value) {
  const auto is_plain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           std::string_view("_.-+:/,=").find(c) != std::string_view::npos;
  };
  if (!value.empty() && std::all_of(value.begin(), value.end(), is_plain))
    return std::string(value);
  std::string word = "'";
  for (const char c : printable(value)) {
    if (c == '\'')
      word += R"('\'')";
    else
      word += c;
  }
  return word + "'";
}

}  // namespace

bool has_option(const CLI::App& app, const std::string& name) {
  const CLI::Option* option = app.get_option_no_throw("--" + name);
  return option != nullptr && option->count() > 0;
}

std::vector<std::string> options_to_repeat(const CLI::App& app, const MeshOrigin& origin) {
  std::vector<std::string> options;
  if (origin.scale != 1 && !has_option(app, "scale"))
    options.push_back(fmt::format("--scale {}", describe(origin.scale)));
  for (const auto& [written, value] : origin.provenance.settings) {
    const OptionEntry* const cleaning = find_option(written);
    const ReadOptionEntry* const reading = find_read_option(written);
    const bool is_of_input =
        reading != nullptr || (cleaning != nullptr && cleaning->group == OptionGroup::cleaning);
    if (!is_of_input) continue;
    const std::string name(reading != nullptr ? reading->name : cleaning->name);
    if (has_option(app, name)) continue;
    const bool is_flag = (reading != nullptr ? reading->kind : cleaning->kind) == OptionKind::flag;
    options.push_back(is_flag ? fmt::format("--{}", name)
                              : fmt::format("--{} {}", name, shell_word(value)));
  }
  return options;
}

AngleTargets targets_with_run(const CLI::App& app, const MeshOrigin& origin,
                              const AngleTargets& usual) {
  Options options;
  bool is_told = false;
  for (const auto& [name, value] : origin.provenance.settings) {
    if (name == "method" && value != "quality") return usual;  // the others have none
    if (name != "max-angle" && name != "min-angle") continue;
    const OptionEntry& entry = *find_option(name);
    if (!entry.set(entry, value, options)) return usual;  // by a program with other ranges
    is_told = true;
  }
  if (!is_told) return usual;
  AngleTargets targets = usual;
  if (!has_option(app, "max-angle")) {
    targets.largest = options.max_angle;
    targets.is_largest_of_run = true;
  }
  if (!has_option(app, "min-angle")) {
    targets.smallest = options.min_angle;
    targets.is_smallest_of_run = true;
  }
  return targets;
}

}  // namespace cover::app
