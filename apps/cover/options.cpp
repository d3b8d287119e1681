#include "options.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <sstream>

#include <fmt/ranges.h>

#include <cover/read_size_field.hpp>

#include "base/suggest.hpp"
#include "clean/weld.hpp"
#include "pipeline/check_options.hpp"

namespace cover::app {
namespace {

constexpr const char* kMeshing = "Meshing";

/// Help of at most 100 columns.
class NarrowHelp : public CLI::Formatter {
 public:
  NarrowHelp() {
    column_width(kNames);
    label("REQUIRED", "");
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    std::string out;
    std::size_t column = 0;
    std::istringstream words(option->get_description());
    for (std::string word; words >> word;) {
      if (column > 0 && column + 1 + word.size() > kDescription) {
        out += '\n';
        column = 0;
      }
      if (column > 0) ++column, out += ' ';
      out += word;
      column += word.size();
    }
    return out;
  }

 private:
  static constexpr std::size_t kNames = 32;
  static constexpr std::size_t kDescription = 68;
};

/// number_in() for an option that also stands alone, and so takes the word behind it for its
/// number.
CLI::Validator optional_number_in(Range range) {
  return {[is_in = number_in(range)](std::string& text) -> std::string {
            const std::string fault = is_in(text);
            double ignored = 0;
            return fault.empty() || CLI::detail::lexical_cast(text, ignored)
                       ? fault
                       : fault + "; before a file, write it with '=' and a number";
          },
          ""};
}

/// The long names (`--fill`) of all options of a command.
std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string did_you_mean(const CLI::App& command, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  const auto meant = closest(name, option_names(command));
  return meant ? fmt::format("; did you mean '{}'?", *meant) : std::string();
}

/// What was wrong, in words for the user.
std::string explain(const CLI::App& command, const CLI::ParseError& error) {
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    const std::string word = command.remaining().front();
    if (word.starts_with('-')) {
      return fmt::format("unknown option '{}'{}", word, did_you_mean(command, word));
    }
    return fmt::format("unexpected argument '{}'", word);
  }
  if (dynamic_cast<const CLI::ConfigError*>(&error) != nullptr) {
    const std::string text = error.what();
    const std::string key = text.substr(text.rfind(' ') + 1);
    if (const std::size_t dot = key.find('.'); dot != std::string::npos)
      return fmt::format("the --config file has a section [{}]; its keys stand without sections",
                         key.substr(0, dot));
    return fmt::format("unknown key '{}' in the --config file{}", key,
                       did_you_mean(command, "--" + key));
  }
  if (dynamic_cast<const CLI::FileError*>(&error) != nullptr) {
    return fmt::format("cannot read the --config file: {}", error.what());
  }
  return error.what();
}

}  // namespace

CLI::Validator one_of(std::vector<std::string> words) {
  return {[words = std::move(words)](std::string& word) -> std::string {
            if (std::find(words.begin(), words.end(), word) != words.end()) return {};
            const auto meant = closest(word, words);
            return fmt::format("'{}' is not one of {}{}", word, fmt::join(words, ", "),
                               meant ? fmt::format("; did you mean '{}'?", *meant) : "");
          },
          ""};
}

CLI::Validator number_in(Range range) {
  return {[range](std::string& text) -> std::string {
            double value = 0;
            if (!CLI::detail::lexical_cast(text, value))
              return fmt::format("'{}' is not a number", text);
            if (range.holds(value)) return {};
            return fmt::format("{} is not {}", text, describe(range));
          },
          ""};
}

void add_verbosity(CLI::App& command, Verbosity& verbosity) {
  const char* group = "Messages";
  command.add_flag("-q,--quiet", verbosity.quiet, "Print errors only")->group(group);
  command.add_flag("-v,--verbose", verbosity.verbose, "Say what is done; -vv: in detail")
      ->group(group);
  command.add_option("--log", verbosity.log_file, "Write all messages, with times, to FILE")
      ->type_name("FILE")
      ->group(group);
}

std::optional<int> parse(CLI::App& command, Arguments arguments) {
  command.formatter(std::make_shared<NarrowHelp>());
  std::reverse(arguments.begin(), arguments.end());
  try {
    command.parse(std::move(arguments));
    return std::nullopt;
  } catch (const CLI::CallForHelp&) {
    std::fputs(command.help().c_str(), stdout);
    return exit_ok;
  } catch (const CLI::ParseError& error) {
    return usage_error(command, explain(command, error));
  }
}

std::string configuration(const CLI::App& command) {
  std::istringstream lines(command.config_to_str(true, true));
  std::string out;
  for (std::string line; std::getline(lines, line);) {
    const std::string name = line.substr(0, line.find('='));
    const CLI::Option* option = command.get_option_no_throw("--" + name);
    if (option == nullptr) option = command.get_option_no_throw(name);
    // A flag given more than once is a list to CLI11, which it cannot read back.
    if (option != nullptr && option->get_expected_max() == 0 && option->count() > 1)
      line = fmt::format("{}={}", name, option->count());
    // A default is not printed as if it were given: it may be the value of an option that is off.
    out += (option != nullptr && option->count() == 0 ? "# " : "") + line + '\n';
  }
  return out;
}

