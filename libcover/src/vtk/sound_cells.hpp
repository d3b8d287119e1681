// What VTK believes without looking, and crashes on where a file is broken.
#pragma once

#include <string_view>

class vtkDataSet;

namespace cover {

/// Whether the cells in the text of a legacy file (.vtk) are as many numbers as they say, and it
/// has no more points than letters. VTK's reader writes beyond its arrays where it is not so.
///
/// Cost: O(n)
bool has_sound_cells(std::string_view legacy_text);

/// Whether the cells of a grid or a surface lie within their own arrays. Other data sets have no
/// such arrays.
///
/// Cost: O(n)
bool has_sound_cells(vtkDataSet& data);

}  // namespace cover
