// What a check found, in words. Each text ends its last line; it is empty where there is nothing to
// say.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <cover/angle.hpp>
#include <cover/options.hpp>
#include <cover/result.hpp>
#include <cover/verify.hpp>
#include <cover/verify_curved.hpp>
#include <cover/verify_layers.hpp>

#include "commands/check/cut_input.hpp"
#include "commands/check/named_groups.hpp"
#include "commands/check/named_lines.hpp"
#include "commands/check/rounded_points.hpp"
#include "commands/check/told_names.hpp"

namespace cover::app {

/// The broken promises, a line each and lines with the places.
std::string violations_text(const Verification& found);
/// The angles beside which a mesh is put.
struct AngleTargets {
  Angle largest = VerifyOptions().max_angle;
  Angle smallest = VerifyOptions().min_angle;
  bool is_largest_of_run = false;  ///< that of the run that made the mesh, which tells its targets
  bool is_smallest_of_run = false;
};
/// Of a mesh of so many triangles that breaks no promise: what was checked, and what was not.
/// `is_all_met`: nothing else that was asked for has failed.
std::string sound_text(const Verification& found, std::size_t triangles, bool is_all_met,
                       const AngleTargets& targets = {});

/// Points of the input under other names in the mesh.
std::string wrong_points_text(std::span<const WrongPoint> points);
/// Regions with triangles under another name.
std::string wrong_regions_text(std::span<const WrongRegion> regions);

/// Named lines that are not as in the input.
std::string wrong_lines_text(const NamedLines& lines);
/// What was not checked of named lines.
std::string unchecked_lines_text(const NamedLines& lines);

/// How segments are cut; where nobody meant that: how to allow it. What is said of
/// sides that are images of each other helps only where none are told.
std::string cuts_text(const OwnCuts& cuts, bool are_sides_images);
/// Points of the input that the mesh's format has rounded.
std::string rounded_text(const RoundedPoints& rounded);
/// So many points of the input are no vertices: which options the run that made the mesh had
/// (`of_run`, if that is known) or may have had, that are not those of the check.
std::string missing_text(std::size_t points, std::span<const std::string> of_run,
                         std::span<const std::string> possible);
/// Which options the run that made the mesh had, if any, that are not those of the check.
std::string repeat_text(std::span<const std::string> of_run);
/// Which options of reading may make other materials of the input; empty: none.
std::string materials_text(std::span<const std::string> possible);
/// So many sides have a triangle of the void beside them: which option allows that.
std::string in_void_text(std::size_t triangles);
/// So many triangles have the RegionId of another region: which option may have joined regions.
std::string other_ids_text(std::size_t triangles);

/// The negative couplings of the box method, the first of them one by one.
std::string couplings_text(const Verification& found);

/// What is wrong with middle nodes.
std::string curved_violations_text(const CurvedVerification& found);
/// Of middle nodes with which nothing is wrong.
std::string curved_sound_text(const CurvedVerification& found);

/// The number of pairs on periodic sides, or why there are not enough.
std::string periodic_text(const PeriodicRule& rule, const Result<std::size_t>& pairs);

/// The rows of triangles along a line in a region, which are as they should be or not.
std::string layers_text(const LayersFound& layers, const std::string& line,
                        const std::string& region, bool is_met);

}  // namespace cover::app
