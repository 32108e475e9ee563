#include "cli/view/page_output.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "cli/report/agreement_report.hpp"
#include "cli/report/curve_file.hpp"
#include "engine/base/text.hpp"
#include "viewer/page.hpp"
#include "viewer/scenes/scenes.hpp"

namespace lober::cli {
namespace {

// The lines of a text, first of all notes: what a reader has to know before the numbers.
void add_lines(viewer::Scene& scene, const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end > begin) lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  scene.notes.insert(scene.notes.begin(), lines.begin(), lines.end());
}

// Where the result comes from, as in the files of curves.
void add_origin(viewer::Scene& scene, std::string_view command, const operations::Outcome& outcome,
                const std::vector<std::string>& inputs, const std::string& system = {}) {
  for (const auto& [name, value] : notes_of(command, outcome, inputs, system))
    scene.notes.push_back(std::string(name).append(": ").append(value));
  for (const std::string& remark : outcome.remarks) scene.notes.push_back(remark);
  add_lines(scene, agreement_text(outcome.agreement));
}

// The tangle of the same curves, by the options that both operations have.
operations::Outcome tangle_of_transport(const operations::Outcome& transport,
                                        const std::vector<operations::Input>& inputs) {
  const operations::Operation& operation = operations::named("tangle");
  std::vector<operations::OptionSetting> settings{{"smooth", true}};
  for (const operations::OptionSetting& setting : transport.settings()) {
    if (std::any_of(operation.options.begin(), operation.options.end(),
                    [&](const operations::OptionSpec& spec) { return spec.is_for(setting.key); })) {
      settings.push_back(setting);
    }
  }
  return operation.run(inputs, operations::Options(operation.options, settings), {});
}

}  // namespace

Option add_html_option(OptionParser& parser, std::string& path) {
  return parser
      .add("--html", path,
           "Write a page to FILE that shows the result, as deep as doubles go, in any browser, without a network "
           "(default: no file).")
      .value("FILE");
}

void write_page(const std::string& path, const CurvesReport& report) {
  const bool by_rule = report.outcome.options.find("rule") != nullptr;
  viewer::Scene scene = by_rule ? viewer::regions_scene(report.outcome.as<operations::CurveRegions>(),
                                                        report.inputs[0].curve, report.inputs[1].curve)
                                : viewer::overlay_scene(report.outcome.as<operations::CurveOverlay>());
  add_origin(scene, "overlay", report.outcome, notes_on(report.inputs));
  viewer::write_page(path, scene);
}

bool has_page(const operations::Operation& operation) {
  return operation.name == "regions" || operation.name == "curve_transport";
}

void write_page(const std::string& path, const std::string& command, const operations::Operation& operation,
                const operations::Outcome& outcome, const std::vector<operations::Input>& inputs,
                const std::vector<std::string>& notes) {
  viewer::Scene scene;
  operations::Outcome tangle;  // which the scene refers to
  if (operation.name == "regions") {
    const auto curve = [&](std::size_t k) {
      return k < inputs.size() ? std::get<operations::CurveInput>(inputs[k]).curve : CurveView{};
    };
    scene = viewer::regions_scene(outcome.as<operations::CurveRegions>(), curve(0), curve(1));
  } else {
    tangle = tangle_of_transport(outcome, inputs);
    scene = viewer::transport_scene(tangle.as<operations::CurveTangle>(), outcome.as<operations::CurveTransport>());
  }
  add_origin(scene, command, outcome, notes);
  viewer::write_page(path, scene);
}

void write_page(const std::string& path, const TangleReport& report) {
  viewer::Scene scene = viewer::tangle_scene(report.result());
  const std::string system = report.origin ? system_text(*report.origin->system) : std::string();
  if (!system.empty()) scene.title = "Tangle of " + system;
  add_origin(scene, "tangle", report.outcome, report.origin ? std::vector<std::string>{} : notes_on(report.inputs),
             system);
  viewer::write_page(path, scene);
}

void write_page(const std::string& path, const TransportReport& report) {
  viewer::Scene scene = viewer::transport_scene(report.result());
  const std::string system = system_text(report.system);
  scene.title = "Transport of " + system;
  add_origin(scene, "transport", report.outcome, {}, system);
  viewer::write_page(path, scene);
}

void write_page(const std::string& path, const EscapeReport& report) {
  viewer::Scene scene = viewer::escape_scene(report.result());
  System chosen;
  chosen.info = report.system;
  scene.title = "Escape from " + system_text(chosen);
  add_origin(scene, "escape", report.outcome, {}, system_text(chosen));
  viewer::write_page(path, scene);
}

void write_page(const std::string& path, const System& system, const operations::Outcome& grown) {
  const auto& manifold = grown.as<operations::SystemManifold>();
  const std::string name = system_text(system);
  const viewer::Line line{"manifold of " + name, manifold};
  viewer::Scene scene = viewer::curves_scene(std::span(&line, 1));
  scene.notes.push_back("saddle: " + detail::format_point(manifold.local.saddle));
  add_origin(scene, "grow", grown, {}, name);
  viewer::write_page(path, scene);
}

}  // namespace lober::cli
