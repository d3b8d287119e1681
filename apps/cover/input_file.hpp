// Reading the geometry that a subcommand is given.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include <cover/input.hpp>
#include <cover/result.hpp>

namespace cover::app {

/// The INPUT argument and the options that say what its coordinates mean.
class GeometryFile {
 public:
  /// Adds INPUT, --unit and --scale; returns INPUT.
  CLI::Option* add(CLI::App& command);

  [[nodiscard]] const std::string& path() const { return path_; }

  /// Reads the file; `-` is standard input, whose format follows from how it begins.
  ///
  /// Errors: those of read_input(), read_vtk_input() and scale_input()
  [[nodiscard]] Result<Input> read() const;

 private:
  std::string path_;
  std::string unit_;
  double scale_ = 1;
};

}  // namespace cover::app
