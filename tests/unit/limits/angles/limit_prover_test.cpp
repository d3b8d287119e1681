// Limits are held to account by meshes: random ones, meshes that climb towards a limit, those of
// the quality method. None may be better than what was proven impossible.
#include "limits/angles/limit_prover.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <span>
#include <string>

#include <gtest/gtest.h>

#include "base/numbers.hpp"
#include "base/run_all.hpp"
#include "cdt/cdt.hpp"
#include "geom/predicates.hpp"
#include "geom/vector.hpp"
#include "support/inputs/random_regions.hpp"
#include "support/inputs/shapes.hpp"

namespace cover {
namespace {

using namespace testing;

constexpr double kPi = std::numbers::pi;

Triangulation cdt_of(const RegionBoundary& boundary) {
  return triangulate_domain(boundary.points, boundary.sides).triangulation;
}

bool refuted(const RegionBoundary& boundary, double most, double least,
             std::uint64_t budget = 20000) {
  const Triangulation cdt = cdt_of(boundary);
  LimitProver prover(cdt);
  return prover.refutes({most * kDegree, least * kDegree}, budget, {0, 0, 20000});
}

/// Any angles of a mesh.
struct Angles {
  double largest = 0;
  double smallest = kPi;
};

Angles angles_of(const Triangulation& mesh) {
  Angles angles;
  for (const Triangle& f : mesh.triangles) {
    for (const Corner i : kCorners) {
      const double x =
          angle_at(mesh.points[f.v[i.next()]], mesh.points[f.v[i]], mesh.points[f.v[i.previous()]]);
      angles.largest = std::max(angles.largest, x);
      angles.smallest = std::min(angles.smallest, x);
    }
  }
  return angles;
}

/// Covering meshes of one region at random.
class RandomMeshes {
 public:
  RandomMeshes(const RegionBoundary& boundary, std::mt19937_64& random)
      : boundary_(boundary), random_(random), plain_(cdt_of(boundary)) {}

  [[nodiscard]] const Triangulation& plain() const { return plain_; }

  double uniform(double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random_);
  }

  Point random_place() {
    const Triangle& f = plain_.triangles[random_() % plain_.triangles.size()];
    double s = uniform(0, 1), t = uniform(0, 1);
    if (s + t > 1) s = 1 - s, t = 1 - t;
    const Point a = plain_.points[f.v[0]];
    return a + s * (plain_.points[f.v[1]] - a) + t * (plain_.points[f.v[2]] - a);
  }

  void start(int vertices) {
    steiner_.clear();
    for (int k = 0; k < vertices; ++k) steiner_.push_back(random_place());
  }

  /// Changes the vertices a little or a lot.
  void change() {
    before_ = steiner_;
    const double what = uniform(0, 1);
    if (what < 0.05 || steiner_.empty()) {
      steiner_.push_back(random_place());
    } else if (what < 0.1) {
      steiner_.erase(steiner_.begin() + static_cast<std::ptrdiff_t>(random_() % steiner_.size()));
    } else {
      Point& p = steiner_[random_() % steiner_.size()];
      double nearest = 1e300;
      for (const Point& q : boundary_.points) nearest = std::min(nearest, length(q - p));
      const double by = nearest * std::pow(10, uniform(-3, 0));
      p = p + Vector{uniform(-by, by), uniform(-by, by)};
    }
  }
  void undo() { steiner_ = before_; }

  /// The mesh with these vertices; none if one of them is not inside.
  std::optional<Triangulation> mesh() {
    std::vector<Point> points = boundary_.points;
    points.insert(points.end(), steiner_.begin(), steiner_.end());
    CdtResult result = triangulate_domain(points, boundary_.sides);
    if (!result.conflicts.empty()) return std::nullopt;
    std::vector<bool> used(points.size());
    for (const Triangle& f : result.triangulation.triangles) {
      for (const std::uint32_t v : f.v) used[v] = true;
    }
    for (std::size_t v = boundary_.points.size(); v < used.size(); ++v) {
      if (!used[v]) return std::nullopt;
    }
    return std::move(result.triangulation);
  }

