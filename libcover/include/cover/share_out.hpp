// Regions meshed elsewhere: in other processes, on other machines.
//
// A region needs nothing of its neighbours, so any process may mesh any of them in any order, and
// the mesh is the same, byte for byte.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include <cover/result.hpp>

namespace cover {

struct Options;

/// What travels between processes of one program on machines of one kind.
using Bytes = std::vector<std::byte>;

/// The regions of one call of the library, for whoever shares them out.
class RegionJobs {
 public:
  RegionJobs() = default;
  RegionJobs(const RegionJobs&) = delete;
  RegionJobs& operator=(const RegionJobs&) = delete;
  virtual ~RegionJobs() = default;

  [[nodiscard]] virtual std::size_t size() const = 0;
  /// The expected work of a region, in triangles or so.
  [[nodiscard]] virtual std::size_t cost(std::size_t region) const = 0;
  /// What mesh_region_bytes() needs of a region.
  [[nodiscard]] virtual Bytes boundary(std::size_t region) const = 0;
  /// What options_of_bytes() needs.
  [[nodiscard]] virtual Bytes options() const = 0;
  /// Tells when all that is left may be left.
  [[nodiscard]] virtual std::stop_token stop() const = 0;

  /// To be called before anything is shared out. Where meshes may stay in the processes that make
  /// them, `offer` is called with what KeptRegions::open() needs, and says whether all others can
  /// do it; no file that it needs is there afterwards. True: boundary() is for KeptRegions::mesh()
  /// now, and accept() takes what that has made.
  virtual bool offer_to_keep(const std::function<bool(const Bytes& how)>& offer) = 0;

  /// Meshes a region in this process.
  ///
  /// Threads: any, each with regions of its own; accept() may run meanwhile
  virtual void mesh_here(std::size_t region) = 0;
  /// Meshes regions in this process on `threads` threads, the caller's among them. Each asks `take`
  /// for the next ones until there are none, and until then helps with what a large region can
  /// share out of itself.
  ///
  /// Threads: `take` is called by any of them; accept() may run meanwhile
  virtual void mesh_here(unsigned threads,
                         const std::function<std::vector<std::size_t>()>& take) = 0;
  /// Takes what mesh_region_bytes() made of a region in another process.
  ///
  /// Threads: as mesh_here()
  virtual void accept(std::size_t region, std::span<const std::byte> result) = 0;
};

/// Has every region of the jobs meshed, once, here or elsewhere. What goes wrong inside of a region
/// is kept with it; an error of this function is one of the way between processes.
using ShareOut = std::function<Status(RegionJobs&)>;

/// Has KeptRegions::write() carry out a plan in all other processes that keep meshes, while it
/// calls `here`, which does the same in this one. Returns when all have, with the first error.
using WriteElsewhere =
    std::function<Status(const Bytes& plan, const std::function<Status()>& here)>;

/// The options of a run elsewhere. A size field has its name alone: see load_size_field().
///
/// Errors: internal if the bytes are not those of RegionJobs::options() of this program
Result<Options> options_of_bytes(std::span<const std::byte> bytes);

/// Meshes one region for another process; an error is among the bytes.
///
/// Threads: any
Bytes mesh_region_bytes(std::span<const std::byte> boundary, const Options& options,
                        const std::stop_token& stop = {});

/// Puts meshes in the place of boundaries, as mesh_region_bytes() does, on `threads` threads, which
/// begin in this order and help each other with large regions.
void mesh_region_bytes(std::span<Bytes> regions, const Options& options, unsigned threads);

}  // namespace cover
