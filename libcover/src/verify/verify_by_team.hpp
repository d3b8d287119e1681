// verify_cover() for whoever has threads already.
#pragma once

#include <cover/verify.hpp>

#include "base/team.hpp"

namespace cover {

/// As verify_cover(), by a team instead of options.threads.
Verification verify_by_team(const Pslg& pslg, const RegionTable& table, const TriangleSoup& mesh,
                            const VerifyOptions& options, const Team& team);

}  // namespace cover
