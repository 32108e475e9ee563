// `lober section SYSTEM`: runs the operation, and streams the orbits to a file and a picture.

#include "cli/section/section_command.hpp"

#include <spdlog/fmt/fmt.h>

#include <optional>

#include "cli/picture/picture_options.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/log.hpp"
#include "cli/program/point_arguments.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/system_options.hpp"
#include "cli/program/table_options.hpp"
#include "cli/report/outcome_json.hpp"
#include "cli/report/table.hpp"
#include "cli/section/section_output.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/operations/picture_size.hpp"
#include "lober/base/threads.hpp"

namespace lober::cli {
namespace {

using operations::SystemSection;

constexpr double cell_pixels = 3;  // cell of the picture, which is 960 of them wide

struct SectionRequest {
  SystemRequest system;
  std::vector<std::string> start;
  std::vector<operations::OptionSetting> settings;
  std::string output, json;
  PictureRequest picture;
  int threads = 0;
};

// Takes the orbits as they come.
class Orbits {
 public:
  Orbits(std::string path, Progress& progress) : path_(std::move(path)), progress_(progress) {}

  void take(const SystemSection& so_far) {
    const std::size_t each = so_far.options.iterates + 1;
    if (so_far.first == 0) begin(so_far);
    if (file_) file_->add(so_far.first, so_far.block);
    for (std::size_t k = 0; k < so_far.reached.size(); ++k) {
      if (so_far.reached[k]) density_->add(so_far.block.subspan(k * each, each));
    }
  }
  void finish(const SystemSection& all) {
    if (!density_) begin(all);  // there was no orbit
    if (file_) file_->finish();
  }
  [[nodiscard]] const Density& density() const { return *density_; }

 private:
  void begin(const SystemSection& all) {
    const detail::PictureSize size = detail::picture_size(all.box);
    density_.emplace(all.box, static_cast<std::size_t>(size.width / cell_pixels),
                     static_cast<std::size_t>(size.height / cell_pixels));
    if (!path_.empty()) file_.emplace(path_, all.orbits, all.options.iterates);
    progress_.of(static_cast<double>(all.orbits) * static_cast<double>(all.options.iterates + 1), "points");
  }

