// cover info: what an input holds and what can be reached on it.
#include <fmt/core.h>

#include <cover/cover_mesh.hpp>
#include <cover/text.hpp>

#include "commands/commands.hpp"
#include "commands/options.hpp"
#include "files/input_file.hpp"
#include "terminal/console.hpp"
#include "terminal/interrupt.hpp"
#include "words/text_report.hpp"

namespace cover::app {

int run_info(Arguments arguments) {
  CLI::App app("Show regions, materials, interfaces and bounds on the largest angles; no mesh",
               "cover info");
  app.set_help_flag("-h,--help", "Show this help");
  app.footer("Example:\n  cover info device.poly\n");
  GeometryFile input_file;
  Verbosity verbosity;
  LibraryOptions library;
  input_file.add(app, true)->required();
  library.add(app, OptionGroup::cleaning);
  library.add_threads(app);
  add_verbosity(app, verbosity);
  if (const auto code = parse(app, std::move(arguments))) return *code;
  const Result<Options> options = library.make();
  if (!options) return usage_error(app, options.error().message);
  const Status files = check_files(input_file.read_files(), {log_file(verbosity)});
  if (!files) return usage_error(app, files.error());

  const auto log = make_logger(verbosity);
  const Interrupt interrupt;
  input_file.heed(interrupt.token());
  const Result<Input> input = input_file.read(options->threads);
  if (!input) return fail(*log, input.error());
  for (const std::string& option : input_file.ignored()) log->warn("{}", option);
  const Result<Prepared> prepared = prepare(*input, *options);
  if (!prepared) {  // what readers warn of, as wrong names of layers, may be the reason
    log_warnings(*log, input->warnings);
    return fail(*log, prepared.error());
  }
  const Result<BoxCosts> costs = box_costs(*prepared, *options);
  if (!costs) return fail(*log, costs.error());
  fmt::print("{}{}", info_text(*prepared, verbosity.verbose > 0),
             box_costs_text(*costs, verbosity.verbose > 0));
  if (!input->fields.empty())
    fmt::print("\nAttributes of the map, for --name-field, --material-field and their like: {}\n",
               listed(input->fields));
  std::fflush(stdout);
  log_notes(*log, prepared->report.notes);
  for (const RegionReport& region : prepared->report.regions) log_notes(*log, region.notes);
  return exit_ok;
}

}  // namespace cover::app
