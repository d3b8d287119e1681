#include "messages.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <thread>

namespace cover::mpi {
namespace {

/// MPI counts in int: longer messages go in pieces.
constexpr std::size_t kPiece = std::size_t{1} << 28;

/// Calls `each` with every piece of a message: where it begins and how long it is.
template <class Each>
void for_pieces(std::size_t size, Each each) {
  for (std::size_t at = 0; at < size; at += kPiece)
    each(at, static_cast<int>(std::min(kPiece, size - at)));
}

template <class T>
void append(const T& value, Bytes& bytes) {
  const auto* first = reinterpret_cast<const std::byte*>(&value);
  bytes.insert(bytes.end(), first, first + sizeof value);
}

std::size_t take_size(std::span<const std::byte>& rest) {
  std::size_t value = 0;
  std::memcpy(&value, rest.data(), sizeof value);
  rest = rest.subspan(sizeof value);
  return value;
}

}  // namespace

Bytes pack(std::span<const Parcel> parcels) {
  Bytes bytes;
  for (const Parcel& parcel : parcels) {
    append(parcel.number, bytes);
    append(parcel.bytes.size(), bytes);
    bytes.insert(bytes.end(), parcel.bytes.begin(), parcel.bytes.end());
  }
  return bytes;
}

std::vector<Parcel> unpack(std::span<const std::byte> bytes) {
  std::vector<Parcel> parcels;
  while (!bytes.empty()) {
    const std::size_t number = take_size(bytes), size = take_size(bytes);
    const std::span<const std::byte> content = bytes.first(size);
    parcels.push_back({number, {content.begin(), content.end()}});
    bytes = bytes.subspan(size);
  }
  return parcels;
}

Bytes bytes_of_status(const Status& status) {
  if (status) return {};
  const auto code = static_cast<std::int32_t>(status.error().code);
  const std::string& text = status.error().message;
  Bytes bytes(sizeof code + text.size());
  std::memcpy(bytes.data(), &code, sizeof code);
  std::memcpy(bytes.data() + sizeof code, text.data(), text.size());
  return bytes;
}

Error told_error(const Message& message) {
  std::int32_t code = 0;
  std::memcpy(&code, message.bytes.data(), sizeof code);
  const auto* text = reinterpret_cast<const char*>(message.bytes.data()) + sizeof code;
  return {static_cast<ErrorCode>(code),
          "rank " + std::to_string(message.rank) + ": " +
              std::string(text, message.bytes.size() - sizeof code),
          {},
          {}};
}

int rank_count() {
  int count = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  return count;
}

std::optional<Message> receive_if_any() {
  int there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
  if (there == 0) return std::nullopt;
  // What one rank sends under one tag arrives in order: first the length, then the pieces.
  const int rank = status.MPI_SOURCE, tag = status.MPI_TAG;
  std::size_t size = 0;
  MPI_Recv(&size, sizeof size, MPI_BYTE, rank, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  Message message{rank, static_cast<Tag>(tag), Bytes(size)};
  for_pieces(size, [&](std::size_t at, int count) {
    MPI_Recv(message.bytes.data() + at, count, MPI_BYTE, rank, tag, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
  });
  return message;
}

Message receive() {
  while (true) {
    if (std::optional<Message> message = receive_if_any()) return *std::move(message);
    rest();
  }
}

void send(std::span<const std::byte> bytes, int rank, Tag tag) {
  const std::size_t size = bytes.size();
  MPI_Send(&size, sizeof size, MPI_BYTE, rank, static_cast<int>(tag), MPI_COMM_WORLD);
  for_pieces(size, [&](std::size_t at, int count) {
    MPI_Send(bytes.data() + at, count, MPI_BYTE, rank, static_cast<int>(tag), MPI_COMM_WORLD);
  });
}

bool all_agree(bool agrees) {
  int mine = agrees ? 1 : 0, all = 0;
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  return all != 0;
}

void spread(Bytes& bytes) {
  std::size_t size = bytes.size();
  MPI_Bcast(&size, sizeof size, MPI_BYTE, 0, MPI_COMM_WORLD);
  bytes.resize(size);
  for_pieces(size, [&](std::size_t at, int count) {
    MPI_Bcast(bytes.data() + at, count, MPI_BYTE, 0, MPI_COMM_WORLD);
  });
}

Outbox::~Outbox() {
  for (Letter& letter : letters_)
    MPI_Waitall(static_cast<int>(letter.requests.size()), letter.requests.data(),
                MPI_STATUSES_IGNORE);
}

void Outbox::send(Bytes bytes, int rank, Tag tag) {
  Letter& letter = letters_.emplace_back();
  letter.bytes = std::move(bytes);
  letter.size = letter.bytes.size();
  const auto post = [&](const void* data, int count) {
    MPI_Isend(data, count, MPI_BYTE, rank, static_cast<int>(tag), MPI_COMM_WORLD,
              &letter.requests.emplace_back());
  };
  post(&letter.size, sizeof letter.size);
  for_pieces(letter.size,
             [&](std::size_t at, int count) { post(letter.bytes.data() + at, count); });
}

void Outbox::tidy() {
  letters_.remove_if([](Letter& letter) {
    int arrived = 0;
    MPI_Testall(static_cast<int>(letter.requests.size()), letter.requests.data(), &arrived,
                MPI_STATUSES_IGNORE);
    return arrived != 0;
  });
}

void rest() { std::this_thread::sleep_for(std::chrono::microseconds(100)); }

}  // namespace cover::mpi