  std::string path_;
  Progress& progress_;
  std::optional<Density> density_;
  std::optional<OrbitFile> file_;
};

std::string section_table(const System& system, const SystemSection& result) {
  std::string text = system_text(system) + "\n";
  text += fmt::format("orbits     {} of {} iterates\n", result.orbits, result.options.iterates);
  if (!(result.options.lattice == Point{})) {
    text +=
        fmt::format("folded     by shifts of ({:.10g}, {:.10g})", result.options.lattice.x, result.options.lattice.y);
    const Point& second = result.options.second_lattice;
    text += second == Point{} ? "\n" : fmt::format(" and ({:.10g}, {:.10g})\n", second.x, second.y);
  }
  text += fmt::format("points     {}, {} in [{:.10g}, {:.10g}] x [{:.10g}, {:.10g}]\n", result.points, result.inside,
                      result.box.min_x, result.box.max_x, result.box.min_y, result.box.max_y);
  if (result.unreached > 0) {
    text += fmt::format("no orbit   {} of the starts, which the energy does not reach or the section excludes\n",
                        result.unreached);
  }
  if (result.exit_times) {
    const std::vector<std::uint64_t> counts = result.exit_times->counts();
    const double all = static_cast<double>(result.orbits - counts[0]);
    const bool is_markdown = table_format() == TableFormat::markdown;
    const Table table({{"leave after crossing"}, {"orbits"}, {"share", 0, Align::right, 1, "%"}});
    if (is_markdown && counts.size() > 1) text += table.head();
    for (std::size_t n = 1; n < counts.size(); ++n) {
      const double share = 100 * static_cast<double>(counts[n]) / all;
      text += is_markdown ? table.row({std::to_string(n), std::to_string(counts[n]), fmt::format("{:.4g}", share)})
                          : fmt::format("leave      after crossing {}: {} orbits, {:.4g} %\n", n, counts[n], share);
    }
    text += fmt::format("stay       {} orbits\n", result.exit_times->staying());
  }
  if (result.lost > 0 && system.section) {
    text += fmt::format("left       {} orbits, which do not come back to the section\n", result.lost);
  } else if (result.lost > 0) {
    text += fmt::format("lost       {} orbits, which cannot be followed to the end\n", result.lost);
  }
  return text;
}

void run(const SectionRequest& request) {
  const detail::Stopwatch watch;
  std::vector<std::string> files = files_of_system(request.system.name);
  for (std::string& file : point_files("--start", request.start)) files.push_back(std::move(file));
  std::vector<Output> outputs = request.picture.outputs();
  for (const auto& [option, path] : {std::pair{"-o", request.output}, {"--json", request.json}}) {
    if (!path.empty()) outputs.push_back({option, path});
  }
  check_outputs(outputs, files);
  const operations::Operation& operation = operations::named("section");
  const operations::Options options = checked_options(operation, request.settings);
  const operations::SystemInput input = system_input_of(request.system);
  const System& system = *input.system;
  const Buffer<Point> starts = points_of("--start", request.start);
  std::vector<operations::Input> inputs{input};
  if (!request.start.empty()) inputs.emplace_back(std::span<const Point>(starts));
  operations::Outcome outcome;
  {
    Progress progress;
    progress.phase("orbits", 0, 1);
    Orbits orbits(request.output, progress);
    operations::Context context;
    context.progress = told_to(progress);
    context.on_part = [&](const void* part) {
      const auto& so_far = *static_cast<const SystemSection*>(part);
      if (so_far.first == 0) request.picture.require_inset_in(so_far.box);
      orbits.take(so_far);
    };
    const detail::Stopwatch orbits_watch;
    outcome = operation.run(inputs, options, context);
    const double seconds = orbits_watch.seconds();
    const auto& found = outcome.as<SystemSection>();
    orbits.finish(found);
    if (request.picture.asked()) {
      write_figure(request.picture, found.exit_times
                                        ? exit_times_figure(*found.exit_times, found.options.iterates, system)
                                        : section_figure(orbits.density(), system));
    }
    if (!request.json.empty()) {
      write_outcome_json(request.json, "section", {{"system", system_json(system, input.integration)}}, operation,
                         outcome, [&] {
                           return Json{{"orbits", seconds}, {"total", watch.seconds()}};
                         });
    }
  }
  const auto& found = outcome.as<SystemSection>();
  if (!takes_standard_output(outputs)) {
    print_report(section_table(system, found));
  } else if (found.lost > 0) {
    log_warning(fmt::format("{} orbits end before the last iterate", found.lost));
  }
}

}  // namespace

void run_section(const std::vector<std::string>& arguments) {
  SectionRequest request;
  const operations::Operation& operation = operations::named("section");
  const std::string description = operation.summary + " Writes or draws them.";
  OptionParser parser(description.c_str(), "lober section");
  add_system_option(parser, request.system.name, true);
  add_parameter_option(parser, request.system.parameters);
  const TableOptions options(parser, operation);
  const Option start =
      parser
          .add("--start", request.start,
               "The first points of orbits, in the coordinates of the map: X,Y, or a FILE of points; several may "
               "follow (default: those of --orbits).")
          .value("X,Y|FILE")
          .excludes(options["orbits"])
          .excludes(options["exit_times"]);
  options["orbits"].excludes(start).excludes(options["exit_times"]);
  add_integration_option(parser, request.system.integration);
  parser
      .add("-o,--output", request.output,
           "Write the orbits to FILE while they are followed: .npy, an array of orbits x (iterates + 1) x 2, NaN from "
           "where an orbit is lost; .csv, lines of orbit, iterate, x, y; - is text on standard output (default: no "
           "file).")
      .value("FILE");
  options["exit_times"].needs(
      add_picture_options(parser, request.picture, "the density of the points, or the exit times,"));
  add_json_option(parser, request.json);
  add_table_option(parser);
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return;
  if (!request.output.empty()) OrbitFile::require_name(request.output);
  request.settings = options.settings();
  run_with_threads(request.threads, [&] { run(request); });
}

}  // namespace lober::cli
