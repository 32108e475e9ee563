// `sweep`: the turnstile of a system, value by value of a parameter. Its value is a SystemSweep.
#include "lober/transport/sweep.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "engine/base/even_values.hpp"
#include "engine/base/text.hpp"
#include "engine/operations/connection_choice.hpp"
#include "engine/operations/growth_options.hpp"
#include "engine/operations/melnikov.hpp"
#include "engine/operations/option_list.hpp"
#include "engine/operations/outcome_of.hpp"
#include "engine/operations/schema.hpp"
#include "engine/operations/system_of.hpp"
#include "engine/operations/table.hpp"
#include "lober/base/error.hpp"

namespace lober::detail::table {
namespace {

struct SweepHow {
  std::optional<std::string> range{};
  std::optional<double> tolerance_given{};
  std::size_t max_points = ManifoldTangleOptions{}.max_points;
  bool find_zeros = SweepOptions{}.find_zeros, melnikov = false;
};

const OptionList<SweepHow>& sweep_options() {
  static const OptionList<SweepHow> options = [] {
    OptionList<SweepHow> list;
    list.option("range", &SweepHow::range, "parameter and its values, NAME=FIRST:LAST:STEP",
                {.value = "NAME=FIRST:LAST:STEP"});
    add_growth_options(list)
        .option(
            "find_zeros", &SweepHow::find_zeros,
            "whether to refine the values of the parameter at which the difference in action of the two pips of the "
            "turnstile changes its sign")
        .option(
            "melnikov", &SweepHow::melnikov,
            "whether to compute the areas of lobes to first order in the parameter that is the size of the system's "
            "perturbation (eps), by Melnikov's function, for every value");
    return list;
  }();
  return options;
}

struct Range {
  std::string name;
  std::vector<double> values;
  bool reaches = true;  // false where the step is longer than the range, so that there is one value
};

// LAST is among the values if a whole number of steps leads there, to rounding.
Range range_of(const std::string& text) {
  const auto bad = [&](const char* why) -> UsageError {
    return UsageError("the range \"" + text + "\" is not of the form NAME=FIRST:LAST:STEP" + why);
  };
  const std::size_t equals = text.find('='), first = text.find(':'), second = text.find(':', first + 1);
  if (equals == std::string::npos || first == std::string::npos || second == std::string::npos || first < equals)
    throw bad("");
  std::array<double, 3> numbers{};
  const std::array<std::pair<std::size_t, std::size_t>, 3> parts{
      std::pair{equals + 1, first}, {first + 1, second}, {second + 1, text.size()}};
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const auto [begin, end] = parts[k];
    const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, numbers[k]);
    if (error != std::errc() || stop != text.data() + end || !std::isfinite(numbers[k])) throw bad("");
  }
  const auto [from, to, step] = numbers;
  if (step == 0 || (to - from) / step < 0) throw bad(" with a step that leads from the first value to the last");
  const auto values = even_values(from, to, step);
  if (!values) throw bad(" with at most 100000 values");
  return {text.substr(0, equals), *values, from == to || values->size() > 1};
}

// ---------------------------------------------------------------------------------------------------------- result

// A row, which has nothing but its value where it failed.
struct Row {
  const SweepRow* row;
  std::optional<double> first_order;
};

std::vector<Row> rows_of(const SystemSweep& sweep) {
  std::vector<Row> rows;
  for (std::size_t k = 0; k < sweep.rows.size(); ++k) {
    rows.push_back({&sweep.rows[k], sweep.first_order ? std::optional((*sweep.first_order)[k]) : std::nullopt});
  }
  return rows;
}

template <typename Part>
auto where_known(Part SweepRow::*part) {
  return [part](const Row& r) { return r.row->failure.empty() ? std::optional(r.row->*part) : std::nullopt; };
}

