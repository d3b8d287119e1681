// The library lays the file out; the numbers of data sets come between its structures as they are
// written, so that no copy of a mesh is made.
// Tested by tests/unit/io/write_mesh/vtk_formats/write_vtkhdf_test.cpp.
#include "io/hdf5/hdf5_writer.hpp"

#include <algorithm>
#include <utility>

#include "io/hdf5/hdf5_layout.hpp"

namespace cover {
namespace {

/// An object of the library.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close end) : id_(id), close_(end) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }  // NOLINT: stands for it in every call
  [[nodiscard]] bool is_open() const { return id_ >= 0; }
  /// Closes it now; false where that fails.
  bool close() { return close_(std::exchange(id_, -1)) >= 0; }

 private:
  hid_t id_;
  Close close_;
};

/// Keeps the library from printing what goes wrong.
class Silence {
 public:
  explicit Silence(const Hdf5Library& hdf5) : hdf5_(hdf5) {
    hdf5_.H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    hdf5_.H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Silence() { hdf5_.H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  const Hdf5Library& hdf5_;
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

hid_t native_type(const Hdf5Library& hdf5, NumberType type) {
  switch (type) {
    case NumberType::int8:
      return hdf5.H5T_NATIVE_INT8_g;
    case NumberType::uint8:
      return hdf5.H5T_NATIVE_UINT8_g;
    case NumberType::int16:
      return hdf5.H5T_NATIVE_INT16_g;
    case NumberType::uint16:
      return hdf5.H5T_NATIVE_UINT16_g;
    case NumberType::int32:
      return hdf5.H5T_NATIVE_INT32_g;
    case NumberType::uint32:
      return hdf5.H5T_NATIVE_UINT32_g;
    case NumberType::int64:
      return hdf5.H5T_NATIVE_INT64_g;
    case NumberType::uint64:
      return hdf5.H5T_NATIVE_UINT64_g;
    case NumberType::float32:
      return hdf5.H5T_NATIVE_FLOAT_g;
    case NumberType::float64:
      break;
  }
  return hdf5.H5T_NATIVE_DOUBLE_g;
}

using Extent = Hdf5Plan::Extent;

/// Makes the objects of a file. Every function is false where the library fails.
class Maker {
 public:
  Maker(const Hdf5Library& hdf5, hid_t file) : hdf5_(hdf5), file_(file) {}

  bool make(const Hdf5Content& content) {
    const auto all = [](const auto& items, auto add) {
      return std::all_of(items.begin(), items.end(), add);
    };
    return all(content.groups, [&](const std::string& path) { return group(path); }) &&
           all(content.attributes, [&](const Hdf5Attribute& what) { return attribute(what); }) &&
           all(content.numbers, [&](const Hdf5Numbers& what) { return numbers(what); }) &&
           all(content.texts, [&](const Hdf5Texts& what) { return texts(what); });
  }

  [[nodiscard]] std::vector<Extent> extents() && {
    std::sort(extents_.begin(), extents_.end(),
              [](const Extent& a, const Extent& b) { return a.at < b.at; });
    return std::move(extents_);
  }

 private:
  [[nodiscard]] bool group(const std::string& path) const {
    const Handle creation(hdf5_.H5Pcreate(hdf5_.H5P_CLS_GROUP_CREATE_ID_g), hdf5_.H5Pclose);
    if (hdf5_.H5Pset_obj_track_times(creation, false) < 0) return false;
    return Handle(hdf5_.H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT),
                  hdf5_.H5Gclose)
        .is_open();
  }

  [[nodiscard]] bool attribute(const Hdf5Attribute& what) const {
    const Handle group(hdf5_.H5Gopen2(file_, what.group.c_str(), H5P_DEFAULT), hdf5_.H5Gclose);
    const bool is_text = what.numbers.empty();
    const Handle type(hdf5_.H5Tcopy(is_text ? hdf5_.H5T_C_S1_g : hdf5_.H5T_NATIVE_INT64_g),
                      hdf5_.H5Tclose);
    if (is_text && hdf5_.H5Tset_size(type, std::max<std::size_t>(what.text.size(), 1)) < 0)
      return false;
    const hsize_t count = what.numbers.size();
    const Handle space(
        is_text ? hdf5_.H5Screate(H5S_SCALAR) : hdf5_.H5Screate_simple(1, &count, nullptr),
        hdf5_.H5Sclose);
    const Handle made(
        hdf5_.H5Acreate2(group, what.name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
        hdf5_.H5Aclose);
    const void* value = is_text ? static_cast<const void*>(what.text.c_str()) : what.numbers.data();
    return made.is_open() && hdf5_.H5Awrite(made, type, value) >= 0;
  }

  /// A data set that has its place from the start.
  [[nodiscard]] hid_t data_set(const std::string& path, hid_t type,
                               const std::vector<std::uint64_t>& shape,
                               H5D_fill_time_t fill) const {
    const std::vector<hsize_t> sizes(shape.begin(), shape.end());
    const Handle space(
        hdf5_.H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr),
        hdf5_.H5Sclose);
    const Handle creation(hdf5_.H5Pcreate(hdf5_.H5P_CLS_DATASET_CREATE_ID_g), hdf5_.H5Pclose);
    if (hdf5_.H5Pset_layout(creation, H5D_CONTIGUOUS) < 0 ||
        hdf5_.H5Pset_alloc_time(creation, H5D_ALLOC_TIME_EARLY) < 0 ||
        hdf5_.H5Pset_fill_time(creation, fill) < 0 ||
        hdf5_.H5Pset_obj_track_times(creation, false) < 0)
      return -1;
    return hdf5_.H5Dcreate2(file_, path.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  }

  bool numbers(const Hdf5Numbers& what) {
    const Handle made(
        data_set(what.path, native_type(hdf5_, what.type), what.shape, H5D_FILL_TIME_NEVER),
        hdf5_.H5Dclose);
    if (!made.is_open()) return false;
    std::uint64_t bytes = size_of(what.type);
    for (const std::uint64_t n : what.shape) bytes *= n;
    if (bytes == 0) return true;
    const haddr_t at = hdf5_.H5Dget_offset(made);
    extents_.push_back({at, &what, bytes});
    return at != HADDR_UNDEF;
  }

  [[nodiscard]] bool texts(const Hdf5Texts& what) const {
    const Handle type(hdf5_.H5Tcopy(hdf5_.H5T_C_S1_g), hdf5_.H5Tclose);
    if (hdf5_.H5Tset_size(type, H5T_VARIABLE) < 0) return false;
    // Of texts the library wants to know what they are before they are written: none.
    const Handle made(data_set(what.path, type, {what.texts.size()}, H5D_FILL_TIME_IFSET),
                      hdf5_.H5Dclose);
    std::vector<const char*> begins;
    for (const std::string& text : what.texts) begins.push_back(text.c_str());
    return made.is_open() && (begins.empty() || hdf5_.H5Dwrite(made, type, H5S_ALL, H5S_ALL,
                                                               H5P_DEFAULT, begins.data()) >= 0);
  }

  const Hdf5Library& hdf5_;
  hid_t file_;
  std::vector<Extent> extents_;
};

using Use = std::function<void(std::uint64_t at, std::string_view bytes)>;

/// The structures of the library from `from` up to `to`.
void use_structures(const Hdf5Bytes& bytes, std::uint64_t from, std::uint64_t to, const Use& use) {
  constexpr std::uint64_t kMost = 1 << 16;
  std::string buffer;
  while (from < to) {
    buffer.resize(std::min(kMost, to - from));
    bytes.read(from, buffer.size(), buffer.data());
    use(from, buffer);
    from += buffer.size();
  }
}

}  // namespace

void Hdf5Plan::each_structure(const Use& use) const {
  std::uint64_t at = 0;
  for (const Extent& extent : extents) {
    use_structures(*structures, at, extent.at, use);
    at = extent.at + extent.bytes;
  }
  use_structures(*structures, at, size, use);
}

Result<Hdf5Plan> lay_out_hdf5(const Hdf5Content& content) {
  const Result<const Hdf5Library*> opened = hdf5_library();
  if (!opened) return opened.error();
  const Hdf5Library& hdf5 = **opened;
  const Silence silence(hdf5);
  Hdf5Layout layout(hdf5);
  Handle file(layout.create(), hdf5.H5Fclose);
  Maker maker(hdf5, file);
  // The library has no disk to wait for: memory is all that it can lack.
  if (!file.is_open() || !maker.make(content) || !file.close() || layout.bytes()->lacks_memory) {
    return Error{
        ErrorCode::out_of_memory, "out of memory: HDF5's library cannot lay out the file", {}, {}};
  }
  return Hdf5Plan{std::move(maker).extents(), layout.bytes()->end, layout.bytes()};
}

Status write_hdf5(const Hdf5Content& content, const ByteSink& sink) {
  Result<Hdf5Plan> plan = lay_out_hdf5(content);
  if (!plan) return std::move(plan).error();
  BinaryWriter out(sink);
  const auto put = [&out](std::uint64_t, std::string_view bytes) { out.put(bytes); };
  std::uint64_t at = 0;
  for (const Extent& extent : plan->extents) {
    use_structures(*plan->structures, at, extent.at, put);
    extent.data->write(out);
    at = extent.at + extent.bytes;
  }
  use_structures(*plan->structures, at, plan->size, put);
  out.flush();
  return ok();
}

}  // namespace cover
