#include "cli/report/json.hpp"

#include <cmath>

#include "engine/files/curve_spec.hpp"
#include "lober/base/version.hpp"

namespace lober::cli {

std::string dumped(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json number_json(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json input_json(const NamedCurve& input, double area, Orientation orientation) {
  Json object{{"file", input.file},
              {"zone", input.zone},
              {"sha256", input.sha256},
              {"points", input.curve.points.size()},
              {"area", orientation == Orientation::clockwise ? -area : area},
              {"orientation", name(orientation)}};
  if (!input.remark.empty()) object["remark"] = input.remark;
  return object;
}

void add_spec(Json& input, const NamedCurve& curve, const std::string& spec) {
  if (!curve.group.empty() || !detail::split_spec(spec).columns.empty()) input["spec"] = spec;
}

Json periods_json(const Periods& periods) {
  Json object = Json::object();
  if (periods.x != 0) object["x"] = periods.x;
  if (periods.y != 0) object["y"] = periods.y;
  return object;
}

Json program_json() {
  return {{"name", "lober"}, {"version", version()}};
}

Json meetings_json(const Crossings& nodes) {
  return {{"count", nodes.crossings()},
          {"contacts", nodes.touches()},
          {"shared_arcs", nodes.shared_arcs()},
          {"same_curve", nodes.same_curve()}};
}

}  // namespace lober::cli
