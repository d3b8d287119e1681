// Job files (--config), read as CLI11 reads them, but for what it would misunderstand.
#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace cover::app {

/// A line of a job file that cannot be read.
class JobFileError : public CLI::ConfigError {
 public:
  JobFileError(std::size_t line, const std::string& what) : CLI::ConfigError(what), line_(line) {}
  [[nodiscard]] std::size_t line() const { return line_; }

 private:
  std::size_t line_;
};

/// A key stands once; strings end on their line, arrays before the next key; strings are what
/// stands between their quotes, whatever that is, with escapes in """..."""; `#` in them begins no
/// comment; `true` for an option that also stands alone means that; a byte order mark is skipped.
class JobFile : public CLI::ConfigTOML {
 public:
  explicit JobFile(const CLI::App& command) : command_(command) {}

  /// Throws: JobFileError; CLI::ValidationError, of options that also stand alone
  [[nodiscard]] std::vector<CLI::ConfigItem> from_config(std::istream& input) const override;

 private:
  const CLI::App& command_;
};

/// A value in the quotes that JobFile reads it back from.
std::string quoted_value(const std::string& value);

}  // namespace cover::app
