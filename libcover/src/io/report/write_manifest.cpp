// The manifest, as JSON with one region, group or line per line of text. It holds no times, so that
// equal meshes have equal manifests; times stand in the report. Angles are in degrees, vertices
// count from 0 in the order of the mesh.
//
// { "format": "cover mesh manifest", "format_version": 1, "cover": version, "source": the input's
// file as it was named, "unit", "scale": what its coordinates were multiplied by, "options": {
// name: value }: the method, and what differs from its default; each of them where it is known,
// "order", "ids": WriteOptions::ids, where set, "counts": { "points", "vertices", "input_vertices",
// "cut_vertices", "steiner_vertices", "triangles", "lines", "regions" }; of the input_vertices so
// many cut segments, steiner_vertices are all others, "quality": QUALITY, "region_groups": [ {
// "tag", "name": in .vtk and .obj, "original", "label": in formats with UTF-8, and "set": in .inp,
// each if it is not the name, "material" } ], "line_groups": [ the same, without "material" ],
// "regions": [ { "id", "name", "material", "material_name", "group": tag, "triangles", "area": with
// straight edges, "curved_area": of "order" 2 where there are arcs, inside edges through the middle
// nodes, "quality": QUALITY, "gamma_opt", "bound_held" } ], "lines": [ { "id" (0: the hull),
// "kind", "name", "left", "right", "group": tag, "length", "edges": [[a, b], ...] with the left
// region on the left, "markers": [of the input, by edge] where there are any, "groups": [tags, by
// edge] instead of "group" where they differ } ], "points": [ as in "line_groups", with "vertices":
// [...] of these names ] where there are any, "attributes": [ { "name": of the array in VTK's
// files, .msh and .xdmf, "original" if it is not that, "words": of text, what the numbers of the
// array mean, from 1 on, "values": [by region; null: none] } ] where there are any, "fields": [ {
// "name": of the array at points, "original" } ] where there are any, "periodic": [ { "from", "to":
// names, "map": "translation", "rotation", "mirror" or "glide reflection", "matrix": [[xx, xy, x0],
// [yx, yy, y0]], which takes "from" to "to", "centre", "angle": of a rotation, "vertices": [[a, its
// image], ...], "edges": [[a, b, their images], ...] } ] where there are any, "arcs": [ { "centre",
// "radius", "edges": [[a, b], ...], the shorter arcs between these vertices, "straight": those of
// "order" 2 that are straight since triangles beside them would not be proven valid } ] where there
// are any, "warnings": [sentences] }
//
//   QUALITY  { "largest_angle", "smallest_angle", "obtuse", "above_120", "above_150" }
//
// "quality", "gamma_opt" and "bound_held" are left out for a mesh that was read from a file.
// Tested by tests/unit/io/report/write_manifest_test.cpp.
#include <algorithm>

#include <nlohmann/json.hpp>

#include <cover/curved_mesh.hpp>
#include <cover/mesh.hpp>
#include <cover/mesh_view.hpp>
#include <cover/text.hpp>

#include "base/containers/buckets.hpp"
#include "io/files/text_writer.hpp"
#include "io/report/periodic_json.hpp"
#include "io/report/provenance_json.hpp"
#include "io/write_mesh/check_format.hpp"

namespace cover {
namespace {

using Json = nlohmann::ordered_json;

/// On one line; bytes that are not UTF-8 become U+FFFD.
std::string text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json describe_group(const Group& group, const std::string& set) {
  Json json{{"tag", group.tag}, {"name", group.name}, {"original", group.original}};
  if (group.label != group.name) json["label"] = group.label;
  if (set != group.name) json["set"] = set;
  if (group.material != 0) json["material"] = group.material;
  return json;
}

Json describe_quality(const Quality& quality) {
  return {{"largest_angle", quality.largest_nu.supplement().in_degrees()},
          {"smallest_angle", quality.smallest.in_degrees()},
          {"obtuse", quality.obtuse},
          {"above_120", quality.above_120},
          {"above_150", quality.above_150}};
}

class ManifestWriter {
 public:
  ManifestWriter(const Output& output, const MeshView& view, const std::string& ids,
                 TextWriter& out)
      : output_(output), view_(view), ids_(ids), out_(out) {
    if (!output.pslg.circles.empty()) curved_ = curved_mesh(output);
  }

