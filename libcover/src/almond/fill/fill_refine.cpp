// Tested by tests/unit/almond/fill/refine_large_angles_test.cpp.
#include "almond/fill/fill_refine.hpp"

#include "almond/fill/refine_large_angles.hpp"
#include "cdt/cdt.hpp"
#include "target/refine_budget.hpp"

namespace cover {
namespace {

class RefineFiller : public Filler {
 public:
  explicit RefineFiller(std::size_t factor) : factor_(factor) {}

  [[nodiscard]] Filling fill(const FillTask& task, std::stop_token stop) const override {
    std::vector<IndexPair> pairs;
    for (const Chord& chord : task.chords) pairs.push_back({chord.a, chord.b});
    Triangulation cdt = triangulate_domain(task.points, pairs).triangulation;
    ChordEdges edges;
    Filling filling;
    filling.target_reached = match_chords(cdt, task.chords, edges).empty();
    if (!filling.target_reached) {
      filling.remark = "the chords do not bound a domain";
      return filling;
    }
    Refinement refinement = refine_large_angles(
        cdt, edges, task.chords, {kRefineTarget, 0, factor_ * refine_budget(task.points.size())},
        std::move(stop));
    filling.target_reached = refinement.target_reached;
    if (!filling.target_reached) filling.remark = "an angle above 145 degrees could not be refined";
    filling.splits = std::move(refinement.splits);
    filling.added.assign(cdt.points.begin() + static_cast<std::ptrdiff_t>(task.points.size()),
                         cdt.points.end());
    for (const Triangle& f : cdt.triangles) filling.triangles.push_back(f.v);
    return filling;
  }

 private:
  std::size_t factor_;
};

}  // namespace

std::unique_ptr<Filler> make_refine_filler(std::size_t factor) {
  return std::make_unique<RefineFiller>(factor);
}

}  // namespace cover
