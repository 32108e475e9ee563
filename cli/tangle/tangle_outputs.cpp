#include "cli/tangle/tangle_outputs.hpp"

#include "cli/report/table.hpp"
#include "cli/view/page_output.hpp"
#include "engine/base/stopwatch.hpp"

namespace lober::cli {

void TangleOutputs::add_options(OptionParser& parser) {
  parser
      .add("--lobes", lobes, "Write the outlines of the lobes to FILE, in the format of its ending (default: no file).")
      .value("FILE");
  parser.add("--boundary", boundary, "Write the boundary to FILE as an open polyline (default: no file).")
      .value("FILE");
  parser.add("--pips", pips, "Write the pips to FILE as the points of a curve (default: no file).").value("FILE");
  parser
      .add("--graph", graph,
           "Write every crossing with its order along both manifolds to FILE as JSON, for topological tools (default: "
           "no file).")
      .value("FILE");
  add_json_option(parser, json);
  add_picture_options(parser, picture, "the manifolds, pips, lobes and boundary",
                      "fixed points, regions, pips and lobes");
  add_html_option(parser, html);
  add_format_option(parser, format);
  add_table_option(parser);
}

std::vector<Output> TangleOutputs::files() const {
  if (!format.empty() && lobes.empty() && boundary.empty() && pips.empty()) {
    throw UsageError("--format needs --lobes, --boundary or --pips: it is the format of these");
  }
  std::vector<Output> outputs = picture.outputs();
  for (const auto& [option, path] : {std::pair{"--json", json},
                                     {"--graph", graph},
                                     {"--lobes", lobes},
                                     {"--boundary", boundary},
                                     {"--pips", pips},
                                     {"--html", html}}) {
    if (!path.empty()) outputs.push_back({option, path, format});
  }
  return outputs;
}

void write_tangle(const TangleOutputs& outputs, TangleReport& report, const std::function<double()>& seconds_so_far) {
  const detail::Stopwatch watch;
  if (!outputs.lobes.empty()) write_tangle_lobes(outputs.lobes, report, outputs.format);
  if (!outputs.boundary.empty()) write_tangle_boundary(outputs.boundary, report, outputs.format);
  if (!outputs.pips.empty()) write_tangle_pips(outputs.pips, report, outputs.format);
  if (!outputs.graph.empty()) write_tangle_graph(outputs.graph, report);
  if (outputs.picture.asked()) write_figure(outputs.picture, tangle_figure(report, outputs.picture));
  if (!outputs.html.empty()) write_page(outputs.html, report);
  report.write_seconds = watch.seconds();
  if (!outputs.json.empty()) write_tangle_json(outputs.json, report, seconds_so_far);
}

void print_tangle(const TangleOutputs& outputs, const TangleReport& report) {
  if (!takes_standard_output(outputs.files())) print_report(tangle_table(report));
}

}  // namespace lober::cli
