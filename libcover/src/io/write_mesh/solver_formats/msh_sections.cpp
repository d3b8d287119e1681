// Tested by tests/unit/io/write_mesh/solver_formats/write_msh_test.cpp.
#include "io/write_mesh/solver_formats/msh_sections.hpp"

#include <algorithm>

namespace cover {

void MshSections::head_4(const Buckets& curves) {
  out_ << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  names();
  out_ << "$Entities\n"
       << view_.point_groups.size() << ' ' << used(curves) << ' ' << used_surfaces() << " 0\n";
  point_entities();
  curve_entities(curves);
  for (std::size_t g = 0; g < view_.region_groups.size(); ++g)
    if (cells_.triangles(g) > 0) entity(view_.region_groups[g].tag, cells_.box(g));
  out_ << "$EndEntities\n";
}

void MshSections::names() {
  std::vector<std::uint8_t> has_lines(view_.line_groups.size());
  for (const std::uint32_t group : view_.line_group) has_lines[group] = 1;
  const auto lines = std::count(has_lines.begin(), has_lines.end(), 1);
  out_ << "$PhysicalNames\n"
       << view_.point_groups.size() + static_cast<std::size_t>(lines) + view_.region_groups.size()
       << '\n';
  for (const Group& group : view_.point_groups) name(0, group);
  for (std::size_t g = 0; g < view_.line_groups.size(); ++g) {
    if (has_lines[g] != 0) name(1, view_.line_groups[g]);
  }
  for (const Group& group : view_.region_groups) name(2, group);
  out_ << "$EndPhysicalNames\n";
}

void MshSections::name(int dimension, const Group& group) {
  out_ << dimension << ' ' << group.tag << " \"" << group.label << "\"\n";
}

void MshSections::nodes(std::span<const std::uint32_t> nodes) {
  for (const std::uint32_t node : nodes) out_ << ' ' << node + 1;
  out_ << '\n';
}

void MshSections::entity(int tag, const Box& box) {
  out_ << tag;
  corners(box);
  out_ << " 1 " << tag << " 0\n";
}

void MshSections::corners(const Box& box) {
  out_ << ' ' << box.low.x << ' ' << box.low.y << " 0 " << box.high.x << ' ' << box.high.y << " 0";
}

void MshSections::point_entities() {
  for (std::size_t k = 0; k < view_.named.size(); ++k) {
    if (k > 0 && view_.named_group[k] == view_.named_group[k - 1]) continue;
    const int tag = view_.point_groups[view_.named_group[k]].tag;
    out_ << tag << ' ';
    const Point place = cells_.line_point(view_.named[k]);
    out_ << place.x << ' ' << place.y << " 0 1 " << tag << '\n';
  }
}

void MshSections::curve_entities(const Buckets& members) {
  for (std::size_t g = 0; g < view_.line_groups.size(); ++g) {
    if (members[g].empty()) continue;
    Box box;
    for (const std::size_t l : members[g]) {
      for (const std::uint32_t node : view_.lines[l]) box.add(cells_.line_point(node));
    }
    entity(view_.line_groups[g].tag, box);
  }
}

std::size_t MshSections::used_surfaces() const {
  std::size_t n = 0;
  for (std::size_t g = 0; g < view_.region_groups.size(); ++g) n += cells_.triangles(g) > 0 ? 1 : 0;
  return n;
}

std::size_t MshSections::used(const Buckets& entities) {
  std::size_t n = 0;
  for (std::size_t e = 0; e < entities.size(); ++e) n += entities[e].empty() ? 0 : 1;
  return n;
}

void MshSections::block(int dimension, int tag, int type, std::size_t cells) {
  out_ << dimension << ' ' << tag << ' ' << type << ' ' << cells << '\n';
}

RegionId MshSections::region_of_line(std::size_t l) const {
  const InterfaceId interface = view_.interface[l];
  return interface == kNoInterface ? kVoid : table_.interface(interface).left;
}

void MshSections::begin_data(std::string_view of, const std::string& name, std::size_t count) {
  out_ << '$' << of << "Data\n1\n\"" << name << "\"\n1\n0\n3\n0\n1\n" << count << '\n';
}

}  // namespace cover
