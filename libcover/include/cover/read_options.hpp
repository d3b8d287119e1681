// What readers of geometry are told beside the file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <cover/result.hpp>
#include <cover/window.hpp>

namespace cover {

/// How a geometry file is to be understood. Readers look at what concerns their format only.
///
/// Entries of `layer_map`, and the lines of its files, are "PATTERN=NAME" or "NAME PATTERN". A
/// pattern is a layer and a data type, either of which may be any: "68/20", "68" or "68/*", "*".
/// The first that fits a layer counts, the last lies on top, and layers that none fits are left
/// out. In files '#' begins a comment.
struct ReadOptions {
  std::string format;    ///< extension that names the format, as ".gds"; empty: the file's own
  std::string unit;      ///< nm, um, mm, cm or m, whatever the file says; empty: what it says
  double scale = 1;      ///< all lengths are multiplied by this; > 0
  unsigned threads = 0;  ///< that long files are read by; 0: all cores. What is read is the same

  std::vector<std::string> layers;     ///< what is read, by name or as "68/20"; empty: all
  std::vector<std::string> layer_map;  ///< "68/20=met1", or files of such lines; see below
  std::string label_layer;             ///< whose texts name regions; empty: texts are left out
  std::string cell;                    ///< of a layout: the one that is drawn; empty: the top cell
  std::optional<Window> window;        ///< of a layout: what is outside is cut off
  std::optional<double> chord_error;   ///< how far a chord may be from its curve, a length > 0
  double chord_angle = 5;              ///< what a chord may turn by, in degrees, in (0, 120]

  std::string material_field;  ///< of a map: the attribute that is the material
  std::string name_field;      ///< that is the name of the region or line
  std::string priority_field;  ///< that says which polygon wins where they overlap
  std::vector<std::string>
      keep_fields;  ///< that become arrays of the mesh; "fid": the feature's number
  std::string crs;  ///< as "EPSG:25832": what a map is projected to; empty: nothing

  int speckle = 0;     ///< of a picture: sets of fewer pixels become part of their neighbours
  bool smooth = true;  ///< of a picture: borders are smoothed; false: they are the sides of pixels
  std::string legend;  ///< of a picture: a file of lines "#ff0000,copper" or "7,grain"; empty: none

  /// Of maps that are read to be joined: fields and layers that options name may be in another one.
  /// Those that are missing are no error of the reader's but of join_inputs().
  bool is_one_of_several = false;
};

/// Are all options in their legal ranges?
///
/// Errors: bad_option; the message names the option, its value and the legal range.
Status check_read_options(const ReadOptions& options);

}  // namespace cover
