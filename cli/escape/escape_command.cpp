// `lober escape SYSTEM`: finds orbits, tubes and the table of escape, and hands them to those who show them.

#include "cli/escape/escape_command.hpp"

#include <algorithm>
#include <charconv>

#include "cli/escape/escape_report.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/log.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/system_options.hpp"
#include "cli/report/agreement_report.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/cancellation.hpp"
#include "lober/error.hpp"
#include "lober/files.hpp"
#include "lober/threads.hpp"

namespace lober::cli {
namespace {

struct EscapeRequest {
  std::string system;
  std::optional<double> energy;
  std::vector<std::string> parameters, saddles;
  std::string section, direction, bound;
  EscapeOptions options;
  std::uint64_t trajectories = 2000, seed = 1;
  bool lists_counts = false;  ///< of trajectories, which were asked for
  std::string json, svg, curves, tubes;
  int threads = 0;
};

std::optional<EscapeRequest> parse_escape(const std::vector<std::string>& arguments) {
  EscapeRequest request;
  double energy = 0;
  OptionParser parser(
      "Computes the escape from a potential well: the periodic orbits of its bottlenecks, their tubes on a section, "
      "and the fraction of the trajectories entering by one bottleneck that leave by another after n crossings.",
      "lober escape");
  parser
      .add("SYSTEM", request.system,
           "The name of a built-in system (capsize or pcr3bp), or the path of a shared library (lober_system.h).")
      .required();
  const Option given = parser
                           .add("--energy", energy,
                                "The total energy, above that of the saddles (default: the parameter energy of the "
                                "system).")
                           .value("E");
  parser
      .add(
          "--crossings", request.options.crossings,
          "The number of crossings of the section up to which the table goes (default: 4). With 0 only the orbits, the "
          "tubes and their first crossings are computed.")
      .range(0, max_iterates)
      .value("N");
  add_parameter_option(parser, request.parameters);
  parser
      .add("--saddle", request.saddles,
           "A saddle of the potential: its number among those of the system, from 1, or a position near it, or four "
           "coordinates; the option may be repeated (default: all saddles of the system).")
      .value("K|X,Y[,PX,PY]");
  parser
      .add("--section", request.section,
           "The section, x=VALUE or y=VALUE, where x and y are the coordinates of position (default: the section of "
           "the system).")
      .value("COORDINATE=VALUE");
  parser
      .add("--direction", request.direction,
           "The sign of the velocity of the crossings that count: +, - or, with --crossings 0, both (default: that of "
           "the system's section, or + with --section; with --crossings 0 both, unless the section has a bound).")
      .one_of({"+", "-", "both"})
      .value("SIGN");
  parser
      .add("--bound", request.bound,
           "The part of the section whose crossings count, for example x<-1 or y>0, with --crossings 0 only (default: "
           "that of the system, or the whole section with --section).")
      .value("COORDINATE<VALUE");
  parser
      .add("--tolerance", request.options.tolerance,
           "The maximum distance between a curve and its polygon, relative to the square root of the area of the "
           "smallest entrance (default: 1e-6).")
      .range(1e-12, 1e-2)
      .value("E");
  parser
      .add(
          "--max-points", request.options.max_points,
          "The maximum number of points of a curve (default: 2000000). The table ends before an image that is expected "
          "to need more.")
      .range(std::size_t{100}, std::size_t{1} << 30)
      .value("N");
  parser
      .add("--budget", request.options.budget,
           "The wall-clock time that the table may take, in seconds (default: a limit on the work instead, which gives "
           "the same table on every machine). The table ends before images that are expected to end later; those that "
           "do not end as expected are broken off.")
      .positive()
      .value("SECONDS");
  const Option count = parser
                           .add("--monte-carlo", request.trajectories,
                                "The number of trajectories to follow from each entrance, as a check of the table; "
                                "given, their fractions are listed too (default: 2000, 0: none).")
                           .range(std::uint64_t{0}, std::uint64_t{1'000'000'000'000})
                           .value("N");
  parser.add("--seed", request.seed, "The seed of the random numbers of these trajectories (default: 1).")
      .needs(count)
      .value("S");
  add_json_option(parser, request.json);
  parser.add("--svg", request.svg, "Draw the curves on the section as an SVG picture in FILE (default: no file).")
      .value("FILE");
  parser
      .add("--curves", request.curves,
           "Write the periodic orbits, as points of position, and the curves of all tubes on the section, their images "
           "and pre-images to FILE as Tecplot zones (default: no file).")
      .value("FILE");
  parser
      .add("--tubes", request.tubes,
           "Write the surfaces of the tubes between their orbits and the section to FILE, in the coordinates x, y and "
           "the velocity on the section: as legacy VTK (.vtk), or drawn as an SVG picture (.svg) (default: no file).")
      .value("FILE");
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return std::nullopt;
  if (!request.tubes.empty()) (void)is_vtk(request.tubes);
  if (given.given()) request.energy = energy;
  request.lists_counts = count.given() && request.trajectories > 0;
  if (request.options.crossings == 0 && request.lists_counts) {
    throw UsageError("--monte-carlo checks the table, which --crossings 0 leaves out; give --crossings of at least 1");
  }
  return request;
}

double finite_number(std::string_view text, const std::string& where) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size() || !(value - value == 0)) {
    throw UsageError(where + ": \"" + std::string(text) + "\" is not a number");
  }
  return value;
}

