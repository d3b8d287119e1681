// What ranks say to each other: bytes with a tag, of any length.
//
// Rank 0 reads, splits, meshes and writes; the others read files and mesh regions that it names,
// and write what they keep. All calls of MPI are made by the main thread of a rank.
#pragma once

#include <cstddef>
#include <list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <mpi.h>

#include <cover/error.hpp>
#include <cover/result.hpp>
#include <cover/share_out.hpp>

namespace cover::mpi {

enum class Tag : int {
  files,    ///< rank 0 to others: files to read, as bytes_of_files() makes them
  inputs,   ///< others to rank 0: a Parcel for each of them, in their order
  options,  ///< rank 0 to others: the options from here on
  regions,  ///< rank 0 to others: Parcels to be meshed
  meshes,   ///< others to rank 0: Parcels of what became of them
  keep,     ///< rank 0 to others: where meshes may stay; all of them agree then, see all_agree()
  write,    ///< rank 0 to others: a plan of what is to be written comes, see spread()
  written,  ///< others to rank 0: why that failed, see bytes_of_status(); empty: it did not
  failed,   ///< others to rank 0: why a rank cannot go on, likewise
  end,      ///< rank 0 to others: nothing more will come
};

/// A message that has come.
struct Message {
  int rank = 0;
  Tag tag = Tag::end;
  Bytes bytes;
};

/// Some regions or meshes by number, as one message.
struct Parcel {
  std::size_t number = 0;
  Bytes bytes;
};
Bytes pack(std::span<const Parcel> parcels);
std::vector<Parcel> unpack(std::span<const std::byte> bytes);

/// The code and the words of an error; empty: there is none.
Bytes bytes_of_status(const Status& status);
/// The error that another rank sent so, with the rank's name.
///
/// REQUIRES: the message is not empty
Error told_error(const Message& message);

/// How many processes there are.
int rank_count();

/// The next message from any rank, if one is there.
std::optional<Message> receive_if_any();
/// Waits for a message without taking the processor from others.
Message receive();
/// Returns when the bytes may go.
void send(std::span<const std::byte> bytes, int rank, Tag tag);

/// Messages on their way; sending waits for nobody, as a rank may be at work for long.
class Outbox {
 public:
  Outbox() = default;
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;
  /// Waits until all have arrived.
  ~Outbox();

  void send(Bytes bytes, int rank, Tag tag);
  /// Lets go of what has arrived.
  void tidy();

 private:
  struct Letter {
    std::size_t size = 0;
    Bytes bytes;
    std::vector<MPI_Request> requests;
  };
  std::list<Letter> letters_;
};

/// Whether all ranks agree; to be called by each of them.
bool all_agree(bool agrees);
/// What rank 0 has, for all ranks; to be called by each of them.
void spread(Bytes& bytes);

/// Sleeps for the time between two looks for messages.
void rest();

}  // namespace cover::mpi
