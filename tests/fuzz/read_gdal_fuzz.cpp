// Any bytes as a map: an Input or an error, never a crash, a hang or a huge allocation.
// COVER_FUZZ_FORMAT is the extension that names the format.
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <cover/read_gdal.hpp>

namespace {

namespace fs = std::filesystem;

/// A file, in memory where there is a place for it.
std::string map_file() {
  const fs::path memory = "/dev/shm";
  const fs::path folder = fs::is_directory(memory) ? memory : fs::temp_directory_path();
  return (folder / ("cover_fuzz_" + std::to_string(getpid()) + COVER_FUZZ_FORMAT)).string();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string path = map_file();
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  cover::ReadOptions options;
  options.keep_fields = {"fid"};
  const auto input = cover::read_gdal(path, options);
  fs::remove(path);
  if (!input && input.error().message.empty()) std::abort();
  return 0;
}
