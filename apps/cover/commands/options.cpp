#include "commands/options.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <sstream>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "files/job_file.hpp"
#include "terminal/console.hpp"

namespace cover::app {
namespace {

/// Help of at most 100 columns.
class NarrowHelp : public CLI::Formatter {
 public:
  NarrowHelp() {
    column_width(kNames);
    label("REQUIRED", "");
  }

  /// CLI11 writes "..." behind whatever may be given several times; that stands for several words
  /// behind one name.
  std::string make_option_opts(const CLI::Option* option) const override {
    std::string text = CLI::Formatter::make_option_opts(option);
    const std::string several = option->get_allow_extra_args() ? "" : kSeveral;
    const std::string count = fmt::format(" x {}", option->get_expected());
    for (const std::string& wrong : {several, count})
      if (const std::size_t at = text.find(wrong); at != text.npos) text.erase(at, wrong.size());
    return text;
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    std::string out;
    std::size_t column = 0;
    std::string description = option->get_description();
    const bool is_told = description.find("several") != description.npos;
    if (!option->get_allow_extra_args() && !is_told &&
        CLI::Formatter::make_option_opts(option).find(kSeveral) != std::string::npos)
      description += "; several if repeated";
    std::istringstream words(description);
    for (std::string word; words >> word;) {
      if (column > 0 && column + 1 + word.size() > kDescription) {
        out += '\n';
        column = 0;
      }
      if (column > 0) ++column, out += ' ';
      out += word;
      column += word.size();
    }
    return out;
  }

  /// The last of several words is no option: CLI11 would leave it to the several before it.
  std::string make_usage(const CLI::App* app, std::string name) const override {
    constexpr std::string_view kLast = "... [mesh]";
    std::string text = CLI::Formatter::make_usage(app, std::move(name));
    const std::size_t at = text.find(kLast);
    return at == std::string::npos ? text : text.replace(at, kLast.size(), "... mesh");
  }

 private:
  static constexpr const char* kSeveral = " ...";
  static constexpr std::size_t kNames = 32;
  static constexpr std::size_t kDescription = 68;
};

/// The long names (`--fill`) of all options of a command.
std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string meant_option(const CLI::App& command, const std::string& word) {
  return did_you_mean(word.substr(0, word.find('=')), option_names(command));
}

/// What a flag may be in a file of --config.
std::string yes_or_no(const std::string& text) {
  try {
    const auto value = CLI::detail::to_flag_value(text);
    if (value >= -1 && value <= 1) return {};
  } catch (const std::exception&) {
    // CLI11's way to say that it is no flag.
  }
  return fmt::format("'{}' is not true or false", text);
}

/// What CLI11 says of the number of values in words that it never inflects: "--range: At Most 2
/// required but received 3", "--method: 1 required NAME missing".
std::string explain_number(const std::string& said) {
  const std::size_t colon = said.find(": ");
  if (colon == std::string::npos) return said;
  const std::string name = said.substr(0, colon);
  std::istringstream words(said.substr(colon + 2));
  std::string first, second, number, ignored, received;
  words >> first >> second >> number;
  if (second == "required" && first == "1")
    return fmt::format("{} needs {} behind it", name, number);
  if (first != "At") return said;
  words >> ignored >> ignored >> ignored;  // "required but received"
  std::getline(words >> std::ws, received);
  if (second == "Most" && number == "1")
    return fmt::format("{} is given {} times, once is the most", name, received);
  return fmt::format("{} takes {} values, not {}", name, number, received);
}

/// What was wrong, in words for the user.
std::string explain(const CLI::App& command, const CLI::ParseError& error) {
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    const std::string word = command.remaining().front();
    if (word.starts_with('-')) {
      return fmt::format("unknown option '{}'{}", word, meant_option(command, word));
    }
    return fmt::format("unexpected argument '{}'", word);
  }
  if (const auto* line = dynamic_cast<const JobFileError*>(&error); line != nullptr)
    return fmt::format("{}:{}: {}", config_file(command).path, line->line(), error.what());
  if (dynamic_cast<const CLI::ConfigError*>(&error) != nullptr) {
    const std::string text = error.what();
    if (const std::size_t end = text.find(": This option is not allowed"); end != std::string::npos)
      return fmt::format("'{}' does not stand in a --config file", text.substr(0, end));
    const std::string key = text.substr(text.rfind(' ') + 1);
    return fmt::format("unknown key '{}' in the --config file{}", key,
                       meant_option(command, "--" + key));
  }
  if (dynamic_cast<const CLI::FileError*>(&error) != nullptr) {
    return fmt::format("cannot read the --config file: {}", error.what());
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
    return explain_number(error.what());
  return error.what();
}

/// What CLI11 prints of options, but values as JobFile reads them back.
std::string with_quotes(const CLI::App& command, std::string text) {
  text.insert(0, 1, '\n');  // so that the first name has one in front, too
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || !option->get_configurable()) continue;
    const std::vector<std::string> values = option->reduced_results();
    const std::string name = '\n' + option->get_single_name() + '=';
    const std::string printed = name + CLI::detail::ini_join(values) + '\n';
    const std::size_t at = text.find(printed);
    if (at == std::string::npos) continue;
    std::string list;
    for (const std::string& value : values) {
      if (!list.empty()) list += ", ";
      list += job_value(value);
    }
    if (values.size() > 1) list = fmt::format("[{}]", list);
    text.replace(at, printed.size(), fmt::format("{}{}\n", name, list));
  }
  return text.erase(0, 1);
}

}  // namespace

