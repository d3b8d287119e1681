#include "base/faults/machine_memory.hpp"

#include <sys/resource.h>

#include <gtest/gtest.h>

namespace cover {
namespace {

TEST(MachineMemory, HeedsTheLimitOfTheProcess) {
  const double before = machine_memory();
  EXPECT_GT(before, 1e8);
  EXPECT_LT(before, 1e15);
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_DATA, &old), 0);
  rlimit less = old;
  less.rlim_cur = 1ULL << 30U;
  if (before <= static_cast<double>(less.rlim_cur)) GTEST_SKIP() << "there is less anyway";
  ASSERT_EQ(setrlimit(RLIMIT_DATA, &less), 0);
  EXPECT_EQ(machine_memory(), 0x1p30);
  ASSERT_EQ(setrlimit(RLIMIT_DATA, &old), 0);
  EXPECT_EQ(machine_memory(), before);
}

}  // namespace
}  // namespace cover
