// Tested by tests/cli/program_test.py, class Configuration.
#include "files/job_file.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
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
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kAdvice{
    {{"could not determine value type", "text stands in quotes"},
     {"expected digit", "text stands in quotes"},
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

/// No option has a key of several parts. toml++ makes a table in a table of each part, and gives
/// them back by recursion.
constexpr std::size_t kMostParts = 16;

/// The line of a key of more parts.
std::optional<std::size_t> line_of_long_key(std::string_view text) {
  std::size_t line = 1, parts = 0;
  char quote = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '\n') ++line;
    if (quote != 0) {
      if (c == '\\' && quote == '"' && k + 1 < text.size() && text[k + 1] != '\n') ++k;
      if (c == quote || c == '\n') quote = 0;
    } else if (c == '#') {
      while (k + 1 < text.size() && text[k + 1] != '\n') ++k;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) {
      parts = 0;
    } else if (c == '.' && ++parts > kMostParts) {
      return line;
    }
  }
  return std::nullopt;
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
  const std::string text{std::istreambuf_iterator<char>(input), {}};
  if (const auto line = line_of_long_key(text))
    throw JobFileError(*line, fmt::format("a key has more than {} parts", kMostParts));
  const toml::parse_result file = toml::parse(text);
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
