// cover-mpi: `cover mesh` on several machines. The file is the same as that of `cover mesh`, byte
// for byte, for any number of ranks.
#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>
#include <mpi.h>

#include <cover/version.hpp>

#include "commands/commands.hpp"
#include "commands/exit_code.hpp"
#include "commands/guarded.hpp"
#include "rank_read.hpp"
#include "rank_share_out.hpp"
#include "serve.hpp"
#include "terminal/console.hpp"

namespace {

using cover::mpi::RankCores;

constexpr const char* kHelp =
    R"(cover-mpi: 'cover mesh' on the processes of an MPI run.

Usage: mpirun -n 4 cover-mpi mesh INPUT -o FILE ...

Rank 0 reads the input, shares its regions out among all ranks and writes the files. They are the
same, byte for byte, as those of 'cover mesh', for any number of ranks and threads. Several input
files are read by all ranks; what another rank cannot read, rank 0 reads. Each rank takes its part
of the cores that mpirun lets it use ('mpirun --bind-to none': of all cores of its machine), or as
many threads as -j says. Large meshes that go to .vtkhdf files stay with the ranks that make them,
and all ranks write: the folder must be one that all of them see, else meshes travel to rank 0.

  cover-mpi mesh --help   the options, which are those of 'cover mesh'
)";

/// Tells of cores that nobody uses: mpirun binds each of one or two ranks to one core.
void warn_of_unused_cores(const std::vector<std::string>& words, const RankCores& cores) {
  const auto is_quiet = [](const std::string& word) { return word == "-q" || word == "--quiet"; };
  if (cores.of_all == cores.unbound || std::any_of(words.begin(), words.end(), is_quiet)) return;
  cover::app::print_on_stderr(fmt::format(
      "cover-mpi: warning: mpirun has bound its processes on this machine to {} of {} cores; "
      "'mpirun --bind-to none' lets them use all of these\n",
      cores.of_all, cores.unbound));
}

/// What rank 0 does.
int lead(const std::vector<std::string>& words, const RankCores& cores) {
  if (words.empty() || words[0] == "-h" || words[0] == "--help" || words[0] == "help") {
    std::fputs(kHelp, words.empty() ? stderr : stdout);
    return words.empty() ? cover::app::exit_usage : cover::app::exit_ok;
  }
  if (words[0] == "--version") {
    fmt::print("cover-mpi {}\nLicence: GPL-3.0-or-later\n", COVER_VERSION);
    return cover::app::exit_ok;
  }
  if (words[0] == "mesh") {
    warn_of_unused_cores(words, cores);
    const auto share_out = [&](cover::RegionJobs& jobs) {
      return cover::mpi::share_out_among_ranks(jobs, cores);
    };
    return cover::app::run_mesh(
        {words.begin() + 1, words.end()},
        {share_out, cover::mpi::write_among_ranks, cover::mpi::read_among_ranks});
  }
  cover::app::print_on_stderr(
      fmt::format("cover-mpi: error: '{}' is no command of cover-mpi, which has only 'mesh'; the "
                  "others are those of 'cover'\n",
                  words[0]));
  return cover::app::exit_usage;
}

int guarded_serve(int rank, const RankCores& cores) {
  const std::string name = fmt::format("cover-mpi: rank {}", rank);
  return cover::app::guarded(name, [&] {
    cover::mpi::serve(cores);
    return cover::app::exit_ok;
  });
}

}  // namespace

int main(int argc, char** argv) {
  int level = MPI_THREAD_SINGLE;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &level);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (level < MPI_THREAD_FUNNELED) {
    if (rank == 0)
      cover::app::print_on_stderr(
          "cover-mpi: error: this MPI allows no threads; cover-mpi needs them\n");
    MPI_Abort(MPI_COMM_WORLD, cover::app::exit_internal);
  }
  const std::vector<std::string> words(argv + 1, argv + argc);
  const RankCores cores = cover::mpi::find_rank_cores();
  const int code = rank == 0 ? cover::app::guarded("cover-mpi", [&] { return lead(words, cores); })
                             : guarded_serve(rank, cores);
  // A rank that cannot go on, and a run that was interrupted, wait for nobody.
  if (code == cover::app::exit_interrupted || code == cover::app::exit_internal ||
      code == cover::app::exit_memory || (rank > 0 && code != cover::app::exit_ok))
    MPI_Abort(MPI_COMM_WORLD, code);
  if (rank == 0) cover::mpi::dismiss_ranks();
  MPI_Finalize();
  return code;
}
