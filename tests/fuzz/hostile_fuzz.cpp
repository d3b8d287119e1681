// Hostile geometry with random options through the whole pipeline: a mesh that keeps every promise,
// or an error that is not ours.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

#include "support/inputs/hostile_case.hpp"

namespace {

[[noreturn]] void fail(const cover::testing::HostileCase& hostile, const std::string& why) {
  std::fprintf(stderr, "%s: %s\n", hostile.family.c_str(), why.c_str());
  std::abort();
}

/// Whether the report says of every region that the bound was missed or cannot be held there.
bool says_bound_may_be_missed(const cover::Report& report) {
  return std::any_of(report.regions.begin(), report.regions.end(), [](const auto& region) {
    return !region.bound_held ||
           std::any_of(region.notes.begin(), region.notes.end(), [](const cover::Note& note) {
             return note.kind == cover::Note::Kind::below_resolution;
           });
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const cover::testing::HostileCase hostile = cover::testing::hostile_case(data, size);
  const auto output = cover::cover_mesh(hostile.input, hostile.options);
  if (!output) {
    if (output.error().code == cover::ErrorCode::internal) fail(hostile, output.error().message);
    if (output.error().message.empty()) fail(hostile, "an error without a reason");
    return 0;
  }
  // Against what was meshed, with the cuts that were asked for.
  cover::VerifyOptions verify;
  verify.hull = hostile.options.hull;
  verify.bound = !hostile.options.paper && !says_bound_may_be_missed(output->report);
  const cover::TriangleSoup soup = cover::triangle_soup(output->mesh);
  const auto found = cover::verify_cover(output->pslg, output->table, soup, verify);
  if (!found.violations.empty()) fail(hostile, found.violations.front().message);
  // What misses a bound by rounding, the program writes on request only.
  if (std::any_of(output->report.regions.begin(), output->report.regions.end(),
                  [](const auto& region) { return !region.bound_held; }))
    return 0;
  // And against the input as it was.
  cover::Options uncut = hostile.options;
  uncut.split_interfaces.reset();
  uncut.sizes.clear();
  uncut.input_sizes = false;
  const auto before = cover::prepare(hostile.input, uncut);
  if (!before) fail(hostile, "meshed, and not prepared: " + before.error().message);
  // What is nearer than rounding tells cannot be told from a segment that was cut.
  if (!before->report.changes.empty() || !before->report.notes.empty()) return 0;
  verify.allow_split = true;
  const auto whole = cover::verify_cover(before->pslg, before->table, soup, verify);
  if (!whole.violations.empty()) fail(hostile, "uncut: " + whole.violations.front().message);
  return 0;
}
