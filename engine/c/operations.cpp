// Operations of the table, for C.
#include "lober/operations.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <initializer_list>
#include <span>

#include "engine/c/call.hpp"
#include "engine/c/disagreements.hpp"
#include "engine/c/model.hpp"
#include "lober/base/error.hpp"
#include "lober/base/threads.hpp"

namespace lober::detail::c {
namespace {

namespace ops = operations;

// ---------------------------------------------------------------------------------------------------------- options

struct Settings {
  ops::Options options;
  int threads = 0;
  bool outlines = false;
};

Settings settings_of(const ops::Operation& operation, const char* text) {
  Settings made;
  std::vector<ops::OptionSetting> settings;
  Options given(text);
  made.threads = given.threads();
  made.outlines = given.flag("outlines", false);
  for (const auto& word : words_of(text)) {
    const std::string &key = word.first, &value = word.second;
    if (key == "threads" || key == "outlines") continue;
    const auto spec = std::find_if(operation.options.begin(), operation.options.end(),
                                   [&](const ops::OptionSpec& one) { return one.is_for(key); });
    // Options says what there is where there is no such one.
    settings.push_back(
        {key, spec == operation.options.end() ? ops::OptionValue(value) : ops::option_value(*spec, key, value)});
  }
  made.options = {operation.options, settings};
  return made;
}

// ----------------------------------------------------------------------------------------------------------- inputs

// The inputs of a call; with `kept`, of copies that it holds.
std::vector<ops::Input> inputs_of(const ops::Operation& operation, const lober_input* given, std::size_t count,
                                  std::deque<std::vector<Point>>* kept) {
  if (count > 0 && given == nullptr) throw UsageError("inputs is a null pointer");
  std::vector<ops::Input> inputs;
  for (std::size_t k = 0; k < count; ++k) {
    // The operation says itself how many it takes.
    ops::InputSpec spec;
    spec.kind = ops::InputKind::points;
    if (k < operation.inputs.size()) spec = operation.inputs[k];
    if (spec.kind == ops::InputKind::system) {
      (void)map_of(given[k].model);  // throws for a null pointer
      inputs.emplace_back(given[k].model->input);
    } else {
      std::span<const Point> points = points_of(given[k].points, given[k].n, spec.name.c_str());
      if (kept != nullptr) points = kept->emplace_back(points.begin(), points.end());
      inputs.emplace_back(points);
    }
  }
  return inputs;
}

// ---------------------------------------------------------------------------------------------------------- results

// The values of one field, of one object or of all elements of a list: a row each.
struct Rows {
  lober_result::Doubles doubles;
  lober_result::Integers integers;
  std::vector<std::string> texts;
  lober_result::Integers sizes;  // sizes of fields that have several numbers for one object
  std::size_t columns = 1;