CLI::Validator one_of(std::vector<std::string> words) {
  return {[words = std::move(words)](std::string& word) -> std::string {
            const bool known = std::find(words.begin(), words.end(), word) != words.end();
            return known ? std::string() : not_one_of(word, words);
          },
          ""};
}

CLI::Validator number_in(Range range) {
  return {[range](std::string& text) -> std::string {
            double value = 0;
            if (!CLI::detail::lexical_cast(text, value))
              return fmt::format("'{}' is not a number", text);
            if (range.holds(value)) return {};
            return fmt::format("{} is not {}", text, describe(range));
          },
          ""};
}

void add_verbosity(CLI::App& command, Verbosity& verbosity) {
  const char* group = "Messages";
  command.add_flag("-q,--quiet", verbosity.quiet, "Print errors only")->group(group);
  command.add_flag("-v,--verbose", verbosity.verbose, "Say what is done; -vv: in detail")
      ->group(group);
  command
      .add_option("--log", verbosity.log_file,
                  "Write all messages of this run, with times, to FILE, which is replaced")
      ->type_name("FILE")
      ->group(group);
}

namespace {

/// A short option with its value behind '=' (`-o=x.vtu`), which would belong to the value.
std::optional<std::string> short_with_equals(const CLI::App& command, const Arguments& arguments) {
  for (const std::string& word : arguments) {
    if (word == "--") return std::nullopt;
    if (word.size() < 3 || word[0] != '-' || word[2] != '=') continue;
    const CLI::Option* option = command.get_option_no_throw(word.substr(0, 2));
    if (option != nullptr && option->get_expected_max() > 0)
      return fmt::format("'{}': the value of {} stands behind it without '='", word,
                         word.substr(0, 2));
  }
  return std::nullopt;
}

}  // namespace

std::optional<int> parse(CLI::App& command, Arguments arguments) {
  command.formatter(std::make_shared<NarrowHelp>());
  if (const auto wrong = short_with_equals(command, arguments)) return usage_error(command, *wrong);
  std::reverse(arguments.begin(), arguments.end());
  for (CLI::Option* option : command.get_options()) {
    const bool counts = option->check_lname("verbose") || option->check_lname("help");
    if (option->get_expected_max() == 0 && !counts) option->check(yes_or_no);
  }
  try {
    command.parse(std::move(arguments));
    return std::nullopt;
  } catch (const CLI::CallForHelp&) {
    std::fputs(command.help().c_str(), stdout);
    return exit_ok;
  } catch (const CLI::ParseError& error) {
    return usage_error(command, explain(command, error));
  }
}

std::string configuration(const CLI::App& command) {
  std::istringstream lines(with_quotes(command, command.config_to_str(true, true)));
  std::string out;
  for (std::string line; std::getline(lines, line);) {
    const std::string name = line.substr(0, line.find('='));
    const CLI::Option* option = command.get_option_no_throw("--" + name);
    if (option == nullptr) option = command.get_option_no_throw(name);
    // A flag given more than once is a list to CLI11, which it cannot read back.
    if (option != nullptr && option->get_expected_max() == 0 && option->count() > 1)
      line = fmt::format("{}={}", name, option->count());
    // A default is not printed as if it were given: it may be the value of an option that is off.
    out += (option != nullptr && option->count() == 0 ? "# " : "") + line + '\n';
  }
  return out;
}

int usage_error(const CLI::App& command, const std::string& message) {
  print_on_stderr(
      fmt::format("cover: error: {}\nSee '{} --help'.\n", printable(message), command.get_name()));
  return exit_usage;
}