std::optional<std::string> where_said(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

Schema<Row> sweep_row_schema() {
  Schema<Row> made;
  made.field("value", "", "value of the parameter", [](const Row& r) { return r.row->value; })
      .field("failure", "", "why there is no result", [](const Row& r) { return where_said(r.row->failure); })
      .field("from", "length", "saddle of U", where_known(&SweepRow::from))
      .field("to", "length", "saddle of S", where_known(&SweepRow::to))
      .field("multiplier", "", "multiplier of U at its saddle", where_known(&SweepRow::multiplier))
      .field("period", "", "number of pips from one to its image", where_known(&SweepRow::period))
      .field("bip", "length", "boundary intersection point (q)", where_known(&SweepRow::bip))
      .field("areas", "area", "signed areas of the lobes of the turnstile by geometry", where_known(&SweepRow::areas))
      .field("errors", "area", "their error bars", where_known(&SweepRow::errors))
      .field("areas_by_action", "area",
             "signed areas of the lobes of the turnstile by action; empty where the map has none",
             where_known(&SweepRow::areas_by_action))
      .field("flux12", "area", "area that leaves in one iterate", where_known(&SweepRow::flux12))
      .field("flux21", "area", "area that enters in one iterate", where_known(&SweepRow::flux21))
      .field("lobe_area12", "area", "sum of the lobes that leave, each counted fully",
             where_known(&SweepRow::lobe_area12))
      .field("lobe_area21", "area", "sum of the lobes that enter, each counted fully",
             where_known(&SweepRow::lobe_area21))
      .field("lobe_area12_by_action", "area", "the same by action", where_known(&SweepRow::lobe_area12_by_action))
      .field("lobe_area21_by_action", "area", "the same by action", where_known(&SweepRow::lobe_area21_by_action))
      .field("remark", "", "why there is no flux", [](const Row& r) { return where_said(r.row->remark); })
      .field("difference", "area", "W(q) - W(q'), q' the pip half an iterate before q",
             where_known(&SweepRow::difference))
      .field("follows", "", "whether the pips are those of the row before, followed from there",
             where_known(&SweepRow::follows))
      .field("first_order", "area", "area of the lobes of one side to first order", &Row::first_order);
  return made;
}

Schema<SweepZero> sweep_zero_schema() {
  Schema<SweepZero> made;
  made.field("between", "", "the values between which the zero lies",
             [](const SweepZero& z) {
               return std::vector<double>{z.low, z.high};
             })
      .field("value", "", "value of the parameter", &SweepZero::value)
      .field("width", "", "width of the interval in which the zero is known to lie", &SweepZero::width)
      .field("difference", "area", "difference that is left there", &SweepZero::difference)
      .field("evaluations", "", "number of further values that it took", &SweepZero::evaluations)
      .field("failure", "", "why it could not be refined", [](const SweepZero& z) { return where_said(z.failure); });
  return made;
}

std::vector<Field> sweep_fields() {
  Schema<SystemSweep> made;
  made.field("parameter", "", "name of the parameter", &SystemSweep::parameter)
      .list("rows", "a value each", sweep_row_schema(), rows_of)
      .list("zeros", "zeros of the difference", sweep_zero_schema(),
            [](const SystemSweep& s) -> const std::vector<SweepZero>& { return s.zeros; })
      .field("no_zero", "", "why no zero was found, where zeros were looked for",
             [](const SystemSweep& s) { return where_said(s.no_zero); })
      .field("failures", "", "number of values without a result", [](const SystemSweep& s) { return s.failures(); })
      .field("remarks", "", "remarks on the result", &SystemSweep::remarks);
  return made.fields();
}

// ------------------------------------------------------------------------------------------------------------- run

bool is_known(const SweepRow& row) {
  return row.failure.empty() && !std::isnan(row.difference);
}

// The known differences next to the ends of the range.
std::string no_zero_text(const SystemSweep& found) {
  const std::vector<SweepRow>& rows = found.rows;
  const std::string quantity = "W(q) - W(q')";
  const auto at = [&](const SweepRow& row) {
    return found.parameter + " = " + format_rounded(row.value, 12) + ", where it is " +
           format_rounded(row.difference, 6);
  };
  const auto first = std::find_if(rows.begin(), rows.end(), is_known);
  if (first == rows.end()) {
    return "no zero of " + quantity + " was found: it is not known at any value (only maps with an action have it)";
  }
  const auto last = std::find_if(rows.rbegin(), rows.rend(), is_known);
  if (std::next(first) == last.base()) {
    return "no zero of " + quantity + " was looked for: it is known at one value only, " + at(*first) +
           "; give a range of more values";
  }
  if (first->difference * last->difference < 0) {
    return "no zero of " + quantity + " was found: it changes sign between " + at(*first) + ", and " + at(*last) +
           ", but where it does it is not known, or the pips cannot be followed; give a range of other values";
  }
  const bool gaps = !std::all_of(first, last.base(), is_known);
  return "no zero of " + quantity + " was found: it does not change sign between " + at(*first) + ", and " + at(*last) +
         (gaps ? ", as far as it is known in between" : "") + "; give another range, or a smaller step";
}

std::string failures_text(const SystemSweep& found) {
  const auto first =
      std::find_if(found.rows.begin(), found.rows.end(), [](const SweepRow& row) { return !row.failure.empty(); });
  if (first == found.rows.end()) return {};
  return std::to_string(found.failures()) + " of " + std::to_string(found.rows.size()) +
         " values failed, the first at " + found.parameter + " = " + format_rounded(first->value) + ": " +
         first->failure;
}

class Sweeper {
 public:
  Sweeper(const SystemInput& input, const Options& options, const Context& context)
      : input_(input),
        context_(context),
        how_(sweep_options().how(options)),
        choice_(connection_options().how(options)),
        range_(range_of(*how_.range)) {
    if (!input_.with) throw UsageError("a sweep needs a system whose parameters can be changed");
    first_ = member(range_.values.front());  // also so that wrong names are reported at once
  }

  [[nodiscard]] double tolerance() const { return tolerance_in(first_, how_.tolerance_given); }

  SystemSweep run() const {
    if (first_.no_connection.empty()) (void)chosen_connection(choice_, first_);
    if (how_.melnikov) (void)perturbation_of(first_);
    SweepOptions options;
    options.tangle.tolerance = tolerance();
    options.tangle.max_points = how_.max_points;
    options.find_zeros = how_.find_zeros;
    options.progress = [&](double done) { return context_.progress(how_.melnikov ? 0.95 * done : done, "values"); };
    SystemSweep so_far;
    so_far.parameter = range_.name;
    if (context_.on_part) {
      options.on_row = [&](const SweepRow& row) {
        so_far.rows.push_back(row);
        context_.on_part(&so_far);
      };
    }
    SystemSweep found{sweep(
        [&](double value) -> FamilyMember {
          const System system = member(value);
          return {system.map, chosen_connection(choice_, system), system.lattice};
        },
        range_.values, options)};
    found.parameter = range_.name;
    if (how_.find_zeros && found.zeros.empty()) found.no_zero = no_zero_text(found);
    if (how_.melnikov) add_first_order(found);
    for (const auto& [name, value] : input_.given) {
      if (name != range_.name) continue;
      found.remarks.push_back(name + " = " + format_rounded(value) +
                              " was given, but is not used: the values are those of the range " + *how_.range);
    }
    if (!range_.reaches) {
      found.remarks.push_back("the step of " + *how_.range +
                              " is longer than its range, so there is one value; give NAME=FIRST:LAST:STEP with a "
                              "shorter step");
    }
    return found;
  }

 private:
  [[nodiscard]] System member(double value) const {
    System system = input_.with({{range_.name, value}});
    if (!system.map) throw UsageError("system " + system.info.name + " has no planar map, which this operation needs");
    return system;
  }

  // Adds the estimate of every value that has lobes; one without a connecting orbit there has no estimate.
  void add_first_order(SystemSweep& found) const {
    std::optional<Melnikov> function;
    found.first_order.emplace();
    for (const SweepRow& row : found.rows) {
      double area = std::numeric_limits<double>::quiet_NaN();
      if (row.failure.empty()) {
        const System system = member(row.value);
        const Parameter& eps = perturbation_of(system);
        try {
          if (!function || range_.name != eps.name) {
            function = melnikov_of(input_, {{range_.name, row.value}}, system, chosen_connection(choice_, system));
          }
          const Melnikov::Sides sides = function->lobe_areas(eps.value);
          area = 0.5 * (sides.left + sides.right);
        } catch (const DataError& error) {
          found.remarks.push_back(range_.name + " = " + format_rounded(row.value, 6) + ": " + error.what());
        }
      }
      found.first_order->push_back(area);
      const double done = static_cast<double>(found.first_order->size()) / static_cast<double>(range_.values.size());
      if (!context_.progress(0.95 + 0.05 * done, "Melnikov's function")) throw Cancelled();
    }
  }

  const SystemInput& input_;
  const Context& context_;
  SweepHow how_;
  ConnectionChoice choice_;
  Range range_;
  System first_;  // at the first value
};

}  // namespace