  void add(const ops::FieldValue& value, bool bar) {
    if (const auto* number = std::get_if<double>(&value)) {
      doubles.push_back(*number);
      if (bar) doubles.push_back(std::numeric_limits<double>::quiet_NaN());
    } else if (const auto* measured = std::get_if<Measured>(&value)) {
      doubles.insert(doubles.end(), {measured->value, measured->error});
    } else if (const auto* whole = std::get_if<std::int64_t>(&value)) {
      integers.push_back(*whole);
    } else if (const auto* flag = std::get_if<bool>(&value)) {
      integers.push_back(*flag ? 1 : 0);
    } else if (const auto* text = std::get_if<std::string>(&value)) {
      texts.push_back(*text);
    } else if (const auto* lines = std::get_if<std::vector<std::string>>(&value)) {
      texts.insert(texts.end(), lines->begin(), lines->end());
    } else if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
      doubles.insert(doubles.end(), numbers->begin(), numbers->end());
      sizes.push_back(std::ssize(*numbers));
    } else if (const auto* wholes = std::get_if<std::vector<std::int64_t>>(&value)) {
      integers.insert(integers.end(), wholes->begin(), wholes->end());
      sizes.push_back(std::ssize(*wholes));
    } else if (const auto* point = std::get_if<Point>(&value)) {
      doubles.insert(doubles.end(), {point->x, point->y});
    } else if (const auto* points = std::get_if<std::vector<Point>>(&value)) {
      for (const Point one : *points) doubles.insert(doubles.end(), {one.x, one.y});
    } else if (const auto* matrix = std::get_if<ops::Matrix>(&value)) {
      for (const Measured& entry : matrix->entries) {
        doubles.push_back(entry.value);
        if (bar) doubles.push_back(entry.error);
      }
      columns = std::max<std::size_t>((bar ? 2 : 1) * matrix->entries.size(), 1);
    }
  }
};

bool has_lists(std::span<const ops::Field> fields) {
  return std::any_of(fields.begin(), fields.end(), [](const ops::Field& field) {
    return field.kind == ops::FieldKind::list || has_lists(field.members);
  });
}

void add_rows(lober_result& result, const std::string& name, const ops::Field& field, Rows rows) {
  using Kind = ops::FieldKind;
  // As many columns as numbers, where all objects have as many; else they follow each other.
  if (!rows.sizes.empty() && field.in_json) {
    const bool alike =
        std::adjacent_find(rows.sizes.begin(), rows.sizes.end(), std::not_equal_to<>()) == rows.sizes.end();
    if (alike) rows.columns = std::max<std::size_t>(static_cast<std::size_t>(rows.sizes.front()), 1);
    if (!alike) result.add(name + ".sizes", rows.sizes);
  }
  if (field.kind == Kind::text || field.kind == Kind::lines) return result.add(name, lines_of(rows.texts));
  if (field.kind == Kind::whole || field.kind == Kind::flag || field.kind == Kind::wholes)
    return result.add(name, std::move(rows.integers), rows.columns);
  const bool pair =
      field.kind == Kind::point || field.kind == Kind::points || (field.kind == Kind::number && !field.bar.empty());
  result.add(name, std::move(rows.doubles), pair ? 2 : field.in_json ? rows.columns : 1);
}

// The fields of the objects that `walk` leads to: an array each, with a row for each object. Lists whose elements hold
// lists give arrays for each element, with its number in their names.
void add_columns(lober_result& result, const std::string& prefix, std::span<const ops::Field> fields,
                 const std::function<void(const ops::Field::Use&)>& walk) {
  std::vector<Rows> rows(fields.size());
  walk([&](const void* object) {
    for (std::size_t k = 0; k < fields.size(); ++k) {
      if (fields[k].get) rows[k].add(fields[k].get(object), !fields[k].bar.empty());
    }
  });
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const ops::Field& field = fields[k];
    if (field.get) {
      add_rows(result, prefix + field.name, field, std::move(rows[k]));
    } else if (field.kind == ops::FieldKind::object || !has_lists(field.members)) {
      add_columns(result, prefix + field.name + ".", field.members,
                  [&](const ops::Field::Use& use) { walk([&](const void* object) { field.each(object, use); }); });
    } else {
      std::size_t number = 0;
      walk([&](const void* object) {
        field.each(object, [&](const void* element) {
          add_columns(result, prefix + field.name + "." + std::to_string(number++) + ".", field.members,
                      [&](const ops::Field::Use& use) { use(element); });
        });
      });
    }
  }
}

// Keeps the values that lober_outline needs.
void keep_outlines(lober_result& result, const ops::Operation& operation, const ops::Outcome& found) {
  if (operation.name == "overlay") result.overlay = {found.value, &found.as<ops::CurveOverlay>()};
  if (operation.name == "tangle") result.tangle = {found.value, &found.as<ops::CurveTangle>()};
  if (operation.name == "manifold_tangle") result.tangle = {found.value, &found.as<ops::SystemTangle>()};
}

void call(const ops::Operation& operation, const std::vector<ops::Input>& inputs, const Settings& settings,
          lober_result& result) {
  ops::Context context;
  if (const std::function<bool(double)> function = progress()) {
    context.progress = [function](double fraction, const std::string&) {
      return function(fraction >= 0 ? fraction : -1);
    };
  }
  const ops::Outcome found = operation.run(inputs, settings.options, context);
  if (settings.outlines) keep_outlines(result, operation, found);
  add_columns(result, "", operation.result, [&](const ops::Field::Use& use) { use(found.value.get()); });
  require_agreement(result, found.agreement);
  if (!found.incomplete.empty()) throw WithResult{LOBER_INCOMPLETE, found.incomplete};
}

