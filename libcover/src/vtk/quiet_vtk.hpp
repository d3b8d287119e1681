// VTK writes its errors to the terminal; a library must not.
#pragma once

#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>
#include <vtkStringOutputWindow.h>

namespace cover {

/// Keeps VTK's messages off the terminal while it lives. Errors are asked for by their codes.
///
/// Threads: VTK has one output window for the whole process.
class QuietVtk {
 public:
  QuietVtk() : before_(vtkOutputWindow::GetInstance()) {
    vtkOutputWindow::SetInstance(vtkNew<vtkStringOutputWindow>());
  }
  ~QuietVtk() { vtkOutputWindow::SetInstance(before_); }
  QuietVtk(const QuietVtk&) = delete;
  QuietVtk& operator=(const QuietVtk&) = delete;

 private:
  vtkSmartPointer<vtkOutputWindow> before_;
};

}  // namespace cover
