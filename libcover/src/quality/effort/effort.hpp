// What the steps of a plan may cost, and when they are due. What tunes one algorithm alone stands
// at the head of its file: plan/optimise, repair/search, repair/kicks, repair/best_restart. One
// star evaluation takes some 0.1 us. Figures are from tests/bench/region_faults.py on Voronoi
// cells, parcels and maps, where nothing else is said. "No matter" is a number that was made some
// three times as small and as large, for the same faults: RESULTS.md says on what, and how many
// triangles differed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace cover::effort {

/// Star evaluations for a region: at least, and for each of its points besides. By default neither
/// is any matter: regions end by what their steps may spend.
inline constexpr std::uint64_t kBudgetAtLeast = 5'000, kBudgetPerPoint = 3'000;
/// For each vertex that sizes add. No matter.
inline constexpr std::uint64_t kBudgetPerSizedVertex = 100;
/// Vertices that sizes may ask for in a region. Not measured: it bounds memory.
inline constexpr std::size_t kMostSizedVertices = 50'000'000;
/// Improvement after refinement gets one in so many of what is left. No matter by default.
inline constexpr std::uint64_t kImprovementsPart = 4;

/// With all effort, where a larger share of the triangles is above the goal after improvement, it
/// begins again with a light weight for small angles. With 0.005 nothing changes on the counties of
/// Virginia, with 0.1 faults are 1 % smaller, or 0.5 % larger by the largest angle.
inline constexpr double kShareToStartAgain = 0.02;
/// Where at most this share is, a search with all effort gets so much more for each triangle, but
/// for no more of them than these. No matter: faults differ by 1 %, either way.
inline constexpr double kShareWorthMore = 0.05;
inline constexpr std::size_t kMostWorthMore = 4;
inline constexpr std::uint64_t kMoreForEach = 300'000;
/// Where a larger share is, there is no search: on spiky polygons it took 28 % of the time, for the
/// same meshes. With 0.4 nothing changes on maps. Meshes of no more triangles than these are
/// searched in any case, which was not measured; after each of several candidates, only those of no
/// more than the other number: with 50 faults of maps are 0.6 % larger, with 600 nothing changes.
inline constexpr double kShareWithoutHope = 0.2;
inline constexpr std::size_t kSearchedInAnyCase = 600, kSearchedForEachCandidate = 200;

/// Triangles of an excerpt. Of 36 triangles left on a smooth star of 1e4 points, a search in such
/// excerpts and joint moves left none. No matter on cells and maps.
inline constexpr std::size_t kExcerpt = 64;
/// Triangles that are copied in the time of one star evaluation. No matter by default.
inline constexpr std::uint64_t kCopiedPerEvaluation = 8;

/// Points of a region where all candidates are tried and improved. With 16 faults of Virginia are
/// 1 % larger or smaller, by what is preferred; with 256 nothing changes.
inline constexpr std::size_t kPointsToTryAll = 64;
/// Star evaluations for random restarts in tiny regions, far more than they need, and for a search
/// of what the best of them leaves. With restarts 60 to 75 fewer of 300 regions of Voronoi cells
/// miss their target, for 1.7 times the instructions. Neither number is any matter.
inline constexpr std::uint64_t kRestartsOfAllEffort = 200'000, kSearchAfterRestarts = 10'000;

/// Points of a region that is tried with other goals. With 500 or 8,000 nothing changes on maps.
inline constexpr std::size_t kPointsToAimElsewhere = 2'000;
/// Where a larger share of the triangles is above the goal, a goal with less for small angles is
/// tried: tips near a line end with 28 to 38 triangles above 120 degrees, and with 87 to 105
/// without it. With 0.03 faults by the largest angle are 1 % larger; with 0.3 they are 1 % smaller,
/// but on a picture 101 triangles instead of 81 stay above 120 degrees.
inline constexpr double kShareToEaseSmall = 0.1;
/// Most triangles beyond the region's own target, or above 120 degrees, that are searched for alone
/// in the end; and star evaluations for each of them. The first search leaves 120.2 degrees in a
/// motor's stator, the second 269 triangles in place of 310 in 40 spiky stars, in a third more
/// time. With 4 triangles, or a fifth of the evaluations, faults are up to 1 % larger or smaller;
/// with 64 nothing changes. With five times the evaluations they are up to 2 % smaller.
inline constexpr std::size_t kSearchedAlone = 16;
inline constexpr std::uint64_t kSearchForOwn = 100'000, kSearchForFar = 5'000;

/// Targets for the smallest angle, in parts of the goal's, with which angles above 120 degrees or
/// the bound are narrowed, in turn. Coarser steps leave the smallest angles smaller than need be.
inline constexpr std::array kSmallestParts{0.75, 0.6, 0.45, 0.36, 0.285};
/// Then, for the bound alone and where sizes would be given up else, those of degenerate angles:
/// 4.4 to 0.36 degrees where 20 are asked for.
inline constexpr std::array kDegenerateParts{0.22, 0.16, 0.11, 0.06, 0.018};
inline constexpr double kAimBelowLimit = 0.008;  ///< aimed at below these, in cotangents
/// So far below the bound couplings leave angles then, in cotangents: what sums of cotangents lack
/// below zero counts a fiftieth of what is beyond it (kCouplingFirst, kBoundFirst).
inline constexpr double kCouplingsBelowBound = 0.05;
/// Star evaluations for that at most, for the bound and for fewer angles above 120 degrees. With
/// 100 Voronoi cells end with as many of these, for 2 % more instructions; with 50 for the bound
/// more sides are left to be mended afterwards, which takes longer.
inline constexpr std::uint64_t kNarrowedToBound = 100, kNarrowedToFewerFar = 50;
/// Star evaluations after refinement. Tiny regions, where little more is reached with twice as
/// many (means of the fault 0.2 % smaller, 4 % more instructions), are improved again by restarts.
inline constexpr std::uint64_t kImprovePerTriangle = 100, kImproveTiny = 50;
/// Star evaluations for each triangle, each time that couplings have become heavier: without a
/// limit Voronoi cells take a third more time, for the same faults up to 0.1 %; with 60, 3 % more.
inline constexpr std::uint64_t kCouplePerTriangle = 30;
/// The same with little effort.
inline constexpr std::uint64_t kImproveFast = 25, kCoupleFast = 6;

