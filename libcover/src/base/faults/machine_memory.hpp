// How much memory a run can have.
#pragma once

namespace cover {

inline constexpr double kGigabyte = 1e9;  ///< as messages have it

/// The bytes that this process can have at the most: those of the machine, or of its control group,
/// or what `ulimit` leaves it, whichever is the least; infinite where none of these is known.
double machine_memory();

}  // namespace cover
