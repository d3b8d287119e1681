// A mesh as the files that cover writes hold it, and back to what cover_mesh() returns.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <cover/ids.hpp>
#include <cover/output.hpp>
#include <cover/plane_field.hpp>
#include <cover/pslg.hpp>
#include <cover/regions.hpp>
#include <cover/result.hpp>
#include <cover/triangle_soup.hpp>

namespace cover {

/// An edge on an interface.
struct StoredEdge {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  InterfaceId interface;  ///< where StoredMesh::interfaces has any
  int marker = 0;
  std::uint32_t name = 0;  ///< of a contact, index into StoredMesh::names; 0: none
};

/// Edges that are chords of one circle.
struct StoredArc {
  ArcCircle circle;
  std::vector<std::array<std::uint32_t, 2>> edges;
};

/// Triangles with what belongs to them.
struct StoredMesh {
  TriangleSoup soup;                   ///< with the region and the material of every triangle
  std::size_t input_vertices = 0;      ///< so many of the first vertices are no Steiner vertices
  std::size_t cut_vertices = 0;        ///< the last of these, put on segments, if known
  std::vector<Region> regions;         ///< by RegionId - 1; empty: to be made up from the triangles
  std::vector<Interface> interfaces;   ///< by InterfaceId - 1, without their segments; or empty
  std::vector<std::string> names{""};  ///< of contacts, where there are no interfaces
  std::vector<StoredEdge> edges;       ///< of all interfaces
  std::vector<NamedPoint> points;      ///< that have names, with their numbers in `soup`
  std::vector<PeriodicNodes> periodic;
  std::vector<StoredArc> arcs;
  std::vector<Attribute> attributes;      ///< as RegionTable::attributes
  std::vector<PlaneField::Array> fields;  ///< as Output::fields
  RegionValues region_values;             ///< as Output::region_values
  Provenance provenance;                  ///< and unit and scale: as in Report
  std::string unit;
  double scale = 1;
  bool second_order = false;  ///< the file's triangles have six nodes, of which these are corners
  std::vector<MovedNode> nodes;  ///< of these: as Output::nodes
};

/// Puts a stored mesh together again. The PSLG stays empty and so do the reports of the regions:
/// no file keeps them. Areas and lengths are measured.
///
/// Where `regions` is empty, regions are named after their materials; where `interfaces` is empty,
/// the edges, and every edge between different regions or beside the void, lie on interfaces made
/// up from their names and sides.
///
/// Errors: syntax, if the arrays are no mesh of regions 1, 2, 3, ...: an index out of range,
///         triangles that share a directed edge, an unknown region or interface, a material of more
///         than 32 bits, an array of another length than there are regions or points, more input or
///         cut vertices than there can be.
/// Cost:   O(n log n)
Result<Output> rebuild(const StoredMesh& stored);

/// Fills everything but the triangles of `stored`, and the values of its fields, from a manifest;
/// false, and nothing is changed, if the file is not there or is something else (a report, a
/// geometry). Where the mesh's file does not say to which regions triangles belong, their groups
/// and their order do: within a group they stand by region.
///
/// REQUIRES: stored.soup holds the mesh; `group` by triangle, or empty where materials are known
/// Errors:   cannot_open; syntax, also if the manifest is of another mesh
Result<bool> read_manifest(const std::string& path, std::span<const std::int64_t> group,
                           StoredMesh& stored);

}  // namespace cover
