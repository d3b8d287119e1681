// Tested by tests/unit/app/output_files_test.cpp.
#include "files/output_files.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

#include <fmt/core.h>

#include <cover/files.hpp>
#include <cover/periodic.hpp>
#include <cover/read_mesh.hpp>
#include <cover/text.hpp>
#include <cover/write_mesh.hpp>

namespace cover::app {
namespace {

/// A file as messages name it.
std::string name_of(const std::string& path) { return path == "-" ? "standard output" : path; }

bool is_among(const std::vector<std::string>& all, const std::string& extension) {
  return std::find(all.begin(), all.end(), extension) != all.end();
}

/// Of each attribute of text what its numbers mean: "code: 1 = 07, 2 = 12".
std::vector<std::string> tables_of(const std::vector<Attribute>& attributes) {
  constexpr std::size_t kMost = 10;
  std::vector<std::string> tables;
  for (const Attribute& attribute : attributes) {
    if (!attribute.is_text) continue;
    std::vector<std::string> rows;
    for (std::size_t k = 0; k < std::min(kMost, attribute.words.size()); ++k)
      rows.push_back(fmt::format("{} = {}", k + 1, printable(attribute.words[k])));
    if (attribute.words.size() > kMost) rows.emplace_back("...");
    tables.push_back(fmt::format("{}: {}", attribute.name, listed(rows)));
  }
  return tables;
}

/// Whether a manifest is there; it begins so. A large one takes long to be read.
bool is_manifest(const std::filesystem::path& path) {
  constexpr std::streamsize kBegin = 128;
  std::string head(std::size_t{kBegin}, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), kBegin);
  return head.find("\"cover mesh manifest\"") != std::string::npos;
}

}  // namespace

CLI::Option* OutputFiles::add_meshes(CLI::App& command, const char* on_stdout) {
  std::vector<std::string> several = write_formats();
  std::erase_if(several, [](const std::string& extension) {
    return !is_several_files("mesh" + extension, {});
  });
  return command
      .add_option("-o,--output", meshes_,
                  fmt::format("File to write, several if repeated: {}; '-' is {}, for all but {}",
                              mesh_extensions(), on_stdout, listed(several)))
      ->type_name("FILE")
      ->allow_extra_args(false);
}

CLI::Option* OutputFiles::add_formats(CLI::App& command, const char* group) {
  CLI::Option* format = command.add_option("--format", format_, "Format of '-o -'")
                            ->type_name("EXT")
                            ->capture_default_str();
  formats_.add(command, group);
  format_option_ = format;
  return format;
}

void OutputFiles::add_reports(CLI::App& command, const char* group) {
  command
      .add_option("--report", reports_,
                  "Write a report on every region: .json for programs, .html to read")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->group(group);
}

std::vector<std::string> OutputFiles::names_with_formats() const {
  std::vector<std::string> names = meshes_;
  for (std::string& name : names)
    if (name == "-") name += extension_of_output(name, format_);
  return names;
}

std::vector<std::string> OutputFiles::paths() const {
  std::vector<std::string> all = meshes_;
  all.insert(all.end(), reports_.begin(), reports_.end());
  return all;
}

std::vector<NamedFile> OutputFiles::named_files() const {
  std::vector<NamedFile> files;
  for (const std::string& path : meshes_) files.push_back({"-o", path, true});
  for (const std::string& path : reports_) files.push_back({"--report", path});
  return files;
}

bool OutputFiles::has_stdout() const { return is_among(meshes_, "-"); }

WriteOptions OutputFiles::write_options_for(const std::string& path) const {
  WriteOptions options = write_options();
  const auto knows_parts = [&](const std::string& mesh) {
    WriteOptions in_parts;
    in_parts.msh = "4.1";
    in_parts.parts = 2;
    return can_write("mesh" + extension_of_output(mesh, format_), in_parts).has_value();
  };
  if (options.parts != 1 && !knows_parts(path) &&
      std::any_of(meshes_.begin(), meshes_.end(), knows_parts))
    options.parts = 1;
  return options;
}