  /// Flips some inner edges whose quadrilaterals are convex.
  void flip_some(Triangulation& mesh) {
    for (int k = 0; k < 4; ++k) {
      const auto t = static_cast<std::uint32_t>(random_() % mesh.triangles.size());
      const Corner i = static_cast<std::uint32_t>(random_() % 3);
      Triangle& f = mesh.triangles[t];
      const std::uint32_t n = f.n[i];
      if (n == kNone || f.is_locked(i)) continue;
      Triangle& g = mesh.triangles[n];
      const Corner j = g.edge_to(t);
      const std::uint32_t p = f.v[i];
      const std::uint32_t a = f.v[i.next()];
      const std::uint32_t b = f.v[i.previous()];
      const std::uint32_t q = g.v[j];
      const auto& x = mesh.points;
      if (orientation(x[p], x[a], x[q]) != Sign::positive ||
          orientation(x[p], x[q], x[b]) != Sign::positive)
        continue;
      f.v = {p, a, q};
      g.v = {p, q, b};
      return;  // neighbours are not kept up: one flip is enough of a difference
    }
  }

 private:
  const RegionBoundary& boundary_;
  std::mt19937_64& random_;
  Triangulation plain_;
  std::vector<Point> steiner_, before_;
};

/// Pairs of a largest and a smallest angle that are proven impossible together.
std::vector<AngleRange> refuted_ranges(LimitProver& prover, Meshes meshes = Meshes::all) {
  std::vector<AngleRange> ranges;
  const ProofEffort effort{0, 0, 400};
  const double lowest = std::max(kPi - prover.nu_opt(), kPi / 3);
  double previous = 0;
  for (double most = lowest + 1e-6; most < 175 * kDegree; most += 6 * kDegree) {
    double low = 0, high = kPi / 3;
    std::uint64_t budget = 4000;
    if (previous == 0 && prover.refutes({most, 0}, budget, effort, meshes)) {
      ranges.push_back({most, 0});
      continue;
    }
    for (int step = 0; step < 9; ++step) {
      const double middle = (low + high) / 2;
      budget = 4000;
      (prover.refutes({most, middle}, budget, effort, meshes) ? high : low) = middle;
    }
    previous = high;
    if (high < kPi / 3) ranges.push_back({most, high});  // an equilateral triangle has 60 degrees
  }
  return ranges;
}

RegionBoundary random_boundary(std::mt19937_64& random) {
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const int n = 3 + static_cast<int>(random() % 6);
  switch (random() % 7) {
    case 0:
      return boundary_of({random_star(n, 0.3, random)});
    case 1:
      return boundary_of({random_star(n, 0.8, random)});
    case 2: {  // a convex polygon with sides of all lengths
      std::vector<double> turns;
      for (int k = 0; k < n; ++k) {
        turns.push_back(uniform(0, 2 * kPi));
        if (random() % 3 == 0) turns.push_back(turns.back() + std::pow(10, uniform(-2.5, -0.5)));
      }
      std::sort(turns.begin(), turns.end());
      Loop loop;
      for (const double turn : turns) loop.push_back({std::cos(turn), 0.8 * std::sin(turn)});
      return boundary_of({loop});
    }
    case 3: {  // a rectangle with vertices on its sides
      const double h = uniform(0.1, 1);
      Loop loop{{0, 0}};
      if (random() % 2 != 0U) loop.push_back({uniform(0.1, 0.9), 0});
      loop.push_back({1, 0});
      if (random() % 2 != 0U) loop.push_back({1, uniform(0.1, 0.9) * h});
      loop.push_back({1, h});
      if (random() % 2 != 0U) loop.push_back({uniform(0.1, 0.9), h});
      loop.push_back({0, h});
      return boundary_of({loop});
    }
    case 5: {  // a rectangle whose vertices on its sides lie a little inside: almost convex
      const double h = uniform(0.1, 1), in = std::pow(10, uniform(-9, -5));
      return boundary_of({{{0, 0},
                           {uniform(0.02, 0.98), in},
                           {1, 0},
                           {1 - in, uniform(0.02, 0.98) * h},
                           {1, h},
                           {uniform(0.02, 0.98), h - in},
                           {0, h}}});
    }
    case 4:  // a hole, and a point
      return boundary_of({random_star(n, 0.8, random), reversed(regular_polygon(3, 0.2))},
                         {{0.3, 0.31}});
    default: {
      RandomRegion region = random_region(random);
      while (region.boundary.points.size() > 24) region = random_region(random);
      return region.boundary;
    }
  }
}

/// A boundary that encloses a region: the random hole may stick out.
RegionBoundary region_for_brute_force(std::mt19937_64& random) {
  for (;;) {
    RegionBoundary boundary = random_boundary(random);
    const CdtResult cdt = triangulate_domain(boundary.points, boundary.sides);
    if (!cdt.conflicts.empty() || cdt.triangulation.triangles.empty()) continue;
    if (RegionView(cdt.triangulation).sides().size() == boundary.sides.size()) return boundary;
  }
}

/// On a region whose sides are asked ahead: what a team finds is what one thread finds, whether the
/// budget lasts or not.
TEST(LimitProver, ATeamFindsTheSame) {
  std::mt19937_64 random(test_seed(5));
  Loop loop;
  std::uniform_real_distribution<double> radius(0.8, 1);
  for (int k = 0; k < 3000; ++k) {
    const double t = 2 * kPi * k / 3000, r = radius(random);
    loop.push_back({r * std::cos(t), r * std::sin(t)});
  }
  const Triangulation cdt = cdt_of(boundary_of({loop}));
  const auto prove = [&](const Team& team, double reached, std::uint64_t per_side) {
    LimitProver prover(cdt, team);
    const double nu = prover.nu_opt() * reached;
    return prover.prove({Angle::radians(nu), Angle::radians(nu / 40)},
                        {Angle::degrees(80), Angle::degrees(20)}, {per_side, 400, 400, 16});
  };
  for (const double reached : {0.5, 0.9, 1.0}) {
    for (const std::uint64_t per_side : {1U, 10U, 40U}) {
      const ProvenLimits alone = prove({}, reached, per_side);
      run_all(1, 3, [&](std::size_t, const Team& team) {
        const ProvenLimits together = prove(team, reached, per_side);
        EXPECT_EQ(together.largest_nu, alone.largest_nu);
        EXPECT_EQ(together.smallest, alone.smallest);
        EXPECT_EQ(together.under, alone.under);
      });
    }
  }
}

/// Random meshes of one region beside what is proven of them.
class BruteForce {
 public:
  BruteForce(const RegionBoundary& boundary, std::mt19937_64& random)
      : first_(boundary.points[0]), random_(random), meshes_(boundary, random) {}

