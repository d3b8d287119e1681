// Tested by tests/unit/mend/thin_mesh_test.cpp.
#include "mend/thin_mesh.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "mend/effort.hpp"
#include "mend/repairs.hpp"

namespace cover {
namespace {

class Thinning {
 public:
  Thinning(MeshWithUndo& mesh, const ThinEffort& effort)
      : mesh_(mesh),
        repairs_(mesh, {std::min<std::uint64_t>(effort.places_at_most,
                                                effort.places_per_vertex * movable().size()),
                        effort.mending.stop}),
        for_mending_(effort.mending.places_for(mesh.bad())) {}

  void run() {
    mend();
    take_away();
    search();
  }

 private:
  [[nodiscard]] bool is_over() { return repairs_.left().is_over(); }

  [[nodiscard]] std::vector<std::uint32_t> movable() const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t v = 0; v < mesh_.vertices().size(); ++v) {
      if (mesh_.is_there(v) && mesh_.is_movable(v)) found.push_back(v);
    }
    return found;
  }

  /// Bad triangles, where a few more vertices help: first those that few help, as they may be many.
  void mend() {
    std::swap(repairs_.left(), for_mending_);
    for (const std::size_t tries : {effort::mend::kFewTries, effort::mend::kMostTries})
      mend_with_more_vertices(repairs_, tries);
    mend_beyond_worst(repairs_);
    std::swap(repairs_.left(), for_mending_);
  }

  /// Vertices that are not needed at all.
  void take_away() {
    for (bool changed = true; changed && !is_over();) {
      changed = false;
      const std::vector<std::uint32_t> vertices = movable();
      for (auto v = vertices.rbegin(); v != vertices.rend() && !is_over(); ++v) {
        if (!repairs_.without(*v, MostBad::in(mesh_))) continue;
        mesh_.keep();
        changed = true;
      }
    }
  }

  /// Rounds over all vertices, each with its neighbours.
  void search() {
    Random& random = repairs_.random();
    for (int round = 0; !is_over(); ++round) {
      if (round > 0 && mesh_.bad() > 0) mend();
      std::vector<std::uint32_t> vertices = movable();
      if (vertices.empty()) return;
      for (std::size_t k = vertices.size(); k > 1; --k)
        std::swap(vertices[k - 1], vertices[random.below(k)]);
      for (const std::uint32_t v : vertices) {
        if (is_over()) return;
        if (mesh_.is_there(v)) attempt(v, round);
      }
    }
  }

  /// One less in place of a few; now and then as many as before, in other places.
  void attempt(std::uint32_t v, int round) {
    Random& random = repairs_.random();
    const MostBad most = MostBad::in(mesh_);
    const std::size_t together =
        1 + random.below(std::min<std::size_t>(effort::mend::kMostTogether,
                                               2 + static_cast<std::size_t>(round) / 2));
    const auto others_for = [&](int taken) -> Others {
      const bool shake = round > 0 && random.below(3) == 0;
      return {shake ? taken : taken - 1, effort::mend::steps_to_thin(taken, round)};
    };
    if (repairs_.with_others_in_place_of(repairs_.near(v, together), most, others_for))
      mesh_.keep();
  }

  MeshWithUndo& mesh_;
  Repairs repairs_;
  PlacesLeft for_mending_;
};

}  // namespace

BadTriangles thin_mesh(MeshWithUndo& mesh, const ThinEffort& effort) {
  BadTriangles bad{mesh.bad(), 0};
  Thinning(mesh, effort).run();
  bad.after = mesh.bad();
  return bad;
}

}  // namespace cover