int usage_error(const CLI::App& command, const std::string& message) {
  fmt::print(stderr, "cover: error: {}\nSee '{} --help'.\n", message, command.get_name());
  return exit_usage;
}

int usage_error(const CLI::App& command, const Error& error) {
  const int code = exit_code_of(error.code);
  if (code == exit_usage) return usage_error(command, error.message);
  fmt::print(stderr, "cover: error: {}\n", error.message);
  return code;
}

NamedFile config_file(const CLI::App& command) {
  const CLI::Option* option = command.get_config_ptr();
  return {"--config", option->empty() ? std::string() : option->as<std::string>()};
}

NamedFile log_file(const Verbosity& verbosity) {
  // Standard output is no place for a log: `-` is a file of that name.
  return {"--log", verbosity.log_file == "-" ? "./-" : verbosity.log_file};
}

void LibraryOptions::add_cleaning(CLI::App& command) {
  const char* group = "Input";
  command
      .add_option("--overlap", overlap_,
                  "Which of several painted polygons wins: last, first, or error")
      ->check(one_of({"last", "first", "error"}))
      ->type_name("WHICH")
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--weld", weld_,
                  "Unite ends closer than this part of the drawing's size, at most 1/8 of the "
                  "shortest line there: auto, off or a number (default: auto for polygons, off "
                  "for segments)")
      ->type_name("REL")
      ->group(group);
  command.add_flag("--strict", options_.strict, "Any change to the input is an error")
      ->group(group);
  command
      .add_flag("--merge-materials", options_.merge_materials,
                "Unite touching faces of equal material")
      ->group(group);
}

void LibraryOptions::add_meshing(CLI::App& command) {
  add_method(command);
  add_targets(command);
  add_sizes(command);
  command
      .add_option("--require", require_,
                  "Exit with 6 unless this holds: bound, max-angle, delaunay, non-obtuse")
      ->check(one_of({"bound", "max-angle", "delaunay", "non-obtuse"}))
      ->type_name("WHAT")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->group(kMeshing);
  command.add_option("-j,--threads", options_.threads, "Threads; 0: all cores")
      ->check(number_in({0, 4096}))
      ->type_name("N")
      ->capture_default_str()
      ->group(kMeshing);
}

void LibraryOptions::add_method(CLI::App& command) {
  CLI::Option* method =
      command
          .add_option(
              "--method", method_,
              "quality: good angles, never below the proven bound; almond: the bound "
              "alone, the fastest; nonobtuse: no angle above 90 degrees, or by rounding 90.1, "
              "but segments are split")
          ->check(one_of({"quality", "almond", "nonobtuse"}))
          ->type_name("NAME")
          ->capture_default_str()
          ->group(kMeshing);
  CLI::Option* fill =
      command
          .add_option("--fill", fill_,
                      "What fills the space between the almonds, refine or disks; implies --method "
                      "almond")
          ->check(one_of({"refine", "disks"}))
          ->type_name("NAME")
          ->capture_default_str()
          ->group(kMeshing);
  CLI::Option* paper =
      command
          .add_flag("--paper", options_.paper,
                    "The publication as printed, for comparison: none of our improvements; implies "
                    "--method almond")
          ->group(kMeshing);
  command.parse_complete_callback([this, method, fill, paper] {
    if (method->empty() && (!fill->empty() || !paper->empty())) method_ = "almond";
  });
  command
      .add_option("--pieces", options_.pieces,
                  "With --paper: pieces of an arc are at most 1/N of it")
      ->check(number_in(ranges::kPieces))
      ->type_name("N")
      ->capture_default_str()
      ->needs(paper)
      ->group(kMeshing);
  command
      .add_flag("--hull", options_.hull,
                "Mesh the convex hull; for input that need not enclose anything")
      ->group(kMeshing);
}

void LibraryOptions::add_targets(CLI::App& command) {
  command
      .add_option("--max-angle", max_angle_,
                  "Largest angle that --method quality aims at, and --require max-angle asks for")
      ->check(number_in(ranges::kMaxAngle))
      ->type_name("DEG")
      ->capture_default_str()
      ->group(kMeshing);
  command
      .add_option("--min-angle", min_angle_,
                  "Smallest angle that --method quality aims at, where the largest allows it")
      ->check(number_in(ranges::kMinAngle))
      ->type_name("DEG")
      ->capture_default_str()
      ->group(kMeshing);
  command
      .add_option("--split-interfaces", split_interfaces_,
                  "Cut segments until none forces an angle above DEG (default: 90), and to the "
                  "lengths that sizes ask for; both sides get the same points")
      ->expected(0, 1)
      ->check(optional_number_in(ranges::kSplitInterfaces))
      ->default_str("90")
      ->type_name("DEG")
      ->group(kMeshing);
}

