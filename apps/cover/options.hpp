// Command line options as the library's Options, and what all subcommands share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <cover/option_ranges.hpp>
#include <cover/options.hpp>
#include <cover/result.hpp>

#include "commands.hpp"
#include "console.hpp"
#include "file_check.hpp"

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

/// The options that end in cover::Options.
class LibraryOptions {
 public:
  /// How the input is cleaned: for `mesh`, `info`, `check`.
  void add_cleaning(CLI::App& command);
  /// How it is meshed: for `mesh`.
  void add_meshing(CLI::App& command);

  /// Everything but the background sizes.
  ///
  /// Errors: bad_option
  [[nodiscard]] Result<Options> make() const;

  /// Reads the background sizes, if there are any, into `options`, which make() returned.
  ///
  /// Errors: those of read_size_field() and size_function()
  [[nodiscard]] Status read_size_field(Options& options) const;

  /// Options that were given but do nothing, a sentence each.
  [[nodiscard]] std::vector<std::string> ignored(const CLI::App& command) const;

  /// The file of --size-field; with an empty path where there is none.
  [[nodiscard]] NamedFile size_field_file() const { return {"--size-field", size_field_}; }

 private:
  void add_method(CLI::App& command);
  void add_targets(CLI::App& command);
  void add_sizes(CLI::App& command);

  Options options_;
  std::string method_ = options_.method == Method::quality ? "quality" : "almond";
  std::string fill_ = "refine";
  std::string overlap_ = "last";
  std::string weld_;
  double max_angle_ = options_.max_angle.in_degrees();
  double min_angle_ = options_.min_angle.in_degrees();
  std::vector<std::string> sizes_;
  std::vector<std::string> sizes_at_;
  std::string size_field_;
  bool no_input_sizes_ = false;
  std::optional<double> split_interfaces_;
  std::vector<std::string> require_;
};

}  // namespace cover::app
