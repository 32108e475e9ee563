// The crossings as a structured array of NumPy, a row each; the columns are those of the CSV.
#include <limits>
#include <utility>

#include "cli/overlay/overlay_report.hpp"
#include "engine/base/npy_table.hpp"
#include "engine/base/output_file.hpp"

namespace lober::cli {
namespace {

constexpr std::int64_t none = -1;
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kind_width = 10;  // that of "shared_arc"

using Fields = std::vector<std::pair<std::string, std::string>>;

Fields fields_of(const CurveOverlay& found) {
  Fields fields;
  const auto whole = [&](const std::string& name) { fields.emplace_back(name, "<i8"); };
  const auto real = [&](const std::string& name) { fields.emplace_back(name, "<f8"); };
  whole("index");
  for (const char* name : {"x", "y"}) real(name);
  whole("rho");
  fields.emplace_back("kind", "|S" + std::to_string(kind_width));
  for (const char* k : {"1", "2"}) {
    whole(std::string("segment") + k);
    real(std::string("t") + k);
  }
  for (const char* name : {"class", "order2"}) whole(name);
  for (const char* name : {"end_x", "end_y"}) real(name);
  for (const char* k : {"1", "2"}) {
    whole(std::string("end_segment") + k);
    real(std::string("end_t") + k);
  }
  if (!found.steps) return fields;
  for (const std::string pairing : {"12", "21"}) {
    for (const char* name : {"along1_", "along2_", "sigma_", "class_"}) whole(name + pairing);
    real("s_" + pairing);
  }
  return fields;
}

void put(std::string& bytes, std::int64_t value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}
void put(std::string& bytes, double value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}
void put(std::string& bytes, const Position& position) {
  put(bytes, static_cast<std::int64_t>(position.segment));
  put(bytes, position.t);
}

void put_row(std::string& bytes, const CurveOverlay& found, std::size_t k) {
  const Node node = found.nodes[k];
  put(bytes, static_cast<std::int64_t>(k));
  put(bytes, node.begin.x);
  put(bytes, node.begin.y);
  put(bytes, static_cast<std::int64_t>(node.rho));
  std::string kind = kind_of(node);
  kind.resize(kind_width, '\0');
  bytes += kind;
  put(bytes, node.begin1);
  put(bytes, node.begin2);
  const bool has_class = !found.classes.empty() && found.classes[k] != Overlay::no_class;
  put(bytes, has_class ? static_cast<std::int64_t>(found.classes[k]) : none);
  put(bytes, static_cast<std::int64_t>(found.nodes.rank2(k)));
  const bool has_end = node.shared != 0;
  put(bytes, has_end ? node.end.x : no_number);
  put(bytes, has_end ? node.end.y : no_number);
  for (const Position& end : {node.end1, node.end2}) {
    put(bytes, has_end ? static_cast<std::int64_t>(end.segment) : none);
    put(bytes, has_end ? end.t : no_number);
  }
  if (!found.steps) return;
  for (const std::vector<SigmaStep>& steps : *found.steps) {
    const SigmaStep* const step = step_of(steps, k);
    put(bytes, step != nullptr ? static_cast<std::int64_t>(step->along1) : none);
    put(bytes, step != nullptr ? static_cast<std::int64_t>(step->along2) : none);
    put(bytes, step != nullptr ? static_cast<std::int64_t>(step->sigma) : none);
    put(bytes, step != nullptr ? static_cast<std::int64_t>(step->class_number) : none);
    put(bytes, step != nullptr ? step->s : no_number);
  }
}

}  // namespace

void write_crossings_npy(const std::string& path, const CurveOverlay& found) {
  detail::OutputFile file(path);
  std::string bytes = detail::npy_table_head(fields_of(found), found.nodes.size());
  for (std::size_t k = 0; k < found.nodes.size(); ++k) {
    put_row(bytes, found, k);
    if (bytes.size() < (std::size_t{1} << 20)) continue;
    file.write(bytes);
    bytes.clear();
  }
  file.write(bytes);
  file.commit();
}

}  // namespace lober::cli
