// VTK's readers, and whether they could read.
#pragma once

#include <string>

#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include "vtk/quiet_vtk.hpp"

namespace cover {

/// What a reader makes of a file, or nullptr if it finds fault with it.
template <class Data, class Reader>
vtkSmartPointer<Data> read_quietly(const std::string& path) {
  const QuietVtk quiet;
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  if constexpr (requires { reader->ReadAllScalarsOn(); }) {
    reader->ReadAllScalarsOn();  // a legacy file's further arrays are passed over otherwise
    reader->ReadAllFieldsOn();
  }
  if constexpr (requires { reader->ReadOutputType(); })
    if (reader->ReadOutputType() < 0) return nullptr;  // going on would log to the terminal
  const bool done = reader->GetExecutive()->Update() != 0;
  return done && reader->GetErrorCode() == 0 ? vtkSmartPointer<Data>(reader->GetOutput()) : nullptr;
}

}  // namespace cover
