#include "mesh_file.hpp"

#include <filesystem>

#include <cover/read_mesh.hpp>

#include "console.hpp"

namespace cover::app {

Result<TriangleSoup> read_triangles(const std::string& path, spdlog::logger& log) {
  if (std::filesystem::path(path).extension() == ".vtm") {
    const Result<Output> whole = read_output(path);
    if (!whole) return whole.error();
    log_notes(log, whole->report.notes);
    return triangle_soup(whole->mesh);
  }
  Result<MeshFile> mesh = read_mesh(path);
  if (!mesh) return std::move(mesh).error();
  if (mesh->second_order)
    log.warn("{}: triangles have six nodes, of which the corners are taken", path);
  if (mesh->soup.material.empty() && !mesh->group.empty()) {
    if (const Result<Output> known = read_output(path)) return triangle_soup(known->mesh);
    mesh->soup.material = mesh->group;
  }
  return std::move(mesh->soup);
}

}  // namespace cover::app
