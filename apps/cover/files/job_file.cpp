// Tested by tests/cli/program_test.py, class Configuration.
#include "files/job_file.hpp"

#include <algorithm>
#include <sstream>
#include <string_view>

#include <fmt/core.h>

#include <cover/option_table.hpp>

namespace cover::app {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
constexpr char kNever = '\n';  // which is in no line

/// Follows strings and arrays from line to line.
class Scanner {
 public:
  explicit Scanner(const CLI::App& command) : command_(command) {}

  /// The line without its comment.
  std::string next(const std::string& line) {
    ++number_;
    if (open_ > 0 && is_key(line)) fail_open();
    char before = kNever;  // the last character that is no blank
    for (std::size_t k = 0; k < line.size(); ++k) {
      const char c = line[k];
      const bool begins = before == kNever || before == '=' || before == '[' || before == ',';
      if (c == '#') return line.substr(0, k);
      if (begins && (c == '"' || c == '\'')) {
        const std::size_t end = line.find(c, k + 1);
        if (end == std::string::npos)
          throw JobFileError(number_, fmt::format("the string {} has no {} at its end",
                                                  line.substr(k, line.find('\r') - k), c));
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

  void finish() const {
    if (open_ > 0) fail_open();
  }

 private:
  /// Whether a line begins with the name of an option and '='.
  [[nodiscard]] bool is_key(const std::string& line) const {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) return false;
    const std::string name = CLI::detail::trim_copy(line.substr(0, equals));
    return command_.get_option_no_throw("--" + name) != nullptr;
  }

  [[noreturn]] void fail_open() const {
    throw JobFileError(opened_at_, "the list that begins with [ has no ] at its end");
  }

  const CLI::App& command_;
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
