#include "rank_cores.hpp"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>

#include <mpi.h>

namespace cover::mpi {
namespace {

using Mask = std::array<unsigned char, sizeof(cpu_set_t)>;

Mask mask_of(pid_t process) {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  Mask mask{};
  if (sched_getaffinity(process, sizeof cores, &cores) == 0)
    std::memcpy(mask.data(), &cores, sizeof cores);
  return mask;
}

unsigned count_of(const Mask& mask) {
  cpu_set_t cores;
  std::memcpy(&cores, mask.data(), sizeof cores);
  return static_cast<unsigned>(CPU_COUNT(&cores));
}

}  // namespace

RankCores find_rank_cores() {
  MPI_Comm machine;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  const Mask own = mask_of(0);
  Mask together{};
  MPI_Allreduce(own.data(), together.data(), static_cast<int>(own.size()), MPI_BYTE, MPI_BOR,
                machine);
  const unsigned count = std::max(1U, count_of(own)), of_all = std::max(1U, count_of(together));
  unsigned sum = 0;
  MPI_Allreduce(&count, &sum, 1, MPI_UNSIGNED, MPI_SUM, machine);
  MPI_Comm_free(&machine);
  // Where masks overlap, cores are counted by several ranks.
  const unsigned part = static_cast<unsigned>(static_cast<unsigned long>(count) * of_all / sum);
  // Whoever has started the rank is in the same container, and bound to nothing.
  return {std::max(1U, part), of_all, std::max(of_all, count_of(mask_of(getppid())))};
}

unsigned threads_of_rank(unsigned asked, const RankCores& cores) {
  return asked > 0 ? asked : cores.own;
}

}  // namespace cover::mpi
