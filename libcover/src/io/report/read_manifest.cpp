// Tested by tests/unit/io/read_mesh/read_output_test.cpp.
#include <cover/stored_mesh.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <limits>
#include <map>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "io/read_mesh/complete_mesh.hpp"
#include "io/report/manifest_origin.hpp"
#include "io/report/periodic_json.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

using Json = nlohmann::ordered_json;  // settings keep their order

InterfaceKind kind_of(const std::string& word) {
  if (word == "outline") return InterfaceKind::outline;
  if (word == "slit") return InterfaceKind::slit;
  if (word == "contact") return InterfaceKind::contact;
  return InterfaceKind::interface;
}

Region region_of(const Json& json) {
  Region region;
  region.id = RegionId(json.at("id").get<std::uint32_t>());
  region.name = json.at("name");
  region.material = json.at("material");
  region.material_name = json.at("material_name");
  return region;
}

/// Lines that are not listed, beside as many as are: without a limit, one number would take all
/// memory.
constexpr std::size_t kMostUnlisted = std::size_t{1} << 20U;

std::size_t largest_line(const Json& lines) {
  std::size_t largest = 0;
  for (const Json& line : lines)
    largest = std::max<std::size_t>(largest, line.at("id").get<std::uint32_t>());
  return largest;
}

void add_line(const Json& json, StoredMesh& stored) {
  Interface line;
  line.id = InterfaceId(json.at("id").get<std::uint32_t>());
  if (line.id == kNoInterface) return;  // the hull: no segments
  line.kind = kind_of(json.at("kind"));
  line.name = json.at("name");
  line.left = RegionId(json.at("left").get<std::uint32_t>());
  line.right = RegionId(json.at("right").get<std::uint32_t>());
  const Json markers = json.value("markers", Json::array());
  const Json& edges = json.at("edges");
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const int marker = k < markers.size() ? markers[k].get<int>() : 0;
    stored.edges.push_back({edges[k].at(0), edges[k].at(1), line.id, marker});
  }
  // Lines without an edge in the mesh are not listed, but keep their numbers.
  for (auto k = stored.interfaces.size(); k < line.id.index(); ++k) {
    stored.interfaces.emplace_back();
    stored.interfaces[k].id = InterfaceId(k + 1);
  }
  stored.interfaces[place_of(line.id)] = std::move(line);
}

/// Members whose numbers are ids and counts, and what these may be; all others are as they come.
struct WholeNumbers {
  std::string_view member;
  std::int64_t least;
  std::int64_t most;
};
constexpr std::int64_t kLeastInt = std::numeric_limits<std::int32_t>::min();
constexpr std::int64_t kMostInt = std::numeric_limits<std::int32_t>::max();
constexpr std::int64_t kMostId = std::numeric_limits<std::uint32_t>::max();
constexpr std::array kWholeNumbers{WholeNumbers{"id", 0, kMostId},
                                   WholeNumbers{"left", 0, kMostId},
                                   WholeNumbers{"right", 0, kMostId},
                                   WholeNumbers{"triangles", 0, kMostId},
                                   WholeNumbers{"vertices", 0, kMostId},
                                   WholeNumbers{"input_vertices", 0, kMostId},
                                   WholeNumbers{"edges", 0, kMostId},
                                   WholeNumbers{"cut_vertices", 0, kMostId},
                                   WholeNumbers{"group", kLeastInt, kMostInt},
                                   WholeNumbers{"material", kLeastInt, kMostInt},
                                   WholeNumbers{"markers", kLeastInt, kMostInt}};

bool is_one_of(const Json& number, const WholeNumbers& whole) {
  if (number.is_number_unsigned())
    return number.get<std::uint64_t>() <= static_cast<std::uint64_t>(whole.most);
  return number.is_number_integer() && number.get<std::int64_t>() >= whole.least;
}

/// What is wrong with the first number that is no id or count where one has to be: get() would make
/// one of anything. Empty: nothing. `whole`: what numbers of `json` have to be, if there is that.
std::string wrong_number(const Json& json, std::string_view member, const WholeNumbers* whole,
                         int depth) {
  if (json.is_number() && whole != nullptr && !is_one_of(json, *whole))
    return fmt::format("\"{}\": {} is no whole number from {} to {}", member, json.dump(),
                       whole->least, whole->most);
  if (!json.is_structured() || depth == 0) return {};
  for (const auto& item : json.items()) {
    const WholeNumbers* inner = whole;
    std::string_view name = member;
    if (json.is_object()) {
      name = item.key();
      inner = std::find_if(kWholeNumbers.begin(), kWholeNumbers.end(),
                           [&](const WholeNumbers& known) { return known.member == name; });
      if (inner == kWholeNumbers.end()) inner = nullptr;
    }
    if (std::string what = wrong_number(item.value(), name, inner, depth - 1); !what.empty())
      return what;
  }
  return {};
}

/// A column of attributes as it stands in the mesh: numbers of words for text.
Attribute attribute_of(const Json& json) {
  Attribute attribute;
  attribute.name = json.value("original", json.at("name").get<std::string>());
  attribute.is_text = json.contains("words");
  std::map<std::string, double> number;
  if (attribute.is_text) {
    attribute.words = json.at("words").get<std::vector<std::string>>();
    for (std::size_t k = 0; k < attribute.words.size(); ++k)
      number.emplace(attribute.words[k], static_cast<double>(k + 1));
  }
  for (const Json& value : json.at("values")) {
    if (attribute.is_text)
      attribute.values.push_back(value.is_null() ? 0 : number.at(value.get<std::string>()));
    else
      attribute.values.push_back(value.is_null() ? kNoNumber : value.get<double>());
  }
  return attribute;
}

