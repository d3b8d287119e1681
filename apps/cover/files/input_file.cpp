#include "files/input_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include <cover/files.hpp>
#include <cover/join_inputs.hpp>
#include <cover/text.hpp>

#include "read_geometry.hpp"

namespace cover::app {
namespace {

/// Groups of a DXF come in pairs of lines, a code and its value; the first begins a section.
bool begins_as_dxf(std::string_view text, std::size_t start) {
  if (text.substr(start, 2) != "0\n" && text.substr(start, 3) != "0\r\n") return false;
  const std::size_t value = text.find_first_not_of(" \t\r\n", start + 1);
  return value != std::string_view::npos && text.substr(value).starts_with("SECTION");
}

std::string_view format_of(std::string_view text) {
  if (text.starts_with(std::string_view("\x00\x06\x00\x02", 4))) return ".gds";
  if (text.starts_with("\x89PNG")) return ".png";
  if (text.starts_with("NRRD")) return ".nrrd";
  // Not read from streams, which is told.
  if (text.starts_with("SQLite format 3")) return ".gpkg";
  if (text.starts_with("fgb")) return ".fgb";
  if (text.starts_with(std::string_view("\x00\x00\x27\x0a", 4))) return ".shp";
  if (text.starts_with("%SEMI-OASIS")) return ".oas";
  if (text.starts_with("h TIF") || text.starts_with(std::string_view("II*\0", 4)) ||
      text.starts_with(std::string_view("MM\0*", 4)))
    return ".tif";
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  const char first = start == std::string_view::npos ? ' ' : text[start];
  if (text.starts_with("# vtk DataFile")) return ".vtk";
  if (text.starts_with("\x89HDF")) return ".vtkhdf";
  if (first == '<') {
    const std::string_view head = text.substr(0, 4096);
    if (head.find("<kml") != head.npos) return ".kml";
    if (head.find("FeatureCollection") != head.npos) return ".gml";
    return ".vtu";  // and VTK's other data sets in XML: their root tells
  }
  if (first == '$') return ".msh";
  if (first == ';' || first == '(') return ".cmd";
  if (start != std::string_view::npos && begins_as_dxf(text, start)) return ".dxf";
  if (text.starts_with("v SUPREM")) return ".str";
  if (text.starts_with("ObjectType")) return ".mha";
  if (text.starts_with("BM")) return ".bmp";
  if (first != '{') return ".poly";
  return text.find("\"Feature") != std::string_view::npos ? ".geojson" : ".json";
}

Result<Input> read_stream(std::istream& stream, const std::string& name, ReadOptions& options) {
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (options.format.empty()) options.format = format_of(text);
  return reading::parse_geometry(text, name, options);
}

/// Messages of the library call options as keywords of programs, `keep_field: ...`.
std::string in_words_of_the_command_line(std::string message) {
  for (const ReadOptionEntry& entry : read_option_table()) {
    std::string keyword(entry.name);
    std::replace(keyword.begin(), keyword.end(), '-', '_');
    const std::size_t place = message.find(": " + keyword + ": ");
    if (message.starts_with(keyword + ": "))
      message.replace(0, keyword.size(), fmt::format("--{}", entry.name));
    else if (place != std::string::npos)
      message.replace(place + 2, keyword.size(), fmt::format("--{}", entry.name));
  }
  return message;
}

/// A pipe, as a shell's <(...), has no extension that would tell its format.
bool is_nameless_pipe(const std::filesystem::path& file) {
  std::error_code ignored;
  return !file.has_extension() && std::filesystem::is_fifo(file, ignored);
}

/// Can be read once, by one process.
bool is_stream(const std::string& path) {
  std::error_code ignored;
  return path == "-" || std::filesystem::is_fifo(path, ignored);
}

}  // namespace

bool is_nameless_stream(const std::string& path) { return path == "-" || is_nameless_pipe(path); }

CLI::Option* GeometryFile::add(CLI::App& command, bool several) {
  for (const ReadOptionEntry& entry : read_option_table()) {
    written_.push_back({&entry, default_text(entry), nullptr, {}, false});
    written_.back().add_to(command, "Input");
  }
  const std::string help = fmt::format(
      "Geometry: {}; '-' is standard input, known by how it begins: any of these but .geo, .oas, "
      ".shp, .gpkg, .fgb, .gml and .kml{}",
      reading::known_formats(),
      several ? "; several files are one geometry, painted in this order" : "");
  CLI::Option* input =
      several ? command.add_option("input", paths_, help)
              : command.add_option_function<std::string>(
                    "input", [this](const std::string& path) { paths_ = {path}; }, help);
  return input->type_name("");
}

std::optional<std::string> GeometryFile::take_last() {
  if (paths_.size() < 2) return std::nullopt;
  std::string last = std::move(paths_.back());
  paths_.pop_back();
  return last;
}

std::string GeometryFile::path() const { return listed(paths_); }

std::vector<NamedFile> GeometryFile::read_files() const {
  std::vector<NamedFile> files;
  for (const std::string& path : paths_) files.push_back({"", path});
  for (const auto& written : written_) {
    if (written.entry->name == "legend")
      for (const std::string& text : written.values) files.push_back({"--legend", text});
    if (written.entry->name != "layer-map") continue;
    for (const std::string& text : written.values)
      if (text.find('=') == std::string::npos) files.push_back({"--layer-map", text});
  }
  return files;
}

Result<Input> GeometryFile::read(unsigned threads, const ReadElsewhere& read_elsewhere) {
  Result<Input> input = read_all(threads, read_elsewhere);
  if (input || input.error().code != ErrorCode::bad_option) return input;
  Error error = std::move(input).error();
  error.message = in_words_of_the_command_line(std::move(error.message));
  return error;
}

Result<Input> GeometryFile::read_all(unsigned threads, const ReadElsewhere& read_elsewhere) {
  options_.threads = threads;
  options_.is_one_of_several = paths_.size() > 1;
  for (const auto& written : written_) {
    for (const std::string& text : written.texts()) {
      // They were checked when the command line was.
      const Status status = written.entry->set(*written.entry, text, options_);
      if (!status) return status.error();
    }
  }
  if (paths_.size() == 1) {
    Result<Input> input = read_one(paths_.front());
    formats_ = {options_.format};
    return input;
  }
  Result<std::vector<Input>> inputs = read_several(read_elsewhere);
  if (!inputs) return inputs.error();
  return join_inputs(*std::move(inputs));
}

Result<std::vector<Input>> GeometryFile::read_several(const ReadElsewhere& read_elsewhere) {
  const std::string format = options_.format;
  const auto read_here = [&](const std::string& path) {
    options_.format = format;  // each file has its own unless one was given
    return read_one(path);
  };
  formats_.clear();
  if (read_elsewhere && std::none_of(paths_.begin(), paths_.end(), is_stream)) {
    for (const std::string& path : paths_)
      formats_.push_back(format.empty() ? extension_of(path) : format);
    return read_elsewhere({paths_, options_}, read_here);
  }
  std::vector<Input> inputs;
  for (const std::string& path : paths_) {
    Result<Input> input = read_here(path);
    if (!input) return input.error();
    formats_.push_back(options_.format);
    inputs.push_back(*std::move(input));
  }
  return inputs;
}

Result<Input> GeometryFile::read_one(const std::string& path) {
  if (path == "-") return read_stream(std::cin, "standard input", options_);
  if (is_nameless_pipe(path)) {
    std::ifstream pipe(path, std::ios::binary);
    return read_stream(pipe, path, options_);
  }
  if (options_.format.empty()) options_.format = extension_of(path);
  return reading::read_geometry(path, options_, stop_);
}

bool GeometryFile::counts(const ReadOptionEntry& entry) const {
  return std::any_of(formats_.begin(), formats_.end(), [&](const std::string& format) {
    ReadOptions options = options_;
    options.format = format;
    return entry.counts(options);
  });
}

std::vector<std::string> GeometryFile::ignored() const {
  std::vector<std::string> sentences;
  for (const auto& written : written_) {
    if (written.option->count() == 0 || written.entry->counts == nullptr || counts(*written.entry))
      continue;
    sentences.push_back(does_nothing(*written.entry));
  }
  return sentences;
}

std::vector<std::string> GeometryFile::other_readings(AboutReading about) const {
  constexpr std::array kOfNames{"material-field", "name-field"};
  constexpr const char* kKept = "keep-field";
  std::vector<std::string> names;
  for (const auto& written : written_) {
    const ReadOptionEntry& entry = *written.entry;
    const bool may_change = entry.name == "scale" || (entry.counts != nullptr && counts(entry));
    const bool is_of_names =
        std::find(kOfNames.begin(), kOfNames.end(), entry.name) != kOfNames.end();
    if (may_change && written.option->count() == 0 && entry.name != kKept &&
        is_of_names == (about == AboutReading::names))
      names.push_back(fmt::format("--{}", entry.name));
  }
  return names;
}

std::vector<Provenance::Setting> GeometryFile::settings() const {
  std::vector<Provenance::Setting> settings;
  for (Provenance::Setting& setting : describe_read_options(options_)) {
    const bool given = std::any_of(written_.begin(), written_.end(), [&](const auto& written) {
      return written.entry->name == setting.name && written.option->count() > 0;
    });
    if (given) settings.push_back(std::move(setting));
  }
  return settings;
}

}  // namespace cover::app
