// Tested by tests/unit/cuts/after_meshing/cut_what_is_left_test.cpp.
#include "cuts/after_meshing/cut_what_is_left.hpp"

#include <cstddef>
#include <utility>

#include "cuts/after_meshing/cut_until_met.hpp"
#include "cuts/after_meshing/thin_cuts.hpp"
#include "cuts/boxes/cut_negative_couplings.hpp"

namespace cover {
namespace {

/// Of 62 stacks of layers, with and without --box-method, 3 keep obtuse triangles without this and
/// none with it. With all rounds in the first place none does either, but meshes have 6 % more
/// triangles.
constexpr std::size_t kPointsToTryAgain = 2'000;

}  // namespace

Status cut_what_is_left(Work& work, const Options& options, const Callbacks& callbacks) {
  if (!wants_thinning(work, work.boundaries, options) ||
      work.pslg.points.size() > kPointsToTryAgain || obtuse_triangles(work.meshes) == 0)
    return ok();
  Work again = work;
  if (Status status = cut_until_met(again, options, callbacks, CutUntil::none_is_left); !status)
    return status;
  for (const auto step : {cut_negative_couplings, thin_cuts})
    if (Status status = step(again, options, callbacks); !status) return status;
  if (obtuse_triangles(again.meshes) < obtuse_triangles(work.meshes) &&
      what_is_worse(work.meshes, again.meshes, options).empty())
    work = std::move(again);
  return ok();
}

}  // namespace cover