  [[nodiscard]] const Triangulation& plain() const { return meshes_.plain(); }

  /// Climbs towards meshes with large smallest angles among those that `counts`, and compares each,
  /// and each with a flip if `flips`.
  template <class Counts>
  void climb(std::span<const AngleRange> impossible, std::uint64_t steps, bool flips,
             const Counts& counts) {
    const double aim = meshes_.uniform(80, 150) * kDegree;
    double best = -10;
    meshes_.start(flips ? static_cast<int>(random_() % 4) : 0);
    for (std::uint64_t k = 0; k < steps; ++k) {
      meshes_.change();
      std::optional<Triangulation> mesh = meshes_.mesh();
      if (!mesh || !counts(*mesh)) {
        meshes_.undo();
        continue;
      }
      ++compared;
      const Angles angles = angles_of(*mesh);
      const double value = angles.smallest - 3 * std::max(0.0, angles.largest - aim);
      if (value < best && meshes_.uniform(0, 1) > 0.1) meshes_.undo();
      best = std::max(best, value);
      compare(angles, impossible);
      if (!flips) continue;
      meshes_.flip_some(*mesh);
      compare(angles_of(*mesh), impossible);
    }
  }

  std::uint64_t compared = 0;
  double sharpest = 1;  ///< the least part of a limit that was missing