Operation sweep_operation() {
  Operation operation;
  operation.name = "sweep";
  operation.revision = 6;  // sums of hidden areas in another order
  operation.title = "areas of the turnstile of a system for values of a parameter";
  operation.summary =
      "Computes the areas of the turnstile for the values FIRST to LAST of a parameter, in steps of STEP, and where "
      "the "
      "flux changes sides.";
  operation.inputs = {{"system", InputKind::system, "the system whose parameter is varied"}};
  operation.options = sweep_options().specs();
  operation.options.insert(operation.options.end(), connection_options().specs().begin(),
                           connection_options().specs().end());
  operation.result = sweep_fields();
  operation.examples = {{{"standard"}, {{"range", "K=1:2:0.1"}}, "flux of the standard map over its parameter"},
                        {{"ovp1"},
                         {{"range", "gamma=1.4:1.41:0.01"}, {"find_zeros", true}},
                         "where the two sides of a turnstile change places"}};
  operation.run = [](std::span<const Input> inputs, const Options& options, const Context& context) {
    const Sweeper sweeper(system_of(inputs), options, context);
    Outcome outcome = outcome_of(sweeper.run(), options);
    outcome.chosen = {{"tolerance", sweeper.tolerance()}};
    outcome.failed = failures_text(outcome.as<SystemSweep>());
    return outcome;
  };
  return operation;
}

}  // namespace lober::detail::table
