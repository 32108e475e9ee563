// Plans as CBOR.

#include <nlohmann/json.hpp>

#include "engine/batch/manifest/plan.hpp"
#include "engine/batch/operations/bytes.hpp"
#include "engine/batch/operations/option_json.hpp"

namespace lober::detail {
namespace {

using Json = nlohmann::json;

Json to_json(const JobGroup& group) {
  Json options = Json::array();  // in their order
  for (const auto& [key, value] : group.options.settings()) {
    options.push_back({key, json_of<Json>(value)});
  }
  Json made{{"name", group.name}, {"operation", group.operation->name}, {"options", std::move(options)}};
  if (group.periods.any()) made["periods"] = {group.periods.x, group.periods.y};
  return made;
}

OptionValue value_of(const Json& value) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number_float()) return value.get<double>();
  if (value.is_array()) return value.get<std::vector<double>>();
  return value.get<std::string>();
}

Periods periods_of(const Json& from) {
  const auto periods = from.find("periods");
  return periods == from.end() ? Periods{} : Periods{periods->at(0).get<double>(), periods->at(1).get<double>()};
}

JobGroup group_of(const Json& from) {
  const auto operation = from.at("operation").get<std::string>();
  JobGroup group{from.at("name").get<std::string>(), find_operation(operation), {}};
  if (group.operation == nullptr) throw UsageError("there is no operation \"" + operation + "\" in this version");
  std::vector<OptionSetting> settings;
  for (const Json& option : from.at("options"))
    settings.push_back({option.at(0).get<std::string>(), value_of(option.at(1))});
  group.options = {group.operation->options, settings};
  group.periods = periods_of(from);
  return group;
}

Json to_json(const CurveRecipe& recipe) {
  Json made{{"kind", recipe.kind},
            {"system", recipe.system},
            {"parameters", recipe.parameters},
            {"iterates", recipe.iterates},
            {"tolerance", recipe.tolerance},
            {"integration_tolerance", recipe.integration_tolerance},
            {"length", recipe.length},
            {"branch", recipe.branch}};
  if (recipe.saddle) made["saddle"] = {recipe.saddle->x, recipe.saddle->y};
  return made;
}

CurveRecipe recipe_of(const Json& from) {
  CurveRecipe recipe;
  const auto kind = from.at("kind").get<std::uint64_t>();
  if (kind > static_cast<std::uint64_t>(CurveRecipe::Kind::image))
    throw DataError("a stored curve has an unknown kind");
  recipe.kind = static_cast<CurveRecipe::Kind>(kind);
  recipe.system = from.at("system").get<std::string>();
  recipe.parameters = from.at("parameters").get<ParameterValues>();
  recipe.iterates = from.at("iterates").get<int>();
  recipe.tolerance = from.at("tolerance").get<double>();
  recipe.integration_tolerance = from.at("integration_tolerance").get<double>();
  recipe.length = from.at("length").get<double>();
  recipe.branch = from.at("branch").get<int>();
  if (const auto saddle = from.find("saddle"); saddle != from.end()) {
    recipe.saddle = Point{saddle->at(0).get<double>(), saddle->at(1).get<double>()};
  }
  return recipe;
}

Json to_json(const CurveSource& source) {
  Json made{{"file", source.file}, {"closed", source.closed}};
  if (source.zone) made["zone"] = *source.zone;
  if (!source.zone_name.empty()) made["zone_name"] = source.zone_name;
  if (!source.columns.empty()) made["columns"] = source.columns;
  if (source.periods.any()) made["periods"] = {source.periods.x, source.periods.y};
  if (source.recipe) made["recipe"] = to_json(*source.recipe);
  return made;
}

CurveSource source_of(const Json& from) {
  CurveSource source{from.at("file").get<std::string>()};
  source.closed = from.at("closed").get<bool>();
  source.periods = periods_of(from);
  if (const auto zone = from.find("zone"); zone != from.end()) source.zone = zone->get<std::size_t>();
  if (const auto name = from.find("zone_name"); name != from.end()) source.zone_name = name->get<std::string>();
  if (const auto columns = from.find("columns"); columns != from.end()) source.columns = columns->get<std::string>();
  if (const auto recipe = from.find("recipe"); recipe != from.end()) source.recipe = recipe_of(*recipe);
  if (source.file.empty() && !source.recipe) throw DataError("a stored curve has neither a file nor a recipe");
  return source;
}

Plan plan_of(const Json& from) {
  Plan plan;
  for (const Json& group : from.at("groups")) plan.groups.push_back(group_of(group));
  for (const Json& curve : from.at("curves")) plan.curves.push_back(source_of(curve));
  plan.jobs = values_of<Job>(from.at("jobs").get_binary());
  const auto is_curve = [&](CurveId id) { return id == no_curve || id < plan.curves.size(); };
  for (const Job& job : plan.jobs) {
    if (job.group >= plan.groups.size() || !is_curve(job.first) || !is_curve(job.second)) {
      throw DataError("a job of the stored plan names a group or a curve that the plan does not have");
    }
  }
  return plan;
}

}  // namespace

std::string Plan::encoded() const {
  Json made{{"groups", Json::array()}, {"curves", Json::array()}, {"jobs", Json::binary(bytes_of<Job>(jobs))}};
  for (const JobGroup& group : groups) made["groups"].push_back(to_json(group));
  for (const CurveSource& source : curves) made["curves"].push_back(to_json(source));
  std::string bytes;
  Json::to_cbor(made, bytes);
  return bytes;
}

Plan Plan::decoded(std::string_view bytes) {
  try {
    return plan_of(Json::from_cbor(bytes));
  } catch (const Json::exception& error) {
    throw DataError(std::string("the stored bytes cannot be read as a plan: ") + error.what());
  }
}

}  // namespace lober::detail
