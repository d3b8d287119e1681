#include "io/write_mesh/vtk_formats/vtu_file.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/run_all.hpp"

namespace cover {
namespace {

constexpr std::size_t kCells = 400'000;  // some pieces, and more than are made at a time

double value(std::size_t k) { return 0.25 * static_cast<double>(k); }

/// Arrays that know their items by number, before and behind one that only writes them in order;
/// one of them is empty.
VtuGrid grid() {
  VtuGrid grid;
  grid.points = kCells;
  grid.cells = kCells;
  grid.coordinates = vtu_array<double>("Points", 3 * kCells, value);
  grid.cell_data.push_back(vtu_array<std::int32_t>("a", kCells, [](std::size_t k) { return k; }));
  VtuArray in_order = vtu_array<double>("b", kCells, value);
  in_order.write = [](BinaryWriter& out) {
    for (std::size_t k = 0; k < kCells; ++k) out.put(value(k));
  };
  grid.cell_data.push_back(in_order);
  grid.cell_data.push_back(vtu_array<double>("c", kCells, value));
  grid.cell_data.push_back(vtu_array<std::int64_t>("none", 0, [](std::size_t k) { return k; }));
  for (const char* name : {"connectivity", "offsets", "types"})
    grid.connectivity.push_back(
        vtu_array<std::uint8_t>(name, kCells, [](std::size_t k) { return k % 251; }));
  return grid;
}

std::string bytes(const Team& team) {
  std::string all;
  write_vtu_bytes(
      grid(), [&](std::string_view some) { all += some; }, team);
  return all;
}

/// Appends a number as it lies in memory.
template <class T>
void put(T number, std::string& out) {
  out.append(reinterpret_cast<const char*>(&number), sizeof number);
}

TEST(VtuFile, HasTheSameBytesForAnyNumberOfThreads) {
  const std::string alone = bytes(Team());
  std::string appended;
  put<std::uint64_t>(4 * kCells, appended);
  for (std::size_t k = 0; k < kCells; ++k) put(static_cast<std::int32_t>(k), appended);
  for (int times = 0; times < 2; ++times) {
    put<std::uint64_t>(8 * kCells, appended);
    for (std::size_t k = 0; k < kCells; ++k) put(value(k), appended);
  }
  put<std::uint64_t>(0, appended);
  put<std::uint64_t>(24 * kCells, appended);
  for (std::size_t k = 0; k < 3 * kCells; ++k) put(value(k), appended);
  for (int times = 0; times < 3; ++times) {
    put<std::uint64_t>(kCells, appended);
    for (std::size_t k = 0; k < kCells; ++k) appended += static_cast<char>(k % 251);
  }
  const std::size_t begin = alone.find("\n   _") + 5;
  EXPECT_TRUE(alone.compare(begin, appended.size(), appended) == 0);
  EXPECT_EQ(alone.substr(begin + appended.size()), "\n  </AppendedData>\n</VTKFile>\n");
  for (const unsigned workers : {2U, 3U, 7U})
    with_team(workers, [&](const Team& team) { EXPECT_TRUE(bytes(team) == alone); });
}

/// What ends writing, as a full disk might, ends all of it.
TEST(VtuFile, ThrowsWhatTheSinkThrows) {
  for (const unsigned workers : {1U, 3U}) {
    with_team(workers, [&](const Team& team) {
      std::size_t calls = 0;
      const ByteSink sink = [&](std::string_view) {
        if (++calls == 20) throw std::runtime_error("full");
      };
      EXPECT_THROW(write_vtu_bytes(grid(), sink, team), std::runtime_error);
      EXPECT_EQ(calls, 20U);
    });
  }
}

}  // namespace
}  // namespace cover
