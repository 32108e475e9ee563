#include "cli/published/published_form.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>

#include "cli/program/command_line.hpp"
#include "cli/program/log.hpp"
#include "cli/program/progress.hpp"
#include "cli/report/report.hpp"
#include "cli/report/text.hpp"
#include "engine/files/number.hpp"
#include "lober/curve/files.hpp"
#include "lober/operations.hpp"
#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"

namespace lober::cli {
namespace {

struct PublishedFormRequest {
  std::array<std::string, 2> curves;
  std::string result;
  bool light = false;                              // the interior method
  std::optional<EndsDensification> densification;  // -DENS
};

std::optional<int> whole_number(const std::string& text) {
  constexpr int most = 1'000'000;
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || value < 0 || value > most) return std::nullopt;
  return value;
}

// The values after -DENS: two whole numbers, or a single 0, as Naik, Lekien & Ross (2017) also write it. Moves `k` to
// the last one.
EndsDensification after_dens(const std::vector<std::string>& arguments, std::size_t& k) {
  const auto number = [&](std::size_t index) {
    return index < arguments.size() ? whole_number(arguments[index]) : std::nullopt;
  };
  const std::optional<int> passes = number(k + 1), points = number(k + 2);
  if (passes && points) {
    k += 2;
    return {*passes, *points};
  }
  if (passes == 0) {
    k += 1;
    return {};
  }
  throw UsageError("-DENS takes two whole numbers from 0 to 1000000, <nPass> <nDens>");
}

PublishedFormRequest parse_published_form(const std::vector<std::string>& arguments) {
  PublishedFormRequest request;
  std::vector<std::string> files;
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    if (arguments[k] == "-light") {
      request.light = true;
    } else if (arguments[k] == "-DENS") {
      request.densification = after_dens(arguments, k);
    } else if (arguments[k].starts_with("-") && arguments[k] != "-") {
      throw UsageError("unknown option " + arguments[k] + " (see lober --help)");
    } else {
      files.push_back(arguments[k]);
    }
  }
  if (files.size() < 3) {
    const std::string form = request.light ? "lober -light <c1> <c2> <rslt>" : "lober <c1> <c2> <rslt>";
    const std::string other = request.light || files.empty() ? "" : "\"" + files[0] + "\" is not a command, and ";
    throw UsageError(other + form + " takes three files (see lober --help)");
  }
  if (files.size() > 3) throw UsageError("too many arguments: " + files[3] + " (see lober --help)");
  request.curves = {files[0], files[1]};
  request.result = files[2];
  return request;
}

// The results of all methods, and the points of both curves with their labels.
struct PublishedResult {
  Areas areas;
  Areas error;
  std::array<std::vector<LabelledPoint>, 2> points;
};

std::array<std::vector<LabelledPoint>, 2> points_of(const Crossings& nodes, const EndsDensification& densification) {
  return {labelled_points(nodes, 1, densification), labelled_points(nodes, 2, densification)};
}

std::string result_line(const PublishedResult& result) {
  const auto percent = [](double error, double area) { return area == 0 ? 0 : 100 * error / area; };
  std::string line;
  append_all(line, result.areas.c1_minus_c2, "\t", percent(result.error.c1_minus_c2, result.areas.c1_minus_c2), "\t",
             result.areas.c2_minus_c1, "\t", percent(result.error.c2_minus_c1, result.areas.c2_minus_c1), "\n");
  return line;
}

// -DENS adds to the points only.
PublishedResult by_overlay(const IndexedCurve& c1, const IndexedCurve& c2,
                           const std::optional<EndsDensification>& densification,
                           const std::function<bool(double)>& progress) {
  OverlayOptions options;
  options.pieces = false;
  options.progress = progress;
  const Overlay found = overlay(c1, c2, options);
  return {found.areas, found.rounding, points_of(found.nodes, densification.value_or(EndsDensification{}))};
}

// Segments are split where the curves meet unless -DENS asks for the rule of the article instead.
PublishedResult by_interior(const IndexedCurve& c1, const IndexedCurve& c2,
                            const std::optional<EndsDensification>& densification,
                            const std::function<bool(double)>& progress) {
  const operations::Operation& operation = operations::named("interior");
  std::vector<operations::OptionSetting> settings;
  if (densification) {
    settings = {{"method", "ends"},
                {"passes", std::int64_t{densification->passes}},
                {"points", std::int64_t{densification->points}}};
  }
  const std::array<operations::Input, 2> curves{operations::CurveInput{c1.view(), {}, &c1},
                                                operations::CurveInput{c2.view(), {}, &c2}};
  operations::Context context;
  context.progress = [&](double fraction, const std::string&) { return progress(fraction); };
  const operations::Outcome outcome = operation.run(curves, {operation.options, settings}, context);
  const auto& found = outcome.as<operations::CurveInterior>();
  PublishedResult result{found.areas, found.rounding,
                         points_of(found.nodes, densification.value_or(EndsDensification{}))};
  if (found.splitting) {
    for (const NamedArea& area : named_areas) result.error.*area.member += (*found.splitting).*area.member;
  }
  return result;
}

