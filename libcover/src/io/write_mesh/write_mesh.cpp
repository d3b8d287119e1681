// One table says what each extension stands for, so that formats, help texts and errors agree.
// Tested by tests/unit/io/write_mesh/write_mesh_test.cpp.
#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string_view>

#include <cover/curved_mesh.hpp>
#include <cover/files.hpp>
#include <cover/mesh.hpp>
#include <cover/write_mesh.hpp>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/faults/errors.hpp"
#include "base/faults/out_of_memory.hpp"
#include "io/files/temporary_file.hpp"
#include "io/write_mesh/check_format.hpp"
#include "io/write_mesh/partition.hpp"

namespace cover {
namespace {

using Writer = Status (*)(const Output&, const std::string& path, const WriteOptions&);

/// How many files a mesh becomes.
enum class Files { one, several, one_or_parts, one_or_with_hdf5 };

struct Format {
  const char* extension;
  Writer write;
  bool attributes = false;   ///< of regions
  bool words = false;        ///< of text among these; else they are numbered
  bool values = false;       ///< at points
  bool periodic = false;     ///< which vertices are images of each other
  bool points = false;       ///< names of points, or groups of them
  bool numbers = false;      ///< solvers find regions and lines by the numbers of groups
  bool triangles = true;     ///< holds any
  bool second_order = true;  ///< can hold triangles with six nodes, or no triangles at all
  Files files = Files::one;
  std::array<const char*, 2> companions{};  ///< endings of its other files, always there
};

Status write_clean_input(const Output& output, const std::string& path,
                         const WriteOptions& options) {
  if (output.pslg.points.empty()) return check_mesh(output, path);
  return write_poly(output.pslg, output.table, path, options);
}

constexpr std::array kFormats{
    Format{.extension = ".vtu",
           .write = write_vtu,
           .attributes = true,
           .values = true,
           .periodic = true},
    Format{.extension = ".vtm",
           .write = write_vtm,
           .attributes = true,
           .words = true,
           .values = true,
           .periodic = true,
           .points = true,
           .files = Files::several,
           .companions = {""}},
    Format{.extension = ".vtkhdf",
           .write = write_vtkhdf,
           .attributes = true,
           .words = true,
           .values = true,
           .periodic = true,
           .points = true},
    Format{
        .extension = ".vtk", .write = write_vtk, .values = true, .periodic = true, .numbers = true},
    Format{.extension = ".msh",
           .write = write_msh,
           .attributes = true,
           .values = true,
           .periodic = true,
           .points = true,
           .numbers = true,
           .files = Files::one_or_parts},
    Format{.extension = ".pvtu",
           .write = write_pvtu,
           .attributes = true,
           .values = true,
           .periodic = true,
           .files = Files::several,
           .companions = {".parts"}},
    Format{.extension = ".xdmf",
           .write = write_xdmf,
           .attributes = true,
           .values = true,
           .numbers = true,
           .files = Files::one_or_with_hdf5},
    Format{.extension = ".mesh", .write = write_medit, .points = true, .numbers = true},
    Format{.extension = ".inp", .write = write_inp, .points = true},
    Format{.extension = ".ele",
           .write = write_triangle,
           .numbers = true,
           .files = Files::several,
           .companions = {".node", ".edge"}},
    Format{.extension = ".obj", .write = write_obj, .second_order = false},
    Format{.extension = ".off", .write = write_off, .second_order = false},
    Format{.extension = ".ply", .write = write_ply, .second_order = false},
    Format{.extension = ".json",
           .write = write_manifest,
           .attributes = true,
           .words = true,
           .periodic = true,
           .points = true,
           .triangles = false},
    Format{.extension = ".poly", .write = write_clean_input, .triangles = false},
};

const Format* find_format(std::string_view extension) {
  const auto* const found =
      std::find_if(kFormats.begin(), kFormats.end(),
                   [&](const Format& format) { return format.extension == extension; });
  return found != kFormats.end() ? found : nullptr;
}

Result<Format> format_of(const std::string& path) {
  if (const Format* const found = find_format(extension_of(path))) return *found;
  return unknown_output_format(path, write_formats());
}

std::vector<std::string> formats_with(bool (*has)(const Format&)) {
  std::vector<std::string> extensions;
  for (const Format& format : kFormats)
    if (has(format)) extensions.emplace_back(format.extension);
  return extensions;
}

/// Whether there are so many parts.
Status check_parts(const Format& format, const std::string& path, const WriteOptions& options) {
  constexpr int kMostOpen = 500;  // all are open until the last one is on the disk
  if (format.write == write_pvtu) return ok();
  if (format.files != Files::one_or_parts)
    return bad_option(
        fmt::format("cannot write '{}' in parts: .pvtu has some, and .msh 4.1", path));
  if (options.msh != "4.1")
    return bad_option(
        fmt::format("cannot write '{}' in parts: .msh has some in version 4.1", path));
  if (options.parts > kMostOpen)
    return bad_option(fmt::format("cannot write '{}' in more than {} parts", path, kMostOpen));
  return ok();
}

/// Files in XML that name others beside them cannot hold every name of a file.
Status check_name(const Format& format, const std::string& path, const WriteOptions& options) {
  if (format.write != write_vtm && format.write != write_pvtu &&
      (format.write != write_xdmf || options.xdmf != "hdf5"))
    return ok();
  const Result<std::filesystem::path> target = end_of_links(path);
  if (!target) return target.error();
  const std::string name = target->filename();
  if (printable(name) == name) return ok();
  return bad_option(
      fmt::format("cannot write '{}': the XML of {} cannot name files beside it that are "
                  "called so: control characters, or no UTF-8",
                  printable(path), format.extension));
}

Status check_for(const Format& format, const std::string& path, const WriteOptions& options) {
  if (Status status = check_write_options(options); !status) return status;
  if (options.order == 2 && !format.second_order)
    return bad_option(
        fmt::format("cannot write '{}': {} has no second-order triangles", path, format.extension));
  if (Status status = check_name(format, path, options); !status) return status;
  return options.parts == 1 ? ok() : check_parts(format, path, options);
}

/// No solver takes triangles of second order that fold over.
Status check_nodes(const Format& format, const Output& output, const std::string& path,
                   const WriteOptions& options) {
  if (options.order != 2 || !format.triangles) return ok();
  const std::vector<std::uint32_t> folded = curved_mesh(output).not_valid;
  if (folded.empty()) return ok();
  Error error{ErrorCode::cannot_write, {}, {}, {}};
  const TriMesh& mesh = output.mesh.tri();
  for (const auto v : mesh.fv_range(TriMesh::FaceHandle(static_cast<int>(folded[0]))))
    error.where.push_back({mesh.point(v)[0], mesh.point(v)[1]});
  if (output.nodes && !output.nodes->empty()) {
    error.message = fmt::format(
        "cannot write '{}' of second order: with the nodes that were read, {} folded over: {}{}, "
        "{}, {}",
        path, folded.size() == 1 ? "a triangle is" : fmt::format("{} triangles are", folded.size()),
        folded.size() == 1 ? "" : "the first is ", describe(error.where[0]),
        describe(error.where[1]), describe(error.where[2]));
    return error;
  }
  error.message = fmt::format(
      "cannot write '{}' of second order: {} so thin that no doubles serve as nodes of {} edges, "
      "{}that of {}, {}, {}",
      path, folded.size() == 1 ? "a triangle is" : fmt::format("{} triangles are", folded.size()),
      folded.size() == 1 ? "its" : "their", folded.size() == 1 ? "" : "first ",
      describe(error.where[0]), describe(error.where[1]), describe(error.where[2]));
  return error;
}

}  // namespace

Status check_format(std::string_view extension, const Output& output, const std::string& path,
                    const WriteOptions& options) {
  Status status = check_for(*find_format(extension), path, options);
  return status ? check_mesh(output, path) : status;
}

Status check_mesh(const Output& output, const std::string& path) {
  if (output.mesh.triangles() > 0) return ok();
  return Error{ErrorCode::cannot_write,
               fmt::format("cannot write '{}': the output has no triangles; {}", path,
                           output.table.regions.empty()
                               ? "nothing was meshed into it, or it was moved from"
                               : "those of a streamed mesh are on the disk, from where "
                                 "write_streamed_mesh() writes them"),
               {},
               {}};
}

Error unknown_output_format(const std::string& path, std::span<const std::string> known) {
  const std::string extension = extension_of(path);
  return {ErrorCode::unsupported_format,
          fmt::format("cannot write '{}': {}; possible are {}", path,
                      extension.empty() ? "the name has no extension that tells the format"
                                        : fmt::format("unknown format '{}'", extension),
                      listed(known)),
          {},
          {}};
}

std::vector<std::string> write_formats() {
  return formats_with([](const Format&) { return true; });
}

std::vector<std::string> attribute_formats() {
  return formats_with([](const Format& format) { return format.attributes; });
}

std::vector<std::string> word_formats() {
  return formats_with([](const Format& format) { return format.words; });
}

std::vector<std::string> value_formats() {
  return formats_with([](const Format& format) { return format.values; });
}

std::vector<std::string> periodic_formats() {
  return formats_with([](const Format& format) { return format.periodic; });
}

std::vector<std::string> point_formats(const WriteOptions& options) {
  std::vector<std::string> formats =
      formats_with([](const Format& format) { return format.points; });
  if (options.parts != 1) std::erase(formats, ".msh");
  return formats;
}

std::vector<std::string> first_of_all(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 10;
  std::vector<std::string> first;
  std::set<std::string> known;
  for (const std::string& name : names)
    if (known.insert(name).second && known.size() <= kMost) first.push_back(name);
  if (known.size() > kMost) first.back() += fmt::format(" and {} more", known.size() - kMost);
  return first;
}

std::string not_held(std::string_view what, const std::vector<std::string>& names,
                     const std::vector<std::string>& files,
                     const std::vector<std::string>& formats) {
  if (names.empty() || files.empty()) return {};
  return fmt::format("{} ({}) are not in {}: formats that hold them are {}", what, listed(names),
                     listed(files), listed(formats));
}

std::vector<std::string> number_formats() {
  return formats_with([](const Format& format) { return format.numbers; });
}

std::vector<std::string> companions_of(const std::string& path) {
  const Result<Format> format = format_of(path);
  if (!format) return {};
  std::vector<std::string> companions;
  for (const char* ending : format->companions)
    if (ending != nullptr)
      companions.push_back(std::filesystem::path(path).replace_extension(ending).string());
  return companions;
}

Status can_write(const std::string& path, const WriteOptions& options) {
  return memory_as_value(path, [&]() -> Status {
    const Result<Format> format = format_of(path);
    return format ? check_for(*format, path, options) : Status(format.error());
  });
}

Status can_write_periodic(const std::string& path, const WriteOptions& options) {
  const Result<Format> format = format_of(path);
  if (!format || format->write != write_msh || options.parts == 1) return ok();
  return periodic_in_parts(path);
}

bool is_several_files(const std::string& path, const WriteOptions& options) {
  const Result<Format> format = format_of(path);
  if (!format) return false;
  return format->files == Files::several || options.parts > 1 ||
         (format->files == Files::one_or_with_hdf5 && options.xdmf == "hdf5");
}

Status write_mesh(const Output& output, const std::string& path, const WriteOptions& options) {
  return memory_as_value(path, [&]() -> Status {
    if (Status status = can_write(path, options); !status) return status;
    const Result<Format> format = format_of(path);
    if (format->write != write_clean_input) {
      if (Status status = check_mesh(output, path); !status) return status;
    }
    if (Status status = check_nodes(*format, output, path, options); !status) return status;
    return format->write(output, path, options);
  });
}

}  // namespace cover
