#include "base/opened_library.hpp"

#include <dlfcn.h>

namespace cover {

OpenedLibrary::OpenedLibrary(const char* soname, const char* file)
    : soname_(soname), library_(dlopen(soname, RTLD_NOW | RTLD_LOCAL)) {
  if (library_ != nullptr) return;
  failure_ = dlerror();
  library_ = dlopen(file, RTLD_NOW | RTLD_LOCAL);
  if (library_ != nullptr) failure_.clear();
}

void* OpenedLibrary::address_of(const char* name) {
  void* const found = library_ != nullptr ? dlsym(library_, name) : nullptr;
  if (found == nullptr && failure_.empty()) failure_ = soname_ + " has no " + name;
  return found;
}

}  // namespace cover
