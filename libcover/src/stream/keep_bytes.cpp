// Tested by tests/unit/stream/kept_regions_test.cpp.
#include "stream/keep_bytes.hpp"

#include <cstring>
#include <type_traits>
#include <vector>

namespace cover {
namespace {

template <class T>
void put_items(std::span<const T> items, Bytes& out) {
  static_assert(std::is_trivially_copyable_v<T>);
  const std::uint64_t count = items.size();
  const auto size = std::as_bytes(std::span(&count, 1));
  const auto bytes = std::as_bytes(items);
  out.insert(out.end(), size.begin(), size.end());
  out.insert(out.end(), bytes.begin(), bytes.end());
}

/// Takes what put_items() put from the front of `rest`; false where that is not all there.
template <class Items>
bool take_items(std::span<const std::byte>& rest, Items& out) {
  std::uint64_t count = 0;
  if (rest.size() < sizeof count) return false;
  std::memcpy(&count, rest.data(), sizeof count);
  rest = rest.subspan(sizeof count);
  constexpr std::size_t kEach = sizeof(typename Items::value_type);
  if (count > rest.size() / kEach) return false;
  out.resize(count);
  if (count > 0) std::memcpy(out.data(), rest.data(), count * kEach);
  rest = rest.subspan(count * kEach);
  return true;
}

using Numbers = std::vector<std::uint64_t>;

}  // namespace

Bytes to_bytes(const OfferToKeep& offer) {
  Bytes out;
  put_items<char>(offer.beside, out);
  put_items<char>(offer.seen, out);
  put_items<std::uint64_t>(Numbers{offer.word, offer.input_vertices, offer.regions}, out);
  return out;
}

std::optional<OfferToKeep> offer_of_bytes(std::span<const std::byte> bytes) {
  OfferToKeep offer;
  Numbers numbers;
  if (!take_items(bytes, offer.beside) || !take_items(bytes, offer.seen) ||
      !take_items(bytes, numbers) || numbers.size() != 3 || !bytes.empty())
    return std::nullopt;
  offer.word = numbers[0];
  offer.input_vertices = numbers[1];
  offer.regions = numbers[2];
  return offer;
}

Bytes to_bytes(const ColumnPlan& plan) {
  Bytes out;
  put_items<char>(plan.path, out);
  put_items<char>(plan.shown, out);
  put_items<std::uint64_t>(Numbers{plan.input_vertices}, out);
  put_items<ColumnPlace>(plan.columns, out);
  put_items<RegionCounts>(plan.regions, out);
  return out;
}

std::optional<ColumnPlan> plan_of_bytes(std::span<const std::byte> bytes) {
  ColumnPlan plan;
  Numbers numbers;
  if (!take_items(bytes, plan.path) || !take_items(bytes, plan.shown) ||
      !take_items(bytes, numbers) || numbers.size() != 1 || !take_items(bytes, plan.columns) ||
      !take_items(bytes, plan.regions) || !bytes.empty())
    return std::nullopt;
  plan.input_vertices = numbers[0];
  return plan;
}

}  // namespace cover
