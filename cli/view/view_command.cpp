// `lober view RESULT|CURVE... -o FILE`: a page of curves, or of a result, which is computed again from its inputs.

#include "cli/view/view_command.hpp"

#include <memory>
#include <optional>

#include "cli/program/command_line.hpp"
#include "cli/program/commands.hpp"
#include "cli/program/option_parser.hpp"
#include "cli/program/output_names.hpp"
#include "cli/program/system_options.hpp"
#include "cli/report/report.hpp"
#include "cli/view/repeated_result.hpp"
#include "engine/files/curve_spec.hpp"
#include "lober/base/error.hpp"
#include "lober/base/threads.hpp"
#include "viewer/page.hpp"
#include "viewer/scenes/scenes.hpp"

namespace lober::cli {
namespace {

struct ViewRequest {
  std::vector<std::string> inputs;
  std::string output, library;
  bool closed = false;
  int threads = 0;
};

// Nothing when the arguments asked for help, which is printed.
std::optional<ViewRequest> parse_view(const std::vector<std::string>& arguments) {
  ViewRequest request;
  OptionParser parser(
      "Writes a page that shows curves, or a result with lobes, crossings and areas, in any browser: one file that "
      "needs no network, and that can be looked into as deep as doubles go. A RESULT names its inputs and options; it "
      "is computed again from them.",
      "lober view");
  parser.add_example("lober view examples/manifolds.dat -o manifolds.html", "all curves of a file");
  parser.add_example("lober view examples/manifolds.dat#0 -o u.html", "one of them");
  parser
      .add("RESULT|CURVE", request.inputs,
           "A result of overlay, regions, tangle, transport, escape or grow, written by --json; or curves: FILE, all "
           "curves of it, or FILE#ZONE, one of them.")
      .required();
  parser.add("-o,--output", request.output, "Write the page to FILE.").value("FILE").required();
  parser.add_flag("--closed", request.closed,
                  "Join the last point of each curve to the first (default: where they are equal).");
  parser
      .add("--library", request.library,
           "The shared library that has the system of the RESULT, where that is not one of lober; its code runs "
           "(default: no library is loaded, whatever a RESULT names).")
      .value("FILE");
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return std::nullopt;
  return request;
}

// The curves that an argument names: one zone, or all of the file.
std::vector<Curve> curves_of(const std::string& spec) {
  const detail::CurveSpec parts = detail::split_spec(spec);
  std::vector<Curve> curves;
  if (parts.zone) {
    curves.push_back(read_curve(spec, false, {.hash = false}).curve);
    if (curves.back().name.empty()) curves.back().name = spec;
    return curves;
  }
  CurveFile file = read_curve_file(parts.file, {.hash = false, .columns = parts.columns});
  for (std::size_t k = 0; k < file.zones.size(); ++k) {
    Zone& zone = file.zones[k];
    Curve curve;
    curve.name = zone.title.empty() ? parts.file : zone.title;
    if (zone.title.empty() && file.zones.size() > 1) curve.name += "#" + std::to_string(k);
    curve.points = std::move(zone.points);
    curve.closed = false;
    curves.push_back(std::move(curve));
  }
  return curves;
}

void run(const ViewRequest& request) {
  std::vector<Curve> curves;
  for (const std::string& input : request.inputs) {
    for (Curve& curve : curves_of(input)) curves.push_back(std::move(curve));
  }
  std::vector<viewer::Line> lines;
  std::size_t points = 0;
  for (Curve& curve : curves) {
    const std::size_t given = curve.points.size();
    if (given > 2 && curve.points.front() == curve.points.back()) drop_closing_vertex(curve.points);
    curve.closed = request.closed || curve.points.size() < given;
    points += curve.points.size();
    lines.push_back({curve.name, curve});
  }
  viewer::Scene scene = viewer::curves_scene(lines);
  for (const std::string& input : request.inputs) scene.notes.push_back("curves: " + input);
  viewer::write_page(request.output, scene);
  if (request.output != "-") {
    print(counted(lines.size(), "curve", "curves") + ", " + counted(points, "point", "points") + ": " + request.output +
          "\n");
  }
}

}  // namespace

void run_view(const std::vector<std::string>& arguments) {
  const std::optional<ViewRequest> request = parse_view(arguments);
  if (!request) return;
  require_fitting_name("--html", request->output);
  std::vector<std::string> read = request->inputs;
  if (!request->library.empty()) {
    if (!is_library_path(request->library) || !is_system(request->library)) {
      throw UsageError("--library: " + request->library + " does not end in .so, as shared libraries do");
    }
    read.push_back(request->library);
  }
  check_outputs(std::vector<Output>{{"-o", request->output}}, read);
  if (request->inputs.size() == 1) {
    if (auto result = repeated_result(request->inputs.front(), request->library)) {
      result->arguments.push_back("--html=" + request->output);
      if (request->threads > 0) result->arguments.push_back("--threads=" + std::to_string(request->threads));
      return run_command(result->command, result->arguments);
    }
  }
  if (!request->library.empty()) throw UsageError("--library: curves need no system; give it with a RESULT");
  run_with_threads(request->threads, [&] { run(*request); });
}

}  // namespace lober::cli
