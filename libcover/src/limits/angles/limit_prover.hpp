// What no covering mesh of a region can have better, whatever vertices are put into it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <cover/angle.hpp>

#include "base/team.hpp"
#include "cdt/triangulation.hpp"
#include "limits/angles/angle_range.hpp"
#include "limits/angles/angles_around.hpp"
#include "limits/angles/fan_growth.hpp"
#include "limits/angles/region_view.hpp"

namespace cover {

/// The worst angles of a mesh.
struct ReachedAngles {
  Angle largest_nu;  ///< pi minus the largest
  Angle smallest;
};

/// Proven limits of a region. What was reached is no better than they are.
struct ProvenLimits {
  Angle largest_nu;                 ///< no mesh has a larger pi - largest angle
  Angle smallest;                   ///< no mesh whose largest angle is at most pi - under has more
  Angle under;                      ///< as pi minus angle
  Meshes of_largest = Meshes::all;  ///< of which meshes that is proven
  Meshes of_smallest = Meshes::all;
};

/// How hard a limit is looked for, in boxes (about 0.2 us each).
struct ProofEffort {
  std::uint64_t per_side = 10;     ///< for a whole region, times its sides,
  std::uint64_t per_region = 400;  ///< and this
  std::uint64_t per_search = 400;  ///< for one side and one question,
  std::uint64_t at_first = 16;     ///< of which so many before the next side is asked
  bool asks_far = true;            ///< where no limit is near, whether there is one by five degrees
  /// In radians: what is not cut any more lies on the border of what is forbidden, where hardly a
  /// proof needs finer boxes. With 1e-7 all effort proves 11 of 2,000 Voronoi cells fewer: what is
  /// spent there is not left for other sides. With 1e-3 it proves 23 more, but not that squares
  /// leave no angle below 89.9 degrees.
  double smallest_box = 1e-4;

  /// What corners say, without any box: of 2,000 Voronoi cells and 5,000 parcels 16 boxes for a
  /// side prove a tenth more, for a sixth of the time of little effort.
  static ProofEffort brief() { return {0, 0, 0, 0, false, 0}; }
  /// What pays beside a mesh: of 2,000 Voronoi cells, 400 boxes for a side prove 3 limits more.
  static ProofEffort usual() { return {10, 240, 200, 4, false, 1e-3}; }
};

/// Proves limits of one region.
class LimitProver {
 public:
  /// REQUIRES: `cdt` is the constrained Delaunay triangulation of the region; its outer and its
  ///           locked edges are the sides, each of which is an edge of every mesh in question. It
  ///           outlives the prover.
  /// Cost:     O(triangles)
  explicit LimitProver(const Triangulation& cdt, const Team& team = {});

  /// Tells the angles of a covering mesh of this region. A side beside which all of them are in the
  /// range in question is passed over: the triangle that the mesh has there shows that nothing
  /// forbids one.
  void compare_with(AnglesAround mesh) { mesh_ = std::move(mesh); }

  /// Tells of a covering mesh of this region: no question is asked of all that it answers.
  ///
  /// REQUIRES: all its angles are in `angles`
  void has_seen(const AngleRange& angles) { seen_.push_back(angles); }

  /// From now on coupled meshes may have negative couplings on these sides, too, beside those that
  /// a vertex of the region encroaches. Forgets what was answered about them.
  void exempt(std::span<const IndexPair> sides);

  /// pi - gamma_opt: Lemma 1.
  [[nodiscard]] double nu_opt() const { return nu_opt_; }

  /// True: none of `meshes` has all angles in `range`. False: not known.
  ///
  /// EXACT: a proof (docs/limits.md), with kAngleSlack in favour of a mesh
  /// Cost:  O(sides), and the boxes that are taken off `budget`
  bool refutes(AngleRange range, std::uint64_t& budget, const ProofEffort& effort = {},
               Meshes meshes = Meshes::all);

  /// The limits beside what a mesh has reached: of the largest angle where that is above
  /// `wanted.largest_nu` allows, of the smallest one where it is below `wanted.smallest`, among the
  /// meshes whose largest angle is no larger than reached or wanted. Lemma 1 and what follows from
  /// it where nothing better is found.
  ///
  /// What is not proven of all is asked of `meshes`: where that finds a limit, the side that has it
  /// is asked once more whether it is one of all.
  /// REQUIRES: one of `meshes` has reached that
  ProvenLimits prove(const ReachedAngles& reached, const ReachedAngles& wanted,
                     const ProofEffort& effort = {}, Meshes meshes = Meshes::all);

  /// Whether a mesh that has reached that is within a degree of its limits: what prove() says in
  /// full, by its first questions.
  ///
  /// REQUIRES: as prove()
  bool is_near(const ReachedAngles& reached, const ReachedAngles& wanted,
               const ProofEffort& effort = {});

 private:
  class Question;

  /// Which sides are asked: all, or the one alone that settled the last question.
  enum class Asked { all, last };

  /// An answer to remember.
  struct Answer {
    AngleRange range;
    std::uint64_t per_search = 0;  ///< what was tried; of no importance where it was refuted
  };
  /// What was answered of meshes.
  struct Known {
    std::vector<Answer> refuted, open;
  };

  bool refutes(AngleRange range, std::uint64_t& budget, const ProofEffort& effort, Meshes meshes,
               Asked asked);
  std::optional<Meshes> kept_out(const AngleRange& range, std::uint64_t& budget,
                                 const ProofEffort& effort, Meshes meshes, Asked asked);
  [[nodiscard]] bool is_known_to_refute(const AngleRange& range, Meshes meshes) const;
  [[nodiscard]] bool is_known_as_open(const AngleRange& range, const ProofEffort& effort,
                                      Meshes meshes) const;
  bool corners_refute(const FanGrowth& growth, Meshes meshes);
  [[nodiscard]] bool ask_sides(const FanGrowth& growth, std::uint64_t& budget,
                               const ProofEffort& effort, Meshes meshes, Asked asked);
  void ask_worst_first();
  [[nodiscard]] bool is_worth_asking(const RegionSide& side, const AngleRange& range) const;

  RegionView view_;
  Team team_;
  AnglesAround mesh_;  ///< nothing: none is known
  double nu_opt_;
  std::uint32_t last_refuter_ = 0;  ///< the side that settled the last question
  bool has_refuter_ = false;
  std::vector<std::uint32_t> undecided_;
  Known all_, coupled_;
  std::vector<AngleRange> seen_;  ///< angles of covering meshes
};

}  // namespace cover
