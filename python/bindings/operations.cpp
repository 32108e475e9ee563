// Operations of the table (lober/operations.hpp): one function calls them all, and makes a dictionary of any result.
#include "lober/operations.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "engine/base/stopwatch.hpp"
#include "python/bindings/agreement.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/module.hpp"
#include "python/bindings/outcome.hpp"
#include "python/bindings/system.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

namespace ops = operations;
using Fields = std::span<const ops::Field>;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// ---------------------------------------------------------------------------------------------------------- results

py::array_t<double> matrix_of(const ops::Matrix& matrix, double Measured::*part) {
  py::array_t<double> array({static_cast<py::ssize_t>(matrix.rows), static_cast<py::ssize_t>(matrix.columns)});
  double* number = array.mutable_data();
  for (const Measured& entry : matrix.entries) *number++ = entry.*part;
  return array;
}

py::object object_of(ops::FieldValue value, bool with_bars = false) {
  return std::visit(
      [with_bars](auto& any) -> py::object {
        using Value = std::decay_t<decltype(any)>;
        if constexpr (std::is_same_v<Value, std::monostate>) {
          return py::none();
        } else if constexpr (std::is_same_v<Value, Measured>) {
          return py::make_tuple(any.value, any.error);
        } else if constexpr (std::is_same_v<Value, Point>) {
          return pair_of(any);
        } else if constexpr (std::is_same_v<Value, ops::Matrix>) {
          if (!with_bars) return matrix_of(any, &Measured::value);
          return py::make_tuple(matrix_of(any, &Measured::value), matrix_of(any, &Measured::error));
        } else if constexpr (std::is_same_v<Value, std::vector<Point>>) {
          return array_of(std::move(any));
        } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
          return array_of(std::move(any));
        } else {
          return py::cast(any);
        }
      },
      value);
}

// A column of a list: an array where every element has one number, or as many of them.
class Column {
 public:
  explicit Column(const ops::Field& field) : field_(field) {}

  void add(const void* element) {
    const ops::FieldValue value = field_.get(element);
    if (const auto* number = std::get_if<double>(&value)) {
      put({*number, unknown});
    } else if (const auto* measured = std::get_if<Measured>(&value)) {
      put(*measured);
    } else if (const auto* point = std::get_if<Point>(&value)) {
      put({point->x, 0});
      put({point->y, 0});
    } else if (const auto* matrix = std::get_if<ops::Matrix>(&value)) {
      for (const Measured& entry : matrix->entries) put(entry);
      shape_ = {matrix->rows, matrix->columns};
    } else if (field_.kind == ops::FieldKind::point) {
      put({unknown, unknown});
      put({unknown, unknown});
    } else if (field_.kind == ops::FieldKind::number || field_.kind == ops::FieldKind::whole ||
               field_.kind == ops::FieldKind::flag) {
      const auto* whole = std::get_if<std::int64_t>(&value);
      const auto* flag = std::get_if<bool>(&value);
      put({whole != nullptr ? static_cast<double>(*whole) : flag != nullptr ? (*flag ? 1.0 : 0.0) : unknown, unknown});
    } else {
      objects_.append(object_of(value));
    }
    ++rows_;
  }

  [[nodiscard]] py::object done() {
    using Kind = ops::FieldKind;
    if (field_.kind == Kind::matrix || field_.kind == Kind::point) {
      const auto rows = static_cast<py::ssize_t>(rows_);
      const std::vector<py::ssize_t> shape = field_.kind == Kind::point
                                                 ? std::vector<py::ssize_t>{rows, 2}
                                                 : std::vector<py::ssize_t>{rows, static_cast<py::ssize_t>(shape_[0]),
                                                                            static_cast<py::ssize_t>(shape_[1])};
      const bool complete =
          values_.size() == static_cast<std::size_t>(shape[0] * shape[1] * (shape.size() > 2 ? shape[2] : 1));
      if (!complete || (field_.kind == Kind::matrix && values_.empty())) return py::none();
      py::object values = array_of(std::move(values_)).reshape(shape);
      if (field_.bar.empty()) return values;
      return py::make_tuple(values, array_of(std::move(errors_)).reshape(shape));
    }
    if (field_.kind == Kind::number) {
      if (field_.bar.empty()) return array_of(std::move(values_));
      return py::make_tuple(array_of(std::move(values_)), array_of(std::move(errors_)));
    }
    if (field_.kind == Kind::whole) return cast_all<std::int64_t>();
    if (field_.kind == Kind::flag) return cast_all<bool>();
    return std::move(objects_);
  }