/// What the mesh was made of and how.
void take_origin(const Json& json, StoredMesh& stored) {
  MeshOrigin origin = origin_of(json);
  stored.provenance = std::move(origin.provenance);
  stored.unit = json.value("unit", "");
  stored.scale = origin.scale;
}

/// Why the manifest is not that of the mesh; empty if it is.
std::string misfit(const Json& json, const StoredMesh& stored) {
  const Json& counts = json.at("counts");
  const TriangleSoup& soup = stored.soup;
  if (counts.at("vertices") != soup.points.size() ||
      counts.at("triangles") != soup.triangles.size()) {
    return fmt::format("it is of another mesh: {} vertices and {} triangles instead of {} and {}",
                       counts.at("vertices").get<std::size_t>(),
                       counts.at("triangles").get<std::size_t>(), soup.points.size(),
                       soup.triangles.size());
  }
  return {};
}

/// The region of each triangle by its place among those of its group; false if the groups of the
/// mesh are not those of the manifest.
bool assign_regions(const Json& regions, std::span<const std::int64_t> group, StoredMesh& stored) {
  struct Share {
    std::int64_t region;
    std::size_t left;
  };
  std::map<std::int64_t, std::deque<Share>> shares;  // by group; one group where there are none
  for (const Json& region : regions) {
    const std::int64_t tag = group.empty() ? 0 : region.at("group").get<std::int64_t>();
    shares[tag].push_back({region.at("id"), region.at("triangles")});
  }
  for (std::size_t t = 0; t < stored.soup.triangles.size(); ++t) {
    auto& queue = shares[group.empty() ? 0 : group[t]];
    while (!queue.empty() && queue.front().left == 0) queue.pop_front();
    if (queue.empty()) return false;
    --queue.front().left;
    stored.soup.region.push_back(queue.front().region);
  }
  return true;
}

}  // namespace

Result<bool> read_manifest(const std::string& path, std::span<const std::int64_t> group,
                           StoredMesh& stored) {
  const auto wrong = [&](const std::string& what) {
    return Error{ErrorCode::syntax, fmt::format("{}: {}", path, what), {}, {}};
  };
  if (!std::filesystem::is_regular_file(path)) return false;
  const Result<std::string> text = read_file(path);
  if (!text) return text.error();
  const Json json = Json::parse(*text, nullptr, false);
  if (!is_manifest(json)) return false;
  try {
    constexpr int kDeepest = 5;  // "lines", a line, "edges", an edge, an end
    if (const std::string what = wrong_number(json, "", nullptr, kDeepest); !what.empty())
      return wrong(what);
    if (const std::string what = misfit(json, stored); !what.empty()) return wrong(what);
    stored.regions.clear();
    stored.interfaces.clear();
    stored.edges.clear();
    stored.points.clear();
    stored.periodic.clear();
    stored.arcs.clear();
    stored.attributes.clear();
    stored.fields.clear();
    take_origin(json, stored);
    const Json& counts = json.at("counts");
    stored.input_vertices = counts.at("input_vertices");
    // Manifests of 0.2.0 do not tell.
    stored.cut_vertices =
        std::max(stored.cut_vertices, counts.value("cut_vertices", std::size_t{}));
    for (const Json& region : json.at("regions")) stored.regions.push_back(region_of(region));
    const Json& lines = json.at("lines");
    if (const std::size_t last = largest_line(lines); last > 2 * lines.size() + kMostUnlisted)
      return wrong(fmt::format("a line has the number {}, and {} are listed", last, lines.size()));
    for (const Json& line : lines) add_line(line, stored);
    for (const Json& named : json.value("points", Json::array()))
      for (const Json& vertex : named.at("vertices"))
        stored.points.push_back({VertexId(vertex.get<std::uint32_t>()), named.at("original")});
    for (const Json& arc : json.value("arcs", Json::array()))
      stored.arcs.push_back({{{arc.at("centre").at(0), arc.at("centre").at(1)}, arc.at("radius")},
                             arc.at("edges").get<decltype(StoredArc::edges)>()});
    for (const Json& attribute : json.value("attributes", Json::array()))
      stored.attributes.push_back(attribute_of(attribute));
    for (const Json& field : json.value("fields", Json::array()))
      stored.fields.push_back({field.value("original", field.at("name").get<std::string>()), {}});
    for (const Json& pair : json.value("periodic", Json::array()))
      stored.periodic.push_back(periodic_of(pair));
    if (stored.soup.region.empty() && !assign_regions(json.at("regions"), group, stored))
      return wrong("it is of another mesh: its groups have other triangles");
  } catch (const Json::exception& error) {
    return wrong(error.what());
  } catch (const std::out_of_range&) {
    return wrong("an attribute has a value that is none of its words");
  }
  for (std::size_t r = 0; r < stored.regions.size(); ++r) {
    if (stored.regions[r].id != RegionId(r + 1)) return wrong("regions are not in order");
  }
  stored.soup.material.clear();  // which may be other numbers, by WriteOptions::ids
  if (!take_materials(stored)) return wrong("it is of another mesh: it lacks regions");
  return true;
}

}  // namespace cover
