// Tested by tests/unit/vtk/vtk_cover_mesh_test.cpp.
#include <cover/vtk_cover_mesh.hpp>

#include <vtkAbstractArray.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkVariant.h>

#include <array>
#include <map>
#include <stop_token>
#include <thread>
#include <utility>

#include <fmt/core.h>

#include <cover/cover_mesh.hpp>
#include <cover/mesh.hpp>
#include <cover/option_table.hpp>
#include <cover/read_size_field.hpp>
#include <cover/requirements.hpp>
#include <cover/verify.hpp>

struct vtkCoverMesh::Settings {
  cover::OptionReader options;
  std::string material_array = "material";
  std::string line_array = "name";
  std::string error;
};

namespace cover {
namespace {

Error wrong(std::string what, ErrorCode code = ErrorCode::syntax) {
  return {code, std::move(what), {}, {}};
}

/// The value of a cell as text; `otherwise` where there is no array.
std::string text_of(vtkAbstractArray* array, vtkIdType cell, const std::string& otherwise) {
  if (array == nullptr || array->GetNumberOfTuples() <= cell) return otherwise;
  return array->GetVariantValue(cell * array->GetNumberOfComponents()).ToString();
}

/// The cells of a data set as geometry.
class PolyDataInput {
 public:
  PolyDataInput(vtkPolyData& data, const std::string& material, const std::string& line)
      : data_(data),
        material_(data.GetCellData()->GetAbstractArray(material.c_str())),
        line_(data.GetCellData()->GetAbstractArray(line.c_str())) {}

  Result<Input> read() {
    input_.source = "the input";
    for (vtkIdType p = 0; p < data_.GetNumberOfPoints(); ++p) {
      const double height = place(p)[2];
      if (height != z())
        return wrong(
            fmt::format("the input is not in a plane z = constant: point 0 has z = {}, point {} {}",
                        z(), p, height),
            ErrorCode::unsupported_format);
    }
    if (Status status = read_cells(); !status) return std::move(status).error();
    if (input_.polygons.empty()) add_segments();
    return std::move(input_);
  }

  [[nodiscard]] double z() const { return data_.GetNumberOfPoints() > 0 ? place(0)[2] : 0; }

 private:
  using AddCell = void (PolyDataInput::*)(vtkIdType cell, const std::vector<Point>& points);

  /// All cells, in the order in which VTK numbers them. It looks up points and cells without asking
  /// whether they are there, so that is done here.
  Status read_cells() {
    const struct {
      const char* name;
      vtkCellArray* cells;
      AddCell add;
    } kinds[] = {{"vertex", data_.GetVerts(), nullptr},
                 {"line", data_.GetLines(), &PolyDataInput::add_line},
                 {"polygon", data_.GetPolys(), &PolyDataInput::add_area},
                 {"strip", data_.GetStrips(), &PolyDataInput::add_strip}};
    const vtkIdType most = data_.GetNumberOfPoints();
    vtkIdType cell = 0;
    vtkNew<vtkIdList> ids;
    for (const auto& [name, cells, add] : kinds) {
      if (cells == nullptr) continue;
      if (!cells->IsValid())
        return wrong(
            fmt::format("the {} cells of the input are no cells: the offsets do not rise "
                        "from 0 to the end of the points",
                        name));
      for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c, ++cell) {
        cells->GetCellAtId(c, ids);
        std::vector<Point> points;
        for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k) {
          const vtkIdType p = ids->GetId(k);
          if (p < 0 || p >= most)
            return wrong(fmt::format("{} {} of the input has the point {}, but there are {} points",
                                     name, c, p, most),
                         ErrorCode::id_out_of_range);
          points.push_back(at(p));
        }
        if (add != nullptr) (this->*add)(cell, points);
      }
    }
    return ok();
  }

  /// A copy: VTK's own is overwritten by its next call.
  [[nodiscard]] std::array<double, 3> place(vtkIdType p) const {
    std::array<double, 3> x{};
    data_.GetPoint(p, x.data());
    return x;
  }
  [[nodiscard]] Point at(vtkIdType p) const {
    const std::array<double, 3> x = place(p);
    return {x[0], x[1]};
  }

