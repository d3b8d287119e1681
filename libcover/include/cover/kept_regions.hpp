// Meshes that stay in the process that made them until a file is written: no mesh travels.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>

#include <cover/result.hpp>
#include <cover/share_out.hpp>

namespace cover {

struct Options;

/// What a process meshes for another one and keeps, in a spool file beside the file that will be
/// written. The other process has what RegionJobs::offer_to_keep() says.
class KeptRegions {
 public:
  /// `how` is what RegionJobs::offer_to_keep() offers.
  ///
  /// Errors: cannot_write where this process does not see the folder of the file; internal if the
  ///         bytes are not those of this program
  static Result<KeptRegions> open(std::span<const std::byte> how);
  KeptRegions(KeptRegions&& other) noexcept;
  KeptRegions& operator=(KeptRegions&& other) noexcept;
  KeptRegions(const KeptRegions&) = delete;
  KeptRegions& operator=(const KeptRegions&) = delete;
  ~KeptRegions();

  /// Meshes the regions with these numbers, as mesh_region_bytes() does; in the place of each comes
  /// what is told of its mesh.
  void mesh(std::span<const std::size_t> numbers, std::span<Bytes> regions, const Options& options,
            unsigned threads);

  /// Writes what belongs to these regions, by a plan from Callbacks::write_elsewhere.
  ///
  /// Errors: cannot_write; internal if the plan is none of this program
  [[nodiscard]] Status write(std::span<const std::byte> plan, unsigned threads) const;

 private:
  struct Spool;
  explicit KeptRegions(std::unique_ptr<Spool> spool);

  std::unique_ptr<Spool> spool_;
};

}  // namespace cover