int call_on(const char* operation, std::initializer_list<lober_input> inputs, const char* options,
            lober_result** result) {
  return lober_call(operation, inputs.begin(), inputs.size(), options, result);
}

}  // namespace
}  // namespace lober::detail::c

int lober_call(const char* operation, const lober_input* inputs, size_t count, const char* options,
               lober_result** result) {
  using namespace lober::detail::c;
  if (result) *result = nullptr;
  return guarded([&] {
    if (!operation || !result) throw lober::UsageError("operation or result is a null pointer");
    const lober::operations::Operation& entry = lober::operations::named(operation);
    const Settings settings = settings_of(entry, options);
    auto made = std::make_unique<lober_result>();
    const auto given = inputs_of(entry, inputs, count, settings.outlines ? &made->inputs : nullptr);
    try {
      lober::run_with_threads(settings.threads, [&] { call(entry, given, settings, *made); });
    } catch (const WithResult&) {
      *result = made.release();
      throw;
    }
    *result = made.release();
  });
}

int lober_overlay(const double* curve1, size_t n1, const double* curve2, size_t n2, const char* options,
                  lober_result** result) {
  return lober::detail::c::call_on("overlay", {{curve1, n1, nullptr}, {curve2, n2, nullptr}}, options, result);
}

int lober_interior(const double* curve1, size_t n1, const double* curve2, size_t n2, const char* options,
                   lober_result** result) {
  return lober::detail::c::call_on("interior", {{curve1, n1, nullptr}, {curve2, n2, nullptr}}, options, result);
}

int lober_regions(const double* curve1, size_t n1, const double* curve2, size_t n2, const char* options,
                  lober_result** result) {
  const lober_input inputs[] = {{curve1, n1, nullptr}, {curve2, n2, nullptr}};
  return lober_call("regions", inputs, n2 == 0 ? 1 : 2, options, result);
}

int lober_winding(const double* curve, size_t n, const double* points, size_t count, const char* options,
                  lober_result** result) {
  return lober::detail::c::call_on("winding", {{curve, n, nullptr}, {points, count, nullptr}}, options, result);
}

int lober_tangle(const double* u, size_t nu, const double* s, size_t ns, const char* options, lober_result** result) {
  return lober::detail::c::call_on("tangle", {{u, nu, nullptr}, {s, ns, nullptr}}, options, result);
}

int lober_densify(const double* curve, size_t n, const char* options, lober_result** result) {
  return lober::detail::c::call_on("densify", {{curve, n, nullptr}}, options, result);
}

int lober_simplify(const double* curve, size_t n, const char* options, lober_result** result) {
  return lober::detail::c::call_on("simplify", {{curve, n, nullptr}}, options, result);
}

int lober_fixed_points(const lober_model* model, const char* options, lober_result** result) {
  return lober::detail::c::call_on("fixed_points", {{nullptr, 0, model}}, options, result);
}

int lober_grow(const lober_model* model, const char* options, lober_result** result) {
  return lober::detail::c::call_on("grow", {{nullptr, 0, model}}, options, result);
}

int lober_image(const lober_model* model, const double* curve, size_t n, const char* options, lober_result** result) {
  return lober::detail::c::call_on("image", {{nullptr, 0, model}, {curve, n, nullptr}}, options, result);
}

int lober_model_tangle(const lober_model* model, const char* options, lober_result** result) {
  return lober::detail::c::call_on("manifold_tangle", {{nullptr, 0, model}}, options, result);
}

int lober_transport(const lober_model* model, const char* options, lober_result** result) {
  return lober::detail::c::call_on("transport", {{nullptr, 0, model}}, options, result);
}

int lober_operations(lober_result** result) {
  using namespace lober::detail::c;
  return operation(nullptr, result, [](Options&) {
    return [](lober_result& made) {
      std::vector<std::string> names, summaries, schemas;
      for (const lober::operations::Operation& entry : lober::operations::all()) {
        names.push_back(entry.name);
        summaries.push_back(entry.summary);
        schemas.push_back(json_schema(entry.result));
      }
      made.add("names", lines_of(names));
      made.add("summaries", lines_of(summaries));
      made.add("schemas", lines_of(schemas));
    };
  });
}