// As labelled_points, of a curve that may cross itself.
std::vector<LabelledPoint> labelled_loop(const IndexedCurve& curve, const IndexedCurve& other) {
  const std::span<const Point> vertices = curve.view().points;
  const Buffer<Side> labels = label_points(other, vertices);
  const std::vector<CommonPoint> common = common_points(curve, other);
  std::vector<LabelledPoint> points;
  points.reserve(vertices.size() + common.size());
  std::size_t next = 0;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    points.push_back({vertices[k], labels[k]});
    for (; next < common.size() && common[next].first.segment == k; ++next) {
      if (!common[next].vertex1) points.push_back({common[next].at, Side::on});
    }
  }
  return points;
}

// The result for curves that cross themselves, which Lober 1.8 takes: by the nonzero rule, as points are labelled.
PublishedResult by_rule(const std::array<NamedCurve, 2>& inputs, const std::function<bool(double)>& progress) {
  RegionOptions options;
  options.progress = progress;
  const Regions found =
      regions(ClosedCurve::borrow(inputs[0].curve.points), ClosedCurve::borrow(inputs[1].curve.points), options);
  const IndexedCurve c1(inputs[0].curve), c2(inputs[1].curve);
  return {found.areas(FillRule::nonzero),
          found.rounding(FillRule::nonzero),
          {labelled_loop(c1, c2), labelled_loop(c2, c1)}};
}

void write_labelled_points(const std::string& path, const std::vector<LabelledPoint>& points, Side side) {
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
constexpr std::array<PointFile, 6> published_point_files{{
    {"c12.dat", 1, Side::outside},
    {"c21.dat", 2, Side::outside},
    {"c11.dat", 1, Side::inside},
    {"c22.dat", 2, Side::inside},
    {"c10.dat", 1, Side::on},
    {"c20.dat", 2, Side::on},
}};

// The result is named by its place only, so a slip names another file: `lober A.npy B.npy C.npy`. No more is replaced
// than what this form wrote before: one line of four numbers.
void require_earlier_result(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored) || std::filesystem::file_size(path, ignored) == 0) return;
  constexpr std::streamsize longest = 1024;
  std::string content(static_cast<std::size_t>(longest), '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(content.data(), longest);
  content.resize(static_cast<std::size_t>(file.gcount()));
  std::istringstream line(content);
  std::size_t numbers = 0;
  bool other =
      content.size() == static_cast<std::size_t>(longest) || std::count(content.begin(), content.end(), '\n') > 1;
  for (std::string word; line >> word; ++numbers) {
    double value = 0;
    other = other || detail::parse_number(word, value) == detail::NumberKind::not_a_number;
  }
  if (!other && numbers == 4) return;
  throw UsageError("<rslt> would overwrite " + path +
                   ", which is not an earlier result (a line of four numbers); remove it first, or name another file");
}

}  // namespace

void run_published_form(const std::vector<std::string>& arguments) {
  const PublishedFormRequest request = parse_published_form(arguments);
  std::vector<Output> outputs{{"<rslt>", request.result}};
  for (const PointFile& file : published_point_files) outputs.push_back({"this command", file.path});
  check_outputs(outputs, request.curves);
  require_earlier_result(request.result);

  Progress progress;
  progress.phase("reading", 0, 0.3);
  std::array<NamedCurve, 2> inputs;
  for (std::size_t k = 0; k < 2; ++k) {
    progress.file(k, 2);
    inputs[k] = read_curve(request.curves[k], true, {.hash = false});
  }
  require_same_columns(inputs[0].curve, inputs[1].curve);
  progress.of(static_cast<double>(inputs[0].curve.points.size() + inputs[1].curve.points.size()), "points");
  progress.phase(request.light ? "interior" : "overlay", 0.3, 0.8);
  const auto advance = [&](double fraction) { return progress.advance(fraction); };
  PublishedResult result;
  try {
    const IndexedCurve c1(inputs[0].curve), c2(inputs[1].curve);
    result = (request.light ? by_interior : by_overlay)(c1, c2, request.densification, advance);
  } catch (const NotSimpleError& error) {
    const std::string what = request.curves[static_cast<std::size_t>(error.curve - 1)] + ": " + error.what();
    if (!request.light) throw DataError(what + " (lober overlay --rule and lober -light take such curves)");
    if (request.densification) {
      throw DataError(what + " (lober -light without -DENS and lober interior --rule take such curves)");
    }
    log_warning("warning: " + what +
                "; points that a curve winds round are inside it, as by lober interior --rule nonzero");
    result = by_rule(inputs, advance);
  }
  progress.phase("writing", 0.8, 1);
  for (const PointFile& file : published_point_files) {
    write_labelled_points(file.path, result.points[static_cast<std::size_t>(file.curve - 1)], file.side);
  }
  write_file(request.result, result_line(result));
}

}  // namespace lober::cli
