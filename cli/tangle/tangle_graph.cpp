// The tangle graph as JSON: what topological tools (homotopic lobe dynamics and its like) need to know of a tangle.

#include "cli/report/json_file.hpp"
#include "cli/tangle/tangle_report.hpp"

namespace lober::cli {
namespace {

// One row a crossing, so that a million of them stay readable and short.
constexpr const char* node_columns =
    R"(["order_u","order_s","x","y","segment_u","t_u","segment_s","t_s","rho","kind","generation","arc_u","arc_s"])";

const Json member_meanings{
    {"order_u", "place along U, from 0; the rows are in this order"},
    {"order_s", "place along S, from 0"},
    {"rho", "1: S passes from the right of U to its left; -1: from left to right; 0: it stays on one side"},
    {"kind", "pip, sip or touch"},
    {"generation", "arc_u - arc_s: how far apart the two lobes are whose arcs cross; 0 for pips"},
    {"arc_u", "k: from pip k on along U, before pip k + 1; -1: before pip 0"},
    {"arc_s", "k: from pip k to before pip k + 1, whichever way S runs; -1: beyond pip 0"},
    {"lobes",
     "lobe k is bounded by arc k of U, the crossings u[0] to u[1] in order_u, and by arc k of S, the crossings s[0] to "
     "s[1] in order_s; both ends are pips"}};

const char* node_kind(int rho, bool pip) {
  if (rho == 0) return "touch";
  return pip ? "pip" : "sip";
}

void write_nodes(detail::OutputFile& file, const Tangle& result) {
  const std::vector<ArcsAt> arcs = arcs_at_nodes(result);
  std::vector<bool> is_pip(result.nodes.size());
  for (const Pip& pip : result.pips) is_pip[pip.node] = true;
  write_list(file, result.nodes.size(), [&](std::string& text, std::size_t k) {
    const Node node = result.nodes[k];
    put(text, "[", k, ",", result.nodes.rank2(k), ",", node.begin.x, ",", node.begin.y, ",", node.begin1.segment, ",",
        node.begin1.t, ",", node.begin2.segment, ",", node.begin2.t, ",", node.rho, ",\"",
        node_kind(node.rho, is_pip[k]), "\",", arcs[k].generation(), ",", arcs[k].u, ",", arcs[k].s, "]");
  });
}

}  // namespace

void write_tangle_graph(const std::string& path, const TangleReport& report) {
  const Tangle& result = report.result();
  JsonFile json(path, "tangle --graph");
  Json inputs = Json::array();
  for (const NamedCurve& input : report.inputs) {
    inputs.push_back(report.origin ? Json{{"grown", input.file}}
                                   : Json{{"file", input.file}, {"zone", input.zone}, {"sha256", input.sha256}});
  }
  Json pips = Json::array();
  for (const Pip& pip : result.pips) pips.push_back(pip.node);
  json.member("inputs", inputs);
  json.member("meaning", member_meanings);
  json.member("crossings", meetings_json(result.nodes));
  json.member("pips", pips);
  json.member("bip", result.boundary ? Json(result.boundary->bip) : Json());
  json.member("period", result.images.period == 0 ? Json() : Json(result.images.period));
  json.list("lobes", result.lobes.size(), [&](std::string& text, std::size_t k) {
    const std::uint32_t first = result.pips[k].node, last = result.pips[k + 1].node;
    put(text, "{\"index\":", k, ",\"area\":", result.lobes[k].area, ",\"u\":[", first, ",", last, "],\"s\":[",
        result.nodes.rank2(last), ",", result.nodes.rank2(first), "]}");
  });
  json.file().write(std::string("\"columns\": ") + node_columns + ",\n\"nodes\": ");
  write_nodes(json.file(), result);
  json.file().write("}\n");
  json.file().commit();
}

}  // namespace lober::cli
