// Runs hostile_fuzz over seeds, or writes the input and the options of one.
//
//   hostile_runs FIRST COUNT [SECONDS]   meshes and verifies; names a seed that takes longer than
//                                        that, and the one at which it crashed
//   hostile_runs --write SEED FILE       the input as JSON; prints the options of the program
#include <sys/time.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string_view>

#include "support/inputs/hostile_case.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

volatile std::uint64_t current = 0;

/// Names the seed, then dies as it would have.
extern "C" void name_seed(int signal) {
  char text[64];
  const int length = std::snprintf(text, sizeof text, "seed %llu: signal %d\n",
                                   static_cast<unsigned long long>(current), signal);
  if (write(2, text, static_cast<std::size_t>(length)) < 0) std::_Exit(3);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

int write_case(const char* seed, const char* file) {
  const auto bytes = cover::testing::bytes_of_seed(std::strtoull(seed, nullptr, 10));
  const auto hostile = cover::testing::hostile_case(bytes.data(), bytes.size());
  std::ofstream(file) << cover::testing::json_of(hostile.input);
  for (const std::string& argument : cover::testing::arguments_of(hostile.options))
    std::printf("%s\n", argument.c_str());
  std::fprintf(stderr, "%s\n", hostile.family.c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 4 && std::string_view(argv[1]) == "--write") return write_case(argv[2], argv[3]);
  if (argc < 3) return 2;
  const std::uint64_t first = std::strtoull(argv[1], nullptr, 10);
  const std::uint64_t count = std::strtoull(argv[2], nullptr, 10);
  const double longest = argc > 3 ? std::strtod(argv[3], nullptr) : 20;
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGPROF})
    std::signal(signal, name_seed);
  int slow = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    current = seed;
    const itimerval most{{0, 0}, {static_cast<time_t>(20 * longest), 0}};
    setitimer(ITIMER_PROF, &most, nullptr);  // of CPU time: the machine may be busy
    const auto bytes = cover::testing::bytes_of_seed(seed);
    const std::clock_t start = std::clock();
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (seconds < longest) continue;
    std::fprintf(stderr, "seed %llu: %.1f s\n", static_cast<unsigned long long>(seed), seconds);
    ++slow;
  }
  std::printf("%llu runs\n", static_cast<unsigned long long>(count));
  return slow == 0 ? 0 : 1;
}
