// deal.II: mesh (.vtk or .msh), then the problem. Interior lines are no boundaries in deal.II: in a
// .vtk with lines they are known by their manifold ids, in a .msh they are where materials change.
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

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace dealii;

namespace {

/// See problem.py.
struct Problem {
  struct Region {
    double k;
    Tensor<1, 2> flux;
  };
  std::map<types::material_id, Region> regions;
  std::vector<std::array<double, 3>> affine;
  std::vector<types::boundary_id> fixed;
  std::set<types::manifold_id> inner;
  std::set<types::boundary_id> outer;

  explicit Problem(const std::string& path) {
    std::ifstream file(path);
    for (std::string word; file >> word;) {
      if (word == "region") {
        types::material_id number = 0;
        Region region{};
        file >> number >> region.k >> region.flux[0] >> region.flux[1];
        region.flux *= region.k;
        regions[number] = region;
      } else if (word == "affine") {
        std::array<double, 3> a{};
        file >> a[0] >> a[1] >> a[2];
        affine.push_back(a);
      } else if (word == "fixed") {
        file >> fixed.emplace_back();
      } else {
        unsigned number = 0, left = 0, is_outer = 0;
        double x = 0, y = 0;
        file >> number >> left >> x >> y >> is_outer;
        if (is_outer != 0) {
          outer.insert(number);
        } else {
          inner.insert(number);
        }
      }
    }
  }

  [[nodiscard]] double exact(const Point<2>& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, gx, gy] : affine) least = std::min(least, a + gx * p[0] + gy * p[1]);
    return least;
  }
};

class Exact : public Function<2> {
 public:
  explicit Exact(const Problem& problem) : problem_(problem) {}
  double value(const Point<2>& p, unsigned) const override { return problem_.exact(p); }

 private:
  const Problem& problem_;
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

/// Whether there is a source on a face, seen from `cell`.
template <class Cell>
bool has_source(const Cell& cell, unsigned f, const Problem& problem, bool has_lines) {
  const auto face = cell->face(f);
  if (cell->at_boundary(f)) return problem.outer.count(face->boundary_id()) != 0;
  if (has_lines) return problem.inner.count(face->manifold_id()) != 0;
  return cell->neighbor(f)->material_id() != cell->material_id();
}

void assemble(const DoFHandler<2>& dofs, const Mapping<2>& mapping, const Problem& problem,
              bool has_lines, SparseMatrix<double>& matrix, Vector<double>& right_side) {
  const QGaussSimplex<2> cell_rule(2);
  const QGaussSimplex<1> face_rule(2);
  FEValues<2> inside(mapping, dofs.get_fe(), cell_rule, update_gradients | update_JxW_values);
  FEFaceValues<2> along(mapping, dofs.get_fe(), face_rule,
                        update_values | update_normal_vectors | update_JxW_values);
  std::vector<types::global_dof_index> index(3);
  for (const auto& cell : dofs.active_cell_iterators()) {
    cell->get_dof_indices(index);
    inside.reinit(cell);
    const Problem::Region& region = problem.regions.at(cell->material_id());
    for (unsigned q = 0; q < cell_rule.size(); ++q) {
      for (unsigned i = 0; i < 3; ++i) {
        for (unsigned j = 0; j < 3; ++j) {
          matrix.add(index[i], index[j],
                     region.k * inside.shape_grad(i, q) * inside.shape_grad(j, q) * inside.JxW(q));
        }
      }
    }
    for (const unsigned f : cell->face_indices()) {
      if (!has_source(cell, f, problem, has_lines)) continue;
      along.reinit(cell, f);
      for (unsigned q = 0; q < face_rule.size(); ++q) {
        for (unsigned i = 0; i < 3; ++i) {
          right_side(index[i]) +=
              region.flux * along.normal_vector(q) * along.shape_value(i, q) * along.JxW(q);
        }
      }
    }
  }
}

double largest_error(const std::string& path, const Problem& problem) {
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
  assemble(dofs, mapping, problem, is_vtk(path), matrix, right_side);

  std::map<types::global_dof_index, double> fixed;
  const Exact exact(problem);
  for (const auto line : problem.fixed)
    VectorTools::interpolate_boundary_values(mapping, dofs, line, exact, fixed);
  MatrixTools::apply_boundary_values(fixed, matrix, solution, right_side);
  SparseDirectUMFPACK inverse;
  inverse.initialize(matrix);
  inverse.vmult(solution, right_side);

  std::map<types::global_dof_index, Point<2>> points;
  DoFTools::map_dofs_to_support_points(mapping, dofs, points);
  double error = 0;
  for (const auto& [dof, p] : points)
    error = std::max(error, std::abs(solution(dof) - problem.exact(p)));
  return error;
}

}  // namespace

int main(int, char** argv) {
  try {
    std::cout << "largest error " << largest_error(argv[1], Problem(argv[2])) << '\n';
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
