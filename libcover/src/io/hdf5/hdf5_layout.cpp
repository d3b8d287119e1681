// Tested by tests/unit/io/write_mesh/vtk_formats/write_vtkhdf_test.cpp.
#include "io/hdf5/hdf5_layout.hpp"

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

namespace cover {
namespace {

constexpr unsigned kTruncate = 2;  ///< H5F_ACC_TRUNC, without the calls that come with it

/// An open file: the library's part, and ours. It owns its bytes, too, in case that the library
/// closes it late.
struct LayoutFile {
  H5FD_t library{};
  std::shared_ptr<Hdf5Bytes> bytes;
  haddr_t allocated = 0;
  haddr_t written = 0;
};

/// What the library hands from create() to open_layout().
struct LayoutInfo {
  const std::shared_ptr<Hdf5Bytes>* bytes = nullptr;
};

LayoutFile& own(H5FD_t* file) { return *reinterpret_cast<LayoutFile*>(file); }
const LayoutFile& own(const H5FD_t* file) { return *reinterpret_cast<const LayoutFile*>(file); }

H5FD_t* open_layout(const char* /*name*/, unsigned /*flags*/, hid_t properties, haddr_t /*most*/) {
  // It is there already: what fails halfway through the library crashes it later.
  const auto* info = static_cast<const LayoutInfo*>(opened_hdf5().H5Pget_driver_info(properties));
  if (info == nullptr) return nullptr;
  auto* file = static_cast<LayoutFile*>((*info->bytes)->file.get());
  *file = LayoutFile{};
  file->bytes = *info->bytes;
  return &file->library;
}

herr_t close_layout(H5FD_t* file) {
  own(file).bytes->end = own(file).allocated;
  const std::shared_ptr<Hdf5Bytes> last = std::move(own(file).bytes);
  return 0;
}

herr_t tell_features(const H5FD_t* /*file*/, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA;
  return 0;
}

haddr_t allocated_in(const H5FD_t* file, H5FD_mem_t /*type*/) { return own(file).allocated; }

herr_t allocate(H5FD_t* file, H5FD_mem_t /*type*/, haddr_t end) {
  own(file).allocated = end;
  return 0;
}

haddr_t end_of_layout(const H5FD_t* file, H5FD_mem_t /*type*/) {
  return std::max(own(file).written, own(file).allocated);
}

herr_t read_layout(H5FD_t* file, H5FD_mem_t /*type*/, hid_t /*dxpl*/, haddr_t at, std::size_t size,
                   void* out) {
  own(file).bytes->read(at, size, static_cast<char*>(out));
  return 0;
}

herr_t write_layout(H5FD_t* file, H5FD_mem_t /*type*/, hid_t /*dxpl*/, haddr_t at, std::size_t size,
                    const void* bytes) {
  LayoutFile& layout = own(file);
  layout.written = std::max(layout.written, at + size);
  layout.bytes->write(at, {static_cast<const char*>(bytes), size});
  return 0;  // always: a file that the library cannot close crashes it at the end of the program
}

H5FD_class_t layout_class() {
  H5FD_class_t out{};
#if H5_VERSION_GE(1, 13, 2)
  out.version = H5FD_CLASS_VERSION;
  out.value = static_cast<H5FD_class_value_t>(600);  // one that is free for anybody
#endif
  out.name = "cover_layout";
  out.maxaddr = HADDR_MAX;
  out.fc_degree = H5F_CLOSE_STRONG;
  out.fapl_size = sizeof(LayoutInfo);
  out.open = open_layout;
  out.close = close_layout;
  out.query = tell_features;
  out.get_eoa = allocated_in;
  out.set_eoa = allocate;
  out.get_eof = end_of_layout;
  out.read = read_layout;
  out.write = write_layout;
  const H5FD_mem_t map[H5FD_MEM_NTYPES] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(map), std::end(map), std::begin(out.fl_map));
  return out;
}

}  // namespace

void Hdf5Bytes::write(std::uint64_t at, std::string_view bytes) {
  try {
    while (!bytes.empty()) {
      std::unique_ptr<Page>& page = pages_[at / kPage];
      if (page == nullptr) page = std::make_unique<Page>();
      const std::size_t from = at % kPage, size = std::min(kPage - from, bytes.size());
      std::memcpy(page->data() + from, bytes.data(), size);
      bytes.remove_prefix(size);
      at += size;
    }
  } catch (const std::bad_alloc&) {
    lacks_memory = true;
  }
}

void Hdf5Bytes::read(std::uint64_t at, std::size_t size, char* out) const {
  while (size > 0) {
    const std::size_t from = at % kPage, now = std::min(kPage - from, size);
    const auto page = pages_.find(at / kPage);
    if (page == pages_.end() || page->second == nullptr)
      std::memset(out, 0, now);
    else
      std::memcpy(out, page->second->data() + from, now);
    out += now;
    at += now;
    size -= now;
  }
}

Hdf5Layout::Hdf5Layout(const Hdf5Library& hdf5)
    : hdf5_(hdf5), bytes_(std::make_shared<Hdf5Bytes>()) {
  bytes_->file = std::make_shared<LayoutFile>();
  const H5FD_class_t driver = layout_class();
  driver_ = hdf5_.H5FDregister(&driver);
}

Hdf5Layout::~Hdf5Layout() {
  if (driver_ >= 0) hdf5_.H5FDunregister(driver_);
}

hid_t Hdf5Layout::create() {
  const hid_t access = hdf5_.H5Pcreate(hdf5_.H5P_CLS_FILE_ACCESS_ID_g),
              creation = hdf5_.H5Pcreate(hdf5_.H5P_CLS_FILE_CREATE_ID_g);
  const LayoutInfo info{&bytes_};
  const bool good = driver_ >= 0 && hdf5_.H5Pset_driver(access, driver_, &info) >= 0 &&
                    hdf5_.H5Pset_obj_track_times(creation, false) >= 0;
  const hid_t file = good ? hdf5_.H5Fcreate("layout", kTruncate, creation, access) : -1;
  hdf5_.H5Pclose(creation);
  hdf5_.H5Pclose(access);
  return file;
}

}  // namespace cover