Status OutputFiles::plan() {
  planned_.clear();
  for (const std::string& path : meshes_) {
    const WriteOptions options = write_options_for(path);
    Result<Writer> writer =
        path == "-" ? stdout_writer(format_, options) : mesh_writer(path, options);
    if (!writer) return std::move(writer).error();
    planned_.push_back({path, *std::move(writer), false});
  }
  for (const std::string& path : reports_) {
    Result<Writer> writer = report_writer(path, write_options().order);
    if (!writer) return std::move(writer).error();
    planned_.push_back({path, *std::move(writer), true});
  }
  return ok();
}

Status OutputFiles::can_hold_periodic() const {
  Status status = ok();
  for (const std::string& path : meshes_)
    if (status) status = can_write_periodic(path, write_options());
  return status;
}

std::vector<std::string> OutputFiles::warnings(const std::vector<Attribute>& attributes,
                                               std::span<const PlaneField::Array> values_at_points,
                                               std::span<const PeriodicRule> periodic,
                                               const std::vector<std::string>& points) const {
  std::vector<std::string> with_options = meshes_;  // and pages, which draw the mesh
  std::copy_if(reports_.begin(), reports_.end(), std::back_inserter(with_options),
               [](const std::string& path) { return extension_of(path) == ".html"; });
  std::vector<std::string> sentences = formats_.ignored(with_options, format_);
  if (format_option_ != nullptr && format_option_->count() > 0 && !has_stdout())
    sentences.emplace_back("--format does nothing: it counts with '-o -' only");
  const auto names_of = [](const auto& all) {
    std::vector<std::string> names;
    for (const auto& one : all) names.push_back(one.name);
    return names;
  };
  if (!has_manifest()) {
    std::vector<std::string> sides;
    for (const PeriodicRule& rule : periodic) sides.push_back(describe(rule));
    sentences.push_back(lost("attributes", names_of(attributes), attribute_formats()));
    if (!writes(".vtm"))
      sentences.push_back(
          lost("texts", tables_of(attributes), word_formats(), attribute_formats()));
    sentences.push_back(
        lost("pairs on periodic sides", sides, periodic_formats(), write_formats()));
    if (!writes(".vtm"))
      sentences.push_back(
          lost("names of points", first_of_all(points), point_formats(write_options())));
  }
  sentences.push_back(lost("values at points", names_of(values_at_points), value_formats()));
  std::erase_if(sentences, [](const std::string& sentence) { return sentence.empty(); });
  return sentences;
}

std::vector<std::string> OutputFiles::left_beside() const {
  namespace fs = std::filesystem;
  const std::vector<std::string> read = mesh_formats();
  std::set<fs::path> seen;
  for (const std::string& path : paths()) seen.insert(fs::path(path).lexically_normal());
  std::vector<std::string> sentences;
  for (const std::string& path : meshes_) {
    const std::string extension = extension_of(path);
    if (path == "-" || !is_among(read, extension) || extension == ".json") continue;
    for (const char* other : {".json", ".vtm"}) {
      const fs::path beside = fs::path(path).replace_extension(other);
      std::error_code error;
      if (!fs::is_regular_file(beside, error) || !seen.insert(beside.lexically_normal()).second)
        continue;
      // A .vtkhdf needs no blocks, and a .json may be anything.
      if (other == std::string_view(".vtm") ? extension == ".vtkhdf" : !is_manifest(beside))
        continue;
      sentences.push_back(fmt::format(
          "{} stays beside {} as an earlier run left it, and is read with it for {}: remove it, or "
          "write it, too (-o)",
          beside.string(), path, extension == ".vtkhdf" ? "arcs and periodic sides" : "names"));
    }
  }
  return sentences;
}

std::vector<std::string> OutputFiles::warnings_of(const Output& output) const {
  std::vector<std::string> sentences{rounding(output), beyond_axis(output),
                                     lines_left_out(output.table)};
  std::erase_if(sentences, [](const std::string& sentence) { return sentence.empty(); });
  return sentences;
}

std::string OutputFiles::regions_joined(const RegionTable& table) const {
  const std::vector<std::string> decks = inp_files();
  // Regions without a name of their own are told by their material alone.
  std::size_t named = 0;
  std::set<std::pair<std::string, int>> sets;
  for (const Region& region : table.regions) {
    if (region.name == region.material_name) continue;
    ++named;
    sets.emplace(region.name, region.material);
  }
  if (decks.empty() || has_manifest() || sets.size() == named || !write_options().ids.empty())
    return {};
  return fmt::format(
      "{} with names are {} in {}, one for each name and material: --ids region keeps them apart",
      counted(named, "region"), counted(sets.size(), "element set"), listed(decks));
}

