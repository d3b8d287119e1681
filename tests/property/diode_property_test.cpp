// A diode by Scharfetter and Gummel's fluxes on meshes for the box method: Gummel's iteration
// converges, densities stay positive, and the current is that of a mesh 16 times as fine.
#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

#include "support/inputs/inputs.hpp"

namespace cover {
namespace {

using Vec = std::vector<double>;

/// An edge with (cot + cot) / 2, the sum over its regions.
struct Bond {
  std::uint32_t a, b;
  double factor;
};

struct Boxes {
  std::vector<Point> points;
  std::vector<Bond> bonds;
  Vec area;              ///< by vertex
  double least = 1e300;  ///< form factor of an edge in one region
};

Boxes boxes_of(const TriangleSoup& mesh) {
  Boxes boxes{mesh.points, {}, Vec(mesh.points.size(), 0)};
  std::map<std::array<std::uint32_t, 2>, std::map<std::int64_t, double>> sums;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t c = mesh.triangles[t][i], a = mesh.triangles[t][(i + 1) % 3],
                          b = mesh.triangles[t][(i + 2) % 3];
      const double ux = mesh.points[a].x - mesh.points[c].x,
                   uy = mesh.points[a].y - mesh.points[c].y;
      const double vx = mesh.points[b].x - mesh.points[c].x,
                   vy = mesh.points[b].y - mesh.points[c].y;
      const double cot = (ux * vx + uy * vy) / (ux * vy - uy * vx);
      sums[{std::min(a, b), std::max(a, b)}][mesh.region[t]] += cot / 2;
      const double e2 = (ux - vx) * (ux - vx) + (uy - vy) * (uy - vy);
      boxes.area[a] += e2 * cot / 8;
      boxes.area[b] += e2 * cot / 8;
    }
  }
  for (const auto& [edge, by_region] : sums) {
    double sum = 0;
    for (const auto& [region, factor] : by_region) {
      boxes.least = std::min(boxes.least, factor);
      sum += factor;
    }
    boxes.bonds.push_back({edge[0], edge[1], sum});
  }
  return boxes;
}

/// x with sum over bonds of weight (x_a - x_b), plus diagonal x_a, equal to `right` where nothing
/// is fixed; by conjugate gradients.
Vec solve(const Boxes& boxes, const Vec& weight, const Vec& diagonal, const Vec& right,
          const std::vector<bool>& fixed, Vec x) {
  const std::size_t n = x.size();
  Vec scale = diagonal;
  for (std::size_t k = 0; k < weight.size(); ++k) {
    scale[boxes.bonds[k].a] += weight[k];
    scale[boxes.bonds[k].b] += weight[k];
  }
  const auto apply = [&](const Vec& v) {
    Vec out(n);
    for (std::size_t i = 0; i < n; ++i) out[i] = diagonal[i] * v[i];
    for (std::size_t k = 0; k < weight.size(); ++k) {
      const auto [a, b, factor] = boxes.bonds[k];
      out[a] += weight[k] * (v[a] - v[b]);
      out[b] += weight[k] * (v[b] - v[a]);
    }
    for (std::size_t i = 0; i < n; ++i) out[i] = fixed[i] ? 0 : out[i];
    return out;
  };
  Vec r = apply(x), z(n), p(n);
  double rz = 0;
  for (std::size_t i = 0; i < n; ++i) {
    r[i] = fixed[i] ? 0 : right[i] - r[i];
    p[i] = z[i] = r[i] / scale[i];
    rz += r[i] * z[i];
  }
  const double end = 1e-26 * std::max(rz, 1e-300);
  for (int step = 0; step < 20'000 && rz > end; ++step) {
    const Vec q = apply(p);
    double pq = 0;
    for (std::size_t i = 0; i < n; ++i) pq += p[i] * q[i];
    const double along = rz / pq;
    double next = 0;
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += along * p[i];
      r[i] -= along * q[i];
      z[i] = r[i] / scale[i];
      next += r[i] * z[i];
    }
    for (std::size_t i = 0; i < n; ++i) p[i] = z[i] + next / rz * p[i];
    rz = next;
  }
  return x;
}

/// x / (e^x - 1).
double bernoulli(double x) { return std::abs(x) < 1e-5 ? 1 - x / 2 : x / std::expm1(x); }

