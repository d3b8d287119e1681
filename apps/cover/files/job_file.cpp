// Tested by tests/cli/program_test.py, class Configuration.
#include "files/job_file.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <sstream>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include <cover/option_table.hpp>

namespace cover::app {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
constexpr char kNever = '\n';  // which is in no line
constexpr char kMark = '\x01';
constexpr std::string_view kTriple = R"(""")";

/// What the escapes in """...""" mean; others stay as they are.
std::string unescaped(std::string_view text) {
  std::string out;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char next = text[k] == '\\' && k + 1 < text.size() ? text[k + 1] : kNever;
    if (next == '"' || next == '\\') {
      out += next, ++k;
    } else if (next == 'n' || next == 'r') {
      out += next == 'n' ? '\n' : '\r', ++k;
    } else {
      out += text[k];
    }
  }
  return out;
}

/// Follows strings and arrays from line to line. CLI11 takes quotes inside of strings for ends of
/// them, or takes them away: a mark stands for each string until it has read the rest.
class Scanner {
 public:
  explicit Scanner(const CLI::App& command) : command_(command) {}

  /// The line without its comment, and with marks in place of strings.
  std::string next(std::string line) {
    ++number_;
    if (open_ > 0 && is_key(line)) fail_open();
    if (open_ == 0) check_key(line);
    char before = kNever;  // the last character that is no blank
    for (std::size_t k = 0; k < line.size(); ++k) {
      const char c = line[k];
      const bool begins = before == kNever || before == '=' || before == '[' || before == ',';
      if (c == '#') return line.substr(0, k);
      if (begins && (c == '"' || c == '\'')) {
        const bool is_triple = line.compare(k, kTriple.size(), kTriple) == 0;
        const std::string end_of_it = is_triple ? std::string(kTriple) : std::string(1, c);
        const std::size_t from = k + end_of_it.size();
        std::size_t end = line.find(end_of_it, from);
        while (is_triple && end != std::string::npos && is_escaped(line, from, end))
          end = line.find(end_of_it, end + 1);
        if (end == std::string::npos)
          throw JobFileError(number_, fmt::format("the string {} has no {} at its end",
                                                  line.substr(k, line.find('\r') - k), end_of_it));
        const bool is_value = open_ > 0 || before != kNever;
        const std::size_t after = end + end_of_it.size();
        if (is_value && is_end(line, after)) {
          const std::string inside = line.substr(from, end - from);
          const std::string mark = fmt::format("{}{}{}", kMark, strings_.size(), kMark);
          strings_.push_back(is_triple ? unescaped(inside) : inside);
          line.replace(k, after - k, mark);
          end = k + mark.size() - 1;
        }
        k = end;
      }
      if (begins && c == '[' && open_++ == 0) opened_at_ = number_;
      if (c == ']' && open_ > 0) --open_;
      if (c != ' ' && c != '\t' && c != '\r') before = c;
    }
    return line;
  }

  /// Whether a list goes on.
  [[nodiscard]] bool is_open() const { return open_ > 0; }

  /// The string that a mark stands for; else the text itself.
  [[nodiscard]] std::string meant_by(const std::string& text) const {
    if (text.size() < 3 || text.front() != kMark || text.back() != kMark) return text;
    std::size_t number = strings_.size();
    std::from_chars(text.data() + 1, text.data() + text.size() - 1, number);
    return number < strings_.size() ? strings_[number] : text;
  }

  void finish() const {
    if (open_ > 0) fail_open();
  }

 private:
  /// Whether an odd number of backslashes stands before a place.
  static bool is_escaped(const std::string& line, std::size_t from, std::size_t place) {
    std::size_t k = place;
    while (k > from && line[k - 1] == '\\') --k;
    return (place - k) % 2 == 1;
  }

