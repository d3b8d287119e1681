// Any bytes as a mesh file: a whole mesh or an error, never a crash, a hang or a huge allocation.
// COVER_FUZZ_FORMAT is the extension that names the format. Triangle's files are two, the .node
// first and the .ele after a line "#####"; a manifest (.json) is read beside a mesh that fits.
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <cover/mesh.hpp>
#include <cover/read_mesh.hpp>
#include <cover/read_vtk_input.hpp>

namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

/// A folder in memory where there is one.
const fs::path& folder() {
  static const fs::path path = [] {
    const fs::path memory = "/dev/shm";
    fs::path made = (fs::is_directory(memory) ? memory : fs::temp_directory_path()) /
                    ("cover_fuzz_" + std::to_string(getpid()));
    fs::create_directory(made);
    std::atexit([] { fs::remove_all(folder()); });
    return made;
  }();
  return path;
}

std::string write(const char* name, std::string_view text) {
  const fs::path path = folder() / name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

/// Writes the files; returns the path of the mesh among them.
std::string write_files(std::string_view bytes, std::string_view format) {
  if (format == ".ele") {
    constexpr std::string_view separator = "#####\n";
    const std::size_t at = bytes.find(separator);
    if (at == std::string_view::npos) return write("a.ele", bytes);
    (void)write("a.node", bytes.substr(0, at));
    return write("a.ele", bytes.substr(at + separator.size()));
  }
  if (format == ".json") {
    (void)write("a.json", bytes);
    return write(
        "a.mesh",
        "MeshVersionFormatted 2\nDimension 2\nVertices\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
        "Edges\n5\n2 3 3\n1 2 3\n3 1 4\n3 4 5\n4 1 5\nTriangles\n2\n2 3 1 1\n3 4 1 2\nEnd\n");
  }
  return write(("a" + std::string(format)).c_str(), bytes);
}

void check(const cover::Output& output) {
  const auto regions = output.table.regions.size();
  const auto& tri = output.mesh.tri();
  for (const auto face : tri.faces()) {
    const auto region = output.mesh.region(face).value();
    if (region < 1 || region > regions) std::abort();
  }
  for (const auto& segment : output.pslg.segments)
    if (segment.a.index() >= tri.n_vertices() || segment.b.index() >= tri.n_vertices())
      std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view format = COVER_FUZZ_FORMAT;
  const std::string path =
      write_files(std::string_view(reinterpret_cast<const char*>(data), size), format);
  const auto output = cover::read_output(path);
  if (output) {
    check(*output);
  } else if (output.error().message.empty()) {
    std::abort();
  }
  if (format == ".vtu" || format == ".vtk" || format == ".vtp") {
    const auto input = cover::read_vtk_input(path);
    if (!input && input.error().message.empty()) std::abort();
  }
  return 0;
}
