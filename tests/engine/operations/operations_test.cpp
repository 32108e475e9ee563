// The table of operations: consistent in itself, and the same numbers to the bit on every face that walks over it.
#include "lober/operations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/batch/operations/operation.hpp"
#include "lober/base/error.hpp"
#include "lober/lober.h"
#include "lober/transport/transport.hpp"

namespace lober::operations {
namespace {

using Json = nlohmann::json;

// A run that takes a moment, of each operation.
struct Case {
  std::string operation, system;  // or curves, or points
  ParameterValues parameters;
  std::vector<OptionSetting> settings;
  std::vector<std::vector<Point>> curves{};
  std::size_t least = 20;  // how many numbers a face has to have
};

// Two wavy circles that cross several times, and a figure of eight.
std::vector<Point> wavy(int points, int waves, Point centre) {
  std::vector<Point> curve;
  for (int k = 0; k < points; ++k) {
    const double angle = 2 * std::numbers::pi * k / points, radius = 1 + 0.2 * std::cos(waves * angle);
    curve.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return curve;
}
// With y = 0, lobes of area 2.
std::vector<Point> sine(int points) {
  std::vector<Point> curve;
  for (int k = 0; k <= points; ++k) {
    const double x = -0.5 + 7 * std::numbers::pi * k / points;
    curve.push_back({x, std::sin(x)});
  }
  return curve;
}
const std::vector<Point> eight{{-1, -1}, {1, 1}, {1, -1}, {-1, 1}};

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"transport", "standard", {{"K", 1.2}}, {{"iterates", std::int64_t{3}}, {"particles", std::int64_t{1000}}}},
      {"escape",
       "capsize",
       {},
       {{"crossings", std::int64_t{2}}, {"tolerance", 1e-4}, {"monte_carlo", std::int64_t{500}}}},
      {"fixed_points",
       "standard",
       {},
       {{"period", std::int64_t{5}}, {"turns", std::int64_t{2}}, {"box", Rectangle{-0.1, 0, 6.1, 6}}}},
      {"levels", "ovp", {{"eps", 0.0}}, {{"grid", Point{90, 80}}, {"box", Rectangle{-3, -3, 3, 3}}}},
      {"section", "henon", {}, {{"exit_times", true}, {"iterates", std::int64_t{20}}}},
      {"sweep", "henon", {}, {{"range", "k=0.9:1.1:0.1"}, {"find_zeros", true}, {"tolerance", 1e-4}}},
      {"grow", "henon", {}, {{"side", "stable"}, {"length", 20.0}, {"box", Rectangle::of({-3, -3}, {3, 3})}}, {}, 10},
      {"overlay",
       "",
       {},
       {{"verify", true}, {"smooth", true}, {"classes", true}},
       {wavy(200, 5, {0, 0}), wavy(150, 3, {0.1, 0.2})}},
      {"interior",
       "",
       {},
       {{"method", "ends"}, {"passes", std::int64_t{2}}, {"points", std::int64_t{3}}, {"verify", true}},
       {wavy(200, 5, {0, 0}), wavy(150, 3, {0.1, 0.2})}},
      {"tangle",
       "",
       {},
       {{"period", std::int64_t{2}}, {"overlaps", true}, {"bip_near", Point{6, 0}}},
       {sine(700), {{7 * std::numbers::pi, 0.0}, {-0.5, 0.0}}}},
      {"curve_transport",
       "",
       {},
       {{"period", std::int64_t{2}}},
       {sine(3000), {{7 * std::numbers::pi, 0.0}, {-0.5, 0.0}}}},
      {"manifold_tangle", "standard", {{"K", 1.2}}, {{"tolerance", 1e-4}, {"overlaps", true}}},
      {"image",
       "standard",
       {{"K", 0.7}},
       {{"circle", std::vector<double>{3, 0, 1}}, {"first", std::int64_t{-1}}, {"last", std::int64_t{2}}}},
      {"densify",
       "",
       {},
       {{"hobson", true}, {"crossings", true}, {"simplify", 1e-3}},
       {wavy(90, 5, {0, 0}), eight},
       10},
      {"simplify", "", {}, {{"tolerance", 1e-3}}, {wavy(900, 5, {0, 0})}, 3},
      {"regions", "", {}, {{"rule", "evenodd"}}, {eight, wavy(150, 3, {0.1, 0.2})}},
      {"winding", "", {}, {}, {eight, {{0.5, 0.1}, {-0.5, 0.1}, {0, 0}, {3, 3}}}, 10},
  };
  return all;
}

