// Shared libraries of others that are opened when they are first wanted: linking a program with one
// that brings dozens of others along takes it a tenth of a second at each start.
#pragma once

#include <string>

namespace cover {

/// A shared library and what it could not give. It stays open to the end of the program.
class OpenedLibrary {
 public:
  /// `soname` first, so that whoever has opened the library before shares it; then `file`, the path
  /// that this was built with.
  OpenedLibrary(const char* soname, const char* file);

  /// Lets `to` point to the function or the variable of this name, or to nothing.
  template <class Symbol>
  void find(const char* name, Symbol*& to) {
    to = reinterpret_cast<Symbol*>(address_of(name));
  }

  /// Why it is not open, or what was not found in it; empty: all is well.
  [[nodiscard]] const std::string& failure() const { return failure_; }

 private:
  [[nodiscard]] void* address_of(const char* name);

  std::string soname_, failure_;
  void* library_ = nullptr;
};

/// What was found in a library, `Members` by their names.
template <class Members>
struct Opened {
  Members members;
  std::string failure;  ///< as OpenedLibrary::failure()
};

/// What `open` returned when it was first called, once for the whole process. May be called from
/// several threads.
template <auto open>
const auto& opened_once() {
  static const auto opened = open();
  return opened;
}

}  // namespace cover