  void write() {
    out_ << "{\n\"format\": \"cover mesh manifest\",\n\"format_version\": 1,\n";
    provenance();
    member("order", view_.second_order() ? 2 : 1);
    if (!ids_.empty()) member("ids", ids_);
    member("counts", counts());
    if (measured()) member("quality", describe_quality(output_.report.quality));
    list("region_groups", groups(view_.region_groups, abaqus_names(view_.region_groups)));
    const std::vector<std::string> sets = abaqus_names(node_sets(view_));
    list("line_groups", groups(view_.line_groups, sets));
    list("regions", regions());
    list("lines", lines());
    if (!view_.named.empty())
      list("points", points(std::span(sets).subspan(view_.line_groups.size())));
    if (!view_.attributes.empty()) list("attributes", attributes());
    if (!view_.fields.empty()) list("fields", fields());
    if (!output_.periodic.empty()) list("periodic", periodic());
    if (!output_.pslg.circles.empty()) list("arcs", arcs());
    list("warnings", warnings(), true);
    out_ << "}\n";
  }

 private:
  void member(std::string_view name, const Json& value) {
    out_ << '"' << name << "\": " << text(value) << ",\n";
  }

  void provenance() {
    const auto& [source, version, settings] = output_.report.provenance;
    if (!version.empty()) member("cover", version);
    if (!source.empty()) member("source", source);
    if (!output_.report.unit.empty()) member("unit", output_.report.unit);
    member("scale", output_.report.scale);
    if (!settings.empty()) member("options", options_json(output_.report.provenance));
  }

  void list(std::string_view name, const std::vector<Json>& items, bool is_last = false) {
    out_ << '"' << name << "\": [";
    for (std::size_t k = 0; k < items.size(); ++k)
      out_ << (k == 0 ? "\n  " : ",\n  ") << text(items[k]);
    out_ << (is_last ? "]\n" : "],\n");
  }

  /// The report has a line for each region: not so for a mesh that was read from a file.
  [[nodiscard]] bool measured() const {
    return output_.report.regions.size() == output_.table.regions.size();
  }

  [[nodiscard]] Json counts() const {
    std::size_t input_points = 0;
    for (const auto v : output_.mesh.tri().vertices())
      input_points += output_.mesh.input_id(v) >= 0 ? 1 : 0;
    return {{"points", view_.points.size()},
            {"vertices", view_.corners},
            {"input_vertices", input_points},
            {"cut_vertices", view_.cut_vertices},
            {"steiner_vertices", view_.corners - input_points},
            {"triangles", view_.triangles.size()},
            {"lines", view_.lines.size()},
            {"regions", output_.table.regions.size()}};
  }

  static std::vector<Json> groups(const std::vector<Group>& groups,
                                  std::span<const std::string> sets) {
    std::vector<Json> list;
    for (std::size_t g = 0; g < groups.size(); ++g)
      list.push_back(describe_group(groups[g], sets[g]));
    return list;
  }

  [[nodiscard]] std::vector<Json> points(std::span<const std::string> sets) const {
    std::vector<Json> list = groups(view_.point_groups, sets);
    for (Json& json : list) json["vertices"] = Json::array();
    for (std::size_t k = 0; k < view_.named.size(); ++k)
      list[view_.named_group[k]]["vertices"].push_back(view_.named[k]);
    return list;
  }

  [[nodiscard]] std::vector<Json> regions() const {
    std::vector<std::size_t> triangles(output_.table.regions.size());
    for (const RegionId region : view_.region) ++triangles[place_of(region)];
    std::vector<Json> list;
    for (std::size_t r = 0; r < triangles.size(); ++r) {
      const Region& region = output_.table.regions[r];
      Json json{{"id", region.id.value()},
                {"name", region.name},
                {"material", region.material},
                {"material_name", region.material_name},
                {"group", view_.region_groups[view_.region_group[r]].tag},
                {"triangles", triangles[r]},
                {"area", region.area}};
      if (view_.second_order() && !curved_.edges.empty()) json["curved_area"] = curved_.areas[r];
      if (measured()) {
        const RegionReport& report = output_.report.regions[r];
        json["quality"] = describe_quality(report.quality);
        json["gamma_opt"] = report.lowest_nu().supplement().in_degrees();
        json["bound_held"] = report.bound_held;
      }
      list.push_back(std::move(json));
    }
    return list;
  }

  [[nodiscard]] std::vector<Json> lines() const {
    const auto& interfaces = output_.table.interfaces;
    const Buckets edges(interfaces.size() + 1, view_.lines.size(),
                        [&](std::size_t l) { return view_.interface[l].index(); });
    std::vector<Json> list;
    if (!edges[0].empty()) {
      list.push_back({{"id", 0},
                      {"kind", "hull"},
                      {"group", view_.group_of_line(edges[0].front()).tag},
                      {"edges", ends(edges[0])}});
    }
    for (const Interface& line : interfaces) {
      const auto members = edges[line.id.index()];
      if (members.empty()) continue;
      Json json{{"id", line.id.value()},     {"kind", describe(line.kind)}, {"name", line.name},
                {"left", line.left.value()}, {"right", line.right.value()}, {"length", line.length},
                {"edges", ends(members)}};
      add_groups(members, json);
      if (Json marks = markers(members); !marks.empty()) json["markers"] = std::move(marks);
      list.push_back(std::move(json));
    }
    return list;
  }

