#include "files/dump_stages.hpp"

#include <filesystem>

#include <fmt/core.h>

namespace cover::app {

Status dump_stages(const std::vector<PackingRecord>& packings, const std::string& folder) {
  constexpr int kWidth = 1000;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    return Error{ErrorCode::cannot_write,
                 fmt::format("cannot make the folder {}: {}", folder, error.message()),
                 {},
                 {}};
  }
  for (const auto& [stage, name] :
       {std::pair(PackingStage::disks, "1_disks.svg"), std::pair(PackingStage::gaps, "2_gaps.svg"),
        std::pair(PackingStage::triangles, "3_triangles.svg")}) {
    const std::string path = (std::filesystem::path(folder) / name).string();
    if (Status status = write_packing_svg(packings, stage, kWidth, path); !status) return status;
  }
  return ok();
}

}  // namespace cover::app
