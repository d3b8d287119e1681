// A table says which parser each extension has.
// Tested by tests/unit/io/read_mesh/read_mesh_test.cpp.
#include <cover/read_mesh.hpp>

#include <algorithm>
#include <array>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/faults/errors.hpp"
#include "base/faults/out_of_memory.hpp"
#include "io/read_mesh/formats/mesh_of_data_set.hpp"
#include "io/read_mesh/formats/pieces/read_pvtu.hpp"
#include "io/read_mesh/formats/pieces/read_vtm.hpp"
#include "io/read_mesh/formats/read_vtkhdf_mesh.hpp"
#include "io/read_mesh/mesh_formats.hpp"
#include "io/text/text.hpp"
#include "io/vtk_files/read_data_set.hpp"

namespace cover {
namespace {

Result<MeshFile> read_vtk(const std::string& path) {
  const Result<DataSetFile> file = read_data_set(path);
  return file ? mesh_of(file->data, path) : file.error();
}

Result<MeshFile> read_hdf(const std::string& path) {
  Result<VtkHdfMesh> file = read_vtkhdf_mesh(path);
  return file ? Result<MeshFile>(std::move(file->mesh)) : std::move(file).error();
}

/// A reader of a text as one of a file.
template <Result<MeshFile> (*parse)(std::string_view, const std::string&)>
Result<MeshFile> read_text(const std::string& path) {
  const Result<std::string> text = read_file(path);
  return text ? parse(*text, path) : text.error();
}

struct Format {
  const char* extension;
  Result<MeshFile> (*read)(const std::string& path);
};

constexpr std::array kFormats{
    Format{".vtu", read_vtk},
    Format{".vtm", read_vtm_mesh},
    Format{".pvtu", read_pvtu_mesh},
    Format{".vtk", read_vtk},
    Format{".vtkhdf", read_hdf},
    Format{".msh", read_text<parse_msh_mesh>},
    Format{".xdmf", read_text<parse_xdmf>},
    Format{".mesh", read_text<parse_medit>},
    Format{".inp", read_text<parse_inp>},
    Format{".ele", read_triangle},
};

/// Why meshes in a format that write_mesh() knows cannot be read.
std::string_view reason(std::string_view extension) {
  if (extension == ".obj" || extension == ".off" || extension == ".ply")
    return ", which keeps no regions that could be read back";
  if (extension == ".json")
    return ", which is a geometry or names, but no mesh: give the mesh itself";
  return "";
}

}  // namespace

std::vector<std::string> mesh_formats() {
  std::vector<std::string> extensions;
  for (const Format& format : kFormats) extensions.emplace_back(format.extension);
  return extensions;
}

Result<MeshFile> read_mesh(const std::string& path) {
  return memory_as_value(path, [&]() -> Result<MeshFile> {
    const std::string extension = extension_of(path);
    const auto* const format = std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& f) {
      return f.extension == extension;
    });
    if (format == kFormats.end())
      return Error{ErrorCode::unsupported_format,
                   fmt::format("cannot read '{}' as a mesh{}: possible are {}", path,
                               reason(extension), listed(mesh_formats())),
                   {},
                   {}};
    Result<MeshFile> mesh = format->read(path);
    if (mesh && mesh->soup.triangles.empty()) return wrong_file(path, "no triangles in it");
    return mesh;
  });
}

}  // namespace cover