  /// Pairs of vertices, from 0, with the left region on the left.
  [[nodiscard]] Json ends(std::span<const std::size_t> lines) const {
    Json list = Json::array();
    for (const std::size_t l : lines)
      list.push_back(Json::array({view_.lines[l][0], view_.lines[l][1]}));
    return list;
  }

  /// Lines with boundary markers may be in other groups than the rest of their interface.
  void add_groups(std::span<const std::size_t> lines, Json& json) const {
    Json tags = Json::array();
    for (const std::size_t l : lines) tags.push_back(view_.group_of_line(l).tag);
    if (std::all_of(tags.begin(), tags.end(), [&](const Json& tag) { return tag == tags[0]; })) {
      json["group"] = tags[0];
    } else {
      json["groups"] = std::move(tags);
    }
  }

  /// Boundary markers of the input, by edge; empty where it has none.
  [[nodiscard]] Json markers(std::span<const std::size_t> lines) const {
    Json list = Json::array();
    bool marked = false;
    for (const std::size_t l : lines) {
      list.push_back(view_.marker[l]);
      marked |= view_.marker[l] != 0;
    }
    return marked ? list : Json::array();
  }

  static Json named(const std::string& name, const std::string& original) {
    Json json{{"name", name}};
    if (original != name) json["original"] = original;
    return json;
  }

  [[nodiscard]] std::vector<Json> attributes() const {
    std::vector<Json> list;
    for (std::size_t k = 0; k < view_.attributes.size(); ++k) {
      const Attribute& attribute = view_.attributes[k];
      Json json = named(attribute.name, output_.table.attributes[k].name);
      if (attribute.is_text) json["words"] = attribute.words;
      Json values = Json::array();
      for (const double value : attribute.values)
        values.push_back(!attribute.is_text ? Json(value)
                         : value == 0       ? Json()
                                      : Json(attribute.words[static_cast<std::size_t>(value) - 1]));
      json["values"] = std::move(values);
      list.push_back(std::move(json));
    }
    return list;
  }

  [[nodiscard]] std::vector<Json> fields() const {
    std::vector<Json> list;
    for (std::size_t k = 0; k < view_.fields.size(); ++k)
      list.push_back(named(view_.fields[k].name, output_.fields[k].name));
    return list;
  }

  [[nodiscard]] std::vector<Json> periodic() const {
    std::vector<Json> list;
    for (const PeriodicNodes& nodes : output_.periodic) {
      Json json = periodic_json(nodes);
      json["vertices"] = nodes.vertices;
      json["edges"] = nodes.edges;
      list.push_back(std::move(json));
    }
    return list;
  }

  [[nodiscard]] std::vector<Json> arcs() const {
    const auto& circles = output_.pslg.circles;
    std::vector<Json> edges(circles.size(), Json::array()), straight(edges), list;
    for (const CurvedEdge& edge : curved_.edges) {
      edges[edge.circle].push_back({edge.a, edge.b});
      if (edge.is_straight) straight[edge.circle].push_back({edge.a, edge.b});
    }
    for (std::size_t c = 0; c < circles.size(); ++c) {
      if (edges[c].empty()) continue;
      Json json{{"centre", {circles[c].centre.x, circles[c].centre.y}},
                {"radius", circles[c].radius},
                {"edges", std::move(edges[c])}};
      if (!straight[c].empty()) json["straight"] = std::move(straight[c]);
      list.push_back(std::move(json));
    }
    return list;
  }

  [[nodiscard]] std::vector<Json> warnings() const {
    std::vector<Json> list;
    const auto add = [&](const std::vector<Note>& notes) {
      for (const Note& note : notes) list.emplace_back(note.message);
    };
    add(output_.report.notes);
    for (const RegionReport& region : output_.report.regions) add(region.notes);
    return list;
  }

  const Output& output_;
  const MeshView& view_;
  const std::string& ids_;
  TextWriter& out_;
  CurvedMesh curved_;  ///< where there are arcs
};

}  // namespace

Status write_manifest(const Output& output, const std::string& path, const WriteOptions& options) {
  // It stands beside a file of another format, whose options these are: parts, too.
  if (Status status = check_write_options(options); !status) return status;
  if (Status status = check_mesh(output, path); !status) return status;
  WriteOptions all = options;
  all.inner_lines = true;
  const MeshView view = view_of(output, all);
  return write_text(path, options.stop, [&](TextWriter& out) {
    ManifestWriter(output, view, options.ids, out).write();
  });
}

}  // namespace cover
