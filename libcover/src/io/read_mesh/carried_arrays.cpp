// Tested by tests/unit/io/read_mesh/carried_arrays_test.cpp.
#include "io/read_mesh/carried_arrays.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/numbers.hpp"
#include "io/text/array_names.hpp"

namespace cover {
namespace {

/// One value for each region, of the values of its triangles; nothing where they differ.
std::optional<std::vector<double>> by_region(const std::vector<double>& values,
                                             const TriangleSoup& soup) {
  std::vector<double> found;
  std::vector<bool> known;
  for (std::size_t t = 0; t < values.size(); ++t) {
    const auto region = static_cast<std::size_t>(soup.region[t] - 1);
    if (region >= found.size()) {
      found.resize(region + 1, kNoNumber);
      known.resize(region + 1);
    }
    const double value = values[t];
    if (known[region] && found[region] != value &&
        !(std::isnan(found[region]) && std::isnan(value)))
      return std::nullopt;
    found[region] = value;
    known[region] = true;
  }
  return found;
}

/// Makes text of numbers of words, where all are such numbers; numbers they stay else.
void make_text(std::vector<std::string> words, Attribute& attribute) {
  const auto is_word = [&](double value) {
    return std::isnan(value) ||
           (value >= 0 && value == std::floor(value) && value <= static_cast<double>(words.size()));
  };
  attribute.is_text = std::all_of(attribute.values.begin(), attribute.values.end(), is_word);
  if (!attribute.is_text) {
    attribute.words.clear();
    return;
  }
  attribute.words = std::move(words);
  for (double& value : attribute.values)
    if (std::isnan(value)) value = 0;
}

void take_words(const ArrayWords& words, Attribute& attribute) {
  const auto found = words.find(attribute.name);
  if (found != words.end()) make_text(found->second, attribute);
}

/// Numbers of the mesh's own file, and its words where it has some, for an attribute that a file
/// beside it names.
void take_own_values(CellArray own, const ArrayWords& words, Attribute& attribute) {
  attribute.values = std::move(own.values);
  const auto found = words.find(own.name);
  if (found != words.end())
    make_text(found->second, attribute);
  else if (attribute.is_text)
    make_text(std::move(attribute.words), attribute);
}

/// What arrays that a file beside the mesh tells of are called in the mesh's own.
struct KnownNames {
  std::vector<std::string> attributes, fields;
};

KnownNames known_names(const StoredMesh& stored) {
  std::vector<std::string> all;
  for (const Attribute& attribute : stored.attributes) all.push_back(attribute.name);
  for (const PlaneField::Array& field : stored.fields) all.push_back(field.name);
  all = array_names(std::move(all));
  const auto first_field = all.begin() + static_cast<std::ptrdiff_t>(stored.attributes.size());
  return {{all.begin(), first_field}, {first_field, all.end()}};
}

/// The number of the last region; nothing where the triangles cannot have the regions that they
/// say: rebuild() tells what is wrong.
std::optional<std::size_t> last_region(const StoredMesh& stored) {
  const TriangleSoup& soup = stored.soup;
  const auto regions = static_cast<std::int64_t>(stored.regions.size());
  std::int64_t last = regions;
  for (const std::int64_t region : soup.region) {
    if (region < 1 || (regions > 0 && region > regions)) return {};
    last = std::max(last, region);
  }
  const auto found = static_cast<std::size_t>(last);
  if (soup.region.size() != soup.triangles.size() ||
      found > std::max(soup.triangles.size(), stored.regions.size()))
    return {};
  return found;
}

/// Names of attributes that a mesh does not get.
struct AttributesLost {
  std::vector<std::string> mixed;     ///< they differ within a region
  std::vector<std::string> not_held;  ///< the mesh's own file does not have them
};

/// Arrays of triangles become attributes of regions, or the values of known ones.
AttributesLost take_attributes(std::vector<CellArray> of_triangles,
                               const std::vector<std::string>& known, const ArrayWords& words,
                               bool holds_all, StoredMesh& stored) {
  const std::optional<std::size_t> regions = last_region(stored);
  if (!regions) return {};
  AttributesLost lost;
  std::set<std::string> taken;
  std::vector<bool> is_held(known.size(), !holds_all);
  for (CellArray& array : of_triangles) {
    if (is_own_array(array.name) || !taken.insert(array.name).second) continue;
    std::optional<std::vector<double>> values = by_region(array.values, stored.soup);
    if (!values) {
      lost.mixed.push_back(std::move(array.name));
      continue;
    }
    values->resize(*regions, kNoNumber);
    const auto k =
        static_cast<std::size_t>(std::find(known.begin(), known.end(), array.name) - known.begin());
    if (k < known.size()) {
      is_held[k] = true;
      take_own_values({array.name, *std::move(values)}, words, stored.attributes[k]);
      continue;
    }
    stored.attributes.push_back({std::move(array.name), false, {}, *std::move(values)});
    take_words(words, stored.attributes.back());
  }
  for (std::size_t k = known.size(); k-- > 0;) {
    if (is_held[k]) continue;
    const auto attribute = stored.attributes.begin() + static_cast<std::ptrdiff_t>(k);
    // One that differs within a region is told as such.
    if (std::find(lost.mixed.begin(), lost.mixed.end(), known[k]) == lost.mixed.end())
      lost.not_held.insert(lost.not_held.begin(), attribute->name);
    stored.attributes.erase(attribute);
  }
  return lost;
}

bool are_same(const std::vector<double>& some, const std::vector<double>& more) {
  return std::equal(some.begin(), some.end(), more.begin(), more.end(),
                    [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
}

/// Arrays of points become fields, or the values of known ones. What a file beside the mesh said of
/// regions stays where the values are the same. Returns the names of known fields
/// that got none.
std::vector<std::string> take_fields(std::vector<PlaneField::Array> of_points,
                                     RegionValues of_regions, const std::vector<std::string>& known,
                                     StoredMesh& stored) {
  std::set<std::string> taken;
  of_regions.resize(of_points.size());
  RegionValues known_values = std::exchange(stored.region_values, {});
  known_values.resize(known.size());
  for (std::size_t p = 0; p < of_points.size(); ++p) {
    PlaneField::Array& array = of_points[p];
    if (is_own_array(array.name) || !taken.insert(array.name).second) continue;
    const auto place = std::find(known.begin(), known.end(), array.name);
    std::size_t k = stored.fields.size();
    if (place == known.end()) {
      stored.fields.push_back(std::move(array));
    } else {
      k = static_cast<std::size_t>(place - known.begin());
      if (of_regions[p].empty() && are_same(stored.fields[k].values, array.values))
        of_regions[p] = std::move(known_values[k]);
      stored.fields[k].values = std::move(array.values);
    }
    stored.region_values.resize(std::max(stored.region_values.size(), k + 1));
    stored.region_values[k] = std::move(of_regions[p]);
  }
  stored.region_values.resize(stored.fields.size());
  std::vector<std::string> lost;
  for (std::size_t k = known.size(); k-- > 0;) {
    if (!stored.fields[k].values.empty()) continue;
    lost.push_back(stored.fields[k].name);
    stored.fields.erase(stored.fields.begin() + static_cast<std::ptrdiff_t>(k));
    stored.region_values.erase(stored.region_values.begin() + static_cast<std::ptrdiff_t>(k));
  }
  std::reverse(lost.begin(), lost.end());
  const auto has_none = [](const std::vector<RegionValue>& values) { return values.empty(); };
  if (std::all_of(stored.region_values.begin(), stored.region_values.end(), has_none))
    stored.region_values.clear();
  return lost;
}

}  // namespace

std::vector<std::string> take_arrays(std::vector<CellArray> of_triangles,
                                     std::vector<PlaneField::Array> of_points,
                                     const ArrayWords& words, StoredMesh& stored,
                                     bool holds_all_attributes, RegionValues of_regions) {
  const KnownNames known = known_names(stored);
  const AttributesLost attributes = take_attributes(std::move(of_triangles), known.attributes,
                                                    words, holds_all_attributes, stored);
  const std::vector<std::string> lost =
      take_fields(std::move(of_points), std::move(of_regions), known.fields, stored);
  std::vector<std::string> sentences;
  if (!attributes.mixed.empty())
    sentences.push_back(
        fmt::format("arrays of triangles that differ within a region are left out: {}",
                    listed(attributes.mixed)));
  if (!attributes.not_held.empty())
    sentences.push_back(
        fmt::format("the file does not have the attributes that a file beside it names: {}",
                    listed(attributes.not_held)));
  if (!lost.empty())
    sentences.push_back(
        fmt::format("the file does not have the values at points that a file beside it names: {}",
                    listed(lost)));
  return sentences;
}

}  // namespace cover