  /// The name in front of '=', without quotes around it; empty: none.
  static std::string key_of(const std::string& line) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos || line.find('#') < equals) return {};
    const std::string key = CLI::detail::trim_copy(line.substr(0, equals));
    const bool is_quoted =
        key.size() > 1 && (key.front() == '"' || key.front() == '\'') && key.back() == key.front();
    return is_quoted ? key.substr(1, key.size() - 2) : key;
  }

  /// A key stands once: else one of two lists would be thought to replace the other.
  void check_key(const std::string& line) {
    const std::string key = key_of(line);
    if (key.empty()) return;
    const auto [known, is_new] = line_of_.emplace(key, number_);
    if (is_new) return;
    throw JobFileError(number_,
                       fmt::format("'{}' is given twice, first in line {}: several values are a "
                                   "list, in [ and ]",
                                   key, known->second));
  }

  /// Whether a value has its end here.
  static bool is_end(const std::string& line, std::size_t k) {
    k = line.find_first_not_of(" \t\r", k);
    return k == std::string::npos || line[k] == ',' || line[k] == ']' || line[k] == '#';
  }

  /// Whether a line begins with the name of an option and '='.
  [[nodiscard]] bool is_key(const std::string& line) const {
    const std::string name = key_of(line);
    return !name.empty() && command_.get_option_no_throw("--" + name) != nullptr;
  }

  [[noreturn]] void fail_open() const {
    throw JobFileError(opened_at_, "the list that begins with [ has no ] at its end");
  }

  const CLI::App& command_;
  std::vector<std::string> strings_;
  std::map<std::string, std::size_t> line_of_;  ///< by key
  std::size_t number_ = 0;
  std::size_t opened_at_ = 0;
  std::size_t open_ = 0;
};

/// The option of that name that may stand alone; nullptr if there is none.
const OptionEntry* standing_alone(const std::string& name) {
  const OptionEntry* entry = find_option(name);
  return entry != nullptr && !entry->alone.empty() ? entry : nullptr;
}

}  // namespace

std::string quoted_value(const std::string& value) {
  if (value.find_first_of("\"\n\r") == std::string::npos) return '"' + value + '"';
  if (value.find_first_of("'\n\r") == std::string::npos) return '\'' + value + '\'';
  std::string out(kTriple);
  for (const char c : value) {
    if (c == '"' || c == '\\') out += '\\';
    out += c == '\n' ? "\\n" : c == '\r' ? "\\r" : std::string(1, c);
  }
  return out.append(kTriple);
}

std::vector<CLI::ConfigItem> JobFile::from_config(std::istream& input) const {
  std::stringstream text;
  Scanner scanner(command_);
  bool is_first = true;
  for (std::string line; std::getline(input, line); is_first = false) {
    if (is_first && line.starts_with(kByteOrderMark)) line.erase(0, kByteOrderMark.size());
    text << scanner.next(line) << (scanner.is_open() ? ' ' : '\n');  // a list on one line
  }
  scanner.finish();
  CLI::ConfigTOML plain;
  plain.comment(kNever);  // comments are gone
  std::vector<CLI::ConfigItem> settings = plain.from_config(text);
  for (CLI::ConfigItem& item : settings) {
    for (std::string& value : item.inputs) value = scanner.meant_by(value);
    const OptionEntry* const entry = standing_alone(item.name);
    if (entry == nullptr || item.inputs.size() != 1) continue;
    if (item.inputs.front() == "true") item.inputs.front() = std::string(entry->alone);
    if (item.inputs.front() == "false") continue;
    // Its advice for the command line does not fit here.
    Options ignored;
    if (const Status status = entry->set(*entry, item.inputs.front(), ignored); !status)
      throw CLI::ValidationError("--" + item.name, status.error().message);
  }
  std::erase_if(settings, [](const CLI::ConfigItem& item) {
    return item.inputs == std::vector<std::string>{"false"} && standing_alone(item.name) != nullptr;
  });
  return settings;
}

}  // namespace cover::app
