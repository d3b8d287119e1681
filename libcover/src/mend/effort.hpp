// How long is searched for what mends, thins out or eases a mesh: numbers that any mesh is right
// with, a smaller one sooner, a larger one maybe with fewer vertices or bad triangles. How many
// places may be tried in all, say those who ask (ThinEffort, MendEffort, CouplingEffort). Where no
// figures are told, a number was not measured by itself. What weighs costs against each other, or
// is rounding's, stands at the head of the file that has it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace cover::effort::mend {

/// Vertices that are put near a bad triangle, try by try: few leave fewer vertices, many mend what
/// few cannot. The first kFewTries come first where bad triangles may be many.
inline constexpr std::array<int, 6> kMore{1, 2, 4, 8, 16, 32};
inline constexpr std::size_t kMostTries = kMore.size(), kFewTries = 3;
/// So many triangles in a row that no number of vertices mended: few are tried then, until one is.
/// All of 154 between two rings of chords took three times as long, for nothing.
inline constexpr std::size_t kManyInVain = 32;
/// Steps, each of which adds or moves a vertex, until an attempt with so many more vertices is
/// given up: each is put, and moved some times with its neighbours.
constexpr int steps_with_more(int more) { return 12 + 6 * more; }
/// With others in place of some that went: what is around has its places already.
constexpr int steps_with_others(int more) { return 12 + 4 * more; }
/// Once pieces were cut through layers, with as many vertices as may be.
inline constexpr int kStepsAfterCuts = 6 * kMore.back();
/// Steps of an attempt to thin out, by the round over all vertices: the first takes what goes at
/// little cost.
inline constexpr int kRoundsToGrow = 6;
constexpr int steps_to_thin(int taken, int round) {
  return 6 + 4 * taken + 4 * (round < kRoundsToGrow ? round : kRoundsToGrow);
}
/// Steps in a row that make nothing better, and one for each new vertex, which end an attempt.
inline constexpr int kInVain = 8;

/// Vertices that are taken away at once to thin out, at most; one less is put back.
inline constexpr std::size_t kMostTogether = 4;
/// Vertices around a triangle that are taken away one by one where nothing else mends.
inline constexpr int kMostTaken = 12;
/// Vertices near a triangle that are put elsewhere, at most.
inline constexpr std::size_t kMostAnew = 8;
/// Neighbours of a vertex, and vertices in all, that are looked at for those near it: it bounds
/// what a fan of thousands costs.
inline constexpr std::size_t kMostNeighbours = 64, kMostSeen = 40;
/// Cuts from wall to wall, through a stack of thin layers, to where there is room.
inline constexpr int kLongestDrive = 1'000;

/// Easing: moves for each triangle. They end before where there is room for all that is asked.
inline constexpr std::size_t kMostMoves = 1'000;

/// Couplings within the bound: places tried in a region, at most.
inline constexpr std::uint64_t kMostPlaces = 3'000'000;
/// The same in a region that is no wider than so many units in the last place of its largest
/// coordinate.
inline constexpr std::uint64_t kMostPlacesWhereNarrow = kMostPlaces / 16;
inline constexpr double kNarrow = 4;
/// Regions of so many sides, with so many given up, are those in which room in circles is looked
/// for: it takes a look at half discs all around.
inline constexpr std::size_t kFewSides = 512, kFewGivenUp = 8;
/// Points of a region in which all vertices may be put anew.
inline constexpr std::size_t kSmallRegion = 64;
/// Fillings of room, the first with what costs least, others by chance; and vertices for each.
inline constexpr int kFillings = 30, kMostFilled = 10;
/// Places in a circle, for a vertex. With 64 the same sides are given up on 12,000 Voronoi cells,
/// in twice the time; with 16, one more on a picture of grains.
inline constexpr std::size_t kPlacesInCircle = 32;

}  // namespace cover::effort::mend
