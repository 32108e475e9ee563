// Transport across the boundary of two manifolds that are given as curves, as far as they reach.
#include <cmath>

#include "engine/operations/curve_of.hpp"
#include "engine/operations/curves_tangle.hpp"
#include "engine/operations/option_list.hpp"
#include "engine/operations/outcome_of.hpp"
#include "engine/operations/schema.hpp"
#include "engine/operations/table.hpp"
#include "engine/operations/transport_fields.hpp"
#include "lober/transport/transport.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

struct CurvesTransportHow : CurvesHow {
  std::optional<std::int64_t> rows{};
};

const OptionList<CurvesTransportHow>& curve_transport_options() {
  static const OptionList<CurvesTransportHow> options = [] {
    using How = CurvesTransportHow;
    OptionList<How> list;
    list.option(
        "iterates", &How::rows,
        "number of iterates n up to which the table goes, or as far as the curves reach; n takes n images of the "
        "bip on them",
        {.min = 1, .max = 1000, .otherwise = "as far as the curves reach", .value = "N"});
    add_curves_options(list);
    add_index_option(list).option("check_simple", &How::check_simple,
                                  "whether to refuse manifolds that cross or touch themselves");
    return list;
  }();
  return options;
}

std::vector<Field> curve_transport_fields() {
  using Found = CurveTransport;
  Schema<Found> turnstile, stop;
  turnstile.field("flux12", "area", "area that leaves the region inside in one step", &Found::flux12)
      .field("flux21", "area", "area that enters the region inside in one step", &Found::flux21)
      .field("lobe_area12", "area", "sum of the lobes that leave, each counted fully", &Found::lobe_area12)
      .field("lobe_area21", "area", "sum of the lobes that enter, each counted fully", &Found::lobe_area21);
  stop.field("reason", "", "curves: they reach no farther", [](const Found&) { return "curves"; })
      .field("why", "", "the reason in words", &Found::why);
  Schema<Found> error = step_errors<Found>();
  error.field("area_conservation", "area", "|flux12 - flux21| of the turnstile, by geometry",
              [](const Found& f) { return std::fabs(f.flux12.value - f.flux21.value); });
  const auto whole = [](const Found& f) { return &f; };
  Schema<Found> made;
  made.field("period", "", "number of pips from one to its image", &Found::period)
      .list("regions", "R1, R2", regions_schema(), &Found::regions)
      .field("enclosed", "area", "area that the boundary encloses; where it crosses itself, of what it winds round",
             &Found::enclosed)
      .object("turnstile", "lobes and fluxes", turnstile, whole)
      .list("steps", "n = 1, 2, ...", step_schema(), &Found::steps)
      .object("stop", "why there are fewer rows than were asked for", stop,
              [](const Found& f) { return f.limit.empty() ? nullptr : &f; })
      .field("remarks", "", "remarks on the result", &Found::remarks)
      .object("error", "error bars of T21(n) and the checks that support them", error, whole);
  return made.fields();
}

Outcome run_curve_transport(std::span<const Input> inputs, const Options& options, const Context& context) {
  const Operation& operation = named("curve_transport");
  CurvesTransportHow how = curve_transport_options().how(options);
  how.smooth = true;
  const Tangle tangle = tangle_of_curves(operation, inputs, how, context);
  constexpr int all = 1000;
  CurveTransport found{transport(tangle, static_cast<int>(how.rows.value_or(all)))};
  found.period = tangle.images.period;
  if (!found.limit.empty()) {
    const std::string of = how.rows ? " of " + std::to_string(*how.rows) : "";
    found.why =
        (found.steps.empty() ? "no n" : "n = 1 to " + std::to_string(found.steps.size())) + of + ": " + found.limit;
  }
  return outcome_of(std::move(found), options);
}

}  // namespace

Operation curve_transport_operation() {
  Operation operation;
  operation.name = "curve_transport";
  operation.revision = 5;  // sums of hidden areas in another order
  operation.title = "transport across the boundary of two manifolds that are given as curves";
  operation.summary =
      "Computes the transport across the boundary of two manifolds that are given as curves: the fluxes a(n) and T(n) "
      "by "
      "lobes and by boundaries, for as many n as there are images of the bip on the curves. No map is needed.";
  operation.inputs = manifold_inputs();
  operation.options = curve_transport_options().specs();
  operation.result = curve_transport_fields();
  operation.examples = {
      {{"examples/manifolds.dat#0", "examples/manifolds.dat#1"}, {{"iterates", std::int64_t{4}}}, "four iterates"},
      {{"examples/manifolds.dat#0", "examples/manifolds.dat#1"}, {}, "as many iterates as the curves reach"}};
  operation.run = run_curve_transport;
  return operation;
}

}  // namespace lober::detail::table
