// Tested by tests/unit/app/cut_input_test.cpp, tests/cli/check_test.py.
#include "commands/check/cut_input.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <cover/adopt_cuts.hpp>
#include <cover/read_mesh.hpp>
#include <cover/result.hpp>

namespace cover::app {
namespace {

/// Whether all is well where segments are cut: numbers of materials have no part in that.
bool is_sound_but_for_materials(const Verification& found) {
  return std::all_of(found.violations.begin(), found.violations.end(),
                     [](const Violation& violation) { return violation.promise == 4; });
}

/// Whether segments are no edges, though they are not allowed to be cut.
bool has_split(const Verification& found, const VerifyOptions& verify) {
  const auto is_split = [](const Violation& violation) { return violation.promise == 1; };
  return !verify.allow_split &&
         std::any_of(found.violations.begin(), found.violations.end(), is_split);
}

/// Whether the mesh is sound but for vertices inside segments, angles, and materials.
bool is_split_only(const Prepared& prepared, const TriangleSoup& mesh, VerifyOptions verify) {
  verify.allow_split = true;
  return is_sound_but_for_materials(verify_cover(prepared.pslg, prepared.table, mesh, verify));
}

/// What is found on an input that was cut.
struct CheckedPieces {
  CutInput input;
  Verification found;
};

/// Where a mesh is sound but for materials and for vertices on arcs, which are beside their chords:
/// the input with these vertices, on which all promises hold.
std::optional<CheckedPieces> cut_on_arcs(const Verification& found, const Prepared& prepared,
                                         const TriangleSoup& mesh, const VerifyOptions& verify) {
  if (found.violations.empty() || prepared.pslg.circles.empty()) return std::nullopt;
  CheckedPieces cut{cut_as(prepared, mesh), {}};
  if (cut.input.points == 0) return std::nullopt;
  cut.found = verify_cover(cut.input.pslg, cut.input.table, mesh, verify);
  if (!is_sound_but_for_materials(cut.found)) return std::nullopt;
  return cut;
}

/// What made the run that wrote the mesh cut segments, as its manifest or the mesh itself tells;
/// else empty.
std::string cutting_option(const std::string& path, const MeshTriangles& mesh) {
  std::string by_itself = mesh.cut_vertices > 0 ? "its field data say so" : "";
  const Result<Output> known = read_output(path);
  if (!known) return by_itself;
  if (by_itself.empty() && known->report.input_points < known->pslg.points.size())
    by_itself = "its file says so";
  std::string options;
  for (const auto& [name, value] : known->report.provenance.settings) {
    if (name == "split-interfaces" || name == "box-method" ||
        (name == "method" && value == "nonobtuse"))
      options += fmt::format("{}--{}{}{}", options.empty() ? "" : " ", name,
                             value == "true" ? "" : " ", value == "true" ? "" : value);
  }
  return options.empty() ? by_itself : options;
}

/// Of what is found on a mesh that is sound but for `points` in its segments: each cut one once,
/// and what is found on the input that is cut likewise, materials. All else follows from the cuts.
void keep_cut_segments(Verification& found, const Verification& on_pieces, std::size_t points) {
  std::vector<Violation> cut;
  for (Violation& violation : found.violations) {
    const bool is_cut = violation.promise == 1;
    const bool is_known = std::any_of(cut.begin(), cut.end(), [&](const Violation& other) {
      return std::is_permutation(other.where.begin(), other.where.end(), violation.where.begin(),
                                 violation.where.end());
    });
    if (is_cut && !is_known) cut.push_back(std::move(violation));
  }
  found.violations = std::move(cut);
  found.violations.insert(found.violations.end(), on_pieces.violations.begin(),
                          on_pieces.violations.end());
  found.violation_count =
      on_pieces.segments_whole - points - found.segments_whole + on_pieces.violation_count;
  found.in_void = on_pieces.in_void;
  found.other_ids = on_pieces.other_ids;
}

}  // namespace

CutInput cut_as(const Prepared& prepared, const TriangleSoup& mesh) {
  CutInput cut{prepared.pslg, prepared.table, 0};
  cut.points = adopt_cuts(cut.pslg, cut.table, mesh);
  return cut;
}

std::optional<OwnCuts> take_own_cuts(const std::string& path, const MeshTriangles& mesh,
                                     const VerifyOptions& verify, Prepared& prepared,
                                     Verification& found) {
  std::optional<CheckedPieces> pieces = cut_on_arcs(found, prepared, mesh.soup, verify);
  const bool are_on_arcs = pieces.has_value();
  if (!pieces && !has_split(found, verify)) return std::nullopt;
  const std::string option = cutting_option(path, mesh);
  if (!pieces) {
    pieces = CheckedPieces{cut_as(prepared, mesh.soup), {}};
    pieces->found = verify_cover(pieces->input.pslg, pieces->input.table, mesh.soup, verify);
    // Where another input was meshed, what the run cut would hide what is different.
    const bool is_cut_by_run = !option.empty() && pieces->input.points > 0 &&
                               pieces->found.violation_count < found.violation_count;
    if (!is_cut_by_run && !is_split_only(prepared, mesh.soup, verify)) pieces.reset();
  }
  if (!pieces) return std::nullopt;
  OwnCuts cuts{pieces->input.points, are_on_arcs, true, option, pieces->found.violations.empty()};
  cuts.are_meant = verify.allow_split || !cuts.option.empty();
  if (cuts.are_meant) {
    found = std::move(pieces->found);
    prepared.pslg = std::move(pieces->input.pslg);
    prepared.table = std::move(pieces->input.table);
  } else {
    keep_cut_segments(found, pieces->found, pieces->input.points);
  }
  return cuts;
}

}  // namespace cover::app
