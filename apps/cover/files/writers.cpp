#include "files/writers.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <cover/files.hpp>
#include <cover/picture.hpp>
#include <cover/text.hpp>
#include <cover/write_mesh.hpp>

#include "files/temporary_folder.hpp"
#include "page/html_report.hpp"
#include "png/draw_png.hpp"
#include "terminal/console.hpp"

namespace cover::app {
namespace {

struct Format {
  std::string extension;
  Writer write;
};

/// The picture that `cover render` makes, with the names that only the run knows.
template <auto Draw, int Order>
Status draw_with(const Output& output, const std::string& path, const std::stop_token&) {
  PictureOptions options;
  options.title = fmt::format("{}: {} triangles", std::filesystem::path(path).stem().string(),
                              grouped(output.report.quality.triangles));
  return Draw(picture_of(output, Order), options, path);
}

const std::vector<Format>& picture_formats(int order = 1) {
  static const std::vector<Format> formats{{".svg", draw_with<write_svg, 1>},
                                           {".png", draw_with<draw_png, 1>}},
      curved{{".svg", draw_with<write_svg, 2>}, {".png", draw_with<draw_png, 2>}};
  return order == 2 ? curved : formats;
}

Status report_as_json(const Output& output, const std::string& path, const std::stop_token&) {
  return write_report_json(output, path);
}

template <int Order>
Status page_with(const Output& output, const std::string& path, const std::stop_token&) {
  return write_report_html(output, path, Order);
}

const std::vector<Format>& report_formats(int order) {
  static const std::vector<Format> formats{{".json", report_as_json}, {".html", page_with<1>}},
      curved{{".json", report_as_json}, {".html", page_with<2>}};
  return order == 2 ? curved : formats;
}

std::vector<std::string> extensions(const std::vector<Format>& formats) {
  std::vector<std::string> names;
  for (const Format& format : formats) names.push_back(format.extension);
  return names;
}

Result<Writer> find(const std::vector<Format>& formats, const std::string& path) {
  const std::string extension = extension_of(path);
  for (const Format& format : formats) {
    if (format.extension == extension) return format.write;
  }
  return unknown_output_format(path, extensions(formats));
}

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, Close>;

/// By errno, where a call has set it.
Error stdout_failed() {
  const std::string why = errno != 0 ? ": " + std::generic_category().message(errno) : "";
  return {ErrorCode::cannot_write, "cannot write to standard output" + why, {}, {}};
}

Status copy_to_stdout(std::FILE* file) {
  std::array<char, 65536> buffer;
  bool good = true;
  errno = 0;
  for (std::size_t n = 0; good && (n = std::fread(buffer.data(), 1, buffer.size(), file)) > 0;) {
    good = std::fwrite(buffer.data(), 1, n, stdout) == n;
  }
  return good && std::fflush(stdout) == 0 ? ok() : Status(stdout_failed());
}

}  // namespace

Result<Writer> mesh_writer(const std::string& path, const WriteOptions& options) {
  if (Result<Writer> picture = find(picture_formats(options.order), path)) {
    if (extension_of(path) == ".png") {
      if (Status there = can_draw_png(); !there) return std::move(there).error();
    }
    return picture;
  }
  if (Status status = can_write(path, options); !status) {
    Error error = std::move(status).error();
    if (error.code == ErrorCode::unsupported_format) {
      error.message += ", " + listed(extensions(picture_formats()));
    }
    return error;
  }
  return Writer(
      [options](const Output& output, const std::string& target, const std::stop_token& stop) {
        WriteOptions stopped = options;
        stopped.stop = stop;
        return write_mesh(output, target, stopped);
      });
}

Result<Writer> stdout_writer(const std::string& format, const WriteOptions& options) {
  if (is_several_files("stdout." + format, options))
    return Error{ErrorCode::bad_option,
                 fmt::format("a mesh in .{}{} is more than one file: give -o a name for it", format,
                             options.parts > 1  ? " in parts"
                             : format == "xdmf" ? " with HDF5"
                                                : ""),
                 {},
                 {}};
  return mesh_writer("stdout." + format, options);
}

Result<Writer> report_writer(const std::string& path, int order) {
  return find(report_formats(order), path);
}

std::string mesh_extensions() {
  return fmt::format("{}, {}", listed(write_formats()), listed(extensions(picture_formats())));
}

std::string extension_of_output(const std::string& path, const std::string& format) {
  return path == "-" ? "." + format : extension_of(path);
}

Status write_to(const std::string& path, const std::string& extension,
                const std::function<Status(const std::string&)>& write) {
  if (path != "-") return write(path);
  OpenFile file;
  {
    const auto folder = temporary_folder("cover-stdout");
    if (!folder) return folder.error();
    const std::string name = folder->path() / ("stdout" + extension);
    if (Status written = write(name); !written) return written;
    file.reset(std::fopen(name.c_str(), "rb"));
  }
  // The folder is gone already: whoever stops reading ends the program in the middle of this.
  return file ? copy_to_stdout(file.get()) : Status(stdout_failed());
}

Status write_to(const Writer& writer, const Output& output, const std::string& path,
                const std::string& extension, const std::stop_token& stop) {
  return write_to(path, extension,
                  [&](const std::string& target) { return writer(output, target, stop); });
}

}  // namespace cover::app
