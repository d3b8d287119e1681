// Tested by tests/unit/pipeline/periodic_test.cpp.
#include "io/report/periodic_json.hpp"

#include <array>

namespace cover {
namespace {

constexpr std::array kMaps{"translation", "rotation", "mirror", "glide reflection"};

}  // namespace

nlohmann::ordered_json periodic_json(const PeriodicNodes& nodes) {
  const Isometry& m = nodes.map;
  nlohmann::ordered_json json{
      {"from", nodes.rule.from},
      {"to", nodes.rule.to},
      {"map", kMaps.at(static_cast<std::size_t>(nodes.rule.map))},
      {"matrix", {{m.xx[0], m.xy[0], m.x0[0]}, {m.yx[0], m.yy[0], m.y0[0]}}}};
  if (nodes.rule.map != PeriodicRule::Map::rotation) return json;
  json["centre"] = {nodes.rule.centre.x, nodes.rule.centre.y};
  json["angle"] = nodes.rule.angle.in_degrees();
  return json;
}

PeriodicNodes periodic_of(const nlohmann::ordered_json& json) {
  PeriodicNodes nodes;
  nodes.rule.from = json.at("from");
  nodes.rule.to = json.at("to");
  const std::string map = json.at("map");
  for (std::size_t k = 0; k < kMaps.size(); ++k) {
    if (map == kMaps[k]) nodes.rule.map = static_cast<PeriodicRule::Map>(k);
  }
  if (nodes.rule.map == PeriodicRule::Map::rotation) {
    nodes.rule.centre = {json.at("centre").at(0), json.at("centre").at(1)};
    nodes.rule.angle = Angle::degrees(json.at("angle"));
  }
  const auto& matrix = json.at("matrix");
  Isometry& m = nodes.map;
  const std::array rows{std::array{&m.xx, &m.xy, &m.x0}, std::array{&m.yx, &m.yy, &m.y0}};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t k = 0; k < rows[row].size(); ++k) *rows[row][k] = {matrix.at(row).at(k), 0};
  }
  nodes.vertices = json.at("vertices").get<decltype(nodes.vertices)>();
  nodes.edges = json.at("edges").get<decltype(nodes.edges)>();
  return nodes;
}

}  // namespace cover
