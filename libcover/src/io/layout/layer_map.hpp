// Which layers of a layout are read, under which names, and which of them lies on top.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cover/read_options.hpp>
#include <cover/result.hpp>

#include "io/layout/gds_library.hpp"

namespace cover {

/// Layers by number and data type, either of which may be any: "68/20", "68" or "68/*", "*".
struct LayerPattern {
  std::optional<std::int16_t> layer;
  std::optional<std::int16_t> type;
  [[nodiscard]] bool matches(GdsLayer of) const {
    return (!layer || *layer == of.layer) && (!type || *type == of.type);
  }
};

/// Nothing if `text` is no pattern.
std::optional<LayerPattern> parse_layer_pattern(std::string_view text);

/// A layer that is read.
struct NamedLayer {
  std::string name;
  double height = 0;  ///< the higher lies on top
};

/// The choice of layers.
class LayerMap {
 public:
  /// Of ReadOptions::layers and layer_map, whose files it reads. Lines of such a file, and entries
  /// on the command line, are "PATTERN=NAME" or "NAME PATTERN"; '#' begins a comment; the first
  /// that fits a layer counts.
  ///
  /// Errors: cannot_open, syntax, bad_option
  static Result<LayerMap> make(const ReadOptions& options);

  /// Nothing if the layer is left out. Without a map, L68D20, higher numbers on top.
  ///
  /// Cost: O(log n) after the first time for a layer
  const NamedLayer* find(GdsLayer layer);

  /// Layers that find() was asked for and that are left out, in order: all of them, or those that
  /// the map does not have.
  [[nodiscard]] std::vector<GdsLayer> left_out() const;
  [[nodiscard]] std::vector<GdsLayer> not_in_map() const;
  /// Entries of ReadOptions::layers that no layer fits which find() was asked for.
  [[nodiscard]] std::vector<std::string> choices_of_nothing() const;

 private:
  struct Rule {
    LayerPattern pattern;
    std::string name;
  };
  Status add_file(const std::string& path);
  Status add_rule(std::string_view pattern, std::string_view name, const std::string& where);
  [[nodiscard]] std::optional<NamedLayer> decide(GdsLayer layer) const;
  [[nodiscard]] bool is_chosen(GdsLayer layer, const std::string& name) const;
  /// The first rule that fits; null if there is none.
  [[nodiscard]] const Rule* rule_for(GdsLayer layer) const;

  std::vector<Rule> rules_;
  std::vector<std::string> chosen_;  ///< names or patterns; empty: all
  std::map<GdsLayer, std::optional<NamedLayer>> known_;
};

}  // namespace cover