  void add_strip(vtkIdType c, const std::vector<Point>& points) {
    for (std::size_t k = 2; k < points.size(); ++k)
      add_area(c, {points[k - 2], points[k - 1], points[k]});
  }

  void add_area(vtkIdType c, const std::vector<Point>& ring) {
    if (ring.size() < 3) return;
    InputPolygon polygon;
    polygon.rings.push_back(ring);
    polygon.material = text_of(material_, c, "1");
    polygon.id = static_cast<long>(c);
    input_.polygons.push_back(std::move(polygon));
  }

  void add_line(vtkIdType c, const std::vector<Point>& points) {
    if (points.size() < 2) return;
    InputLine line;
    line.name = text_of(line_, c, std::to_string(input_.lines.size() + 1));
    line.points = points;
    line.id = static_cast<long>(c);
    input_.lines.push_back(std::move(line));
  }

  /// Lines alone: the segments of a PSLG, whose faces are regions.
  void add_segments() {
    std::map<Point, std::uint32_t> index;
    const auto number = [&](Point p) {
      const auto [entry, is_new] =
          index.emplace(p, static_cast<std::uint32_t>(input_.points.size()));
      if (is_new) input_.points.push_back(p);
      return entry->second;
    };
    for (const InputLine& line : input_.lines) {
      for (std::size_t k = 0; k + 1 < line.points.size(); ++k) {
        InputSegment segment;
        segment.a = number(line.points[k]);
        segment.b = number(line.points[k + 1]);
        segment.id = line.id;
        if (line_ != nullptr) segment.name = line.name;
        input_.segments.push_back(std::move(segment));
      }
    }
    input_.lines.clear();
  }

  vtkPolyData& data_;
  vtkAbstractArray* material_;
  vtkAbstractArray* line_;
  Input input_;
};

template <class Items, class Name>
void add_names(const char* array, const Items& items, Name name, vtkPolyData& to) {
  vtkNew<vtkStringArray> names;
  names->SetName(array);
  for (const auto& item : items) names->InsertNextValue(name(item));
  to.GetFieldData()->AddArray(names);
}

void write_triangles(const Output& output, double z, vtkPolyData& to) {
  const TriangleSoup soup = triangle_soup(output.mesh);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& p : soup.points) points->InsertNextPoint(p.x, p.y, z);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> regions, materials;
  regions->SetName("RegionId");
  materials->SetName("material");
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    cells->InsertNextCell(3);
    for (const std::uint32_t v : soup.triangles[t]) cells->InsertCellPoint(v);
    regions->InsertNextValue(static_cast<int>(soup.region[t]));
    materials->InsertNextValue(static_cast<int>(soup.material[t]));
  }
  to.SetPoints(points);
  to.SetPolys(cells);
  to.GetCellData()->AddArray(regions);
  to.GetCellData()->AddArray(materials);
  add_names(
      "RegionName", output.table.regions, [](const Region& r) { return r.name; }, to);
  add_names(
      "MaterialName", output.table.regions, [](const Region& r) { return r.material_name; }, to);
}

void write_lines(const Output& output, double z, vtkPolyData& to) {
  const TriMesh& tri = output.mesh.tri();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> ids;
  ids->SetName("LineId");
  std::map<int, vtkIdType> index;
  const auto number = [&](TriMesh::VertexHandle v) {
    const auto [entry, is_new] = index.emplace(v.idx(), points->GetNumberOfPoints());
    if (is_new) points->InsertNextPoint(tri.point(v)[0], tri.point(v)[1], z);
    return entry->second;
  };
  for (const auto e : tri.edges()) {
    const InterfaceId id = output.mesh.interface(e);
    if (id == kNoInterface) continue;
    const auto h = tri.halfedge_handle(e, 0);
    cells->InsertNextCell(2);
    cells->InsertCellPoint(number(tri.from_vertex_handle(h)));
    cells->InsertCellPoint(number(tri.to_vertex_handle(h)));
    ids->InsertNextValue(static_cast<int>(id.value()));
  }
  to.SetPoints(points);
  to.SetLines(cells);
  to.GetCellData()->AddArray(ids);
  add_names(
      "LineName", output.table.interfaces, [](const Interface& line) { return line.name; }, to);
}

