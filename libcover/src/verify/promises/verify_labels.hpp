// The numbers on triangles that are known to fill the regions: for verify_cover().
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include <cover/ids.hpp>
#include <cover/regions.hpp>
#include <cover/verify.hpp>

namespace cover {

/// Takes a triangle whose number is wrong, and a message.
using TellViolation = std::function<void(std::uint32_t triangle, std::string message)>;

/// Every region has one RegionId of its own, whichever. `region` is by triangle, kVoid for those to
/// be passed over.
///
/// REQUIRES: mesh.region holds one number per triangle
void verify_region_ids(const TriangleSoup& mesh, std::span<const RegionId> region,
                       const TellViolation& tell);

/// Every triangle has the material of its region; if not `numbered`, no number stands for two
/// materials.
///
/// REQUIRES: mesh.material holds one number per triangle
void verify_materials(const TriangleSoup& mesh, std::span<const RegionId> region,
                      const RegionTable& table, bool numbered, const TellViolation& tell);

}  // namespace cover
