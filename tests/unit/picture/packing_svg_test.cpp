#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include <cover/packing.hpp>

#include "disks/fill_disks.hpp"
#include "support/filling_checks.hpp"
#include "support/inputs/shapes.hpp"
#include "support/temporary_folder.hpp"

namespace cover {
namespace {

std::string drawn(const PackingRecord& record, PackingStage stage) {
  const testing::TemporaryFolder folder;
  const std::string path = (folder.path() / "packing.svg").string();
  EXPECT_TRUE(write_packing_svg({record}, stage, 500, path).has_value());
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

TEST(PackingSvg, ShowsEveryDisk) {
  const FillTask task = testing::task_of(testing::boundary_of({testing::regular_polygon(6)}));
  PackingRecord record;
  (void)make_disk_filler({.record = &record})->fill(task, {});
  const std::string gaps = drawn(record, PackingStage::gaps);
  EXPECT_EQ(count_of(gaps, "<circle"), record.disks.size());
  EXPECT_NE(gaps.find("good"), std::string::npos);
  EXPECT_EQ(count_of(drawn(record, PackingStage::disks), "<circle"), 6U + 2U);  // and the legend's
  EXPECT_EQ(count_of(drawn(record, PackingStage::triangles), "<circle"), 0U);
}

TEST(PackingSvg, SaysWhereItCannotWrite) {
  const Status status = write_packing_svg({}, PackingStage::gaps, 500, "/nowhere/at/all.svg");
  ASSERT_FALSE(status.has_value());
  EXPECT_EQ(status.error().code, ErrorCode::cannot_write);
}

}  // namespace
}  // namespace cover
