// The files that a command writes: where, in which formats, and what these cannot hold.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include <spdlog/logger.h>
#include <CLI/CLI.hpp>

#include <cover/attribute.hpp>
#include <cover/options.hpp>
#include <cover/output.hpp>
#include <cover/regions.hpp>
#include <cover/result.hpp>
#include <cover/stream_mesh.hpp>
#include <cover/write_options.hpp>

#include "commands/format_options.hpp"
#include "files/file_check.hpp"
#include "files/writers.hpp"
#include "terminal/progress_line.hpp"

namespace cover::app {

/// The options that name files of meshes and reports and say what they are like. CLI11 points into
/// it: it stays where it is.
class OutputFiles {
 public:
  OutputFiles() = default;
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// Adds -o and returns it; `on_stdout` is what its help says of '-'.
  CLI::Option* add_meshes(CLI::App& command, const char* on_stdout);
  /// Adds --format, which it returns, and the options of formats.
  CLI::Option* add_formats(CLI::App& command, const char* group);
  /// Adds --report.
  void add_reports(CLI::App& command, const char* group);

  [[nodiscard]] const std::vector<std::string>& meshes() const { return meshes_; }
  [[nodiscard]] const std::vector<std::string>& reports() const { return reports_; }
  /// Meshes by names that end in their formats, standard output by one made up.
  [[nodiscard]] std::vector<std::string> names_with_formats() const;
  /// Meshes and, behind them, reports: in the order in which they are written.
  [[nodiscard]] std::vector<std::string> paths() const;
  /// The same with the options that name them.
  [[nodiscard]] std::vector<NamedFile> named_files() const;
  /// Whether a mesh goes to standard output.
  [[nodiscard]] bool has_stdout() const;
  /// What the options of formats say.
  [[nodiscard]] WriteOptions write_options() const { return formats_.make(); }
  /// The same for one of the meshes: whole, where its format knows no parts and another's does.
  [[nodiscard]] WriteOptions write_options_for(const std::string& path) const;

  /// Finds out before the work whether every file can be written in the format that it asks for.
  ///
  /// Errors: unsupported_format, bad_option
  Status plan();
  /// Whether the files can hold periodic sides.
  ///
  /// Errors: bad_option
  [[nodiscard]] Status can_hold_periodic() const;

  /// What is lost without harm, a sentence each: options that do nothing, `attributes`, the texts
  /// that their numbers stand for, pairs on `periodic` sides and names of `points` that stand in no
  /// manifest and that a file cannot hold, and values at points that none of them can. A .vtm tells
  /// texts and names of points to files beside it.
  [[nodiscard]] std::vector<std::string> warnings(
      const std::vector<Attribute>& attributes, std::span<const PlaneField::Array> values_at_points,
      std::span<const PeriodicRule> periodic, const std::vector<std::string>& points = {}) const;
  /// A sentence on each manifest and each .vtm that an earlier run left beside a mesh that is
  /// written now: readers of the mesh take names from it.
  [[nodiscard]] std::vector<std::string> left_beside() const;
  /// What is lost of the mesh itself, a sentence each: digits of coordinates that a file cannot
  /// hold, and named lines that --no-inner-lines leaves out and that stand in no manifest.
  [[nodiscard]] std::vector<std::string> warnings_of(const Output& output) const;

  /// What is lost of the named regions of a mesh that is converted: those of one name and material
  /// are one set of an .inp, and no manifest tells them apart. Empty: nothing.
  [[nodiscard]] std::string regions_joined(const RegionTable& table) const;

  /// Writes all files in turn; the log tells of each, and so does a line on stderr, if it is shown.
  ///
  /// REQUIRES: plan() was successful
  /// Errors:   cannot_write; cancelled
  [[nodiscard]] Status write(const Output& output, const std::stop_token& stop, ShowProgress show,
                             spdlog::logger& log) const;
  /// The same of a mesh that may be on the disk.
  ///
  /// Errors: also bad_option, as write_streamed_mesh()
  [[nodiscard]] Status write(const StreamedOutput& streamed, const std::stop_token& stop,
                             ShowProgress show, spdlog::logger& log) const;

 private:
  struct Planned {
    std::string path;
    Writer write;
    bool is_report = false;
  };

  [[nodiscard]] bool has_manifest() const { return writes(".json"); }
  [[nodiscard]] bool writes(std::string_view extension) const;
  [[nodiscard]] std::vector<std::string> inp_files() const;  ///< names
  [[nodiscard]] std::string rounding(const Output& output) const;
  [[nodiscard]] std::string beyond_axis(const Output& output) const;
  [[nodiscard]] std::string lines_left_out(const RegionTable& table) const;
  /// That files hold none of what is called so: all but those in a format that is `holding`. Only
  /// files in a format that is `among` count, or meshes where there are none.
  [[nodiscard]] std::string lost(std::string_view what, const std::vector<std::string>& names,
                                 const std::vector<std::string>& holding,
                                 const std::vector<std::string>& among = {}) const;
  [[nodiscard]] Status write_each(const std::function<Status(const Planned&)>& write,
                                  ShowProgress show, spdlog::logger& log) const;

  std::vector<std::string> meshes_;
  std::vector<std::string> reports_;
  std::string format_ = "vtu";  ///< of standard output, without its dot
  CLI::Option* format_option_ = nullptr;
  FormatOptions formats_;
  std::vector<Planned> planned_;
};

}  // namespace cover::app