int usage_error(const CLI::App& command, const Error& error) {
  const int code = exit_code_of(error.code);
  if (code == exit_usage) return usage_error(command, error.message);
  print_on_stderr(fmt::format("cover: error: {}\n", printable(error.message)));
  return code;
}

NamedFile config_file(const CLI::App& command) {
  const CLI::Option* option = command.get_config_ptr();
  return {"--config", option->empty() ? std::string() : option->as<std::string>()};
}

NamedFile log_file(const Verbosity& verbosity) {
  // Standard output is no place for a log: `-` is a file of that name.
  return {"--log", verbosity.log_file == "-" ? "./-" : verbosity.log_file};
}

namespace {

/// An argument that the option takes.
template <class Target>
CLI::Validator value_of(const OptionOf<Target>& entry) {
  return {[&entry](std::string& text) -> std::string {
            Target ignored;
            const Status status = entry.set(entry, text, ignored);
            if (status) return {};
            // An option that also stands alone takes the word behind it for its value.
            double number = 0;
            return entry.alone.empty() || CLI::detail::lexical_cast(text, number)
                       ? status.error().message
                       : status.error().message + "; before a file, write it with '=' and a number";
          },
          ""};
}

template <class Target>
std::string names_of(const OptionOf<Target>& entry) {
  return entry.letter != 0 ? fmt::format("-{},--{}", entry.letter, entry.name)
                           : fmt::format("--{}", entry.name);
}

}  // namespace

template <class Target>
void WrittenOption<Target>::add_to(CLI::App& command, const char* group) {
  const std::string help(entry->help);
  if (entry->kind == OptionKind::flag) {
    option = command.add_flag(names_of(*entry), flag, help);
  } else {
    option = command.add_option(names_of(*entry), values, help)
                 ->check(value_of(*entry))
                 ->type_name(std::string(entry->placeholder))
                 ->default_str(default_text)
                 ->allow_extra_args(false);
    if (!entry->repeats) option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::Throw);
    if (entry->kind == OptionKind::words) option->delimiter(',');
    if (!entry->alone.empty()) option->expected(0, 1)->default_str(std::string(entry->alone));
  }
  option->group(group);
}

template <class Target>
std::vector<std::string> WrittenOption<Target>::texts() const {
  if (option->count() == 0) return {};
  if (entry->kind == OptionKind::flag) return {flag ? "true" : "false"};
  return values;
}

template struct WrittenOption<Options>;
template struct WrittenOption<ReadOptions>;
template struct WrittenOption<WriteOptions>;

void LibraryOptions::add(CLI::App& command, OptionGroup group) {
  for (const OptionEntry& entry : option_table()) {
    if (entry.group != group) continue;
    written_.push_back({&entry, default_text(entry), nullptr, {}, false});
    written_.back().add_to(command, group == OptionGroup::cleaning ? "Input" : "Meshing");
  }
  for (const WrittenOption<Options>& written : written_) {
    if (!written.entry->needs.empty() && written.entry->group == group)
      written.option->needs("--" + std::string(written.entry->needs));
  }
}

void LibraryOptions::add_one(CLI::App& command, std::string_view name) {
  const OptionEntry* const entry = find_option(name);
  written_.push_back({entry, default_text(*entry), nullptr, {}, false});
  written_.back().add_to(command, "Options");
}

Result<OptionReader> LibraryOptions::read() const {
  OptionReader reader;
  for (const WrittenOption<Options>& written : written_) {
    for (const std::string& value : written.texts()) {
      Status status = reader.set(*written.entry, value);
      if (status) continue;
      Error error = std::move(status).error();
      error.message = fmt::format("--{}: {}", written.entry->name, error.message);
      return error;
    }
  }
  return reader;
}

Result<Options> LibraryOptions::make() const {
  Result<OptionReader> reader = read();
  if (!reader) return std::move(reader).error();
  return reader->result();
}

std::vector<std::string> LibraryOptions::ignored() const {
  const Result<OptionReader> reader = read();
  std::vector<std::string> sentences;
  if (!reader) return sentences;
  for (const OptionEntry* entry : reader->idle()) sentences.push_back(does_nothing(*entry));
  return sentences;
}

NamedFile LibraryOptions::size_field_file() const {
  for (const WrittenOption<Options>& written : written_) {
    if (written.entry->name == "size-field" && !written.values.empty())
      return {"--size-field", written.values.back()};
  }
  return {"--size-field", ""};
}

}  // namespace cover::app
