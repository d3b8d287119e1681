// Writing results. Every file is written to a temporary name in its folder and renamed.
#pragma once

#include <string>

#include <cover/cover_mesh.hpp>
#include <cover/result.hpp>

namespace cover {

/// Writes VTK's XML unstructured grid: triangles only, float64 points, raw appended data, Int32
/// cell arrays material, MaterialID, mat_id, RegionId, then max_angle and min_angle in degrees.
Status write_vtu(const Output& output, const std::string& path);

/// Writes a multi-block file with one named .vtu per region and per interface beside it.
Status write_vtm(const Output& output, const std::string& path);

/// Writes the clean PSLG as Triangle's .poly, 17 digits, with region and hole seeds.
Status write_poly(const Pslg& pslg, const RegionTable& table, const std::string& path);

/// Writes the report as JSON.
Status write_report_json(const Output& output, const std::string& path);

}  // namespace cover
