#include "output_files.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cover/write_mesh.hpp>

namespace cover::app {
namespace {

struct Format {
  std::string extension;
  Writer write;
};

const std::vector<Format>& mesh_formats() {
  static const std::vector<Format> formats{
      {".vtu", write_vtu},
      {".vtm", write_vtm},
      {".poly", [](const Output& output, const std::string& path) {
         return write_poly(output.pslg, output.table, path);
       }}};
  return formats;
}

const std::vector<Format>& report_formats() {
  static const std::vector<Format> formats{{".json", write_report_json}};
  return formats;
}

std::string extensions(const std::vector<Format>& formats) {
  std::vector<std::string> names;
  for (const Format& format : formats) names.push_back(format.extension);
  return fmt::format("{}", fmt::join(names, ", "));
}

Result<Writer> find(const std::vector<Format>& formats, const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension();
  for (const Format& format : formats) {
    if (format.extension == extension) return format.write;
  }
  return Error{ErrorCode::unsupported_format,
               fmt::format("cannot write '{}': {}; possible are {}", path,
                           extension.empty() ? "the name has no extension that tells the format"
                                             : fmt::format("unknown format '{}'", extension),
                           extensions(formats)),
               {},
               {}};
}

/// A folder of our own that vanishes with its contents.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = std::filesystem::temp_directory_path() / "cover-XXXXXX";
    if (mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

Status copy_to_stdout(const std::string& path) {
  const Error failed{ErrorCode::cannot_write, "cannot write to standard output", {}, {}};
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) return failed;
  std::array<char, 65536> buffer;
  bool good = true;
  for (std::size_t n = 0; good && (n = std::fread(buffer.data(), 1, buffer.size(), file)) > 0;) {
    good = std::fwrite(buffer.data(), 1, n, stdout) == n;
  }
  std::fclose(file);
  return good && std::fflush(stdout) == 0 ? ok() : Status(failed);
}

}  // namespace

Result<Writer> mesh_writer(const std::string& path) { return find(mesh_formats(), path); }

Result<Writer> report_writer(const std::string& path) { return find(report_formats(), path); }

std::string mesh_extensions() { return extensions(mesh_formats()); }

Status write_to(const Writer& writer, const Output& output, const std::string& path,
                const std::string& extension) {
  if (path != "-") return writer(output, path);
  const TemporaryFolder folder;
  if (folder.path().empty()) {
    return Error{ErrorCode::cannot_write, "cannot create a temporary folder", {}, {}};
  }
  const std::string file = folder.path() / ("stdout" + extension);
  Status written = writer(output, file);
  return written ? copy_to_stdout(file) : written;
}

}  // namespace cover::app