 private:
  void put(Measured entry) {
    values_.push_back(entry.value);
    errors_.push_back(entry.error);
  }
  // As doubles where some are not known.
  template <typename T>
  py::object cast_all() {
    for (const double value : values_) {
      if (std::isnan(value)) return array_of(std::move(values_));
    }
    py::array_t<T> array(static_cast<py::ssize_t>(values_.size()));
    for (std::size_t k = 0; k < values_.size(); ++k) array.mutable_data()[k] = static_cast<T>(values_[k]);
    return array;
  }

  const ops::Field& field_;
  std::vector<double> values_, errors_;
  std::array<std::size_t, 2> shape_{};
  py::list objects_;
  std::size_t rows_ = 0;
};

bool has_lists(Fields fields) {
  for (const ops::Field& field : fields) {
    if (field.kind == ops::FieldKind::list || has_lists(field.members)) return true;
  }
  return false;
}

py::dict dict_of(Fields fields, const void* whole);

// A dictionary of columns.
py::dict columns_of(Fields fields, const std::function<void(const ops::Field::Use&)>& walk) {
  py::dict result;
  for (const ops::Field& field : fields) {
    if (field.get) {
      Column column(field);
      walk([&](const void* element) { column.add(element); });
      result[field.name.c_str()] = column.done();
    } else {
      result[field.name.c_str()] = columns_of(field.members, [&](const ops::Field::Use& use) {
        walk([&](const void* element) { field.each(element, use); });
      });
    }
  }
  return result;
}

py::dict dict_of(Fields fields, const void* whole) {
  py::dict result;
  for (const ops::Field& field : fields) {
    py::object made = py::none();
    if (field.get) {
      made = object_of(field.get(whole), !field.bar.empty());
    } else if (field.kind == ops::FieldKind::object) {
      field.each(whole, [&](const void* part) { made = dict_of(field.members, part); });
    } else if (has_lists(field.members)) {
      py::list elements;
      field.each(whole, [&](const void* element) { elements.append(dict_of(field.members, element)); });
      made = elements;
    } else {
      made = columns_of(field.members, [&](const ops::Field::Use& use) { field.each(whole, use); });
    }
    result[field.name.c_str()] = made;
  }
  return result;
}

// ------------------------------------------------------------------------------------------------------------- call

// Calls a function of the package that makes a relative of a system. Errors of it are those of the engine, so that they
// are noted where they come up.
System relative_by(const py::object& make, const ParameterValues& changed) {
  const py::gil_scoped_acquire acquired;
  try {
    py::dict values;
    for (const auto& [name, value] : changed) values[py::str(name)] = value;
    return *make(values).cast<SystemHandle>();
  } catch (const py::error_already_set& error) {
    const py::module_ errors = py::module_::import("lober.errors");
    const std::string text = py::str(error.value());
    if (error.matches(errors.attr("UsageError"))) throw UsageError(text);
    if (error.matches(errors.attr("DataError"))) throw DataError(text);
    throw;
  }
}

// (handle, name or None, parameters, tolerance of the integration, None or a function of changed parameters that makes
// a relative): that of a name needs no function.
ops::SystemInput system_from(const py::tuple& given) {
  ops::SystemInput input;
  IntegrationOptions integration;
  integration.tolerance = given[3].cast<double>();
  if (!given[1].is_none()) {
    input = ops::system_input(given[1].cast<std::string>(), given[2].cast<ParameterValues>(), integration);
  } else if (!given[4].is_none()) {
    // Copied and destroyed in threads without the GIL.
    const std::shared_ptr<py::object> make(new py::object(given[4]), [](const py::object* kept) {
      const py::gil_scoped_acquire acquired;
      delete kept;
    });
    input.with = [make](const ParameterValues& changed) { return relative_by(*make, changed); };
  }
  input.integration = integration;
  input.system = given[0].cast<SystemHandle>();
  return input;
}

ops::OptionValue value_from(const ops::OptionSpec& spec, const py::handle& value) {
  if (PyTuple_Check(value.ptr()) != 0) return value.cast<std::vector<double>>();
  if (PyBool_Check(value.ptr()) != 0) return value.cast<bool>();
  if (PyUnicode_Check(value.ptr()) != 0) return value.cast<std::string>();
  if (PyFloat_Check(value.ptr()) != 0) return value.cast<double>();
  if (PyIndex_Check(value.ptr()) != 0) return value.cast<std::int64_t>();
  throw UsageError(spec.key + ": a value of type " + py::type::of(value).attr("__name__").cast<std::string>() +
                   " cannot be used");
}

ops::Options options_from(const ops::Operation& operation, const py::dict& given) {
  std::vector<ops::OptionSetting> settings;
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    const auto spec = std::find_if(operation.options.begin(), operation.options.end(),
                                   [&](const ops::OptionSpec& one) { return one.is_for(name); });
    if (value.is_none()) continue;
    settings.push_back({name, spec == operation.options.end() ? ops::OptionValue(false) : value_from(*spec, value)});
  }
  return {operation.options, settings};
}

