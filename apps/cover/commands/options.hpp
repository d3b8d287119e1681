// Command line options as the library's Options, and what all subcommands share.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <cover/option_table.hpp>
#include <cover/read_option_table.hpp>
#include <cover/result.hpp>
#include <cover/write_option_table.hpp>

#include "commands/commands.hpp"
#include "files/file_check.hpp"
#include "terminal/console.hpp"

namespace cover::app {

/// An argument that is one of a few words; a near miss is told the word meant.
CLI::Validator one_of(std::vector<std::string> words);
/// An argument in a range.
CLI::Validator number_in(Range range);

/// -q, -v, --log.
void add_verbosity(CLI::App& command, Verbosity& verbosity);

/// Parses `arguments`. What to return from the subcommand if it is not to run (after --help, or a
/// mistake, which is explained on stderr).
std::optional<int> parse(CLI::App& command, Arguments arguments);

/// The options in force as a --config file. What is not set stands there as a comment.
std::string configuration(const CLI::App& command);

/// Ends a subcommand with a mistake in its use.
int usage_error(const CLI::App& command, const std::string& message);
/// The same for an error of the library, which may be one of files.
int usage_error(const CLI::App& command, const Error& error);

/// The file of --config, of --log; with an empty path where there is none.
NamedFile config_file(const CLI::App& command);
NamedFile log_file(const Verbosity& verbosity);

/// An option of a table as it was written.
template <class Target>
struct WrittenOption {
  const OptionOf<Target>* entry;
  std::string default_text;
  CLI::Option* option = nullptr;
  std::vector<std::string> values;
  bool flag = false;

  /// Adds the option to a command, which keeps pointers to this.
  void add_to(CLI::App& command, const char* group);
  /// As texts for the table; none where it was not given.
  [[nodiscard]] std::vector<std::string> texts() const;
};

/// What is said of an option that was given and has no effect.
template <class Target>
std::string does_nothing(const OptionOf<Target>& entry) {
  return fmt::format("--{} does nothing: it counts with {} only", entry.name, entry.counts_with);
}

/// The options that end in cover::Options: those of option_table().
class LibraryOptions {
 public:
  /// Adds all options of a group.
  void add(CLI::App& command, OptionGroup group);
  /// Adds the number of threads.
  void add_threads(CLI::App& command) { add_one(command, "threads"); }
  /// Adds one option.
  /// REQUIRES: option_table() has it
  void add_one(CLI::App& command, std::string_view name);

  /// Everything but the background sizes.
  ///
  /// Errors: bad_option
  [[nodiscard]] Result<Options> make() const;

  /// Options that were given but do nothing, a sentence each.
  [[nodiscard]] std::vector<std::string> ignored() const;

  /// The file of --size-field; with an empty path where there is none.
  [[nodiscard]] NamedFile size_field_file() const;

 private:
  [[nodiscard]] Result<OptionReader> read() const;

  std::deque<WrittenOption<Options>> written_;  ///< which CLI11 points into
};

}  // namespace cover::app