/// The requirements that a mesh misses, as an error.
Status check_requirements(const Output& output, const Options& options) {
  std::string words;
  for (const std::string& requirement : unmet_requirements(output, options))
    words += (words.empty() ? "the mesh does not meet " : "; ") + requirement;
  return words.empty() ? ok() : Status(wrong(std::move(words), ErrorCode::requirement_not_met));
}

}  // namespace
}  // namespace cover

vtkStandardNewMacro(vtkCoverMesh);

vtkCoverMesh::vtkCoverMesh() : settings_(std::make_unique<Settings>()) {
  this->SetNumberOfOutputPorts(2);
}
vtkCoverMesh::~vtkCoverMesh() = default;

bool vtkCoverMesh::SetOption(const std::string& name, const std::string& value) {
  settings_->error.clear();
  const cover::OptionEntry* const entry = cover::find_option(name);
  if (entry == nullptr) {
    settings_->error = fmt::format("there is no option '{}'", name);
  } else if (const cover::Status set = settings_->options.set(*entry, value); !set) {
    settings_->error = fmt::format("{}: {}", name, set.error().message);
  } else {
    this->Modified();
  }
  return settings_->error.empty();
}

void vtkCoverMesh::ClearOptions() {
  settings_->options = {};
  this->Modified();
}

void vtkCoverMesh::SetMaterialArrayName(const std::string& name) {
  if (settings_->material_array == name) return;
  settings_->material_array = name;
  this->Modified();
}
const std::string& vtkCoverMesh::GetMaterialArrayName() const { return settings_->material_array; }

void vtkCoverMesh::SetLineArrayName(const std::string& name) {
  if (settings_->line_array == name) return;
  settings_->line_array = name;
  this->Modified();
}
const std::string& vtkCoverMesh::GetLineArrayName() const { return settings_->line_array; }

const std::string& vtkCoverMesh::LastError() const { return settings_->error; }

int vtkCoverMesh::RequestData(vtkInformation*, vtkInformationVector** inputs,
                              vtkInformationVector* outputs) {
  settings_->error.clear();
  vtkPolyData* const input = vtkPolyData::GetData(inputs[0]);
  cover::PolyDataInput reader(*input, settings_->material_array, settings_->line_array);
  const auto failed = [this](const cover::Error& error) {
    settings_->error = error.message;
    vtkErrorMacro(<< error.message);
    return 0;
  };
  cover::Result<cover::Options> options = settings_->options.result();
  if (!options) return failed(options.error());
  cover::Result<cover::Input> geometry = reader.read();
  if (!geometry) return failed(geometry.error());
  if (const cover::Status loaded = cover::load_size_field(*options, *geometry); !loaded)
    return failed(loaded.error());
  std::stop_source stop;
  cover::Callbacks callbacks;
  callbacks.stop = stop.get_token();
  // Observers of VTK expect to be called where the filter runs.
  callbacks.progress = [&, here = std::this_thread::get_id()](const cover::Progress& step) {
    if (std::this_thread::get_id() == here && step.total > 0)
      this->UpdateProgress(static_cast<double>(step.done) / static_cast<double>(step.total));
    if (this->GetAbortExecute() != 0) stop.request_stop();
  };
  const cover::Result<cover::Output> output =
      cover::cover_mesh(*std::move(geometry), *options, callbacks);
  if (!output) return failed(output.error());
  if (const cover::Status met = cover::check_requirements(*output, *options); !met)
    return failed(met.error());
  cover::write_triangles(*output, reader.z(), *vtkPolyData::GetData(outputs, 0));
  cover::write_lines(*output, reader.z(), *vtkPolyData::GetData(outputs, 1));
  return 1;
}

void vtkCoverMesh::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaterialArrayName: " << settings_->material_array << '\n'
     << indent << "LineArrayName: " << settings_->line_array << '\n';
  if (const cover::Result<cover::Options> options = settings_->options.result()) {
    for (const auto& setting : cover::describe_options(*options))
      os << indent << "Option " << setting.name << ": " << setting.value << '\n';
  }
}
