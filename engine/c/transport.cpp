// Tangles of systems and transport, for C.
#include "lober/transport.hpp"

#include "engine/base/text.hpp"
#include "engine/c/call.hpp"
#include "engine/c/model.hpp"
#include "engine/c/tangle.hpp"
#include "lober/error.hpp"
#include "lober/manifold_tangle.hpp"

namespace lober::detail::c {
namespace {

using Work = std::function<void(lober_result&)>;

std::function<bool(const std::string&)> text_progress() {
  const std::function<bool(double)> function = progress();
  if (!function) return {};
  return [function](const std::string&) { return function(-1); };
}

std::string lines_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

// Adds them to the result, and throws, where routes disagree.
void require_agreement(lober_result& result, const Agreement& agreement) {
  if (agreement.agrees()) return;
  std::vector<std::string> lines;
  for (const Comparison& one : agreement.disagreements()) {
    lines.push_back(one.what + ": " + detail::format_number(one.first) + " by " + one.first_by + ", " +
                    detail::format_number(one.second) + " by " + one.second_by + ", which differ by more than " +
                    detail::format_rounded(one.bar));
  }
  result.add("disagreements", lines_of(lines));
  throw WithResult{LOBER_DISAGREEMENT, lines_of(lines)};
}

Work tangle_work(const lober_model* model, Options& given) {
  const PlanarMap& map = map_of(model);
  const Connection& connection = connection_of(model);
  ManifoldTangleOptions options;
  options.tolerance = given.number("tolerance", options.tolerance);
  options.before = static_cast<int>(given.integer("before", options.before, 1));
  options.after = static_cast<int>(given.integer("after", options.after));
  options.smooth = given.flag("smooth", options.smooth);
  options.max_points = given.count("max_points", options.max_points);
  options.bip_near = given.point("bip_near");
  options.progress = text_progress();
  return [=, &map, &connection](lober_result& result) {
    const std::shared_ptr<const ManifoldTangle> grown = grow_tangle(map, connection, options);
    add_tangle(result, {grown, &grown->tangle}, options.smooth);
    result.add_points("u", grown->u.points, grown);
    result.add_points("s", grown->s.points, grown);
    result.add("areas_by_action", grown->areas_by_action);
    result.add("action_errors", grown->action_errors);
    const Point from = grown->local_u.saddle, to = grown->local_s.saddle;
    result.add("saddles", lober_result::Doubles{from.x, from.y, to.x, to.y}, 2);
    result.add("multipliers", lober_result::Doubles{grown->local_u.multiplier, grown->local_s.multiplier});
    require_agreement(result, agreement_of(*grown));
  };
}

// Each entry followed by its error, a row for each step.
lober_result::Doubles rows_of(const std::vector<TransportStep>& steps, std::size_t regions,
                              RegionMatrix TransportStep::*member) {
  lober_result::Doubles rows;
  for (const TransportStep& step : steps) {
    for (std::size_t i = 0; i < regions; ++i) {
      for (std::size_t j = 0; j < regions; ++j) {
        const Measured entry = (step.*member)(i, j);
        rows.insert(rows.end(), {entry.value, entry.error});
      }
    }
  }
  return rows;
}

Work transport_work(const lober_model* model, Options& given) {
  (void)map_of(model);  // throws for a null pointer, before the work
  const System& system = model->system;
  TransportOptions options;
  options.iterates = static_cast<int>(given.integer("iterates", options.iterates, 1));
  options.tolerance = given.number("tolerance", options.tolerance);
  options.max_points = given.count("max_points", options.max_points);
  options.bip_near = given.point("bip_near");
  options.particles = given.count("particles", options.particles);
  options.seed = given.count("seed", options.seed);
  options.progress = text_progress();
  return [=, &system](lober_result& result) {
    const Transport found = transport(system, options);
    const std::size_t regions = found.regions.size();
    lober_result::Doubles areas;
    for (const Region& region : found.regions) areas.insert(areas.end(), {region.area.value, region.area.error});
    const TransportBoundary& first = found.boundaries.front();
    result.add("region_areas", std::move(areas), 2);
    result.add("flux12", lober_result::Doubles{first.flux12.value, first.flux12.error}, 2);
    result.add("flux21", lober_result::Doubles{first.flux21.value, first.flux21.error}, 2);
    result.add("flux", rows_of(found.steps, regions, &TransportStep::flux), 2 * regions * regions);
    result.add("total", rows_of(found.steps, regions, &TransportStep::total), 2 * regions * regions);
    result.add("iterates_a_step", lober_result::Integers{found.iterates_a_step});
    result.add("remarks", lines_of(found.remarks));
    require_agreement(result, found.agreement);
  };
}

}  // namespace
}  // namespace lober::detail::c

int lober_model_tangle(const lober_model* model, const char* options, lober_result** result) {
  using namespace lober::detail::c;
  return operation(options, result, [=](Options& given) { return tangle_work(model, given); });
}

int lober_transport(const lober_model* model, const char* options, lober_result** result) {
  using namespace lober::detail::c;
  return operation(options, result, [=](Options& given) { return transport_work(model, given); });
}
