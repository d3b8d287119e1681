// Regions share nothing but the ids of their boundary vertices, so joining them is arithmetic on
// numbers: vertices of the PSLG that some region uses come first, then the Steiner vertices of each
// region.
// Tested by tests/unit/mesh/stitch_test.cpp.
#include <cover/mesh.hpp>

#include "mesh/stitch.hpp"

#include <optional>

#include "base/containers/give_back.hpp"
#include "base/containers/unset_vector.hpp"
#include "mesh/find_edges.hpp"
#include "mesh/mesh_builder.hpp"

namespace cover {
namespace {

/// All triangles by global vertex.
struct Gathered {
  UnsetVector<Point> points;              ///< first those of the PSLG
  std::size_t inputs = 0;                 ///< of these
  std::vector<std::size_t> triangles_of;  ///< how many, by region
  std::vector<std::uint32_t> vertex_of;   ///< by VertexId; kNone: not in the mesh
  UnsetVector<IndexTriple> triangles;
};

void number_input_vertices(const Pslg& pslg, std::span<const RegionBoundary> boundaries,
                           Gathered& all) {
  all.vertex_of = input_vertices(pslg, boundaries);
  for (std::size_t v = 0; v < pslg.points.size(); ++v)
    if (all.vertex_of[v] != kNone) all.points.push_back(pslg.points[v]);
  all.inputs = all.points.size();
}

/// Each mesh gives its memory back as soon as it is there.
Gathered gather(const Pslg& pslg, std::span<const RegionBoundary> boundaries,
                std::span<RegionMesh> meshes, const Team& team) {
  Gathered all;
  std::size_t triangles = 0, steiner = 0;
  for (const RegionMesh& mesh : meshes) {
    triangles += mesh.triangles.size();
    steiner += mesh.steiner.size();
    all.triangles_of.push_back(mesh.triangles.size());
  }
  all.triangles.resize(triangles);
  all.points.reserve(pslg.points.size() + steiner);
  number_input_vertices(pslg, boundaries, all);
  std::size_t next = 0;
  for (std::size_t r = 0; r < meshes.size(); ++r) {
    const std::vector<VertexId>& vertices = boundaries[r].vertices;
    const auto first_steiner = static_cast<std::uint32_t>(all.points.size());
    const auto boundary_size = static_cast<std::uint32_t>(vertices.size());
    all.points.insert(all.points.end(), meshes[r].steiner.begin(), meshes[r].steiner.end());
    const auto& own = meshes[r].triangles;
    team.each_range(own.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t) {
        IndexTriple& triangle = all.triangles[next + t];
        for (std::size_t i = 0; i < 3; ++i) {
          const std::uint32_t v = own[t][i];
          triangle[i] = v < boundary_size ? all.vertex_of[vertices[v].index()]
                                          : first_steiner + (v - boundary_size);
        }
      }
    });
    next += own.size();
    give_back(meshes[r].triangles);
    give_back(meshes[r].steiner);
  }
  return all;
}

void set_input_ids(const Gathered& all, const Team& team, Mesh& mesh) {
  const auto handle = [](std::size_t v) { return TriMesh::VertexHandle(static_cast<int>(v)); };
  team.each_range(all.points.size() - all.inputs, kItemsAtATime,
                  [&](std::size_t first, std::size_t last) {
                    for (std::size_t v = first; v < last; ++v)
                      mesh.set_input_id(handle(all.inputs + v), -1);
                  });
  team.each_range(all.vertex_of.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) {
      if (all.vertex_of[v] != kNone)
        mesh.set_input_id(handle(all.vertex_of[v]), static_cast<long>(v));
    }
  });
}

void set_regions(const RegionTable& table, const Gathered& all, const Team& team, Mesh& mesh) {
  std::size_t next = 0;
  for (std::size_t r = 0; r < all.triangles_of.size(); ++r) {
    team.each_range(all.triangles_of[r], kItemsAtATime, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        const TriMesh::FaceHandle face(static_cast<int>(next + k));
        mesh.set_region(face, table.regions[r].id);
        mesh.set_material(face, table.regions[r].material);
      }
    });
    next += all.triangles_of[r];
  }
}

/// Segments that are edges of the mesh, and the last of the half-edges that each is.
struct SegmentEdges {
  std::vector<std::uint32_t> segments;
  std::vector<std::uint32_t> half_edges;  ///< kNone: none after all
};

SegmentEdges find_segments(const Pslg& pslg, const Gathered& all, const Team& team) {
  SegmentEdges found;
  std::vector<std::array<std::uint32_t, 2>> ends;
  for (std::uint32_t s = 0; s < pslg.segments.size(); ++s) {
    const std::uint32_t a = all.vertex_of[pslg.segments[s].a.index()];
    const std::uint32_t b = all.vertex_of[pslg.segments[s].b.index()];
    if (a == kNone || b == kNone) continue;
    ends.push_back({a, b});
    found.segments.push_back(s);
  }
  found.half_edges = find_edges(all.inputs, all.triangles, ends, team);
  return found;
}

void set_segments(const Pslg& pslg, const RegionTable& table, const SegmentEdges& found,
                  const MeshBuilder& builder, const Team& team, Mesh& mesh) {
  const auto set = [&](std::size_t k) {
    if (found.half_edges[k] == kNone) return;
    const std::uint32_t s = found.segments[k];
    const TriMesh::EdgeHandle edge = builder.edge_of(found.half_edges[k]);
    mesh.set_interface(edge, table.sides[s].interface);
    mesh.set_marker(edge, pslg.segments[s].marker);
  };
  team.each_range(found.segments.size(), kItemsAtATime, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) set(k);
  });
}

}  // namespace

std::vector<std::uint32_t> input_vertices(const Pslg& pslg,
                                          std::span<const RegionBoundary> boundaries) {
  std::vector<std::uint32_t> vertex_of(pslg.points.size(), kNone);
  for (const RegionBoundary& boundary : boundaries) {
    for (const VertexId v : boundary.vertices) vertex_of[v.index()] = 0;
  }
  std::uint32_t next = 0;
  for (std::uint32_t& vertex : vertex_of) {
    if (vertex != kNone) vertex = next++;
  }
  return vertex_of;
}

Mesh stitch(const Pslg& pslg, const RegionTable& table, std::vector<RegionBoundary> boundaries,
            std::span<RegionMesh> meshes, const Team& team) {
  const Gathered all = gather(pslg, boundaries, meshes, team);
  give_back(boundaries);
  std::optional<MeshBuilder> builder;
  SegmentEdges segments;
  team.each(2, [&](std::size_t k) {
    if (k == 0) {
      builder.emplace(all.points, all.triangles, team);
    } else {
      segments = find_segments(pslg, all, team);
    }
  });
  Mesh mesh = builder->build(team);
  set_input_ids(all, team, mesh);
  set_regions(table, all, team, mesh);
  set_segments(pslg, table, segments, *builder, team, mesh);
  return mesh;
}

}  // namespace cover
