// Tested by tests/cli/mesh_options_test.py.
#include "commands/check/layer_rows.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/core.h>

#include <cover/option_table.hpp>
#include <cover/verify_layers.hpp>

#include "commands/exit_code.hpp"
#include "words/check_text.hpp"

namespace cover::app {
namespace {

/// What `text` asks of layers: a line, and what they should be like where it has numbers.
struct LayersAsked {
  LayerRule rule;
  bool has_numbers = false;
  std::size_t number = 0;  ///< among all rules, if it has numbers
};

/// LINE[@REGION][=first,growth[,count]], as the option of mesh takes it.
Result<LayersAsked> layers_asked(const std::string& text) {
  const OptionEntry& entry = *find_option("layers");
  Options options;
  Status status = entry.set(entry, text, options);
  if (status) return LayersAsked{options.layers.front(), true};
  // Without numbers a line is all that there is; any will do to read it.
  if (entry.set(entry, text + "=1,1,1", options)) return LayersAsked{options.layers.front(), false};
  return std::move(status).error();
}

/// All that --layers asks, and the rules that count.
struct LayerWishes {
  std::vector<LayersAsked> asked;
  std::vector<LayerRule> rules;  ///< of those for one side of a line the last counts
};

/// What `lines` ask, after `known`, the rules of the input.
Result<LayerWishes> layer_wishes(const std::vector<std::string>& lines,
                                 const std::vector<LayerRule>& known) {
  LayerWishes wishes{{}, known};
  for (const std::string& line : lines) {
    Result<LayersAsked> asked = layers_asked(line);
    if (!asked) return std::move(asked).error();
    asked->number = wishes.rules.size();
    if (asked->has_numbers) wishes.rules.push_back(asked->rule);
    wishes.asked.push_back(*std::move(asked));
  }
  return wishes;
}

/// Whether the rows are those of the rule.
bool are_as_asked(const LayersFound& layers, const LayerRule& rule) {
  constexpr double kSame = 1e-3;  // of a layer's thickness: so much alike are cells of one row
  const auto is_first = [&](double thickness) {
    return std::abs(thickness - rule.first) <= kSame * rule.first;
  };
  return layers.layered > 0 && is_first(layers.first_least) && is_first(layers.first_most) &&
         layers.most >= rule.count;
}

}  // namespace

Result<int> print_layers(const CutInput& cut, const std::vector<std::string>& lines,
                         const std::vector<LayerRule>& known, const TriangleSoup& mesh,
                         bool quiet) {
  const Result<LayerWishes> wishes = layer_wishes(lines, known);
  if (!wishes) return wishes.error();
  const std::vector<LayerRule>& rules = wishes->rules;
  int code = exit_ok;
  for (const LayersAsked& asked : wishes->asked) {
    const LayerRule& rule = asked.rule;
    Result<std::vector<LayersFound>> found =
        verify_layers(cut.pslg, cut.table, mesh, rule.line, rule.region, rules);
    if (!found) return std::move(found).error();
    for (const LayersFound& layers : *found) {
      const Region& region = cut.table.region(layers.region);
      const LayerRule* counts = layer_rule_for(region, rule.line, rules);
      if (asked.has_numbers && counts != &rules[asked.number]) continue;
      const bool is_met = !asked.has_numbers || are_as_asked(layers, rule);
      if (!is_met) code = exit_unmet;
      if (!is_met || !quiet) fmt::print("{}", layers_text(layers, rule.line, region.name, is_met));
    }
  }
  return code;
}

}  // namespace cover::app