void LibraryOptions::add_sizes(CLI::App& command) {
  command
      .add_option("--size", sizes_,
                  "Edge length inside: everywhere (h), or in a region or material (NAME=h), by "
                  "name, number "
                  "of the material, or region:ID")
      ->type_name("[NAME=]h")
      ->allow_extra_args(false)
      ->group(kMeshing);
  command
      .add_option("--size-at", sizes_at_,
                  "Edge length at an interface, a contact or a point (NAME=h)")
      ->type_name("NAME=h")
      ->allow_extra_args(false)
      ->group(kMeshing);
  command
      .add_option(
          "--size-field", size_field_,
          "Background edge lengths: point array (size, h or the only one) of a plane mesh in "
          ".vtu, .vtp or .vtk; linear between points")
      ->type_name("FILE")
      ->group(kMeshing);
  command
      .add_flag("--no-input-sizes", no_input_sizes_,
                "Leave out the sizes that regions have in the input (.poly: largest areas)")
      ->group(kMeshing);
  command
      .add_option(
          "--growth", options_.growth,
          "Ratio of neighbouring edges where sizes differ; above 1 (1.3 unless given). Without "
          "sizes, triangles grow by it from the boundary's own edges")
      ->check(number_in(ranges::kGrowth))
      ->type_name("G")
      ->group(kMeshing);
}

namespace {

/// "NAME=h", or "h" where a name is not needed.
std::optional<SizeRule> size_rule(const std::string& text, bool at) {
  const std::size_t equals = text.rfind('=');
  SizeRule rule;
  rule.at = at;
  if (equals != std::string::npos) rule.name = text.substr(0, equals);
  const std::string number = equals == std::string::npos ? text : text.substr(equals + 1);
  if (!CLI::detail::lexical_cast(number, rule.size) || !ranges::kSize.holds(rule.size))
    return std::nullopt;
  if (at && rule.name.empty()) return std::nullopt;
  return rule;
}

}  // namespace

Result<Options> LibraryOptions::make() const {
  Options options = options_;
  options.method = method_ == "quality"     ? Method::quality
                   : method_ == "nonobtuse" ? Method::nonobtuse
                                            : Method::almond;
  options.fill = fill_ == "disks" ? Fill::disks : Fill::refine;
  options.overlap = overlap_ == "first"   ? Overlap::first
                    : overlap_ == "error" ? Overlap::error
                                          : Overlap::last;
  if (weld_ == "off") {
    options.weld = 0;
  } else if (weld_ == "auto") {
    options.weld = kAutoWeld;
  } else if (!weld_.empty()) {
    double tolerance = 0;
    if (!CLI::detail::lexical_cast(weld_, tolerance) || !ranges::kWeld.holds(tolerance)) {
      return Error{ErrorCode::bad_option,
                   fmt::format("--weld: '{}' is not auto, off or a number, {}", weld_,
                               describe(ranges::kWeld)),
                   {},
                   {}};
    }
    options.weld = tolerance;
  }
  options.input_sizes = !no_input_sizes_;
  options.max_angle = Angle::degrees(max_angle_);
  options.min_angle = Angle::degrees(min_angle_);
  if (split_interfaces_) options.split_interfaces = Angle::degrees(*split_interfaces_);
  for (const bool at : {false, true}) {
    for (const std::string& text : at ? sizes_at_ : sizes_) {
      std::optional<SizeRule> rule = size_rule(text, at);
      if (!rule) {
        return Error{ErrorCode::bad_option,
                     fmt::format("{}: '{}' is not {}=h with a length h above 0",
                                 at ? "--size-at" : "--size", text, at ? "NAME" : "h or NAME"),
                     {},
                     {}};
      }
      options.sizes.push_back(*std::move(rule));
    }
  }
  for (const std::string& what : require_) {
    options.require.bound |= what == "bound";
    options.require.max_angle |= what == "max-angle";
    options.require.delaunay |= what == "delaunay";
    options.require.non_obtuse |= what == "non-obtuse";
  }
  return options;
}

std::vector<std::string> LibraryOptions::ignored(const CLI::App& command) const {
  std::vector<std::string> sentences;
  const auto check = [&](const char* option, bool counts, const char* when) {
    if (!counts && command.get_option(option)->count() > 0)
      sentences.push_back(fmt::format("{} does nothing: it counts with {} only", option, when));
  };
  const bool required = std::find(require_.begin(), require_.end(), "max-angle") != require_.end();
  check("--max-angle", method_ == "quality" || required,
        "--method quality and --require max-angle");
  check("--min-angle", method_ == "quality", "--method quality");
  check("--growth", method_ == "quality" || split_interfaces_,
        "--method quality and --split-interfaces");
  check("--fill", method_ == "almond", "--method almond");
  return sentences;
}

Status LibraryOptions::read_size_field(Options& options) const {
  if (size_field_.empty()) return ok();
  const Result<SizeSamples> samples = cover::read_size_field(size_field_);
  if (!samples) return samples.error();
  Result<SizeFunction> sizes = size_function(*samples, options.growth.value_or(Options::kGrowth));
  if (!sizes) {
    Error error = std::move(sizes).error();
    error.message = fmt::format("{}: {}", size_field_, error.message);
    return error;
  }
  options.size_field = *std::move(sizes);
  options.size_field_name = size_field_;
  return ok();
}

}  // namespace cover::app