/// Most points of a region whose limits are asked before it is refined. Of 3,338 parcels and 1,225
/// Voronoi cells 2,092 and 56 were near them, all with 7 points at most; of 1,465 other regions 3,
/// with 8 at most. To ask the others, too, took a tenth of the time of 900 wavy squares.
inline constexpr std::uint32_t kPointsToBeNear = 8;

/// Half discs leave a region with no more points than these room for one vertex, if for any. It is
/// refined only where the star around one was better than the plain triangulation: with little
/// effort 2,202 of 2,858 parcels are left out, of which 56 would gain something, and 172 of 1,282
/// Voronoi cells, of which 14 would. The means of the fault are 0.02 and 0.1 % larger, instructions
/// 35 and 5 % fewer; 15 and 5 % by default.
inline constexpr std::size_t kPointsOfOneRoom = 5;
/// With little effort a region of no more points than these is refined only where the star was
/// better, and one of no more than kPointsOfOneRoom not at all: 1,109 of 2,000 Voronoi cells to
/// 607. Of 434 with 6 or 7 points and no better star 99 would gain something. The mean of the fault
/// is 1.4 % larger, instructions 15 % fewer.
inline constexpr std::size_t kPointsOfFewRooms = 7;

/// Where at most this share of the triangles of a large mesh misses the goal, they are searched for
/// one by one: on clean input that ends at the goal, on maps nearly all that is left is forced.
inline constexpr double kFewMissed = 0.02;

/// Star evaluations for a triangle that misses the goal only since couplings count, and in small
/// meshes for each more of them. One alone is likely to be mended, as on 900 wavy squares. With as
/// much for all of them the same is found on maps, in 1.1 times the time. Nor do small meshes get
/// more for it than so much for each of their own triangles: of 10,000 wavy squares with some 50,
/// all but 16 of the 470 that are mended take less.
inline constexpr std::uint64_t kSearchForCouplings = 8000, kSearchForOneMore = 500;
inline constexpr std::uint64_t kSearchPerTriangle = 140;

/// Small meshes in which few triangles miss the goal, by no more than this fault (116 degrees, 16
/// degrees), are improved once more, from two starts. On 900 wavy squares the last 3 reach the goal
/// by that; what misses it by more is forced nearly always.
inline constexpr std::size_t kSmallMesh = 600;
inline constexpr std::size_t kFewInSmall = 6;
inline constexpr double kFaultImprovedAgain = 0.2;
/// Star evaluations for that, each; and with couplings, after which few triangles were searched
/// already: with 250 one more of 10,000 wavy squares reaches the goal, and the counties of Virginia
/// take 1.2 times the time; with 50 none, and 1.04 times.
inline constexpr std::uint64_t kLastPerTriangle = 250, kLastCoupled = 20;

/// If no more triangles than these are left then, with no larger faults in sum than one may have,
/// the mesh is made again with a search before couplings have their say, which leads elsewhere. Of
/// 3,600 wavy squares the last 5 reach the goal by that; where sides force something, nothing does.
inline constexpr std::size_t kSearchedAgain = 2;
inline constexpr std::uint64_t kSearchedPerTriangle = 400, kSearchedCoupled = 70;  ///< for that

/// Star evaluations for each large angle of the plain triangulation, where nothing else was taken
/// with couplings. Of 4,796 regions of Voronoi cells, grains, parcels and maps 60 have smaller
/// largest angles by that, and 34 of 2,065 reach their target; cells take 4 % more instructions.
/// With 30 it is 52 and 30, with 300 65 and 39.
inline constexpr std::uint64_t kSearchForLarge = 100;

/// Tiny regions that miss the goal by no more than this fault (109 degrees, 17.8 degrees) get
/// random restarts, if they have so many points: of 1,000 inclusions 4 reach the goal by that.
/// Those with fewer points gain nothing in ten times the time of all else: what they miss is
/// forced.
inline constexpr double kNearMiss = 0.11;
inline constexpr std::size_t kPointsToRestart = 9;
inline constexpr std::uint64_t kRestartsOfTiny = 6'000;  ///< star evaluations for that

/// Tiny regions with an angle above 140 degrees that is not forced get some, whatever else they
/// miss: 2,000 Voronoi cells end at 150.7 instead of 153.0 degrees, for 3 % more instructions. With
/// three times as many 13 of 595 angles above 120 degrees fewer are left, for another 10 %.
inline constexpr std::uint64_t kRestartsOfVeryWide = 1'500;

}  // namespace cover::effort
