// Tested by tests/unit/io/layout/layer_map_test.cpp.
#include "io/layout/layer_map.hpp"

#include <algorithm>
#include <limits>

#include <fmt/core.h>

#include "base/words/characters.hpp"
#include "io/text/text.hpp"

namespace cover {
namespace {

/// A number of 16 bits, or any for '*'. False if the text is neither.
bool parse_layer_part(std::string_view text, std::optional<std::int16_t>& part) {
  if (text == "*") return true;
  const std::optional<long> number = parse_integer(text);
  using Limits = std::numeric_limits<std::int16_t>;
  if (!number || *number < Limits::min() || *number > Limits::max()) return false;
  part = static_cast<std::int16_t>(*number);
  return true;
}

/// Of an entry, which is one line.
std::string_view without_blanks(std::string_view text) { return trimmed(text, " \t\r"); }

/// Whether a choice of layers, by name or as a pattern, has that one.
bool fits(const std::string& choice, GdsLayer layer, const std::string& name) {
  const std::optional<LayerPattern> pattern = parse_layer_pattern(choice);
  return choice == name || (pattern && pattern->matches(layer));
}

}  // namespace

std::optional<LayerPattern> parse_layer_pattern(std::string_view text) {
  LayerPattern pattern;
  const std::size_t slash = text.find('/');
  if (!parse_layer_part(without_blanks(text.substr(0, slash)), pattern.layer)) return std::nullopt;
  if (slash != std::string_view::npos &&
      !parse_layer_part(without_blanks(text.substr(slash + 1)), pattern.type))
    return std::nullopt;
  return pattern;
}

Result<LayerMap> LayerMap::make(const ReadOptions& options) {
  LayerMap map;
  map.chosen_ = options.layers;
  for (const std::string& entry : options.layer_map) {
    const std::size_t equals = entry.find('=');
    const Status status = equals == std::string::npos
                              ? map.add_file(entry)
                              : map.add_rule(std::string_view(entry).substr(0, equals),
                                             std::string_view(entry).substr(equals + 1), "");
    if (!status) return status.error();
  }
  return map;
}

Status LayerMap::add_rule(std::string_view pattern, std::string_view name,
                          const std::string& where) {
  const std::optional<LayerPattern> parsed = parse_layer_pattern(pattern);
  if (parsed && !without_blanks(name).empty()) {
    rules_.push_back({*parsed, std::string(without_blanks(name))});
    return ok();
  }
  const std::string what = fmt::format("'{}={}' is not LAYER/DATATYPE=NAME, as 68/20=met1",
                                       legible(pattern), legible(name));
  return Error{
      where.empty() ? ErrorCode::bad_option : ErrorCode::syntax,
      where.empty() ? fmt::format("layer-map: {}", what) : fmt::format("{}: {}", where, what),
      {},
      {}};
}

Status LayerMap::add_file(const std::string& path) {
  const Result<std::string> text = read_file(path);
  if (!text) return text.error();
  std::string_view rest = *text;
  for (int line = 1; !rest.empty(); ++line) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view entry = rest.substr(0, end);
    rest.remove_prefix(std::min(rest.size(), end + 1));
    entry = without_blanks(entry.substr(0, entry.find('#')));
    if (entry.empty()) continue;
    std::size_t cut = entry.find('=');
    std::string_view pattern = entry.substr(0, cut);
    std::string_view name = cut == std::string_view::npos ? "" : entry.substr(cut + 1);
    if (cut == std::string_view::npos) {  // NAME PATTERN
      cut = entry.find_last_of(" \t");
      pattern = cut == std::string_view::npos ? entry : entry.substr(cut + 1);
      name = cut == std::string_view::npos ? "" : entry.substr(0, cut);
    }
    const Status status = add_rule(pattern, name, fmt::format("{}:{}", path, line));
    if (!status) return status;
  }
  if (!rules_.empty()) return ok();
  return Error{ErrorCode::syntax, fmt::format("{}: no layer in it", path), {}, {}};
}

bool LayerMap::is_chosen(GdsLayer layer, const std::string& name) const {
  return chosen_.empty() ||
         std::any_of(chosen_.begin(), chosen_.end(),
                     [&](const std::string& choice) { return fits(choice, layer, name); });
}

const LayerMap::Rule* LayerMap::rule_for(GdsLayer layer) const {
  const auto rule = std::find_if(rules_.begin(), rules_.end(), [&](const Rule& candidate) {
    return candidate.pattern.matches(layer);
  });
  return rule == rules_.end() ? nullptr : &*rule;
}

std::optional<NamedLayer> LayerMap::decide(GdsLayer layer) const {
  NamedLayer own{fmt::format("L{}D{}", layer.layer, layer.type),
                 65536.0 * layer.layer + layer.type};
  if (!rules_.empty()) {
    const Rule* rule = rule_for(layer);
    if (rule == nullptr) return std::nullopt;
    own = {rule->name, static_cast<double>(rule - rules_.data())};
  }
  return is_chosen(layer, own.name) ? std::optional(own) : std::nullopt;
}

const NamedLayer* LayerMap::find(GdsLayer layer) {
  auto known = known_.find(layer);
  if (known == known_.end()) known = known_.emplace(layer, decide(layer)).first;
  return known->second ? &*known->second : nullptr;
}

std::vector<GdsLayer> LayerMap::left_out() const {
  std::vector<GdsLayer> layers;
  for (const auto& [layer, name] : known_)
    if (!name) layers.push_back(layer);
  return layers;
}

std::vector<GdsLayer> LayerMap::not_in_map() const {
  std::vector<GdsLayer> layers = left_out();
  std::erase_if(layers, [&](GdsLayer layer) { return rule_for(layer) != nullptr; });
  return layers;
}

std::vector<std::string> LayerMap::choices_of_nothing() const {
  std::vector<std::string> unmet;
  for (const std::string& choice : chosen_) {
    const bool is_met = std::any_of(known_.begin(), known_.end(), [&](const auto& known) {
      return fits(choice, known.first, known.second ? known.second->name : "");
    });
    if (!is_met) unmet.push_back(choice);
  }
  return unmet;
}

}  // namespace cover
