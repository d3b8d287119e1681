// A clean input is taken over as it is. Tested by tests/unit/region/pslg_test.cpp.
#include "region/pslg.hpp"

#include <fmt/core.h>

#include <map>

#include "region/check_pslg.hpp"
#include "region/complaint.hpp"

namespace cover {
namespace {

/// The points and segments of a clean input.
Pslg take_over(const Input& input) {
  Pslg pslg;
  pslg.source = input.source;
  pslg.points = input.points;
  for (std::size_t k = 0; k < input.points.size(); ++k) {
    pslg.point_ids.push_back(point_id(input, k));
  }
  pslg.point_markers = input.point_markers;
  pslg.point_markers.resize(input.points.size());
  std::map<std::string, std::uint32_t> name_index{{"", 0}};
  pslg.segments.reserve(input.segments.size());
  for (const InputSegment& s : input.segments) {
    const auto [name, is_new] =
        name_index.emplace(s.name, static_cast<std::uint32_t>(pslg.names.size()));
    if (is_new) pslg.names.push_back(s.name);
    pslg.segments.push_back({VertexId{s.a}, VertexId{s.b}, s.marker, name->second, s.id});
  }
  pslg.seeds = input.seeds;
  pslg.holes = input.holes;
  pslg.void_rule = input.void_rule;
  return pslg;
}

}  // namespace

Result<Pslg> make_pslg(const Input& input, const Options& options, std::vector<Note>&) {
  if (auto error = find_unusable(input)) return *error;
  if (!input.polygons.empty() || !input.lines.empty()) {
    return Error{ErrorCode::unsupported_format,
                 fmt::format("{}: polygons and lines are not read yet", input.source),
                 {},
                 {}};
  }
  if (input.segments.empty() && !options.hull) {
    return Error{
        ErrorCode::no_segments, fmt::format("{}: there are no segments", input.source), {}, {}};
  }
  if (auto error = find_unclean(input)) return *error;
  return take_over(input);
}

}  // namespace cover