Outcome run(const Case& one) {
  const Operation& operation = named(one.operation);
  std::vector<Input> inputs;
  for (const std::vector<Point>& curve : one.curves) inputs.emplace_back(std::span<const Point>(curve));
  if (!one.system.empty()) inputs.emplace_back(system_input(one.system, one.parameters));
  return operation.run(inputs, {operation.options, one.settings}, {});
}

// All paths to numbers, with their bars; those in lists that hold lists are left out.
void add_paths(std::span<const Field> fields, const std::string& prefix, std::vector<std::string>& paths) {
  for (const Field& field : fields) {
    if (!field.members.empty()) {
      add_paths(field.members, prefix + field.name + ".", paths);
    } else if (field.kind == FieldKind::number || field.kind == FieldKind::whole) {
      paths.push_back(prefix + field.name);
      if (!field.bar.empty()) paths.push_back(prefix + field.bar);
    }
  }
}

// The numbers at a path of JSON.
void add_numbers(const Json& json, std::string_view path, std::vector<double>& numbers) {
  if (json.is_array()) {
    for (const Json& element : json) add_numbers(element, path, numbers);
    return;
  }
  const std::size_t dot = std::min(path.find('.'), path.size());
  const auto member = json.find(path.substr(0, dot));
  if (member == json.end()) return;
  if (dot < path.size()) return add_numbers(*member, path.substr(dot + 1), numbers);
  numbers.push_back(member->is_null() ? std::numeric_limits<double>::quiet_NaN() : member->get<double>());
}

void expect_same_bits(const std::vector<double>& first, const std::vector<double>& second, const std::string& what) {
  ASSERT_EQ(first.size(), second.size()) << what;
  for (std::size_t k = 0; k < first.size(); ++k) {
    if (std::isnan(first[k]) && std::isnan(second[k])) continue;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(first[k]), std::bit_cast<std::uint64_t>(second[k])) << what;
  }
}

TEST(OperationsTable, IsConsistent) {
  std::set<std::string> names;
  for (const Operation& operation : all()) {
    EXPECT_TRUE(names.insert(operation.name).second) << operation.name;
    EXPECT_FALSE(operation.title.empty() || operation.summary.empty() || operation.examples.empty()) << operation.name;
    std::set<std::string> keys;
    for (const OptionSpec& option : operation.options) {
      EXPECT_TRUE(keys.insert(option.key).second) << option.key;
      EXPECT_FALSE(option.meaning.empty()) << option.key;
      EXPECT_EQ(option.optional && !option.required, !option.otherwise.empty()) << option.key;
    }
    for (const OptionSpec& option : operation.options) {
      if (option.required) {
        EXPECT_THROW(Options(operation.options, {}), UsageError);
      }
    }
    for (const Example& example : operation.examples) {
      EXPECT_LE(example.inputs.size(), operation.inputs.size());
      for (std::size_t k = example.inputs.size(); k < operation.inputs.size(); ++k)
        EXPECT_TRUE(operation.inputs[k].optional) << operation.name;
      EXPECT_NO_THROW(Options(operation.options, example.options));
    }
    // Names of a schema are read as keys of objects.
    const Json schema = Json::parse(json_schema(operation.result));
    EXPECT_EQ(schema["type"], "object");
    std::vector<std::string> paths;
    add_paths(operation.result, "", paths);
    EXPECT_EQ(std::set<std::string>(paths.begin(), paths.end()).size(), paths.size()) << operation.name;
  }
}

TEST(OperationsTable, HasACaseOfEachOperation) {
  std::set<std::string> tested;
  for (const Case& one : cases()) tested.insert(one.operation);
  for (const Operation& operation : all()) EXPECT_TRUE(tested.contains(operation.name)) << operation.name;
}