// "NAME<separator>VALUE"; the separator is any one of those given, and comes back in `found`.
std::pair<std::string, double> assignment(const std::string& text, const std::string& option,
                                          std::string_view separators, char& found) {
  const std::size_t at = text.find_first_of(separators);
  if (at == std::string::npos || at == 0) {
    std::string forms;
    for (const char separator : separators) {
      forms += (forms.empty() ? "NAME" : " or NAME") + std::string(1, separator) + "VALUE";
    }
    throw UsageError(option + ": \"" + text + "\" is not of the form " + forms);
  }
  found = text[at];
  return {text.substr(0, at), finite_number(std::string_view(text).substr(at + 1), option)};
}

int position_coordinate(const Flow& flow, const std::string& name, const std::string& option) {
  if (name != "x" && name != "y") {
    throw UsageError(option + ": the coordinate has to be x or y, not \"" + name + "\"");
  }
  const auto pairs = flow.conjugate_pairs();
  if (pairs.size() != 2) throw UsageError("lober escape needs a Hamiltonian flow of two degrees of freedom");
  return pairs[name == "x" ? 0 : 1].q;
}

FlowState saddle_of(const std::string& text, const System& system) {
  FlowState state{};
  std::size_t count = 0;
  for (std::size_t begin = 0; begin <= text.size(); ++count) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const double value = finite_number(std::string_view(text).substr(begin, end - begin), "--saddle");
    if (count < 4) state[count] = value;
    begin = end + 1;
  }
  if (count == 4) return state;
  if (count == 2) return state_at_rest(*system.flow, {state[0], state[1]});
  const double index = state[0];
  if (count != 1 || !(index >= 1 && index <= static_cast<double>(system.saddles.size())) ||
      index != std::floor(index)) {
    throw UsageError("--saddle: \"" + text +
                     "\" is neither a position X,Y, nor four coordinates, nor the number of a saddle from 1 to " +
                     std::to_string(system.saddles.size()));
  }
  return system.saddles[static_cast<std::size_t>(index) - 1];
}

System system_with_energy(const EscapeRequest& request) {
  ParameterValues values;
  char separator = 0;
  for (const std::string& parameter : request.parameters) {
    values.push_back(assignment(parameter, "--param", "=", separator));
  }
  if (!request.energy) return make_system(request.system, values);
  // The system's own energy goes with its own section, which then is the one that the escape is about.
  const bool given =
      std::any_of(values.begin(), values.end(), [](const auto& value) { return value.first == "energy"; });
  if (given) throw UsageError("the energy is given twice, by --energy and by --param energy; give it once");
  const System plain = make_system(request.system, values);
  const auto& parameters = plain.info.parameters;
  if (std::any_of(parameters.begin(), parameters.end(), [](const Parameter& p) { return p.name == "energy"; })) {
    values.emplace_back("energy", *request.energy);
  }
  return make_system(request.system, values);
}

double given_energy(const EscapeRequest& request, const System& system) {
  if (request.energy) return *request.energy;
  for (const Parameter& parameter : system.info.parameters) {
    if (parameter.name == "energy") return parameter.value;
  }
  throw UsageError("--energy is missing, and system " + system.info.name + " has no parameter energy; give --energy E");
}

Section section_of(const EscapeRequest& request, const System& system) {
  const Flow& flow = *system.flow;
  if (request.section.empty() && !system.section) {
    throw UsageError("--section is missing, and system " + system.info.name +
                     " has no section of its own; give --section");
  }
  Section section = system.section.value_or(Section{});
  char separator = 0;
  if (!request.section.empty()) {
    const auto [name, value] = assignment(request.section, "--section", "=", separator);
    section = position_section(flow, position_coordinate(flow, name, "--section"), value, 1);
  }
  if (section.bound_side != 0 && request.bound.empty() && request.options.crossings > 0) {
    throw UsageError("the section of system " + system.info.name +
                     " counts only a part of the crossings, and the table of escape needs all of them; give --section, "
                     "or --crossings 0 for the orbits and tubes alone");
  }
  if (!request.direction.empty()) {
    section.direction = request.direction == "+" ? 1 : request.direction == "-" ? -1 : 0;
  } else if (request.options.crossings == 0 && section.bound_side == 0) {
    section.direction = 0;  // as the table has it, which takes tubes where they cross first
  }
  if (!request.bound.empty()) {
    const auto [name, value] = assignment(request.bound, "--bound", "<>", separator);
    section.bound_coordinate = position_coordinate(flow, name, "--bound");
    section.bound = value;
    section.bound_side = separator == '<' ? -1 : 1;
  }
  return section;
}

