// Tested by tests/unit/mend/mend_mesh_test.cpp.
#include "mend/mend_mesh.hpp"

#include <algorithm>

#include "mend/effort.hpp"

namespace cover {
namespace {

constexpr std::size_t kForOneBeyond = 4;  ///< bad triangles in place of one beyond the worst

/// `change` for each triangle, while there are places left. The mesh may grow meanwhile.
template <typename Change>
void for_each_triangle(Repairs& repairs, Change change) {
  for (std::uint32_t t = 0; t < repairs.mesh().triangles().size() && !repairs.left().is_over(); ++t)
    change(t);
}

/// Whether a round of `change` has made `count` smaller, and there are places left.
template <typename Count, typename Change>
void while_fewer(Repairs& repairs, Count count, Change change) {
  for (std::size_t before = count() + 1; count() < before && !repairs.left().is_over();) {
    before = count();
    change();
  }
}

/// By cuts through whole layers, or else by others in place of vertices that are near.
void mend_in_any_way(Repairs& repairs, std::uint32_t t, std::uint64_t places) {
  MostBad most = MostBad::in(repairs.mesh());
  --most.bad;
  if (!repairs.with_cuts(t, most)) repairs.with_other_vertices(t, most, places);
  repairs.mesh().keep();
}

/// A triangle that is gravely bad may at worst become one whose coupling at a piece has the wrong
/// sign.
void mend_one(Repairs& repairs, std::uint32_t t, std::uint64_t places_per_sign,
              std::uint64_t places_per_bad) {
  MostBad most = MostBad::in(repairs.mesh());
  const bool is_grave = repairs.is_grave(t);
  const auto mended = [&](std::uint64_t places) {
    return repairs.with_more_vertices(t, most, effort::mend::kFewTries) ||
           repairs.with_fewer_vertices(t, most) || repairs.with_other_vertices(t, most, places);
  };
  most.by_sign_only = most.bad - most.grave;
  most.grave -= is_grave ? 1 : 0;
  --most.bad;
  if (!mended(places_per_sign) && is_grave) {
    most.by_sign_only = ++most.bad;
    mended(places_per_bad);
  }
  repairs.mesh().keep();
}

}  // namespace

void mend_with_more_vertices(Repairs& repairs, std::size_t tries) {
  MeshWithUndo& mesh = repairs.mesh();
  std::size_t in_vain = 0;
  for_each_triangle(repairs, [&](std::uint32_t t) {
    if (!repairs.is_bad(t)) return;
    MostBad most = MostBad::in(mesh);
    --most.bad;
    const bool is_hopeless = in_vain >= effort::mend::kManyInVain;
    if (repairs.with_more_vertices(
            t, most, is_hopeless ? std::min(tries, effort::mend::kFewTries) : tries)) {
      mesh.keep();
      in_vain = 0;
    } else {
      ++in_vain;
    }
  });
}

void mend_beyond_worst(Repairs& repairs) {
  MeshWithUndo& mesh = repairs.mesh();
  for_each_triangle(repairs, [&](std::uint32_t t) {
    if (!repairs.is_beyond_worst(t)) return;
    MostBad most = MostBad::in(mesh);
    most.bad += kForOneBeyond;
    most.grave += kForOneBeyond;
    --most.beyond_worst;
    if (repairs.with_more_vertices(t, most, effort::mend::kMostTries)) mesh.keep();
  });
}

BadTriangles mend_what_is_left(MeshWithUndo& mesh, const MendEffort& effort) {
  BadTriangles bad{mesh.bad(), 0};
  Repairs repairs(mesh, effort.places_for(mesh.bad()));
  mend_beyond_worst(repairs);
  while_fewer(
      repairs, [&] { return mesh.bad(); },
      [&] {
        mend_with_more_vertices(repairs, effort::mend::kMostTries);
        for_each_triangle(repairs, [&](std::uint32_t t) {
          if (repairs.is_bad(t)) mend_in_any_way(repairs, t, effort.places_per_bad);
        });
      });
  bad.after = mesh.bad();
  return bad;
}

BadTriangles mend_mesh(MeshWithUndo& mesh, const MendEffort& effort,
                       std::uint64_t places_per_sign) {
  BadTriangles bad{mesh.bad(), 0};
  const std::size_t by_sign_only = mesh.bad() - mesh.grave();
  Repairs repairs(
      mesh, {std::min<std::uint64_t>(effort.places_at_most, effort.places_per_bad * mesh.grave() +
                                                                places_per_sign * by_sign_only),
             effort.stop});
  const auto mend = [&](std::uint32_t t) {
    mend_one(repairs, t, places_per_sign, effort.places_per_bad);
  };
  while_fewer(
      repairs, [&] { return mesh.grave(); },
      [&] {
        for_each_triangle(repairs, [&](std::uint32_t t) {
          if (repairs.is_grave(t)) mend(t);
        });
      });
  for_each_triangle(repairs, [&](std::uint32_t t) {
    if (repairs.is_bad_by_a_movable(t)) mend(t);
  });
  bad.after = mesh.bad();
  return bad;
}

}  // namespace cover
