#include "files/temporary_folder.hpp"

#include <filesystem>
#include <system_error>

namespace cover::app {

Result<ScratchFolder> temporary_folder(std::string_view name) {
  std::error_code code;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(code);
  if (code)
    return Error{ErrorCode::cannot_write,
                 "cannot write temporary files: $TMPDIR is no folder: " + code.message(),
                 {},
                 {}};
  return ScratchFolder::beside((folder / name).string());
}

}  // namespace cover::app
