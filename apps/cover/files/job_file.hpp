// Job files (--config): TOML.
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

/// Values and lists of values, none deeper; `true` for an option that also stands alone means that.
class JobFile : public CLI::ConfigTOML {
 public:
  /// Throws: JobFileError; CLI::ValidationError, of options that also stand alone
  [[nodiscard]] std::vector<CLI::ConfigItem> from_config(std::istream& input) const override;
};

/// A value as JobFile reads it back.
std::string job_value(const std::string& value);

}  // namespace cover::app
