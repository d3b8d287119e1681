// Tested by tests/cli/program_test.py.
#include "words/estimate_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "terminal/console.hpp"

namespace cover::app {
namespace {

/// Sizes can ask for more than any integer holds.
std::string whole(double count) {
  constexpr double kMostGrouped = 1e15;
  return count < kMostGrouped ? grouped(static_cast<std::size_t>(count))
                              : fmt::format("{:.2g}", count);
}

/// To two digits.
std::string about(double count) {
  if (count <= 0) return whole(0);
  const double step = std::max(1.0, std::pow(10.0, std::floor(std::log10(count)) - 1));
  return whole(step * std::round(count / step));
}

std::string memory_text(const Estimate& estimate) {
  constexpr double kMegabyte = 1e6;
  std::string out = fmt::format("{} MB of memory", whole(estimate.bytes / kMegabyte));
  if (std::isfinite(estimate.available))
    out += fmt::format(", of {} MB", whole(estimate.available / kMegabyte));
  return out;
}

}  // namespace

std::string estimate_text(const Estimate& estimate, bool stays_on_disk) {
  const std::string triangles = about(estimate.triangles);
  if (!estimate.by_disks)
    return fmt::format("\nA mesh takes about {} triangles and {}\n{}", triangles,
                       memory_text(estimate),
                       stays_on_disk ? "where it is held; this one stays on the disk, region by "
                                       "region, and may take less\n"
                                     : "");
  return fmt::format(
      "\nThere is no estimate where disks are packed, as with --method nonobtuse: lines far from\n"
      "each other take some {} triangles and {}; lines close to each other\n"
      "can take hundreds of times that\n",
      triangles, memory_text(estimate));
}

}  // namespace cover::app