void compute(const EscapeRequest& request, bool print_at_once, EscapeReport& report, Progress& progress) {
  const System system = system_with_energy(request);
  if (!system.flow) throw UsageError("lober escape needs a flow, and system " + system.info.name + " is a map");
  report.system = system.info;
  report.flow = system.flow;
  report.options = request.options;
  std::vector<FlowState> saddles = system.saddles;
  if (!request.saddles.empty()) saddles.clear();
  for (const std::string& text : request.saddles) saddles.push_back(saddle_of(text, system));
  if (saddles.empty()) {
    throw UsageError("--saddle is missing, and system " + system.info.name + " names no saddles; give --saddle");
  }
  const double energy = given_energy(request, system);
  const Section section = section_of(request, system);

  progress.phase("tubes", 0, request.trajectories > 0 ? 0.5 : 0.95);
  EscapeOptions options = request.options;
  options.progress = [&](const EscapeProgress& at) { return progress.advance(at.fraction); };
  if (print_at_once) {
    options.rows_known = [&, warned = false](const Escape& so_far, int n) mutable {
      progress.above([&] {
        if (!warned) print(agreement_text(so_far.agreement));
        warned = !so_far.agreement.agrees();
        if (n == 1) print(escape_heading(report.system.name, so_far));
        print(escape_rows(so_far, n));
      });
    };
  }
  const detail::Stopwatch escape_watch;
  if (options.crossings > 0) {
    report.result = escape(*system.flow, section, energy, saddles, options);
  } else {
    report.result.energy = energy;
    report.result.section = section;
    report.result.bottlenecks = bottlenecks(*system.flow, section, energy, saddles, options);
    compare_areas(report.result.bottlenecks, report.result.agreement);
  }
  report.escape_seconds = escape_watch.seconds();
  if (request.trajectories == 0 || report.result.crossings == 0 || report.result.stop == EscapeStop::cancelled) return;

  progress.phase("Monte Carlo", 0.5, 0.95);
  const detail::Stopwatch check_watch;
  report.lists_counts = request.lists_counts;
  report.check_options.trajectories = request.trajectories;
  report.check_options.seed = request.seed;
  MonteCarloOptions check = report.check_options;
  const auto all = static_cast<double>(request.trajectories * report.result.bottlenecks.size());
  check.progress = [&](double fraction) {
    progress.count(fraction * all, "trajectories");
    return progress.advance(fraction);
  };
  report.check = monte_carlo(*system.flow, report.result, check);
  report.check_seconds = check_watch.seconds();
  const bool agreed = report.result.agreement.agrees();
  compare(report.result, *report.check, report.result.agreement);
  if (print_at_once && agreed) print(agreement_text(report.result.agreement));
}

// After all numbers are out: a picture that cannot be drawn costs none of them.
void draw(const std::string& path, const EscapeReport& report) {
  std::string picture;
  try {
    picture = escape_picture(report);
  } catch (const DataError& error) {
    log_warning("--svg: no picture is drawn: " + std::string(error.what()));
    return;
  }
  write_file(path, picture);
}

void run(const EscapeRequest& request) {
  const detail::Stopwatch watch;
  std::vector<Output> outputs;
  if (!request.json.empty()) outputs.push_back({"--json", request.json});
  if (!request.svg.empty()) outputs.push_back({"--svg", request.svg});
  if (!request.curves.empty()) outputs.push_back({"--curves", request.curves});
  if (!request.tubes.empty()) outputs.push_back({"--tubes", request.tubes});
  check_outputs(outputs, files_of_system(request.system));
  const bool printing = !takes_standard_output(outputs);
  // Rows are printed as soon as they are known; where trajectories are asked for they may take long, and if they
  // contradict a row the first line says so.
  const bool print_at_once = printing && !request.lists_counts;
  EscapeReport report;
  std::optional<CancellationScope> shield;  // what is known is written, even after an interrupt
  {
    Progress progress;
    compute(request, print_at_once, report, progress);
    if (report.result.stop == EscapeStop::cancelled) {
      shield.emplace(CancellationScope::Shield{});
    } else {
      progress.phase("writing", 0.95, 1);
    }
    if (!request.curves.empty()) write_escape_curves(request.curves, report);
    if (!request.tubes.empty()) write_escape_tubes(request.tubes, *report.flow, report);
    if (!request.json.empty()) write_escape_json(request.json, report, [&] { return watch.seconds(); });
  }
  const Escape& result = report.result;
  if (printing && (!print_at_once || result.crossings == 0)) {
    print(agreement_text(result.agreement));
    print(escape_heading(report.system.name, result));
    for (int n = 1; n <= result.crossings; ++n) print(escape_rows(result, n));
  }
  if (printing) print(escape_summary(report));
  if (!request.svg.empty()) draw(request.svg, report);
  if (result.stop == EscapeStop::cancelled) throw Cancelled();
  require_agreement(result.agreement);
}

}  // namespace

void run_escape(const std::vector<std::string>& arguments) {
  const std::optional<EscapeRequest> request = parse_escape(arguments);
  if (request) run_with_threads(request->threads, [&] { run(*request); });
}

}  // namespace lober::cli
