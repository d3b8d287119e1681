// Any bytes as a file that goes with the geometry: a table of sizes (.csv), a map of layers (.map),
// a legend (.legend): something or an error, never a crash, a hang or a huge allocation.
// COVER_FUZZ_FORMAT is one of these, COVER_FUZZ_LAYOUT a layout.
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <cover/read_input.hpp>
#include <cover/read_size_field.hpp>

namespace {

namespace fs = std::filesystem;

/// A file, in memory where there is a place for it.
std::string file_beside() {
  const fs::path memory = "/dev/shm";
  const fs::path folder = fs::is_directory(memory) ? memory : fs::temp_directory_path();
  return (folder / ("cover_fuzz_" + std::to_string(getpid()) + COVER_FUZZ_FORMAT)).string();
}

template <class Outcome>
void check(const Outcome& outcome) {
  if (!outcome && outcome.error().message.empty()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string path = file_beside();
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  const std::string_view format = COVER_FUZZ_FORMAT;
  cover::ReadOptions options;
  if (format == ".csv") {
    check(cover::read_size_field(path));
    check(cover::read_size_field(path, "asinh", 0.5));
  } else if (format == ".map") {
    options.layer_map = {path};
    check(cover::read_input(COVER_FUZZ_LAYOUT, options));
  } else {
    options.legend = path;
    check(cover::parse_input("NRRD0004\ntype: uchar\nsizes: 3 2\nencoding: ascii\n\n1 1 7 1 2 7\n",
                             ".nrrd", "fuzz", options));
  }
  fs::remove(path);
  return 0;
}
