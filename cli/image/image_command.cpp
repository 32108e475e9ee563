// `lober image SYSTEM CURVE`: runs the operation and writes the images.

#include "cli/image/image_command.hpp"

#include <cmath>
#include <optional>

#include "cli/image/image_report.hpp"
#include "cli/picture/picture_options.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/log.hpp"
#include "cli/program/option_names.hpp"
#include "cli/program/output_names.hpp"
#include "cli/program/progress.hpp"
#include "cli/program/system_options.hpp"
#include "cli/program/table_options.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/report/table.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/base/threads.hpp"

namespace lober::cli {
namespace {

struct ImageRequest {
  SystemRequest system;
  std::string curve;
  PictureRequest picture;
  bool open = false;
  std::string iterates = "1", output, json, format;
  int first = 0, last = 0;  // numbers of iterates
  int threads = 0;
  std::vector<operations::OptionSetting> settings;
  bool boundary = false;
};

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
  const std::size_t colon = request.iterates.find(':');
  request.first = iterate_of(request.iterates.substr(0, colon));
  request.last = colon == std::string::npos ? request.first : iterate_of(request.iterates.substr(colon + 1));
  if (request.first > request.last) throw UsageError("--iterates FIRST:LAST: FIRST has to come before LAST, as -4:3");
  if (request.output.empty()) return;
  if (request.output != "-") (void)curve_format(request.output, request.format, false);
  const bool may_be_one = request.first == request.last && !request.boundary && request.output != "-";
  if (!may_be_one && !takes_images(request.output, request.format)) {
    throw UsageError("-o " + request.output +
                     ": several curves need a format that holds several, as .dat (Tecplot), .npz or .geojson, or a "
                     "name with {n}, which becomes the iterate");
  }
}

// Nothing when the arguments asked for help, which is printed.
std::optional<ImageRequest> parse_image(const std::vector<std::string>& arguments) {
  ImageRequest request;
  OptionParser parser(
      "Computes images and pre-images of a curve under a map, or a flow's Poincare map, to a tolerance.",
      "lober image");
  parser
      .add("SYSTEM", request.system.name,
           "The name of a built-in system, or the path of a shared library (lober_system.h).")
      .required();
  const Option curve = parser.add("CURVE", request.curve,
                                  "The curve: FILE, or FILE#ZONE for one zone of it (by number from 0, or by title). "
                                  "Or give --circle, --rectangle or --boundary.");
  parser.add_flag("--open", request.open, "Take the curve of the file as open (default: closed).").needs(curve);
  add_parameter_option(parser, request.system.parameters);
  parser
      .add("--iterates", request.iterates,
           "The images that are computed: N, or FIRST:LAST for all from FIRST to LAST; negative numbers are "
           "pre-images (default: 1). Range: -1000 to 1000.")
      .value("FIRST:LAST");
  const TableOptions options(parser, operations::named("image"), {"closed", "first", "last"});
  for (const char* const key : {"circle", "rectangle", "boundary"}) options[key].excludes(curve);
  options["circle"].excludes(options["rectangle"]).excludes(options["boundary"]);
  options["rectangle"].excludes(options["boundary"]);
  add_integration_option(parser, request.system.integration);
  const Option output = parser
                            .add("-o,--output", request.output,
                                 ("Write the images to FILE, whose ending is its format: " + written_endings() +
                                  ". Several go into one file, if its format holds several curves, or, with {n} in the "
                                  "name, which becomes the number of the iterate, into a file for each. An image with "
                                  "gaps is written in parts, each an open curve (default: no file).")
                                     .c_str())
                            .value("FILE");
  add_format_option(parser, request.format).needs(output);
  add_picture_options(parser, request.picture, "all images");
  add_json_option(parser, request.json);
  add_table_option(parser);
  add_threads_option(parser, request.threads);
  if (!parser.parse(arguments)) return std::nullopt;
  request.boundary = options["boundary"].given();
  check(request);
  request.settings = options.settings();
  request.settings.push_back({"closed", !request.open});
  request.settings.push_back({"first", std::int64_t{request.first}});
  request.settings.push_back({"last", std::int64_t{request.last}});
  return request;
}

std::vector<Output> outputs_of(const ImageRequest& request) {
  std::vector<Output> outputs = request.picture.outputs();
  if (!request.output.empty()) {
    for (int n = request.first; n <= request.last; ++n) {
      const std::string path = image_path(request.output, n);
      if (outputs.empty() || path != outputs.back().path) outputs.push_back({"-o", path});
      if (!request.boundary || path == request.output) continue;
      outputs.push_back({"-o", image_path(request.output, n, 1)});  // on a cylinder
    }
  }
  if (!request.json.empty()) outputs.push_back({"--json", request.json});
  return outputs;
}

void run(const ImageRequest& request) {
  const detail::Stopwatch watch;
  const std::vector<Output> outputs = outputs_of(request);
  std::vector<std::string> files = files_of_system(request.system.name);
  if (!request.curve.empty()) files.push_back(request.curve);
  check_outputs(outputs, files);
  const operations::Operation& operation = operations::named("image");
  const operations::Options options = checked_options(operation, request.settings);
  ImageReport report;
  report.system = system_input_of(request.system);
  std::vector<operations::Input> inputs{report.system};
  {
    Progress progress;
    if (!request.curve.empty()) {
      progress.phase("reading", 0, 0.1);
      progress.file(0, 1);
      report.input = read_curve(request.curve, !request.open);
      inputs.emplace_back(operations::CurveInput{report.input->curve, request.curve});
    }
    progress.phase("images", request.curve.empty() ? 0 : 0.1, 0.9);
    operations::Context context;
    context.progress = told_to(progress);
    context.count = [&](double amount, std::string_view unit) { progress.count(amount, unit); };
    report.outcome = operation.run(inputs, options, context);
    progress.phase("writing", 0.9, 1);
    const detail::Stopwatch write_watch;
    if (!request.output.empty()) write_images(request.output, request.format, report);
    if (request.picture.asked()) write_figure(request.picture, image_figure(report));
    report.write_seconds = write_watch.seconds();
    if (!request.json.empty()) write_image_json(request.json, report, [&] { return watch.seconds(); });
  }
  if (!takes_standard_output(outputs)) print_report(image_table(report));
  if (!report.outcome.incomplete.empty()) log_warning(with_option_names(report.outcome.incomplete));
  require_agreement(report.outcome.agreement);
}

}  // namespace

void run_image(const std::vector<std::string>& arguments) {
  const std::optional<ImageRequest> request = parse_image(arguments);
  if (request) run_with_threads(request->threads, [&] { run(*request); });
}

}  // namespace lober::cli