OperationRun run(const std::string& name, const py::list& given, const py::dict& settings, int threads,
                 const py::object& progress) {
  const ops::Operation& operation = ops::named(name);
  const ProgressCallback callback(progress);
  std::vector<ops::Input> inputs;
  for (const py::handle one : given) {
    if (py::isinstance<py::tuple>(one)) {
      inputs.emplace_back(system_from(one.cast<py::tuple>()));
    } else {
      inputs.emplace_back(points_of(one.cast<Array>()));
    }
  }
  const ops::Options options = options_from(operation, settings);
  ops::Context context;
  if (callback.given()) {
    context.progress = [&](double fraction, const std::string& line) {
      return std::isnan(fraction) ? callback(line) : line.empty() ? callback(fraction) : callback(fraction, line);
    };
  }
  double seconds = 0;
  ops::Outcome found = long_call(threads, [&] {
    const lober::detail::Stopwatch watch;
    ops::Outcome made = operation.run(inputs, options, context);
    seconds = watch.seconds();
    return made;
  });
  return {&operation, std::move(found), given, seconds};
}

py::object object_of_option(const ops::OptionValue& value) {
  return std::visit(
      [](const auto& any) -> py::object {
        if constexpr (std::is_same_v<std::decay_t<decltype(any)>, Rectangle>) {
          return py::make_tuple(any.min_x, any.min_y, any.max_x, any.max_y);
        } else {
          return object_of(any);
        }
      },
      value);
}

// The values in place of options that were not given.
py::dict chosen_of(const OperationRun& run) {
  py::dict chosen;
  for (const ops::OptionSetting& setting : run.outcome.chosen) {
    chosen[setting.key.c_str()] = object_of_option(setting.value);
  }
  return chosen;
}

// ------------------------------------------------------------------------------------------------------------ table

py::list fields_of(Fields fields) {
  static const std::array<const char*, 12> kinds{"number", "whole", "flag",   "text",   "lines", "numbers",
                                                 "wholes", "point", "matrix", "object", "list",  "points"};
  py::list list;
  for (const ops::Field& field : fields) {
    py::dict one;
    one["name"] = field.name;
    one["kind"] = kinds.at(static_cast<std::size_t>(field.kind));
    one["unit"] = field.unit;
    one["meaning"] = field.meaning;
    one["bar"] = field.bar;
    one["members"] = fields_of(field.members);
    list.append(one);
  }
  return list;
}

py::dict option_of(const ops::OptionSpec& spec) {
  static const std::array<const char*, 7> types{"bool", "int", "float", "str", "point", "box", "numbers"};
  py::dict one;
  one["key"] = spec.key;
  one["type"] = types.at(spec.fallback.index());
  one["default"] = spec.optional ? py::object(py::none()) : object_of_option(spec.fallback);
  one["required"] = spec.required;
  one["otherwise"] = spec.otherwise;
  one["meaning"] = spec.meaning;
  return one;
}

// The table that the functions of the package are made from.
py::list table() {
  py::list list;
  for (const ops::Operation& operation : ops::all()) {
    py::dict one;
    one["name"] = operation.name;
    one["title"] = operation.title;
    one["summary"] = operation.summary;
    one["compares"] = operation.compares;
    py::list inputs, options;
    for (const ops::InputSpec& input : operation.inputs) {
      py::dict given;
      given["name"] = input.name;
      given["meaning"] = input.meaning;
      given["system"] = input.kind == ops::InputKind::system;
      given["optional"] = input.optional;
      inputs.append(given);
    }
    for (const ops::OptionSpec& spec : operation.options) options.append(option_of(spec));
    one["inputs"] = inputs;
    one["options"] = options;
    one["result"] = fields_of(operation.result);
    list.append(one);
  }
  return list;
}

}  // namespace

void bind_operations(py::module_& module) {
  py::class_<OperationRun>(module, "OperationRun")
      .def("value", [](const OperationRun& run) { return dict_of(run.operation->result, run.outcome.value.get()); })
      .def("json",
           [](const OperationRun& run) {
             return long_call(0, [&] { return json_object(run.operation->result, run.outcome.value.get()); });
           })
      .def("comparisons", [](const OperationRun& run) { return comparisons_of(run.outcome.agreement); })
      .def("chosen", chosen_of)
      .def_readonly("seconds", &OperationRun::seconds)
      .def_property_readonly("incomplete", [](const OperationRun& run) { return run.outcome.incomplete; });
  module.def("run", run, py::arg("name"), py::arg("inputs"), py::arg("settings"), py::arg("threads"),
             py::arg("progress"));
  module.def("table", table);
}

}  // namespace lober::python
