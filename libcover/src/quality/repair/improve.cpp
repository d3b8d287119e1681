// See improve.hpp. Tested by tests/unit/quality/repair/improve_test.cpp.
#include "quality/repair/improve.hpp"

#include <algorithm>
#include <array>

#include "base/once_queue.hpp"
#include "quality/moves/flip.hpp"
#include "quality/moves/relocate.hpp"
#include "quality/moves/remove.hpp"
#include "quality/moves/restar.hpp"

namespace cover {
namespace {

/// Cheapest first. Inserting only after all others have settled gives 2 % fewer triangles for 12 %
/// more instructions.
constexpr std::array<Move, 4> kMoves{try_flip, try_relocate, try_remove, try_restar};

}  // namespace

ImproveResult improve(MutableMesh& mesh, std::uint64_t budget, std::span<const double> known) {
  ImproveResult result;
  Piece piece(mesh);
  OnceQueue queue;
  const auto enqueue = [&](std::uint32_t t) {
    if (mesh.excess[t] > 0) queue.push(t);
  };
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t >= known.size() || mesh.excess[t] != known[t]) enqueue(t);
  }
  while (!queue.empty()) {
    const std::uint32_t t = queue.pop();
    if (!(mesh.excess[t] > 0)) continue;
    if (piece.evaluations > budget) {
      result.budget_used_up = true;
      break;
    }
    const bool has_moved =
        std::any_of(kMoves.begin(), kMoves.end(), [&](Move move) { return move(piece, t); });
    if (!has_moved) continue;
    for (const std::uint32_t changed : piece.again) enqueue(changed);
    piece.again.clear();
  }
  result.evaluations = piece.evaluations;
  return result;
}

}  // namespace cover
