// Tested by tests/unit/pipeline/cover_mesh_test.cpp.
#include "sizes/fields/ask_size.hpp"

#include <exception>
#include <new>

#include <fmt/core.h>

#include <cover/text.hpp>

#include "base/faults/caller_fault.hpp"

namespace cover {
namespace {

CallerFault fault_of_size_function(const char* what, Point p) {
  return {fmt::format("the size function failed at {}: {}", describe(p), what), p};
}

}  // namespace

double ask_size(const SizeFunction& field, Point p) {
  try {
    return field(p);
  } catch (const CallerFault&) {  // a function that asks another one
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    throw fault_of_size_function(e.what(), p);
  } catch (...) {
    throw fault_of_size_function("it threw what is no std::exception", p);
  }
}

}  // namespace cover
