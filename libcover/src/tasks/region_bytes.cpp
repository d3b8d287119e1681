// Tested by tests/unit/pipeline/share_out_test.cpp.
#include "tasks/region_bytes.hpp"

#include <concepts>
#include <cstring>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

namespace cover {
namespace {

template <class T, class Of>
concept Either = std::same_as<std::remove_const_t<T>, Of>;

template <Either<Note> T>
auto members(T& note) {
  auto& [kind, region, message, where] = note;
  return std::tie(kind, region, message, where);
}

template <Either<Error> T>
auto members(T& error) {
  auto& [code, message, where, inputs] = error;
  return std::tie(code, message, where, inputs);
}

template <Either<LayerReport::Short> T>
auto members(T& part) {
  auto& [why, segments, at] = part;
  return std::tie(why, segments, at);
}

template <Either<LayerRule> T>
auto members(T& rule) {
  auto& [line, region, first, growth, count] = rule;
  return std::tie(line, region, first, growth, count);
}

template <Either<LayerReport> T>
auto members(T& report) {
  auto& [asked, segments, length, complete, fewest, most, thickness, cut_short] = report;
  return std::tie(asked, segments, length, complete, fewest, most, thickness, cut_short);
}

template <Either<RegionReport> T>
auto members(T& report) {
  auto& [id, method, nu_opt, nu_bound, quality, box, couplings, input_vertices, steiner_vertices,
         forced_above_120, forced_above_150, layers, limits, has_no_room, bound_held, notes,
         seconds] = report;
  return std::tie(id, method, nu_opt, nu_bound, quality, box, couplings, input_vertices,
                  steiner_vertices, forced_above_120, forced_above_150, layers, limits, has_no_room,
                  bound_held, notes, seconds);
}

template <Either<RegionMesh> T>
auto members(T& mesh) {
  auto& [steiner, triangles, layer_triangles, layer_vertices, report] = mesh;
  return std::tie(steiner, triangles, layer_triangles, layer_vertices, report);
}

template <Either<KeptMesh> T>
auto members(T& mesh) {
  auto& [report, steiner, triangles, half_edges] = mesh;
  return std::tie(report, steiner, triangles, half_edges);
}

template <Either<RegionBoundary> T>
auto members(T& boundary) {
  auto& [id, points, vertices, sides, segments, size, size_at, size_expressions, size_function,
         layers, is_part, known_cdt] = boundary;
  static_cast<void>(size_function);
  static_cast<void>(known_cdt);  // finding them again is not more than sending them
  return std::tie(id, points, vertices, sides, segments, size, size_at, size_expressions, layers,
                  is_part);
}

template <Either<SizeRule> T>
auto members(T& rule) {
  auto& [name, size, at, expression] = rule;
  return std::tie(name, size, at, expression);
}

template <Either<PeriodicRule> T>
auto members(T& rule) {
  auto& [from, to, map, centre, angle] = rule;
  return std::tie(from, to, map, centre, angle);
}

template <Either<Options> T>
auto members(T& options) {
  auto& [method, fill, paper, pieces, hull, max_angle, min_angle, prefer, effort, couplings, sizes,
         input_sizes, size_field, size_field_name, size_of, size_step, growth, box_method,
         split_interfaces, layers, periodic, overlap, weld, strict, merge_materials, require,
         threads] = options;
  static_cast<void>(size_field);
  return std::tie(method, fill, paper, pieces, hull, max_angle, min_angle, prefer, effort,
                  couplings, sizes, input_sizes, size_field_name, size_of, size_step, growth,
                  box_method, split_interfaces, layers, periodic, overlap, weld, strict,
                  merge_materials, require, threads);
}

/// As it lies in memory.
template <class T>
concept Plain = std::is_trivially_copyable_v<T>;

class ByteWriter {
 public:
  template <Plain T>
  void put(const T& value) {
    append(&value, sizeof value);
  }
  void put(const std::string& text) {
    put(text.size());
    append(text.data(), text.size());
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(values.size());
    if constexpr (Plain<T>) {
      append(values.data(), values.size() * sizeof(T));
    } else {
      for (const T& value : values) put(value);
    }
  }
  template <class T>
  requires requires(const T& value) { members(value); }
  void put(const T& value) {
    std::apply([this](const auto&... member) { (this->put(member), ...); }, members(value));
  }
  [[nodiscard]] Bytes take() { return std::move(bytes_); }