bool OutputFiles::writes(std::string_view extension) const {
  return std::any_of(meshes_.begin(), meshes_.end(), [&](const std::string& path) {
    return extension_of_output(path, format_) == extension;
  });
}

std::string OutputFiles::lost(std::string_view what, const std::vector<std::string>& names,
                              const std::vector<std::string>& holding,
                              const std::vector<std::string>& among) const {
  std::vector<std::string> known = among;
  if (known.empty()) {  // a .poly is geometry
    known = write_formats();
    std::erase(known, ".poly");
  }
  std::vector<std::string> without;
  for (const std::string& path : meshes_) {
    const std::string extension = extension_of_output(path, format_);
    if (is_among(known, extension) && extension != ".json" && !is_among(holding, extension))
      without.push_back(name_of(path));
  }
  return not_held(what, names, without, holding);
}

std::vector<std::string> OutputFiles::inp_files() const {
  std::vector<std::string> names;
  for (const std::string& path : meshes_)
    if (extension_of_output(path, format_) == ".inp") names.push_back(name_of(path));
  return names;
}

std::string OutputFiles::rounding(const Output& output) const {
  const std::vector<std::string> decks = inp_files();
  const std::size_t rounded = decks.empty() ? 0 : points_rounded_by_inp(output, write_options());
  if (rounded == 0) return {};
  return fmt::format(
      "{} in {} {} rounded: readers of .inp take 20 characters of a coordinate; other formats keep "
      "all digits",
      counted(rounded, "point"), listed(decks), rounded == 1 ? "is" : "are");
}

std::string OutputFiles::beyond_axis(const Output& output) const {
  const std::vector<std::string> decks = inp_files();
  const std::size_t beyond = decks.empty() ? 0 : points_beyond_axis(output, write_options());
  if (beyond == 0) return {};
  return fmt::format(
      "{} in {} {} x < 0: solvers refuse axisymmetric elements (--inp-element CAX) there, the axis "
      "is x = 0",
      counted(beyond, "point"), listed(decks), beyond == 1 ? "has" : "have");
}

std::string OutputFiles::lines_left_out(const RegionTable& table) const {
  const WriteOptions options = write_options();
  if (options.inner_lines || has_manifest()) return {};
  std::vector<std::string> files, names;
  for (const std::string& path : meshes_) {
    const std::string extension = extension_of_output(path, format_);
    if (counts_with(*find_write_option("no-inner-lines"), extension) &&
        (extension != ".vtk" || options.lines))
      files.push_back(name_of(path));
  }
  for (const Interface& line : table.interfaces)
    if (line.kind == InterfaceKind::contact && line.left != kVoid && line.right != kVoid &&
        !is_among(names, line.name))
      names.push_back(line.name);
  if (files.empty() || names.empty()) return {};
  return fmt::format(
      "named lines with triangles on both sides ({}) are not in {}: --no-inner-lines leaves them "
      "out",
      listed(names), listed(files));
}

Status OutputFiles::write(const Output& output, const std::stop_token& stop, ShowProgress show,
                          spdlog::logger& log) const {
  const auto write_it = [&](const Planned& file) {
    return write_to(file.write, output, file.path, "." + format_, stop);
  };
  return write_each(write_it, show, log);
}

Status OutputFiles::write(const StreamedOutput& streamed, const std::stop_token& stop,
                          ShowProgress show, spdlog::logger& log) const {
  if (!streamed.is_streamed()) return write(streamed.output, stop, show, log);
  WriteOptions options = write_options();
  options.stop = stop;
  const auto write_it = [&](const Planned& file) {
    return file.is_report ? write_report_json(streamed, file.path)
                          : write_streamed_mesh(streamed, file.path, options);
  };
  return write_each(write_it, show, log);
}

Status OutputFiles::write_each(const std::function<Status(const Planned&)>& write,
                               ShowProgress show, spdlog::logger& log) const {
  for (const Planned& file : planned_) {
    ProgressLine line(file.path == "-" ? ShowProgress::off : show);
    line.update({"write", 0, 0});
    Status written = write(file);
    line.clear();
    if (!written) return written;
    log.info("wrote {}", file.path == "-" ? "to standard output" : file.path);
  }
  return ok();
}

}  // namespace cover::app