TEST(OperationsTable, JsonHasTheNumbersOfTheResult) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.operation);
    const Operation& operation = named(one.operation);
    const Outcome found = run(one);
    const Json json = Json::parse("{" + json_members(operation.result, found.value.get()) + "}");
    std::vector<std::string> paths;
    add_paths(operation.result, "", paths);
    std::size_t compared = 0;
    for (const std::string& path : paths) {
      const std::vector<double> numbers = numbers_at(operation.result, found.value.get(), path);
      std::vector<double> in_json;
      add_numbers(json, path, in_json);
      // Unknown values are left out in JSON.
      if (in_json.empty()) continue;
      expect_same_bits(numbers, in_json, path);
      compared += numbers.size();
    }
    EXPECT_GE(compared, one.least);
    const Json schema = Json::parse(json_schema(operation.result));
    for (const auto& [name, value] : json.items()) EXPECT_TRUE(schema["properties"].contains(name)) << name;
  }
}

TEST(OperationsTable, CHasTheNumbersOfTheResult) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.operation);
    const Operation& operation = named(one.operation);
    const Outcome found = run(one);
    std::vector<lober_input> inputs;
    for (const std::vector<Point>& curve : one.curves) inputs.push_back({&curve[0].x, curve.size(), nullptr});
    lober_model* model = nullptr;
    if (!one.system.empty()) {
      std::string parameters;
      for (const auto& [name, value] : one.parameters) parameters += name + "=" + to_string(OptionValue(value)) + " ";
      ASSERT_EQ(lober_model_open(one.system.c_str(), parameters.c_str(), nullptr, &model), LOBER_OK);
      inputs.push_back({nullptr, 0, model});
    }
    lober_result* result = nullptr;
    ASSERT_EQ(lober_call(one.operation.c_str(), inputs.data(), inputs.size(), to_string(one.settings).c_str(), &result),
              LOBER_OK)
        << lober_message();
    std::size_t compared = 0;
    for (std::size_t k = 0; k < lober_array_count(result); ++k) {
      lober_array array;
      ASSERT_EQ(lober_array_at(result, k, &array), LOBER_OK);
      const std::string name = array.name;
      // "images.2.points" is of the third element of a list.
      std::string path = name;
      std::optional<std::size_t> element;
      if (const auto digits = name.find_first_of("0123456789");
          digits != std::string::npos && name[digits - 1] == '.') {
        const std::size_t end = name.find('.', digits);
        element = std::stoul(name.substr(digits, end - digits));
        path = name.substr(0, digits) + name.substr(end + 1);
      }
      if (array.type == LOBER_TEXT || array.columns > 2 || (element && array.rows != 1)) continue;
      std::vector<double> numbers;
      try {
        numbers = numbers_at(operation.result, found.value.get(), path);
      } catch (const UsageError&) {
        continue;
      }
      if (element) {
        ASSERT_LT(*element, numbers.size()) << name;
        numbers = {numbers[*element]};
      }
      std::vector<double> in_c;
      for (std::size_t row = 0; row < array.rows; ++row) {
        const std::size_t at = row * array.columns;
        in_c.push_back(array.type == LOBER_DOUBLES
                           ? static_cast<const double*>(array.data)[at]
                           : static_cast<double>(static_cast<const std::int64_t*>(array.data)[at]));
      }
      if (!numbers.empty() && std::isnan(numbers[0])) continue;  // points, and what is not known
      expect_same_bits(numbers, in_c, name);
      compared += numbers.size();
    }
    EXPECT_GE(compared, one.least);
    lober_result_free(result);
    lober_model_free(model);
  }
}

// A job that follows from the description alone, without a branch below, has a column for each path of a number.
void expect_described_columns(const Operation& operation, const Outcome& found, const detail::Operation& job,
                              const detail::Result& record) {
  std::vector<std::string> paths;
  add_paths(operation.result, "", paths);
  std::size_t compared = 0;
  for (const std::string& path : paths) {
    std::string name = path;
    std::replace(name.begin(), name.end(), '.', '_');
    for (std::size_t k = 0; k < job.columns.size(); ++k) {
      if (job.columns[k].name != name) continue;
      expect_same_bits({record.values[k]}, numbers_at(operation.result, found.value.get(), path), name);
      ++compared;
    }
  }
  EXPECT_GT(compared, 0U) << operation.name;
}

