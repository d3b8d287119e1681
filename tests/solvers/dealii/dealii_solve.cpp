// deal.II: mesh (.vtk or .msh), then the numbers of Si, SiO2, left, right, interface. Interior
// lines are no boundaries in deal.II: the interface is where materials change; of a .vtk with
// lines it is checked that the same faces carry its number as manifold id.
#include <deal.II/base/function.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/matrix_tools.h>
#include <deal.II/numerics/vector_tools.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>

using namespace dealii;

namespace {

struct Numbers {
  unsigned si, sio2, left, right, between;
};

bool is_vtk(const std::string& path) { return std::filesystem::path(path).extension() == ".vtk"; }

void read_grid(const std::string& path, Triangulation<2>& grid) {
  GridIn<2> reader(grid);
  std::ifstream file(path);
  if (is_vtk(path)) {
    reader.read_vtk(file);
  } else {
    reader.read_msh(file);
  }
}

double conductivity(const Numbers& numbers, types::material_id material) {
  if (material == numbers.si) return 1;
  if (material == numbers.sio2) return 4;
  throw std::runtime_error("unknown material");
}

double exact(const Point<2>& p) { return p[0] < 1 ? 0.9 * p[0] : 0.9 + 0.1 * (p[0] - 1); }

void assemble(const DoFHandler<2>& dofs, const Mapping<2>& mapping, const Numbers& numbers,
              bool has_lines, SparseMatrix<double>& matrix, Vector<double>& right_side) {
  const QGaussSimplex<2> cell_rule(2);
  const QGaussSimplex<1> face_rule(2);
  FEValues<2> inside(mapping, dofs.get_fe(), cell_rule, update_gradients | update_JxW_values);
  FEFaceValues<2> along(mapping, dofs.get_fe(), face_rule, update_values | update_JxW_values);
  std::vector<types::global_dof_index> index(3);
  for (const auto& cell : dofs.active_cell_iterators()) {
    cell->get_dof_indices(index);
    inside.reinit(cell);
    const double k = conductivity(numbers, cell->material_id());
    for (unsigned q = 0; q < cell_rule.size(); ++q) {
      for (unsigned i = 0; i < 3; ++i) {
        for (unsigned j = 0; j < 3; ++j) {
          matrix.add(index[i], index[j],
                     k * inside.shape_grad(i, q) * inside.shape_grad(j, q) * inside.JxW(q));
        }
      }
    }
    for (const unsigned f : cell->face_indices()) {
      if (cell->at_boundary(f)) continue;
      const bool on_interface = cell->neighbor(f)->material_id() != cell->material_id();
      if (has_lines && on_interface != (cell->face(f)->manifold_id() == numbers.between)) {
        throw std::runtime_error("a face has the wrong manifold id");
      }
      if (!on_interface) continue;
      along.reinit(cell, f);
      for (unsigned q = 0; q < face_rule.size(); ++q) {
        for (unsigned i = 0; i < 3; ++i) {
          // Half of the source from either side.
          right_side(index[i]) += 0.25 * along.shape_value(i, q) * along.JxW(q);
        }
      }
    }
  }
}

double largest_error(const std::string& path, const Numbers& numbers) {
  Triangulation<2> grid;
  read_grid(path, grid);
  const FE_SimplexP<2> element(1);
  const MappingFE<2> mapping(element);
  DoFHandler<2> dofs(grid);
  dofs.distribute_dofs(element);
  DynamicSparsityPattern dynamic(dofs.n_dofs());
  DoFTools::make_sparsity_pattern(dofs, dynamic);
  SparsityPattern pattern;
  pattern.copy_from(dynamic);
  SparseMatrix<double> matrix(pattern);
  Vector<double> right_side(dofs.n_dofs()), solution(dofs.n_dofs());
  assemble(dofs, mapping, numbers, is_vtk(path), matrix, right_side);

  std::map<types::global_dof_index, double> fixed;
  VectorTools::interpolate_boundary_values(mapping, dofs, numbers.left,
                                           Functions::ZeroFunction<2>(), fixed);
  VectorTools::interpolate_boundary_values(mapping, dofs, numbers.right,
                                           Functions::ConstantFunction<2>(1.0), fixed);
  MatrixTools::apply_boundary_values(fixed, matrix, solution, right_side);
  SparseDirectUMFPACK inverse;
  inverse.initialize(matrix);
  inverse.vmult(solution, right_side);

  std::map<types::global_dof_index, Point<2>> points;
  DoFTools::map_dofs_to_support_points(mapping, dofs, points);
  double error = 0;
  for (const auto& [dof, p] : points) error = std::max(error, std::abs(solution(dof) - exact(p)));
  return error;
}

}  // namespace

int main(int, char** argv) {
  try {
    const auto number = [&](int k) { return static_cast<unsigned>(std::atoi(argv[k])); };
    const Numbers numbers{number(2), number(3), number(4), number(5), number(6)};
    std::cout << "largest error " << largest_error(argv[1], numbers) << '\n';
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
