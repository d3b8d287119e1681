#include "files/mesh_file.hpp"

#include <filesystem>

#include <cover/read_mesh.hpp>
#include <cover/stored_mesh.hpp>

#include "terminal/console.hpp"

namespace cover::app {

Result<MeshTriangles> read_triangles(const std::string& path, spdlog::logger& log) {
  Result<MeshFile> mesh = read_mesh(path);
  if (!mesh) return std::move(mesh).error();
  if (mesh->second_order)
    log.warn("{}: triangles have six nodes, of which the corners are taken", path);
  if (!mesh->soup.material.empty() || mesh->group.empty())
    return MeshTriangles{std::move(mesh->soup), true, std::move(mesh->middles), mesh->cut_vertices,
                         mesh->parts};
  StoredMesh stored;
  stored.soup = std::move(mesh->soup);
  const Result<bool> named =
      read_manifest(std::filesystem::path(path).replace_extension(".json"), mesh->group, stored);
  if (named && *named)
    return MeshTriangles{std::move(stored.soup), true, std::move(mesh->middles), mesh->cut_vertices,
                         mesh->parts};
  if (!named) log.warn("{}", named.error().message);
  stored.soup.region.clear();
  stored.soup.material = mesh->group;
  return MeshTriangles{std::move(stored.soup), false, std::move(mesh->middles), mesh->cut_vertices,
                       mesh->parts};
}

}  // namespace cover::app
