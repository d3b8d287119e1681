// How short pieces of segments may be that are cut before regions are meshed, how near to their
// ends, and how near to an angle that was asked for.
#pragma once

namespace cover {

constexpr double kLeastHalf = 0x1p-10;        ///< of its segment: the shortest half of a piece
constexpr double kLeastBesideFoot = 0x1p-40;  ///< of its segment: the shortest piece beside a foot
/// Of an apex's height: so near to an end of the segment, a cut at its foot leaves a needle of less
/// than a degree, which nothing forces: farther from the end it serves as well.
constexpr double kNeedle = 0x1p-6;
constexpr double kNuRounding = 1e-9;  ///< radians: feet are rounded, and angles at them

}  // namespace cover
