#include "almond/fill/fill_memory.hpp"

#include <string>

#include <gtest/gtest.h>

namespace cover {
namespace {

/// One triangle, and how often it was asked.
class CountingFiller final : public Filler {
 public:
  explicit CountingFiller(int& asked) : asked_(&asked) {}
  [[nodiscard]] Filling fill(const FillTask& task, std::stop_token) const override {
    ++*asked_;
    Filling filling;
    filling.triangles = {{0, 1, 2}};
    filling.remark = std::to_string(task.points.size());
    return filling;
  }

 private:
  int* asked_;
};

FillTask triangle() {
  return {{{0, 0}, {1, 0}, {0, 1}}, {{0, 1, false, 1}, {1, 2, false, 1}, {2, 0, true, 1}}};
}

TEST(FillMemory, FillsTheSameTaskOnce) {
  int asked = 0;
  const CountingFiller filler(asked);
  FillMemory memory;
  const Filling first = memory.filling(filler, 0, triangle(), {});
  const Filling again = memory.filling(filler, 0, triangle(), {});
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(again.triangles, first.triangles);
  EXPECT_EQ(again.remark, first.remark);
}

TEST(FillMemory, TellsTasksApart) {
  int asked = 0;
  const CountingFiller filler(asked);
  FillMemory memory;
  FillTask moved = triangle(), locked = triangle(), wider = triangle(), more = triangle();
  moved.points[1].x = 2;
  locked.chords[0].locked = true;
  wider.chords[1].nu = 2;
  more.points.push_back({0.25, 0.25});
  for (const FillTask& task : {triangle(), moved, locked, wider, more})
    EXPECT_EQ(memory.filling(filler, 0, task, {}).remark, std::to_string(task.points.size()));
  EXPECT_EQ(asked, 5);
  (void)memory.filling(filler, 1, triangle(), {});  // another filler of the plan
  EXPECT_EQ(asked, 6);
}

}  // namespace
}  // namespace cover
