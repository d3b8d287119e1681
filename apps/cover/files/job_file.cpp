// Tested by tests/cli/program_test.py, class Configuration.
#include "files/job_file.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <cover/option_table.hpp>

#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

namespace cover::app {
namespace {

/// What helps where a file is no TOML, by what toml++ says.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kAdvice{
    {{"could not determine value type", "text stands in quotes"},
     {"control characters other than TAB", "a string ends on its line"},
     {"cannot redefine existing", "several values of an option are a list: [a, b]"}}};

std::string explained(std::string_view said) {
  constexpr std::string_view kStart = "Error while parsing ";
  if (said.starts_with(kStart)) said.remove_prefix(kStart.size());
  std::string text(said);
  for (const auto& [part, advice] : kAdvice)
    if (said.find(part) != std::string_view::npos) text += fmt::format("; {}", advice);
  return text;
}

/// A number, a text, true or false as an option has it; nothing of what is none of these.
std::optional<std::string> text_of(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  return std::nullopt;
}

[[noreturn]] void fail_at(const toml::source_region& place, const std::string& what) {
  throw JobFileError(place.begin.line, what);
}

/// The values of a key.
std::vector<std::string> values_of(std::string_view key, const toml::node& node) {
  if (node.is_table())
    fail_at(
        node.source(),
        fmt::format("the --config file has a section [{}]; its keys stand without sections", key));
  std::vector<std::string> values;
  const auto add = [&](const toml::node& value) {
    std::optional<std::string> text = text_of(value);
    if (!text)
      fail_at(value.source(),
              fmt::format("the value of {} is no text, number, true, false or list of these", key));
    values.push_back(*std::move(text));
  };
  if (const toml::array* list = node.as_array())
    for (const toml::node& value : *list) add(value);
  else
    add(node);
  return values;
}

/// The option of that name that may stand alone; nullptr if there is none.
const OptionEntry* standing_alone(const std::string& name) {
  const OptionEntry* entry = find_option(name);
  return entry != nullptr && !entry->alone.empty() ? entry : nullptr;
}

}  // namespace

std::string job_value(const std::string& value) {
  const toml::parse_result file = toml::parse("value = " + value);
  if (file && file.table().size() == 1 && !file.table().begin()->second.is_string() &&
      text_of(file.table().begin()->second) == value)
    return value;
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
  const bool has_control = std::any_of(value.begin(), value.end(), is_control);
  if (!has_control && value.find_first_of("\"\\") == std::string::npos) return '"' + value + '"';
  if (!has_control && value.find('\'') == std::string::npos) return '\'' + value + '\'';
  std::string out = "\"";
  for (const char c : value) {
    if (is_control(c)) {
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      if (c == '"' || c == '\\') out += '\\';
      out += c;
    }
  }
  return out + '"';
}

std::vector<CLI::ConfigItem> JobFile::from_config(std::istream& input) const {
  const toml::parse_result file = toml::parse(input);
  if (!file) fail_at(file.error().source(), explained(file.error().description()));
  std::vector<std::pair<const toml::key*, const toml::node*>> lines;
  for (const auto& [key, node] : file.table()) lines.emplace_back(&key, &node);
  std::sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) {
    return a.first->source().begin < b.first->source().begin;
  });
  std::vector<CLI::ConfigItem> settings;
  for (const auto& [key, node] : lines) {
    CLI::ConfigItem item;
    item.name = std::string(key->str());
    item.inputs = values_of(key->str(), *node);
    if (const OptionEntry* const entry = standing_alone(item.name);
        entry != nullptr && item.inputs.size() == 1) {
      if (item.inputs.front() == "true") item.inputs.front() = std::string(entry->alone);
      if (item.inputs.front() == "false") continue;
      // Its advice for the command line does not fit here.
      Options ignored;
      if (const Status status = entry->set(*entry, item.inputs.front(), ignored); !status)
        throw CLI::ValidationError("--" + item.name, status.error().message);
    }
    settings.push_back(std::move(item));
  }
  return settings;
}

}  // namespace cover::app
