// VTK writes its errors to the terminal; a library must not.
#pragma once

#include <vtkObject.h>

namespace cover {

/// Keeps VTK's messages off the terminal while it lives. Errors are asked for by their codes.
///
/// Threads: VTK has one switch for the whole process.
class QuietVtk {
 public:
  QuietVtk() : before_(vtkObject::GetGlobalWarningDisplay()) {
    vtkObject::GlobalWarningDisplayOff();
  }
  ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(before_); }
  QuietVtk(const QuietVtk&) = delete;
  QuietVtk& operator=(const QuietVtk&) = delete;

 private:
  int before_;
};

}  // namespace cover
