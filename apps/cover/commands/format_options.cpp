#include "commands/format_options.hpp"

namespace cover::app {

void FormatOptions::add(CLI::App& command, const std::string& group) {
  command.add_option("--order", options_.order, "2: triangles with six nodes")
      ->type_name("1|2")
      ->capture_default_str()
      ->group(group);
  command.add_option("--msh", options_.msh, "Version of .msh: 2.2 or 4.1")
      ->type_name("VERSION")
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--xdmf", options_.xdmf,
                  "Numbers of .xdmf: text inside, or hdf5, in X.h5 beside X.xdmf, for large meshes")
      ->type_name("FORM")
      ->capture_default_str()
      ->group(group);
  command
      .add_option(
          "--parts", options_.parts,
          "Parts of a .pvtu, with ghosts, owners and global ids, for as many processes; or of "
          "a .msh 4.1, as X_1.msh, X_2.msh, ...")
      ->type_name("N")
      ->capture_default_str()
      ->group(group);
  command.add_flag("--no-inner-lines", no_inner_lines_, "Leave out lines between two triangles")
      ->group(group);
  command.add_flag("--lines", options_.lines, "Lines in .vtk too, as deal.II wants them")
      ->group(group);
  command
      .add_option("--ids", options_.ids,
                  "Numbers of triangles for solvers: region, material or name; unless given, "
                  "name in .msh, else material")
      ->type_name("WHAT")
      ->group(group);
  command.add_option("--inp-element", options_.inp_element, "Elements of .inp: S, CPS, CPE or CAX")
      ->type_name("KIND")
      ->capture_default_str()
      ->group(group);
}

WriteOptions FormatOptions::make() const {
  WriteOptions options = options_;
  options.inner_lines = !no_inner_lines_;
  return options;
}

}  // namespace cover::app