 private:
  void append(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  Bytes bytes_;
};

/// Reads what a ByteWriter put. After the end, everything is empty, and whole() is false.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <Plain T>
  void get(T& value) {
    take(&value, sizeof value);
  }
  void get(std::string& text) {
    text.resize(count(1));
    take(text.data(), text.size());
  }
  template <class T>
  void get(std::vector<T>& values) {
    values.resize(count(Plain<T> ? sizeof(T) : 1));
    if constexpr (Plain<T>) {
      take(values.data(), values.size() * sizeof(T));
    } else {
      for (T& value : values) get(value);
    }
  }
  template <class T>
  requires requires(T& value) { members(value); }
  void get(T& value) {
    std::apply([this](auto&... member) { (this->get(member), ...); }, members(value));
  }
  /// Whether all was there, and nothing is left.
  [[nodiscard]] bool whole() const { return !short_ && rest_.empty(); }

 private:
  /// A number of elements that the rest can hold.
  std::size_t count(std::size_t bytes_each) {
    std::size_t n = 0;
    get(n);
    if (n <= rest_.size() / bytes_each) return n;
    short_ = true;
    return 0;
  }
  void take(void* data, std::size_t size) {
    if (size > rest_.size()) {
      short_ = true;
      rest_ = {};
      return;
    }
    if (size > 0) std::memcpy(data, rest_.data(), size);
    rest_ = rest_.subspan(size);
  }

  std::span<const std::byte> rest_;
  bool short_ = false;
};

/// The first byte of a mesh or of an error in its place.
enum class Answer : std::uint8_t { mesh, error };

template <class T>
Bytes bytes_of(const T& value) {
  ByteWriter writer;
  writer.put(value);
  return writer.take();
}

Error not_ours() {
  return {ErrorCode::internal, "another process sent what this one cannot read", {}, {}};
}

template <class T>
Result<T> value_of(std::span<const std::byte> bytes) {
  ByteReader reader(bytes);
  T value;
  reader.get(value);
  if (!reader.whole()) return not_ours();
  return value;
}

/// A value or an error.
template <class T>
Bytes bytes_of_result(const Result<T>& result) {
  ByteWriter writer;
  writer.put(result ? Answer::mesh : Answer::error);
  if (result) {
    writer.put(*result);
  } else {
    writer.put(result.error());
  }
  return writer.take();
}

template <class T>
Result<T> result_of_bytes(std::span<const std::byte> bytes) {
  if (bytes.empty()) return not_ours();
  if (bytes.front() == std::byte{static_cast<std::uint8_t>(Answer::mesh)})
    return value_of<T>(bytes.subspan(1));
  ByteReader reader(bytes.subspan(1));
  Error sent;
  reader.get(sent);
  return reader.whole() ? std::move(sent) : not_ours();
}

}  // namespace

Bytes to_bytes(const RegionBoundary& boundary) { return bytes_of(boundary); }
Bytes to_bytes(const Options& options) { return bytes_of(options); }

Bytes to_bytes(const Result<RegionMesh>& mesh) { return bytes_of_result(mesh); }
Bytes to_bytes(const Result<KeptMesh>& mesh) { return bytes_of_result(mesh); }

Result<RegionBoundary> boundary_of_bytes(std::span<const std::byte> bytes) {
  return value_of<RegionBoundary>(bytes);
}

Result<Options> options_of_bytes(std::span<const std::byte> bytes) {
  return value_of<Options>(bytes);
}

Result<RegionMesh> mesh_of_bytes(std::span<const std::byte> bytes) {
  return result_of_bytes<RegionMesh>(bytes);
}

Result<KeptMesh> kept_of_bytes(std::span<const std::byte> bytes) {
  return result_of_bytes<KeptMesh>(bytes);
}

}  // namespace cover
