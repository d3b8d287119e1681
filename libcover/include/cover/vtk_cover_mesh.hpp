// The mesher as a filter in a pipeline of VTK. In the component cover::vtk, whose users need VTK's
// headers for this one alone.
#pragma once

#include <memory>
#include <string>

#include <vtkPolyDataAlgorithm.h>

// NOLINTBEGIN(readability-identifier-naming): named as VTK names its own.

/// Meshes plane polygons and lines.
///
/// Input: polygons, triangles and strips are painted areas, of which later ones lie on top; of each
/// the material is its value in the cell array MaterialArrayName, a text or a number, without the
/// array 1. Areas of one material that touch stay regions of their own, unless the option
/// merge-materials unites them. Lines on areas are contacts, named by their value in LineArrayName,
/// without the array by their number among the lines. Lines without any area are segments, and
/// every face that they enclose is a region. All points have one z, which the output has too.
///
/// Output 0: triangles with the cell arrays RegionId and material, and as field data the strings
/// RegionName and MaterialName by RegionId - 1. Output 1: the edges of all interfaces and contacts,
/// on points of their own, with the cell array LineId and the strings LineName by LineId - 1.
///
/// What is wrong is told as VTK does it (ErrorEvent) and in LastError(); the outputs are empty
/// then. So is what VTK lets pass: cells with points that are not there, and places that are not
/// finite; and what the option `require` asks for and the mesh misses.
class vtkCoverMesh : public vtkPolyDataAlgorithm {
 public:
  static vtkCoverMesh* New();
  vtkTypeMacro(vtkCoverMesh, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// An option of `cover mesh` by its name, "max-angle", with a value as the program takes it;
  /// "true" switches a flag on. False, with the reason in LastError(), where it is none.
  bool SetOption(const std::string& name, const std::string& value);
  /// All options are at their defaults again.
  void ClearOptions();

  void SetMaterialArrayName(const std::string& name);
  [[nodiscard]] const std::string& GetMaterialArrayName() const;
  void SetLineArrayName(const std::string& name);
  [[nodiscard]] const std::string& GetLineArrayName() const;

  /// What was wrong with the last option or run; empty: nothing.
  [[nodiscard]] const std::string& LastError() const;

  vtkCoverMesh(const vtkCoverMesh&) = delete;
  void operator=(const vtkCoverMesh&) = delete;

 protected:
  vtkCoverMesh();
  ~vtkCoverMesh() override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

 private:
  struct Settings;
  std::unique_ptr<Settings> settings_;
};

// NOLINTEND(readability-identifier-naming)
