// `lober section SYSTEM`: follows orbits, and streams their points to a file and a picture.

#include "cli/section/section_command.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <optional>

#include "cli/program/command_line.hpp"
#include "cli/program/log.hpp"
#include "cli/program/point_arguments.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/system_options.hpp"
#include "cli/report/json_file.hpp"
#include "cli/report/svg.hpp"
#include "cli/section/section_output.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/error.hpp"
#include "lober/orbits.hpp"
#include "lober/threads.hpp"

namespace lober::cli {
namespace {

constexpr double cell_pixels = 3;  // of the picture
constexpr double exit_cell_pixels = 4;

struct SectionRequest {
  std::string system;
  std::vector<std::string> parameters, start;
  std::vector<double> box;
  std::size_t orbits = 1000, iterates = 1000;
  bool lifted = false, exit_times = false;
  IntegrationOptions integration;
  std::string output, svg, json;
  int threads = 0;
};

void add_options(OptionParser& parser, SectionRequest& request) {
  add_system_option(parser, request.system, true);
  add_parameter_option(parser, request.parameters);
  const Option orbits =
      parser
          .add("--orbits", request.orbits,
               "The number of orbits, whose first points are spread evenly over the box (default: 1000).")
          .range(std::size_t{1}, std::size_t{1'000'000'000})
          .value("N");
  parser
      .add("--start", request.start,
           "The first points of orbits, in the coordinates of the map: X,Y, or a FILE of points; several may follow "
           "(default: those of --orbits).")
      .value("X,Y|FILE")
      .excludes(orbits);
  parser.add("--iterates", request.iterates, "The number of iterates of each orbit (default: 1000).")
      .range(std::size_t{1}, std::size_t{10'000'000})
      .value("M");
  parser
      .add(
          "--box", request.box,
          "Two corners of the box in which orbits start and which is drawn, X0 < X1 and Y0 < Y1 (default: all that the "
          "system is about, as a rule its window).")
      .comma_separated()
      .count(4)
      .value("X0,Y0,X1,Y1");
  parser.add_flag(
      "--lifted", request.lifted,
      "Leave lifted angles as they come (default: points of a map that repeats after a shift, such as 2 pi, "
      "are shifted into one cell from the left side of the box on, and from its lower side where both coordinates are "
      "angles).");
  add_integration_option(parser, request.integration);
  parser
      .add("-o,--output", request.output,
           "Write the orbits to FILE while they are followed: .npy, an array of orbits x (iterates + 1) x 2, NaN from "
           "where an orbit is lost; .csv, lines of orbit, iterate, x, y; - is text on standard output (default: no "
           "file).")
      .value("FILE");
  const Option picture =
      parser.add("--svg", request.svg, "Draw the density of the points as an SVG picture in FILE (default: no file).")
          .value("FILE");
  parser
      .add_flag(
          "--exit-times", request.exit_times,
          "Draw after how many crossings of the section orbits leave, the first point being crossing 1, in place of "
          "the density: one orbit begins in each cell of the picture. Works for systems whose orbits escape.")
      .needs(picture)
      .excludes(orbits);
  add_json_option(parser, request.json);
  add_threads_option(parser, request.threads);
}

void check(const SectionRequest& request) {
  if (!request.box.empty() && !(request.box[0] < request.box[2] && request.box[1] < request.box[3])) {
    throw UsageError("--box: the corners have to have X0 < X1 and Y0 < Y1");
  }
  if (!request.output.empty()) OrbitFile::require_name(request.output);
  if (request.exit_times && !request.start.empty()) {
    throw UsageError("--exit-times and --start cannot be given together: orbits begin in the cells of the picture");
  }
}

struct SectionResult {
  System system;
  Rectangle box;
  OrbitOptions options;
  std::size_t orbits = 0, lost = 0, unreached = 0;
  std::uint64_t points = 0, inside = 0;
  std::optional<ExitTimes> exit_times;
  double seconds = 0;
};

// A Density, or ExitTimes, with cells of that many pixels of the picture.
template <typename Cells>
Cells cells_of(const Rectangle& box, double pixels) {
  const View view(box);
  return {box, static_cast<std::size_t>(view.width() / pixels), static_cast<std::size_t>(view.height() / pixels)};
}

void follow(const SectionRequest& request, std::span<const Point> starts, SectionResult& result, Density& density,
            Progress& progress) {
  std::optional<OrbitFile> file;
  if (!request.output.empty()) file.emplace(request.output, starts.size(), request.iterates);
  const std::size_t each = request.iterates + 1;
  progress.of(static_cast<double>(starts.size()) * static_cast<double>(each), "points");
  follow_orbits(*result.system.map, starts, result.options, [&](std::size_t first, std::span<const Point> points) {
    if (file) file->add(first, points);
    const std::size_t count = points.size() / each;
    for (std::size_t k = 0; k < count; ++k) {
      const std::span<const Point> orbit = points.subspan(k * each, each);
      // Such a start is not a point of the section.
      const bool reached = result.system.map->is_defined_at(orbit.front());
      if (result.exit_times) result.exit_times->add(orbit, reached);
      if (!reached) {
        ++result.unreached;
        continue;
      }
      density.add(orbit);
      result.lost += std::isnan(orbit.back().x) ? 1U : 0U;
    }
    return progress.advance(static_cast<double>(first + count) / static_cast<double>(starts.size()));
  });
  if (file) file->finish();
}

std::string section_table(const SectionResult& result) {
  std::string text = system_text(result.system) + "\n";
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
    for (std::size_t n = 1; n < counts.size(); ++n) {
      const double share = 100 * static_cast<double>(counts[n]) / all;
      text += fmt::format("leave      after crossing {}: {} orbits, {:.4g} %\n", n, counts[n], share);
    }
    text += fmt::format("stay       {} orbits\n", result.exit_times->staying());
  }
  if (result.lost > 0 && result.system.section) {
    text += fmt::format("left       {} orbits, which do not come back to the section\n", result.lost);
  } else if (result.lost > 0) {
    text += fmt::format("lost       {} orbits, which cannot be followed to the end\n", result.lost);
  }
  return text;
}

void write_section_json(const SectionRequest& request, const SectionResult& result,
                        const std::function<double()>& seconds_so_far) {
  JsonFile json(request.json, "section");
  json.member("system", system_json(result.system, request.integration));
  json.member("options", {{"orbits", result.orbits},
                          {"iterates", result.options.iterates},
                          {"box", {result.box.min_x, result.box.min_y, result.box.max_x, result.box.max_y}},
                          {"lattice", point_json(result.options.lattice)},
                          {"second_lattice", point_json(result.options.second_lattice)}});
  json.member("points", result.points);
  json.member("points_in_box", result.inside);
  json.member("lost_orbits", result.lost);
  json.member("unreached_starts", result.unreached);
  if (result.exit_times) {
    Json leaving = Json::array();
    const std::vector<std::uint64_t> counts = result.exit_times->counts();
    for (std::size_t n = 1; n < counts.size(); ++n) leaving.push_back({{"crossings", n}, {"orbits", counts[n]}});
    json.member("exit_times", {{"columns", result.exit_times->columns()},
                               {"rows", result.exit_times->rows()},
                               {"leaving", leaving},
                               {"staying", result.exit_times->staying()}});
  }
  json.finish({{"orbits", result.seconds}, {"total", seconds_so_far()}});
}

void run(const SectionRequest& request) {
  const detail::Stopwatch watch;
  std::vector<Output> outputs;
  for (const auto& [option, path] :
       {std::pair{"-o", request.output}, {"--svg", request.svg}, {"--json", request.json}}) {
    if (!path.empty()) outputs.push_back({option, path});
  }
  std::vector<std::string> inputs = files_of_system(request.system);
  for (std::string& file : point_files("--start", request.start)) inputs.push_back(std::move(file));
  check_outputs(outputs, inputs);
  SectionResult result;
  result.system = system_of({request.system, request.parameters, request.integration, {}, {}, {}, {}, {}},
                            parameter_values(request.parameters));
  result.box = result.system.picture;
  if (!request.box.empty())
    result.box = Rectangle::of({request.box[0], request.box[1]}, {request.box[2], request.box[3]});
  result.options.iterates = request.iterates;
  if (!request.lifted) {
    result.options.lattice = result.system.lattice;
    result.options.second_lattice = result.system.second_lattice;
  }
  // One cell of what repeats, exactly.
  if (request.box.empty() && result.options.lattice.x > 0) {
    result.box.max_x = result.box.min_x + result.options.lattice.x;
  }
  if (request.box.empty() && result.options.second_lattice.y > 0) {
    result.box.max_y = result.box.min_y + result.options.second_lattice.y;
  }
  result.options.origin = {result.box.min_x, result.box.min_y};
  if (request.exit_times) result.exit_times = cells_of<ExitTimes>(result.box, exit_cell_pixels);
  const Buffer<Point> starts = result.exit_times       ? result.exit_times->starts()
                               : request.start.empty() ? spread_points(result.box, request.orbits)
                                                       : points_of("--start", request.start);
  result.orbits = starts.size();
  {
    Progress progress;
    progress.phase("orbits", 0, 1);
    auto density = cells_of<Density>(result.box, cell_pixels);
    const detail::Stopwatch orbits_watch;
    follow(request, starts, result, density, progress);
    result.seconds = orbits_watch.seconds();
    result.points = density.inside() + density.outside();
    result.inside = density.inside();
    if (result.exit_times) {
      write_exit_times_picture(request.svg, *result.exit_times, request.iterates, system_text(result.system));
    } else if (!request.svg.empty()) {
      write_section_picture(request.svg, density, system_text(result.system));
    }
    if (!request.json.empty()) write_section_json(request, result, [&] { return watch.seconds(); });
  }
  if (!takes_standard_output(outputs)) {
    print(section_table(result));
  } else if (result.lost > 0) {
    log_warning(fmt::format("{} orbits end before the last iterate", result.lost));
  }
}

}  // namespace

void run_section(const std::vector<std::string>& arguments) {
  SectionRequest request;
  OptionParser parser("Follows orbits of a map, or of a flow's Poincare map, and writes or draws their points.",
                      "lober section");
  add_options(parser, request);
  if (!parser.parse(arguments)) return;
  check(request);
  run_with_threads(request.threads, [&] { run(request); });
}

}  // namespace lober::cli
