// The files of a mesh that is more than one file.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <unordered_set>
#include <vector>

#include <cover/result.hpp>

#include "io/files/byte_sink.hpp"
#include "io/files/temporary_file.hpp"

namespace cover {

/// The folder X/ of the pieces X_K_HASH.vtu that a file X.vtm names; those of X.pvtu are
/// X.parts/X.parts_K_HASH.vtu. Since the hash is that of a piece's content, new pieces stand beside
/// the old ones until X.vtm is replaced, by one rename; then the old ones go. Whenever that is
/// interrupted, X.vtm and its pieces are those of one mesh, and what is left over goes when X.vtm
/// is written again.
///
/// What else is in the folder is not ours and stays.
/// Threads: one object at a time writes to a folder; others wait, also those of other processes.
class PieceFolder {
 public:
  /// Makes the folder where it is not there, and waits for it. `target` is X.vtm, and `shown` its
  /// name for messages.
  ///
  /// Errors: cannot_write; cancelled
  static Result<PieceFolder> open(const std::filesystem::path& target, const std::string& shown,
                                  std::stop_token stop);

  PieceFolder(PieceFolder&& other) noexcept;
  PieceFolder& operator=(PieceFolder&&) = delete;
  PieceFolder(const PieceFolder&) = delete;
  PieceFolder& operator=(const PieceFolder&) = delete;
  /// Removes what was added, unless it was committed.
  ~PieceFolder();

  /// Adds a piece that `write` writes; one that is there already, whole, stays as it is. The result
  /// is its name as X.vtm wants it.
  ///
  /// Errors: cannot_write; cancelled
  Result<std::string> add(const std::function<void(const ByteSink&)>& write);

  /// Replaces X.vtm by `text`, which names all the pieces that were added.
  ///
  /// Errors: cannot_write; cancelled
  Status commit(std::string_view text);

 private:
  PieceFolder() = default;
  Status lock();
  Status sync_pieces();
  void remove_old_pieces();

  std::filesystem::path target_;
  std::string stem_;
  std::filesystem::path folder_;
  std::string shown_;
  std::stop_token stop_;
  std::optional<FileOwner> owner_;
  int lock_ = -1;  ///< -1: moved from
  bool is_made_ = false;
  std::unordered_set<std::string> named_before_;  ///< pieces that the old X.vtm names
  std::vector<std::string> pieces_;
  std::vector<std::string> made_;  ///< those of them that were not there
};

}  // namespace cover
