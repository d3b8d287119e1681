// VTK's readers, and whether they could read.
#pragma once

#include <exception>
#include <string>

#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include "io/text/text.hpp"
#include "vtk/quiet_vtk.hpp"
#include "vtk/sound_cells.hpp"

namespace cover {

/// What a reader makes of a file, or nullptr if it or we find fault with it.
template <class Data, class Reader>
vtkSmartPointer<Data> read_quietly(const std::string& path) {
  const QuietVtk quiet;
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  if constexpr (requires { reader->ReadAllScalarsOn(); }) {
    const Result<std::string> text = read_file(path);
    if (!text || !has_sound_cells(*text)) return nullptr;
    reader->ReadAllScalarsOn();  // a legacy file's further arrays are passed over otherwise
    reader->ReadAllFieldsOn();
  }
  if constexpr (requires { reader->ReadOutputType(); })
    if (reader->ReadOutputType() < 0) return nullptr;  // going on would log to the terminal
  try {
    if (reader->GetExecutive()->Update() == 0 || reader->GetErrorCode() != 0) return nullptr;
  } catch (const std::exception&) {  // memory for as many points as a broken file says it has
    return nullptr;
  }
  vtkSmartPointer<Data> data(reader->GetOutput());
  return data && has_sound_cells(*data) ? data : nullptr;
}

}  // namespace cover
