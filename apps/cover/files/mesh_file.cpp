// Tested by tests/cli/streams_test.py.
#include "files/mesh_file.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include <cover/read_mesh.hpp>
#include <cover/stored_mesh.hpp>
#include <cover/text.hpp>

#include "files/input_file.hpp"
#include "files/temporary_folder.hpp"
#include "terminal/console.hpp"

namespace cover::app {
namespace {

/// Enough of a file to tell its format.
constexpr std::streamsize kHead = 4096;

/// The format of a mesh that is one file, by how it begins; empty: none.
std::string_view format_of_mesh(std::string_view head) {
  if (head.starts_with("\x89HDF")) return ".vtkhdf";
  const std::size_t start = head.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) return "";
  const std::string_view text = head.substr(start);
  if (text.starts_with("# vtk DataFile")) return ".vtk";
  if (text.starts_with("<"))
    return text.find("<VTKFile") != text.npos ? ".vtu"
           : text.find("<Xdmf") != text.npos  ? ".xdmf"
                                              : "";
  if (text.starts_with("$")) return ".msh";
  if (text.starts_with("*")) return ".inp";
  if (text.starts_with("MeshVersionFormatted")) return ".mesh";
  return "";
}

Error system_error(ErrorCode code, const char* what, const std::string& path) {
  const std::string reason = std::generic_category().message(errno);
  return {code, fmt::format("cannot {} {}: {}", what, path, reason), {}, {}};
}

Error no_mesh(const std::string& name) {
  return {ErrorCode::unsupported_format,
          fmt::format("{} begins as no mesh that is one file: .vtu, .vtk, .vtkhdf, .msh, .xdmf, "
                      ".mesh, .inp",
                      name),
          {},
          {}};
}

/// Copies what is left of `stream` to a new file that begins with `head`.
Status copy_to(const std::string& target, std::string_view head, std::istream& stream) {
  std::ofstream file(target, std::ios::binary);
  file.write(head.data(), static_cast<std::streamsize>(head.size()));
  std::vector<char> block(1 << 16);
  while (file && stream) {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    file.write(block.data(), stream.gcount());
  }
  file.close();
  return file ? ok() : Status(system_error(ErrorCode::cannot_write, "write", target));
}

}  // namespace

Result<MeshSource> MeshSource::open(const std::string& given) {
  MeshSource source;
  source.file_ = source.name_ = given;
  if (!is_nameless_stream(given)) return source;
  std::ifstream pipe;
  if (given == "-") {
    source.name_ = "standard input";
  } else {
    pipe.open(given, std::ios::binary);
    if (!pipe) return system_error(ErrorCode::cannot_open, "open", given);
  }
  std::istream& stream = given == "-" ? std::cin : pipe;
  std::string head(std::size_t{kHead}, '\0');
  stream.read(head.data(), kHead);
  head.resize(static_cast<std::size_t>(stream.gcount()));
  const std::string_view format = format_of_mesh(head);
  if (format.empty()) return no_mesh(source.name_);
  Result<ScratchFolder> folder = temporary_folder("cover-stdin");
  if (!folder) return std::move(folder).error();
  source.folder_ = *std::move(folder);
  source.file_ = (source.folder_->path() / "stdin").string() + std::string(format);
  if (Status copied = copy_to(source.file_, head, stream); !copied)
    return std::move(copied).error();
  return source;
}

std::string MeshSource::named(std::string message) const {
  if (!folder_) return message;
  const auto replace_all = [&](const std::string& path, const std::string& word) {
    for (std::size_t at = 0; (at = message.find(path, at)) != std::string::npos; at += word.size())
      message.replace(at, path.size(), word);
  };
  replace_all(file_, name_);
  replace_all(folder_->path().string() + "/", "");  // of files that are looked for beside it
  return message;
}

Error MeshSource::named(Error error) const {
  error.message = named(std::move(error.message));
  return error;
}

void warn_of_corners(const MeshSource& source, spdlog::logger& log) {
  log.warn("{}: triangles have six nodes, of which the corners are taken", source.name());
}

Result<MeshTriangles> read_triangles(const MeshSource& source, spdlog::logger& log) {
  const std::string& path = source.file();
  Result<MeshFile> mesh = read_mesh(path);
  if (!mesh) return source.named(std::move(mesh).error());
  if (mesh->second_order && mesh->middles.empty()) warn_of_corners(source, log);
  MeshTriangles triangles;
  triangles.middles = std::move(mesh->middles);
  triangles.cut_vertices = mesh->cut_vertices;
  triangles.parts = mesh->parts;
  triangles.lines = std::move(mesh->lines);
  triangles.line_names = std::move(mesh->line_names);
  triangles.named_points = std::move(mesh->named_points);
  if (!mesh->soup.material.empty() || mesh->group.empty()) {
    triangles.soup = std::move(mesh->soup);
    return triangles;
  }
  StoredMesh stored;
  stored.soup = std::move(mesh->soup);
  const Result<bool> named =
      read_manifest(std::filesystem::path(path).replace_extension(".json"), mesh->group, stored);
  triangles.soup = std::move(stored.soup);
  if (named && *named) return triangles;
  if (!named) log.warn("{}", named.error().message);
  triangles.has_materials = false;
  triangles.soup.region.clear();
  triangles.soup.material = std::move(mesh->group);
  triangles.group_names = std::move(mesh->region_names);
  return triangles;
}

}  // namespace cover::app
