// Tested by tests/unit/io/report/write_manifest_test.cpp.
#include "io/report/provenance_json.hpp"

namespace cover {

using Json = nlohmann::ordered_json;

Json options_json(const Provenance& provenance) {
  Json options = Json::object();
  for (const Provenance::Setting& setting : provenance.settings) {
    Json& value = options[setting.name];
    if (value.is_null()) {
      value = setting.value;
    } else if (value.is_array()) {
      value.push_back(setting.value);
    } else {
      value = Json::array({value, setting.value});
    }
  }
  return options;
}

std::vector<Provenance::Setting> options_of(const Json& json) {
  std::vector<Provenance::Setting> settings;
  for (const auto& [name, value] : json.items()) {
    for (const Json& one : value.is_array() ? value : Json::array({value}))
      settings.push_back({name, one});
  }
  return settings;
}

}  // namespace cover
