#include "cli/published_form.hpp"

#include <algorithm>
#include <charconv>

#include "cli/command_line.hpp"
#include "cli/densified_curve.hpp"
#include "cli/progress.hpp"
#include "cli/text.hpp"
#include "engine/overlay/overlay.hpp"

namespace lober::cli {
namespace {

struct Request {
  std::array<std::string, 2> curves;
  std::string result;
  Densification densification;
};

int count_after_dens(const std::string& text) {
  constexpr int most = 1'000'000;
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || value < 0 || value > most) {
    throw UsageError("-DENS takes two whole numbers from 0 to 1000000, not " + text);
  }
  return value;
}

Request parse(const std::vector<std::string>& arguments) {
  Request request;
  std::vector<std::string> files;
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    if (arguments[k] == "-light") throw UsageError("the interior method (-light) is not in this version");
    if (arguments[k] == "-BIP") throw UsageError("tangles of open manifolds (-BIP) are not in this version");
    if (arguments[k] == "-DENS") {
      if (k + 2 >= arguments.size()) throw UsageError("-DENS takes two whole numbers, <nPass> <nDens>");
      request.densification = {count_after_dens(arguments[k + 1]), count_after_dens(arguments[k + 2])};
      k += 2;
    } else if (arguments[k].starts_with("-") && arguments[k] != "-") {
      throw UsageError("unknown option " + arguments[k] + " (see lober --help)");
    } else {
      files.push_back(arguments[k]);
    }
  }
  constexpr std::size_t tangle_arguments = 8;
  if (files.size() >= tangle_arguments) throw UsageError("tangles of open manifolds are not in this version");
  if (files.size() < 3) {
    throw UsageError("\"" + files[0] +
                     "\" is no command, and lober <c1> <c2> <rslt> takes three files (see lober --help)");
  }
  if (files.size() > 3) throw UsageError("too many arguments: " + files[3] + " (see lober --help)");
  request.curves = {files[0], files[1]};
  request.result = files[2];
  return request;
}

std::string result_line(const Overlay& result) {
  const auto percent = [](double error, double area) { return area == 0 ? 0 : 100 * error / area; };
  std::string line;
  append_all(line, result.areas.c1_minus_c2, "\t", percent(result.rounding.c1_minus_c2, result.areas.c1_minus_c2), "\t",
             result.areas.c2_minus_c1, "\t", percent(result.rounding.c2_minus_c1, result.areas.c2_minus_c1), "\n");
  return line;
}

void write_points(const std::string& path, const std::vector<LabelledPoint>& points, Side side) {
  Zone zone;
  for (const LabelledPoint& point : points) {
    if (point.side == side) zone.points.push_back(point.point);
  }
  write_tecplot(path, {&zone, 1});
}

// The published names: which curve, then where its points lie.
struct PointFile {
  const char* path;
  int curve;
  Side side;
};
constexpr std::array<PointFile, 6> point_files{{
    {"c12.dat", 1, Side::outside},
    {"c21.dat", 2, Side::outside},
    {"c11.dat", 1, Side::inside},
    {"c22.dat", 2, Side::inside},
    {"c10.dat", 1, Side::on},
    {"c20.dat", 2, Side::on},
}};

}  // namespace

void run_published_form(const std::vector<std::string>& arguments) {
  const Request request = parse(arguments);
  std::vector<Output> outputs{{"<rslt>", request.result}};
  for (const PointFile& file : point_files) outputs.push_back({"this command", file.path});
  check_outputs(outputs, request.curves);

  Progress progress;
  progress.phase("reading", 0, 0.3);
  const std::array<NamedCurve, 2> inputs{read_curve(request.curves[0], true, {.hash = false}),
                                         read_curve(request.curves[1], true, {.hash = false})};
  progress.phase("overlay", 0.3, 0.8);
  OverlayOptions options;
  options.pieces = false;
  options.progress = [&](double fraction) { return progress.advance(fraction); };
  Overlay result;
  try {
    result = overlay(inputs[0].curve, inputs[1].curve, options);
  } catch (const NotSimpleError& error) {
    throw DataError(request.curves[static_cast<std::size_t>(error.curve - 1)] + ": " + error.what());
  }
  progress.phase("writing", 0.8, 1);
  const std::array<std::vector<LabelledPoint>, 2> points{densified_curve(result.nodes, 1, request.densification),
                                                         densified_curve(result.nodes, 2, request.densification)};
  for (const PointFile& file : point_files) {
    write_points(file.path, points[static_cast<std::size_t>(file.curve - 1)], file.side);
  }
  write_file(request.result, result_line(result));
}

}  // namespace lober::cli
