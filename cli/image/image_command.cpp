// `lober image SYSTEM CURVE`: makes the system and the curve, follows the curve forward and backward, writes the
// images.

#include "cli/image/image_command.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <numbers>

#include "cli/image/image_report.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/output_names.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/system_options.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/report/report.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/drawing.hpp"
#include "lober/manifold_tangle.hpp"
#include "lober/threads.hpp"

namespace lober::cli {
namespace {

struct ImageRequest {
  std::string system, curve;
  std::vector<std::string> parameters;
  std::vector<double> circle, rectangle, box, window;
  bool boundary = false, open = false;
  std::string iterates = "1", output, json, svg;
  int first = 0, last = 0;  // of iterates
  int threads = 0;
  IntegrationOptions integration;
  ImageOptions options;
};

void add_options(OptionParser& parser, ImageRequest& request) {
  parser
      .add("SYSTEM", request.system, "The name of a built-in system, or the path of a shared library (lober_system.h).")
      .required();
  const Option curve = parser.add("CURVE", request.curve,
                                  "The curve: FILE, or FILE#ZONE for one zone of it (by number from 0, or by title). "
                                  "Or give --circle, --rectangle or --boundary.");
  const Option circle = parser
                            .add("--circle", request.circle,
                                 "The circle about X,Y of radius R, in the coordinates of the map, counter-clockwise; "
                                 "followed as a circle, not as a polygon.")
                            .comma_separated()
                            .count(3)
                            .value("X,Y,R")
                            .excludes(curve);
  const Option rectangle = parser
                               .add("--rectangle", request.rectangle,
                                    "The rectangle with these corners, X0 < X1 and Y0 < Y1, counter-clockwise.")
                               .comma_separated()
                               .count(4)
                               .value("X0,Y0,X1,Y1")
                               .excludes(curve)
                               .excludes(circle);
  parser
      .add_flag("--boundary", request.boundary,
                "The boundary that the system's tangle makes, from its manifolds: U up to the boundary intersection "
                "point and S from there; on a cylinder the upper and the lower one.")
      .excludes(curve)
      .excludes(circle)
      .excludes(rectangle);
  parser.add_flag("--open", request.open, "Take the curve of the file as open (default: closed).").needs(curve);
  add_parameter_option(parser, request.parameters);
  parser
      .add("--iterates", request.iterates,
           "The images that are computed: N, or FIRST:LAST for all from the one to the other; negative numbers are "
           "pre-images (default: 1). Range: -1000 to 1000.")
      .value("FIRST:LAST");
  add_tolerance_option(parser, request.options.tolerance,
                       "The maximum distance between an image and its polygon, in units of the coordinates "
                       "(default: 1e-5).");
  parser
      .add("--box", request.box,
           "Two corners of the box in which the tolerance holds, X0 < X1 and Y0 < Y1; outside it images are followed "
           "coarsely (default: the box of the curve and of the system's window, three times as wide and high).")
      .comma_separated()
      .count(4)
      .value("X0,Y0,X1,Y1");
  add_max_points_option(parser, request.options.max_points,
                        "The maximum number of points of an image, at which it ends (default: 100000000).");
  add_integration_option(parser, request.integration);
  parser
      .add("-o,--output", request.output,
           "Write the images to FILE: one file of Tecplot zones (.dat), or, with {n} in the name, which becomes the "
           "number of the iterate, a file for each (.npy, .csv, .txt, .dat or .raw). An image with gaps is written "
           "in parts, each an open curve (default: no file).")
      .value("FILE");
  const Option picture =
      parser.add("--svg", request.svg, "Draw all images as an SVG picture in FILE (default: no file).").value("FILE");
  add_window_option(parser, request.window, picture);
  add_json_option(parser, request.json);
  add_threads_option(parser, request.threads);
}

int iterate_of(const std::string& text) {
  const std::optional<double> number = number_of(text);
  if (!number || *number != std::floor(*number) || std::fabs(*number) > 1000) {
    throw UsageError("--iterates: \"" + text +
                     "\" is not a whole number from -1000 to 1000; give N or FIRST:LAST, as -4:3");
  }
  return static_cast<int>(*number);
}

// Checks that the parser cannot make.
void check(ImageRequest& request) {
  if (request.curve.empty() && request.circle.empty() && request.rectangle.empty() && !request.boundary) {
    throw UsageError(
        "the curve is missing; name a file, or give --circle, --rectangle or --boundary (see lober image --help)");
  }
  const std::size_t colon = request.iterates.find(':');
  request.first = iterate_of(request.iterates.substr(0, colon));
  request.last = colon == std::string::npos ? request.first : iterate_of(request.iterates.substr(colon + 1));
  if (request.first > request.last) throw UsageError("--iterates FIRST:LAST: FIRST has to come before LAST, as -4:3");
  if (!request.circle.empty() && !(request.circle[2] > 0)) throw UsageError("--circle X,Y,R: R has to be above 0");
  for (const auto& [option, box] : {std::pair{"--rectangle", &request.rectangle}, {"--box", &request.box}}) {
    if (box->empty() || ((*box)[0] < (*box)[2] && (*box)[1] < (*box)[3])) continue;
    throw UsageError(std::string(option) + ": the corners have to have X0 < X1 and Y0 < Y1");
  }
  if (request.output.empty()) return;
  if (request.output != "-") (void)format_of(request.output);
  if (!takes_images(request.output)) {
    throw UsageError("-o " + request.output +
                     ": several curves need a Tecplot file (.dat), or a name with {n}, which becomes the iterate");
  }
}

std::vector<Output> outputs_of(const ImageRequest& request) {
  std::vector<Output> outputs;
  if (!request.output.empty()) {
    for (int n = request.first; n <= request.last; ++n) {
      const std::string path = image_path(request.output, n);
      if (outputs.empty() || path != outputs.back().path) outputs.push_back({"-o", path});
      if (!request.boundary || path == request.output) continue;
      outputs.push_back({"-o", image_path(request.output, n, 1)});  // on a cylinder
    }
  }
  if (!request.json.empty()) outputs.push_back({"--json", request.json});
  if (!request.svg.empty()) outputs.push_back({"--svg", request.svg});
  return outputs;
}

// The curve as points, or as a function with the parameters of its corners.
struct Given {
  std::vector<Point> points;
  CurveFunction function;
  std::vector<double> corners;
  std::vector<Point> second{};  // the other boundary of a strip
};

Given circle(const ImageRequest& request, ImageReport& report) {
  const Point centre{request.circle[0], request.circle[1]};
  const double radius = request.circle[2];
  report.curve = fmt::format("circle of radius {:.10g} about ({:.10g}, {:.10g})", radius, centre.x, centre.y);
  Given given;
  given.function = [centre, radius](std::span<const double> parameters, std::span<Point> points) {
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const double turn = parameters[k] == 1 ? 0 : parameters[k], angle = 2 * std::numbers::pi * turn;
      points[k] = {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
    }
  };
  given.corners = {0, 1};
  given.points = {{centre.x - radius, centre.y - radius}, {centre.x + radius, centre.y + radius}};
  return given;
}

// On a cylinder the region lies between two boundaries, each from a saddle to its copy.
Given boundary(const System& system, ImageReport& report, Progress& progress) {
  if (!system.connection) {
    throw UsageError("system " + system.info.name + " names no tangle whose boundary could be taken; give a curve");
  }
  ManifoldTangleOptions options;
  options.tolerance = report.options.tolerance;
  options.progress = [&](const std::string& line) { return progress.step(line); };
  report.closed = !system.further_needed;
  std::vector<Connection> connections{*system.connection};
  if (system.further_needed) connections.insert(connections.end(), system.further.begin(), system.further.end());
  Given given;
  for (const Connection& connection : connections) {
    const auto tangle = grow_tangle(*system.map, connection, options);
    const Point bip = tangle->tangle.pips[tangle->bip].at;
    report.curve +=
        fmt::format("{}boundary with the bip ({:.10g}, {:.10g})", report.curve.empty() ? "" : " and ", bip.x, bip.y);
    (given.points.empty() ? given.points : given.second) = boundary_curve(*tangle);
  }
  return given;
}

Given curve_of(const ImageRequest& request, ImageReport& report, Progress& progress) {
  if (!request.circle.empty()) return circle(request, report);
  if (!request.rectangle.empty()) {
    const std::vector<double>& r = request.rectangle;
    report.curve = fmt::format("rectangle [{:.10g}, {:.10g}] x [{:.10g}, {:.10g}]", r[0], r[2], r[1], r[3]);
    return {{{r[0], r[1]}, {r[2], r[1]}, {r[2], r[3]}, {r[0], r[3]}}, {}, {}};
  }
  if (request.boundary) return boundary(report.system, report, progress);
  report.closed = !request.open;
  report.input = read_curve(request.curve, report.closed);
  report.curve = spec_of(*report.input);
  return {report.input->curve.points, {}, {}};
}

double length_of(const ImagePart& part) {
  double length = 0;
  for (std::size_t k = 0; k + 1 < part.points.size(); ++k) {
    length += std::hypot(part.points[k + 1].x - part.points[k].x, part.points[k + 1].y - part.points[k].y);
  }
  if (part.closed) {
    length += std::hypot(part.points.front().x - part.points.back().x, part.points.front().y - part.points.back().y);
  }
  return length;
}

void measure_images(ImageReport& report) {
  for (const CurveImage& image : report.images) {
    report.parts.push_back(parts_of(image));
    double length = 0;
    for (const ImagePart& part : report.parts.back()) length += length_of(part);
    report.lengths.push_back(length);
    const std::vector<ImagePart>& parts = report.parts.back();
    const bool whole = parts.size() == 1 && parts[0].closed && image.diagnostics.empty();
    report.areas.push_back(whole ? std::optional(signed_area(CurveView{parts[0].points, true})) : std::nullopt);
  }
}

// A map that preserves area keeps that of the curve, as far as both polygons meet their tolerance.
void compare_image_areas(ImageReport& report) {
  Point image =
      report.images.empty() || report.images.front().points.empty() ? Point{} : report.images.front().points[0];
  const Point from = image;
  report.system.map->iterate({&image, 1}, 1);
  report.preserves_area = report.system.map->action(from, image).has_value();
  if (!report.preserves_area || !report.closed) return;
  std::optional<std::size_t> base;
  for (std::size_t k = 0; k < report.images.size(); ++k) {
    if (!report.areas[k]) continue;
    if (!base) {
      base = k;
      continue;
    }
    report.agreement.compare({"area enclosed by the curve", image_name(report.images[*base].iterate),
                              image_name(report.images[k].iterate), *report.areas[*base], *report.areas[k],
                              report.area_error(*base) + report.area_error(k)});
  }
}

void compute(const ImageRequest& request, ImageReport& report, Progress& progress) {
  progress.phase("curve", 0, 0.2);
  const detail::Stopwatch curve_watch;
  const Given given = curve_of(request, report, progress);
  report.curve_seconds = curve_watch.seconds();
  ImageOptions& options = report.options;
  if (!request.box.empty()) {
    options.box = Rectangle::of({request.box[0], request.box[1]}, {request.box[2], request.box[3]});
  } else {
    options.box = report.system.window;
    for (const Point& point : given.points) options.box.add(point);
    for (const Point& point : given.second) options.box.add(point);
    options.box = widened(options.box, 1);
  }
  progress.phase("images", 0.2, 0.9);
  const detail::Stopwatch image_watch;
  options.progress = [&](const GrowthProgress& at) {
    progress.count(static_cast<double>(at.images), "images of points");
    return progress.advance(0);
  };
  report.images =
      given.function
          ? images_of(*report.system.map, request.first, request.last, given.function, given.corners, options)
          : images_of(*report.system.map, request.first, request.last, CurveView{given.points, report.closed}, options);
  if (!given.second.empty()) {
    auto others =
        images_of(*report.system.map, request.first, request.last, CurveView{given.second, report.closed}, options);
    for (CurveImage& image : others) report.images.push_back(std::move(image));
  }
  options.progress = {};
  report.image_seconds = image_watch.seconds();
  measure_images(report);
  compare_image_areas(report);
}

void run(const ImageRequest& request) {
  const detail::Stopwatch watch;
  const std::vector<Output> outputs = outputs_of(request);
  std::vector<std::string> inputs = files_of_system(request.system);
  if (!request.curve.empty()) inputs.push_back(request.curve);
  check_outputs(outputs, inputs);
  ImageReport report;
  report.system =
      system_of({request.system, request.parameters, request.integration}, parameter_values(request.parameters));
  report.integration = request.integration;
  report.first = request.first;
  report.last = request.last;
  report.options = request.options;
  {
    Progress progress;
    compute(request, report, progress);
    progress.phase("writing", 0.9, 1);
    const detail::Stopwatch write_watch;
    if (!request.output.empty()) write_images(request.output, report);
    if (!request.svg.empty()) write_image_picture(request.svg, report, window_of(request.window));
    report.write_seconds = write_watch.seconds();
    if (!request.json.empty()) write_image_json(request.json, report, [&] { return watch.seconds(); });
  }
  if (!takes_standard_output(outputs)) print(image_table(report));
  require_agreement(report.agreement);
}

}  // namespace

void run_image(const std::vector<std::string>& arguments) {
  ImageRequest request;
  OptionParser parser(
      "Computes images and pre-images of a curve under a map, or a flow's Poincare map, to a tolerance.",
      "lober image");
  add_options(parser, request);
  if (!parser.parse(arguments)) return;
  check(request);
  run_with_threads(request.threads, [&] { run(request); });
}

}  // namespace lober::cli