TEST(OperationsTable, BatchesHaveTheNumbersOfTheResult) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.operation);
    const detail::Operation* const job = detail::find_operation(one.operation);
    ASSERT_NE(job, nullptr);
    std::vector<OptionSetting> settings = one.settings;
    if (!one.system.empty()) settings.push_back({"system", one.system});
    for (const auto& [name, value] : one.parameters) settings.push_back({"parameters." + name, value});
    const detail::Allowance allowance;
    if (job->name == "overlay") settings.push_back({"lobes", true});
    const Options options(job->options, settings);
    std::vector<std::unique_ptr<detail::PreparedCurve>> prepared;
    std::vector<const detail::PreparedCurve*> curves;
    for (const std::vector<Point>& points : one.curves) {
      prepared.push_back(std::make_unique<detail::PreparedCurve>(
          std::make_shared<const Curve>(Curve{points, !job->open, "c"}), job->requirements(options)));
      curves.push_back(prepared.back().get());
    }
    const detail::Result record = job->run(detail::JobCurves(curves, allowance), options);
    ASSERT_EQ(record.values.size(), job->columns.size());
    ASSERT_EQ(record.lists.size(), job->lists.size());
    // By another way than the paths that the job has.
    const Outcome found = run(one);
    const auto list = [&](const std::string& name) {
      const auto at = std::find(job->lists.begin(), job->lists.end(), name);
      return at == job->lists.end() ? std::vector<double>{}
                                    : record.lists[static_cast<std::size_t>(at - job->lists.begin())];
    };
    std::vector<double> expected;
    if (one.operation == "transport") {
      const auto& transport = found.as<SystemTransport>();
      expect_same_bits({record.values[0], record.values[1]},
                       {transport.regions.front().area.value, transport.boundaries.front().flux12.value}, "columns");
      for (const TransportStep& step : transport.steps) expected.push_back(step.total(1, 0).value);
      expect_same_bits(list("total21"), expected, "total21");
    } else if (one.operation == "image") {  // a job that follows from its description alone
      std::vector<double> lengths;
      for (const CurveImages::One& image : found.as<CurveImages>().images) {
        expected.push_back(image.area->value);
        lengths.push_back(image.length);
      }
      expect_same_bits(list("images_area"), expected, "images_area");
      expect_same_bits(list("images_length"), lengths, "images_length");
      EXPECT_EQ(job->view, "images");
    } else if (one.operation == "escape") {
      for (const EscapeFraction& row : found.as<SystemEscape>().table) expected.push_back(row.fraction);
      expect_same_bits(list("fraction"), expected, "fraction");
    } else if (one.operation == "fixed_points") {
      for (const FixedPoint& point : found.as<SystemFixedPoints>().points) expected.push_back(residue(point));
      expect_same_bits(list("residue"), expected, "residue");
    } else if (one.operation == "grow") {
      const auto& manifold = found.as<SystemManifold>();
      expect_same_bits({record.values[0], record.values[1], record.values[3]},
                       {static_cast<double>(manifold.points.size()), manifold.length, manifold.local.multiplier},
                       "columns");
    } else if (one.operation == "levels") {
      for (const SystemLevel& level : found.as<SystemLevels>().levels) expected.push_back(level.value);
      expect_same_bits(list("energies"), expected, "energies");
    } else if (one.operation == "section") {
      const auto& section = found.as<SystemSection>();
      expect_same_bits({record.values[0], record.values[2]},
                       {static_cast<double>(section.points), static_cast<double>(section.lost)}, "columns");
      const std::vector<std::uint64_t> counts = section.exit_times->counts();
      expected.assign(counts.begin() + 1, counts.end());
      expect_same_bits(list("leaving"), expected, "leaving");
    } else if (one.operation == "sweep") {
      for (const SweepRow& row : found.as<SystemSweep>().rows) expected.push_back(row.flux21.value);
      expect_same_bits(list("flux21"), expected, "flux21");
    } else if (one.operation == "overlay") {
      const auto& overlay = found.as<CurveOverlay>();
      expect_same_bits({record.values[0], record.values[7], record.values[21]},
                       {overlay.areas.c1, overlay.rounding.c1, static_cast<double>(overlay.nodes.crossings())},
                       "columns");
      const std::span<const double> areas = overlay.pieces(Pairing::c1_minus_c2).areas();
      expect_same_bits(list("lobes_c1_minus_c2"), {areas.begin(), areas.end()}, "lobes");
    } else if (one.operation == "interior") {
      const auto& interior = found.as<CurveInterior>();
      expect_same_bits({record.values[0], record.values[14]}, {interior.areas.c1, interior.q1}, "columns");
    } else if (one.operation == "regions") {
      const auto& regions = found.as<CurveRegions>();
      expect_same_bits({record.values[0]}, {regions.regions.areas(FillRule::evenodd).c1}, "columns");
      for (const WindingArea& entry : regions.regions.table()) expected.push_back(entry.area);
      expect_same_bits(list("winding_areas"), expected, "winding areas");
    } else if (one.operation == "curve_transport") {
      const auto& transport = found.as<CurveTransport>();
      expect_same_bits({record.values[0], record.values[3]}, {transport.enclosed.value, transport.flux12.value},
                       "columns");
      for (const TransportStep& step : transport.steps) expected.push_back(step.total(1, 0).value);
      expect_same_bits(list("total21"), expected, "total21");
    } else if (one.operation == "tangle" || one.operation == "manifold_tangle") {
      const CurveTangle& tangle = one.operation == "tangle" ? found.as<CurveTangle>()
                                                            : static_cast<const CurveTangle&>(found.as<SystemTangle>());
      expect_same_bits({record.values[0], record.values[3], record.values[8]},
                       {static_cast<double>(tangle.nodes.crossings()), static_cast<double>(tangle.pips.size()),
                        tangle.boundary->area},
                       "columns");
      for (const Lobe& lobe : tangle.lobes) expected.push_back(lobe.area);
      expect_same_bits(list("areas"), expected, "areas of lobes");
    } else if (one.operation == "densify" || one.operation == "simplify") {
      const auto& refined = found.as<RefinedCurve>();
      expect_same_bits({record.values[0], record.values[2]},
                       {signed_area(CurveView{refined.points, true}), static_cast<double>(refined.points.size())},
                       "columns");
    } else if (one.operation == "winding") {
      for (const CurveWinding::Count& count : found.as<CurveWinding>().counts) expected.push_back(count.winding);
      expect_same_bits(list("winding"), expected, "winding numbers");
    } else {
      expect_described_columns(named(one.operation), found, *job, record);
    }
  }
}