/// The current from x = 0 to x = width; potentials in kT/q, lengths in intrinsic Debye lengths,
/// densities in units of the intrinsic one. Slotboom's variables make Scharfetter's and Gummel's
/// fluxes symmetric.
double current_of(const Boxes& boxes, double width, double bias) {
  const std::size_t n = boxes.points.size(), bonds = boxes.bonds.size();
  std::vector<bool> fixed(n);
  Vec doping(n), psi(n), u(n, 1), v(n, 1), weight(bonds), none(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = boxes.points[i].x;
    fixed[i] = x == 0 || x == width;
    doping[i] = 50 * std::tanh((x - width / 2) / 0.8);
    const double applied = x == 0 ? bias : 0;
    psi[i] = std::asinh(doping[i] / 2) + applied;
    u[i] = std::exp(-(x < width / 2 ? bias : 0));  // electrons are u e^psi
    v[i] = std::exp(x < width / 2 ? bias : 0);     // holes are v e^-psi
  }
  Vec factor;
  for (const Bond& bond : boxes.bonds) factor.push_back(bond.factor);
  const auto weights = [&](double sign) {
    for (std::size_t k = 0; k < bonds; ++k) {
      const double from = sign * psi[boxes.bonds[k].a], to = sign * psi[boxes.bonds[k].b];
      weight[k] = factor[k] * bernoulli(to - from) * std::exp(to);
    }
  };
  for (int round = 0;; ++round) {
    EXPECT_LT(round, 100) << "Gummel's iteration does not converge";
    if (round == 100) return 0;
    const Vec before = psi;
    for (int newton = 0; newton < 50; ++newton) {
      Vec diagonal(n), residual(n);
      for (std::size_t i = 0; i < n; ++i) {
        const double electrons = u[i] * std::exp(psi[i]), holes = v[i] * std::exp(-psi[i]);
        diagonal[i] = boxes.area[i] * (electrons + holes);
        residual[i] = boxes.area[i] * (holes - electrons + doping[i]);
      }
      for (std::size_t k = 0; k < bonds; ++k) {
        const auto [a, b, f] = boxes.bonds[k];
        residual[a] -= f * (psi[a] - psi[b]);
        residual[b] -= f * (psi[b] - psi[a]);
      }
      const Vec step = solve(boxes, factor, diagonal, residual, fixed, none);
      double largest = 0;
      for (std::size_t i = 0; i < n; ++i) {
        psi[i] += std::clamp(step[i], -2.0, 2.0);
        largest = std::max(largest, std::abs(step[i]));
      }
      if (largest < 1e-9) break;
      EXPECT_LT(newton, 49) << "Newton's method does not converge";
    }
    weights(1);
    u = solve(boxes, weight, none, none, fixed, u);
    weights(-1);
    v = solve(boxes, weight, none, none, fixed, v);
    EXPECT_GT(*std::min_element(u.begin(), u.end()), 0);
    EXPECT_GT(*std::min_element(v.begin(), v.end()), 0);
    double change = 0;
    for (std::size_t i = 0; i < n; ++i) change = std::max(change, std::abs(psi[i] - before[i]));
    if (change < 1e-7) break;
  }
  double current = 0;
  for (const double sign : {1.0, -1.0}) {
    weights(sign);
    const Vec& density = sign > 0 ? u : v;
    for (std::size_t k = 0; k < bonds; ++k) {
      const auto [a, b, f] = boxes.bonds[k];
      const double flux = sign * weight[k] * (density[b] - density[a]);
      if (boxes.points[a].x == 0 && boxes.points[b].x != 0) current += flux;
      if (boxes.points[b].x == 0 && boxes.points[a].x != 0) current -= flux;
    }
  }
  return current;
}

/// Two regions with a slanted interface beside the junction, and a dimple that encroaches the
/// lower side.
Input two_regions() {
  Input input = testing::segments_between(
      {{0, 0}, {5, 0}, {9, 0}, {9, 4}, {4, 4}, {0, 4}, {4.6, 1.2}, {7, 0.4}},
      {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}, {1, 6}, {6, 4}});
  input.seeds = {{{1, 1}, "p", "", {}, 1, 0}, {{8, 1}, "n", "", {}, 2, 0}};
  return input;
}

TEST(DiodeProperty, CurrentsAgreeOnMeshesForTheBoxMethod) {
  Vec currents;
  std::vector<std::size_t> triangles;
  for (const double size : {0.4, 0.1}) {
    Options options;
    options.box_method = true;
    options.split_interfaces = Angle::degrees(179);
    options.sizes = {{"", size}};
    const Result<Output> output = cover_mesh(two_regions(), options);
    ASSERT_TRUE(output.has_value()) << output.error().message;
    const TriangleSoup mesh = triangle_soup(output->mesh);
    const Boxes boxes = boxes_of(mesh);
    EXPECT_GE(boxes.least, -1e-12);
    double area = 0;
    for (const double box : boxes.area) area += box;
    EXPECT_NEAR(area, 36, 36e-12);
    currents.push_back(current_of(boxes, 9, 4));
    triangles.push_back(mesh.triangles.size());
  }
  EXPECT_GT(triangles[1], 12 * triangles[0]);
  EXPECT_NE(currents[1], 0);
  EXPECT_NEAR(currents[0] / currents[1], 1, 0.01);
  RecordProperty("coarse", std::to_string(currents[0]));
  RecordProperty("fine", std::to_string(currents[1]));
}

}  // namespace
}  // namespace cover
