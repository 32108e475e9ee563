#include "engine/geometry/tangle/running_sums.hpp"

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/crossings/crossings_data.hpp"
#include "engine/geometry/smooth/smooth_gaps.hpp"
#include "engine/geometry/tangle/gaps.hpp"

namespace lober::detail {
namespace {

// Length of a curve up to each vertex.
std::vector<double> lengths(const CurveView& curve) {
  std::vector<double> sums(curve.points.size());
  for (std::size_t k = 1; k < sums.size(); ++k) sums[k] = sums[k - 1] + distance(curve.points[k - 1], curve.points[k]);
  return sums;
}

double length_to(std::span<const double> sums, Position at) {
  const double from = sums[at.segment];
  return at.segment + 1 < sums.size() ? from + at.t * (sums[at.segment + 1] - from) : from;
}

}  // namespace

std::vector<SumsToNode> sums_to_nodes(const TangleCurves& curves, const Crossings& crossings,
                                      std::span<const std::uint32_t> nodes) {
  std::vector<SumsToNode> sums(nodes.size());
  if (nodes.empty()) return sums;
  const Buffer<DD> gaps = polygon_gaps_at(curves, graph_of(crossings), nodes);
  std::vector<double> u, s;
  parallel_if(
      curves.u().segments() + curves.s().segments() > 100'000, [&] { u = lengths(crossings.curve1()); },
      [&] { s = lengths(crossings.curve2()); });
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Node node = crossings[nodes[k]];
    sums[k].gap = gaps[k];
    sums[k].length_u = length_to(u, node.begin1);
    sums[k].length_s = length_to(s, node.begin2);
  }
  if (!curves.smooth) return sums;
  const SmoothGaps smooth = curves.smooth_gaps_at(graph_of(crossings), nodes);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    sums[k].gap += smooth.at[k].twice;
    sums[k].error_u = smooth.at[k].error1;
    sums[k].error_s = smooth.at[k].error2;
    sums[k].uncertainty = smooth.at[k].uncertainty;
  }
  return sums;
}

}  // namespace lober::detail
