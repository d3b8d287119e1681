// Reading drawings in DXF. In the component cover::dxf, which is there where dxflib is.
#pragma once

#include <string>
#include <string_view>

#include <cover/input.hpp>
#include <cover/read_options.hpp>
#include <cover/result.hpp>

namespace cover {

/// Reads the model space of a drawing, as text: lines, arcs, circles, ellipses, polylines with
/// bulges, splines, and blocks, in whatever way they are inserted. All of them become segments, so
/// every closed face is a region, whatever its outline was drawn with; where there is more than one
/// layer, or file, segments have the name of theirs (but those on layer 0). What a CAD program
/// would not print is left out: invisible entities, and lines and curves on layers that are off or
/// frozen, or called Defpoints, unless `options.layers` names the layer. Of lines and curves that
/// run through space, polylines, too, x and y count; of polylines with a width, the line in the
/// middle, which is told. Points are named as their layer (but those on layer 0).
///
/// A curve becomes chords that turn by `options.chord_angle` at most and leave it by no more than
/// `options.chord_error`, if that is given; arcs of one circle share their points, and their chords
/// know it (Input::circles), so that cuts and nodes of second order lie on it. With
/// `options.label_layer`, a text on that layer says of the face around its insertion point:
/// MATERIAL, MATERIAL/REGION or void. What is not read is named in `Input::warnings`.
/// Errors: cannot_open, syntax, truncated, non_finite_coordinate, unsupported_format, bad_option,
///         with the line
/// Cost:   O(n log n) in what is drawn; limits as for layouts
Result<Input> read_dxf(const std::string& path, const ReadOptions& options = {});

/// Reads a drawing from memory; `source` is what messages call it.
///
/// Errors: as read_dxf()
Result<Input> parse_dxf(std::string_view text, const std::string& source,
                        const ReadOptions& options = {});

}  // namespace cover
