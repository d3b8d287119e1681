// Tested by tests/unit/io/read_mesh/carried_arrays_test.cpp.
#include "io/read_mesh/carried_arrays.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

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

/// Makes text of numbers of words, where all are such numbers.
void take_words(const ArrayWords& words, Attribute& attribute) {
  const auto found = words.find(attribute.name);
  if (found == words.end()) return;
  const auto is_word = [&](double value) {
    return std::isnan(value) || (value >= 0 && value == std::floor(value) &&
                                 value <= static_cast<double>(found->second.size()));
  };
  if (!std::all_of(attribute.values.begin(), attribute.values.end(), is_word)) return;
  attribute.is_text = true;
  attribute.words = found->second;
  for (double& value : attribute.values)
    if (std::isnan(value)) value = 0;
}

}  // namespace

std::vector<std::string> take_arrays(std::vector<CellArray> of_triangles,
                                     std::vector<PlaneField::Array> of_points,
                                     const ArrayWords& words, StoredMesh& stored) {
  std::vector<std::string> known;
  for (const Attribute& attribute : stored.attributes) known.push_back(attribute.name);
  for (const PlaneField::Array& field : stored.fields) known.push_back(field.name);
  // What the manifest's arrays are called in the file.
  known = array_names(std::move(known));
  const std::size_t attributes = stored.attributes.size(), fields = stored.fields.size();
  const auto is_valid = [&](std::int64_t region) {
    return region >= 1 &&
           (stored.regions.empty() || region <= static_cast<std::int64_t>(stored.regions.size()));
  };
  const TriangleSoup& soup = stored.soup;
  std::int64_t last = static_cast<std::int64_t>(stored.regions.size());
  for (const std::int64_t region : soup.region) last = std::max(last, region);
  // Else rebuild() tells what is wrong.
  const bool fits =
      soup.region.size() == soup.triangles.size() &&
      std::all_of(soup.region.begin(), soup.region.end(), is_valid) &&
      last <= static_cast<std::int64_t>(std::max(soup.triangles.size(), stored.regions.size()));

  std::vector<std::string> mixed, lost;
  std::set<std::string> taken(known.begin(),
                              known.begin() + static_cast<std::ptrdiff_t>(attributes));
  for (CellArray& array : of_triangles) {
    if (!fits || is_own_array(array.name) || !taken.insert(array.name).second) continue;
    std::optional<std::vector<double>> values = by_region(array.values, soup);
    if (!values) {
      mixed.push_back(std::move(array.name));
      continue;
    }
    values->resize(static_cast<std::size_t>(last), kNoNumber);
    stored.attributes.push_back({std::move(array.name), false, {}, *std::move(values)});
    take_words(words, stored.attributes.back());
  }
  taken.clear();
  for (PlaneField::Array& array : of_points) {
    if (is_own_array(array.name) || !taken.insert(array.name).second) continue;
    const auto place =
        std::find(known.begin() + static_cast<std::ptrdiff_t>(attributes), known.end(), array.name);
    if (place == known.end()) {
      stored.fields.push_back(std::move(array));
    } else {
      stored.fields[static_cast<std::size_t>(place - known.begin()) - attributes].values =
          std::move(array.values);
    }
  }
  for (std::size_t k = 0; k < fields; ++k)
    if (stored.fields[k].values.empty()) lost.push_back(stored.fields[k].name);
  std::erase_if(stored.fields, [](const PlaneField::Array& field) { return field.values.empty(); });

  std::vector<std::string> sentences;
  if (!mixed.empty())
    sentences.push_back(fmt::format(
        "arrays of triangles that differ within a region are left out: {}", listed(mixed)));
  if (!lost.empty())
    sentences.push_back(
        fmt::format("the file does not have the values at points that the "
                    "manifest names: {}",
                    listed(lost)));
  return sentences;
}

}  // namespace cover
