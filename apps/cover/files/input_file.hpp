// Reading the geometry that a subcommand is given.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include <cover/input.hpp>
#include <cover/read_elsewhere.hpp>
#include <cover/read_option_table.hpp>
#include <cover/result.hpp>

#include "commands/options.hpp"

namespace cover::app {

/// Whether nothing but its bytes tells the format of what a path names: `-`, or a pipe without an
/// extension, as a shell's <(...).
bool is_nameless_stream(const std::string& path);

/// What options of reading may change: where points lie, or what regions are named.
enum class AboutReading { places, names };

/// The INPUT argument and the options of read_option_table().
class GeometryFile {
 public:
  /// Adds INPUT and the options; returns INPUT. `several` files may be given.
  CLI::Option* add(CLI::App& command, bool several = false);

  /// Takes the last file away, where there are several.
  std::optional<std::string> take_last();
  /// The files as messages name them; empty: none was given.
  [[nodiscard]] std::string path() const;
  /// The file of --layer-map; with an empty path where there is none.
  [[nodiscard]] std::vector<NamedFile> read_files() const;

  /// Other programs that read() runs are ended where this asks to stop.
  void heed(std::stop_token stop) { stop_ = std::move(stop); }

  /// Reads the files, which become one geometry in this order; `-` is standard input, whose format
  /// follows from how it begins. By that many threads; 0: all cores. Several files are read by
  /// `read_elsewhere` if it is given, and none of them is a stream.
  ///
  /// Errors: those of read_input() and of the readers that are built in
  [[nodiscard]] Result<Input> read(unsigned threads = 0, const ReadElsewhere& read_elsewhere = {});

  /// Options that were given but do nothing, a sentence each.
  /// REQUIRES: read() was called
  [[nodiscard]] std::vector<std::string> ignored() const;
  /// Options of reading that were not given, and may make something else of such files.
  /// REQUIRES: read() was called
  [[nodiscard]] std::vector<std::string> other_readings(AboutReading about) const;
  /// Options of reading that the mesh can be traced to.
  /// REQUIRES: read() was called
  [[nodiscard]] std::vector<Provenance::Setting> settings() const;

 private:
  Result<Input> read_all(unsigned threads, const ReadElsewhere& read_elsewhere);
  [[nodiscard]] Result<std::vector<Input>> read_several(const ReadElsewhere& read_elsewhere);
  Result<Input> read_one(const std::string& path);
  /// Whether an option does something with any of the files.
  [[nodiscard]] bool counts(const ReadOptionEntry& entry) const;

  std::vector<std::string> paths_;
  ReadOptions options_;
  std::vector<std::string> formats_;  ///< of the files that were read
  std::stop_token stop_;
  std::deque<WrittenOption<ReadOptions>> written_;  ///< which CLI11 points into
};

}  // namespace cover::app