TEST(OperationsTable, OptionsAreReadFromText) {
  const Operation& operation = named("transport");
  const auto spec = [&](const char* key) {
    for (const Operation& any : all()) {
      for (const OptionSpec& one : any.options) {
        if (one.is_for(key)) return one;
      }
    }
    ADD_FAILURE() << key;
    return OptionSpec{};
  };
  EXPECT_EQ(option_value(spec("from"), "from", "0.5,-1e3"), OptionValue(Point{0.5, -1000}));
  EXPECT_EQ(option_value(spec("iterates"), "iterates", "12"), OptionValue(std::int64_t{12}));
  EXPECT_EQ(option_value(spec("all_regions"), "all_regions", "1"), OptionValue(true));
  EXPECT_THROW((void)option_value(spec("iterates"), "iterates", "1e3"), UsageError);
  EXPECT_THROW((void)option_value(spec("from"), "from", "0.5"), UsageError);
  EXPECT_THROW((void)option_value(spec("from"), "from", "0.5,1,2"), UsageError);
  EXPECT_EQ(option_value(spec("box"), "box", "-1,0,1e1,2"), OptionValue(Rectangle{-1, 0, 10, 2}));
  EXPECT_EQ(to_string(OptionValue(Rectangle{-1, 0, 10, 2})), "-1,0,10,2");
  EXPECT_THROW((void)option_value(spec("box"), "box", "0,0,1"), UsageError);
  EXPECT_THROW((void)option_value(spec("box"), "box", "0,0,1,"), UsageError);
  const auto refused = [&](const OptionSetting& setting) {
    try {
      (void)Options(operation.options, {&setting, 1});
    } catch (const UsageError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refused({"tolerance", 0.0}), "tolerance: has to be above 0");
  EXPECT_EQ(refused({"iterates", std::int64_t{0}}), "iterates: has to be at least 1");
  EXPECT_EQ(refused({"from", 3.0}), "from: has to be a point [x, y]");
  EXPECT_EQ(refused({"from", std::vector<double>{1, 2, 3}}), "from: has to be a point [x, y]");
  EXPECT_EQ(refused({"from", std::vector<double>{1, NAN}}), "from: the numbers have to be finite");
  EXPECT_EQ(refused({"from", std::vector<double>{1, 2}}), "");
  const OptionSetting box{"box", Rectangle{1, 0, 0, 1}};
  EXPECT_THROW((void)Options(named("fixed_points").options, {&box, 1}), UsageError);
  EXPECT_NE(refused({"speed", 3.0}).find("there is no such option; there are from"), std::string::npos);
}

TEST(OperationsTable, RefusesOtherInputs) {
  const Operation& operation = named("transport");
  const Options options(operation.options, {});
  EXPECT_THROW((void)operation.run({}, options, {}), UsageError);
  const std::vector<Point> points{{0, 0}, {1, 0}};
  const std::vector<Input> curves{std::span<const Point>(points)};
  EXPECT_THROW((void)operation.run(curves, options, {}), UsageError);
  EXPECT_THROW((void)named("transpose"), UsageError);
  EXPECT_THROW((void)numbers_at(operation.result, nullptr, "speed"), UsageError);
}

// Points to start from are an input that may be left out; orbits are kept where nobody takes them as they come.
TEST(OperationsTable, SectionsTakePoints) {
  const Operation& operation = named("section");
  const Options options(operation.options, std::vector<OptionSetting>{{"iterates", std::int64_t{2}}});
  const std::vector<Point> starts{{0.5, 0}, {-0.2, 0.1}};
  const std::vector<Input> inputs{system_input("henon", {{"k", 0.25}}), std::span<const Point>(starts)};
  const Outcome found = operation.run(inputs, options, {});
  const auto& section = found.as<SystemSection>();
  EXPECT_EQ(section.orbits, 2U);
  ASSERT_EQ(section.kept.size(), 6U);
  EXPECT_EQ(section.kept[2], (Point{-0.75, 0}));
  std::vector<Point> taken;
  Context context;
  context.on_part = [&](const void* so_far) {
    const std::span<const Point> block = static_cast<const SystemSection*>(so_far)->block;
    taken.insert(taken.end(), block.begin(), block.end());
  };
  EXPECT_TRUE(operation.run(inputs, options, context).as<SystemSection>().kept.empty());
  EXPECT_EQ(taken, section.kept);

  lober_model* model = nullptr;
  ASSERT_EQ(lober_model_open("henon", "k=0.25", nullptr, &model), LOBER_OK);
  const std::array<lober_input, 3> given{{{nullptr, 0, model}, {&starts[0].x, 2, nullptr}, {&starts[0].x, 2, nullptr}}};
  lober_result* result = nullptr;
  ASSERT_EQ(lober_call("section", given.data(), 2, "iterates=2", &result), LOBER_OK) << lober_message();
  lober_array orbits;
  ASSERT_EQ(lober_array_named(result, "orbits", &orbits), LOBER_OK);
  ASSERT_EQ(orbits.rows, 6U);
  EXPECT_EQ(static_cast<const double*>(orbits.data)[4], -0.75);
  lober_result_free(result);
  for (const std::size_t count : {std::size_t{0}, std::size_t{3}}) {
    EXPECT_EQ(lober_call("section", given.data(), count, nullptr, &result), LOBER_USAGE_ERROR);
    EXPECT_STREQ(lober_message(), ("section takes 1 to 2 inputs, not " + std::to_string(count)).c_str());
  }
  lober_model_free(model);
}

// Rows come as they are ready, before the end, with what was compared so far.
TEST(OperationsTable, ElementsComeAsTheyAreReady) {
  const Operation& operation = named("transport");
  Context context;
  std::vector<double> totals;
  context.on_element = [&](const Field& list, const void* element, const Agreement& agreement) {
    EXPECT_EQ(list.name, "steps");
    totals.push_back(numbers_at(list.members, element, "T21").front());
    EXPECT_TRUE(agreement.agrees());
  };
  const std::vector<Input> inputs{system_input("standard", {{"K", 1.2}})};
  const Outcome found = operation.run(inputs, Options(operation.options, {}), context);
  expect_same_bits(totals, numbers_at(operation.result, found.value.get(), "steps.T21"), "T21");
}

}  // namespace
}  // namespace lober::operations