 private:
  void compare(const Angles& found, std::span<const AngleRange> impossible) {
    for (const AngleRange& range : impossible) {
      ASSERT_FALSE(found.largest <= range.most && found.smallest >= range.least)
          << "a mesh has angles from " << found.smallest / kDegree << " to "
          << found.largest / kDegree << ", proven impossible: all from " << range.least / kDegree
          << " to " << range.most / kDegree << "; first point " << first_.x << " " << first_.y;
      if (found.largest <= range.most && range.least > 0)
        sharpest = std::min(sharpest, 1 - found.smallest / range.least);
    }
  }

  Point first_;
  std::mt19937_64& random_;
  RandomMeshes meshes_;
};

constexpr std::uint64_t kMeshes = 200;  ///< of a region

TEST(LimitProver, NoMeshOfARandomRegionBeatsALimit) {
  const std::uint64_t tries = cases_asked_for("COVER_LIMIT_TRIES", 20'000);
  const std::uint64_t seed = test_seed(11);
  SCOPED_TRACE(seed_trace(seed));
  std::mt19937_64 random(seed);
  double sharpest = 1;
  for (std::uint64_t round = 0; round * kMeshes < tries && !HasFatalFailure(); ++round) {
    SCOPED_TRACE(round);
    const RegionBoundary boundary = region_for_brute_force(random);
    BruteForce meshes(boundary, random);
    LimitProver prover(meshes.plain());
    meshes.climb(refuted_ranges(prover), kMeshes, true, [](const Triangulation&) { return true; });
    sharpest = std::min(sharpest, meshes.sharpest);
  }
  // The test would be none if limits were far from all meshes.
  EXPECT_LT(sharpest, 0.05);
}

/// Whether the only sides that a triangle sees under more than 90 degrees are those.
bool has_no_other_negative(const Triangulation& mesh, std::span<const IndexPair> negative) {
  const RegionView view(mesh);
  const auto sides = view.sides();
  return std::all_of(sides.begin(), sides.end(), [&](const RegionSide& side) {
    return side.is_free ||
           std::find(negative.begin(), negative.end(), IndexPair{side.a, side.b}) != negative.end();
  });
}

TEST(LimitProver, NoCoupledMeshOfARandomRegionBeatsALimit) {
  const std::uint64_t tries = cases_asked_for("COVER_LIMIT_TRIES", 20'000);
  const std::uint64_t seed = test_seed(12);
  SCOPED_TRACE(seed_trace(seed));
  std::mt19937_64 random(seed);
  double sharpest = 1;
  std::uint64_t compared = 0, sharper = 0;
  for (std::uint64_t round = 0; round * kMeshes < tries && !HasFatalFailure(); ++round) {
    SCOPED_TRACE(round);
    const RegionBoundary boundary = region_for_brute_force(random);
    BruteForce meshes(boundary, random);
    std::vector<IndexPair> negative, exempt;
    const RegionView view(meshes.plain());
    for (const RegionSide& side : view.sides()) {
      const bool is_exempt = side.is_free && random() % 8 == 0;
      if (is_exempt) exempt.push_back({side.a, side.b});
      if (is_exempt || !side.is_free) negative.push_back({side.a, side.b});
    }
    LimitProver prover(meshes.plain());
    prover.exempt(exempt);
    const std::vector<AngleRange> of_all = refuted_ranges(prover);
    const std::vector<AngleRange> of_coupled = refuted_ranges(prover, Meshes::coupled);
    for (std::size_t k = 0; k < std::min(of_all.size(), of_coupled.size()); ++k)
      sharper += of_coupled[k].least < of_all[k].least - kDegree ? 1 : 0;
    meshes.climb(of_coupled, kMeshes, false,
                 [&](const Triangulation& mesh) { return has_no_other_negative(mesh, negative); });
    compared += meshes.compared;
    sharpest = std::min(sharpest, meshes.sharpest);
  }
  EXPECT_LT(sharpest, 0.05);
  EXPECT_GT(compared, tries / 50);
  EXPECT_GT(sharper, tries / kMeshes);
}

TEST(LimitProver, ASingleTriangleIsItsOwnLimit) {
  const RegionBoundary triangle = boundary_of({{{0, 0}, {1, 0}, {0.3, 0.4}}});
  const Triangulation cdt = cdt_of(triangle);
  const Angles angles = angles_of(cdt);
  // Beside it there are triangulations with vertices inside, whose smallest angle is smaller.
  const auto most = angles.largest / kDegree, least = angles.smallest / kDegree;
  EXPECT_FALSE(refuted(triangle, most, least));
  EXPECT_TRUE(refuted(triangle, most - 1e-5, 0));
  EXPECT_TRUE(refuted(triangle, most, least + 1e-4));
}

TEST(LimitProver, WhatAMeshHasIsNotAsked) {
  const RegionBoundary pentagon = boundary_of({regular_polygon(5, 1)});
  const Triangulation cdt = cdt_of(pentagon);
  LimitProver prover(cdt);
  const ProofEffort effort{0, 0, 50};
  std::uint64_t budget = 50;
  EXPECT_FALSE(prover.refutes({100 * kDegree, 35 * kDegree}, budget, effort));
  // The same, or less, is not asked again.
  budget = 50;
  EXPECT_FALSE(prover.refutes({101 * kDegree, 34 * kDegree}, budget, effort));
  EXPECT_EQ(budget, 50U);
  // What was proven holds for more, too.
  budget = 4000;
  ASSERT_TRUE(prover.refutes({100 * kDegree, 58 * kDegree}, budget, {0, 0, 4000}));
  budget = 50;
  EXPECT_TRUE(prover.refutes({99 * kDegree, 59 * kDegree}, budget, effort));
  EXPECT_EQ(budget, 50U);
  LimitProver other(cdt);
  other.has_seen({72 * kDegree, 54 * kDegree});
  EXPECT_FALSE(other.refutes({73 * kDegree, 53 * kDegree}, budget, effort));
  EXPECT_EQ(budget, 50U);
}

TEST(LimitProver, LotsOfLandTakeFewBoxes) {
  // A front of 2.6 and a depth of 38.5: no triangle at the front has more than some four degrees.
  const RegionBoundary lot = boundary_of(
      {{{0, 0}, {2.581, 0}, {2.581, 38.49}, {-26.21, 38.49}, {-26.21, 0}, {-22.58, 0}}});
  const Triangulation cdt = cdt_of(lot);
  std::vector<IndexTriple> triangles;
  for (const Triangle& t : cdt.triangles) triangles.push_back(t.v);
  LimitProver prover(cdt);
  prover.compare_with(AnglesAround::of(cdt.points, triangles, cdt.points.size()));
  std::uint64_t budget = 40;
  EXPECT_TRUE(prover.refutes({100 * kDegree, 4.837 * kDegree}, budget, {0, 0, 40, 40}));
}

TEST(LimitProver, LemmaOneIsTheLeast) {
  std::mt19937_64 random(test_seed(3));
  for (int k = 0; k < 50; ++k) {
    const RegionBoundary star = boundary_of({random_star(20, 0.3, random)});
    const Triangulation cdt = cdt_of(star);
    LimitProver prover(cdt);
    const double gamma_opt = kPi - prover.nu_opt();
    EXPECT_TRUE(refuted(star, gamma_opt / kDegree - 1e-5, 0, 0));
    EXPECT_TRUE(refuted(star, 179, (180 - gamma_opt / kDegree) / 2 + 1e-5, 0));
  }
}

TEST(LimitProver, AShortSideForcesSmallAngles) {
  // The corner next to the short side leaves 90 degrees in which edges must become 100 times as
  // long.
  const RegionBoundary notched = boundary_of({{{0, 0}, {1, 0}, {1, 1}, {0.01, 1}, {0, 0.99}}});
  EXPECT_TRUE(refuted(notched, 100, 15));
  EXPECT_FALSE(refuted(notched, 179, 0.01));
}

TEST(LimitProver, ASlitForcesSmallAngles) {
  // 10 long and 1 high: the triangle on a long side has an angle below atan(1/5) = 11.31 degrees.
  const RegionBoundary slit = boundary_of({{{0, 0}, {10, 0}, {10, 1}, {0, 1}}});
  EXPECT_TRUE(refuted(slit, 170, 11.4));
  EXPECT_FALSE(refuted(slit, 170, 5));
}

TEST(LimitProver, TwoStepsGoBeyondLemmaOne) {
  // Every corner of a square sees the sides opposite to it under 45 degrees: Lemma 1 says no more.
  // But the half disks over the sides leave no place for any apex except the centre.
  const RegionBoundary square = boundary_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  EXPECT_TRUE(refuted(square, 89.9, 0));
  EXPECT_FALSE(refuted(square, 90.01, 0));
}

TEST(LimitProver, WhatIsProvenIsNoBetterThanWhatIsReached) {
  std::mt19937_64 random(test_seed(8));
  int near = 0;
  for (int k = 0; k < 60; ++k) {
    const RegionBoundary boundary = region_for_brute_force(random);
    const Triangulation cdt = cdt_of(boundary);
    const Angles angles = angles_of(cdt);
    LimitProver prover(cdt);
    const ReachedAngles reached{Angle::radians(kPi - angles.largest),
                                Angle::radians(angles.smallest)};
    const ReachedAngles wanted{Angle::degrees(80), Angle::degrees(20)};
    const ProvenLimits limits = prover.prove(reached, wanted);
    // What is within a degree is told so by the first questions alone.
    const bool largest_is_near =
        angles.largest <= 100 * kDegree ||
        limits.largest_nu.in_degrees() <= 181 + 1e-9 - angles.largest / kDegree;
    const bool smallest_is_near =
        angles.smallest >= 20 * kDegree ||
        limits.smallest.in_degrees() <= angles.smallest / kDegree + 1 + 1e-9;
    if (largest_is_near && smallest_is_near) {
      EXPECT_TRUE(LimitProver(cdt).is_near(reached, wanted));
      ++near;
    }
    if (LimitProver(cdt).is_near(reached, wanted)) {
      EXPECT_TRUE(largest_is_near);
    }
    EXPECT_GE(limits.largest_nu.in_radians(), kPi - angles.largest - 1e-12);
    EXPECT_LE(limits.largest_nu.in_radians(), prover.nu_opt() + 1e-12);
    EXPECT_GE(limits.smallest.in_radians(), angles.smallest - 1e-12);
    EXPECT_LE(limits.smallest.in_degrees(), 60 + 1e-9);
  }
  EXPECT_GT(near, 0);
}

TEST(LimitProver, TheOrderOfTrianglesDoesNotMatterToWhatIsProven) {
  std::mt19937_64 random(test_seed(9));
  const RegionBoundary star = boundary_of({random_star(12, 0.5, random)});
  const RegionBoundary far = transformed(star, 1024, {0, 0});
  for (const double least : {1.0, 5.0, 10.0, 20.0, 30.0})
    EXPECT_EQ(refuted(star, 110, least), refuted(far, 110, least));
}

}  // namespace
}  // namespace cover
