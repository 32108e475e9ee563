#include "python/bindings/nodes.hpp"

#include "lober/base/buffer.hpp"
#include "python/bindings/arrays.hpp"

namespace py = pybind11;

namespace lober::python {
namespace {

struct NodeRow {
  double x = 0, y = 0;
  std::int32_t rho = 0, shared = 0;
  std::uint32_t segment1 = 0, segment2 = 0;
  double t1 = 0, t2 = 0;
  double end_x = 0, end_y = 0;
  std::uint32_t end_segment1 = 0, end_segment2 = 0;
  double end_t1 = 0, end_t2 = 0;
  std::uint64_t order2 = 0;
};

}  // namespace

void bind_nodes(py::module_&) {
  PYBIND11_NUMPY_DTYPE(NodeRow, x, y, rho, shared, segment1, segment2, t1, t2, end_x, end_y, end_segment1, end_segment2,
                       end_t1, end_t2, order2);
}

py::array nodes_array(const Crossings& nodes) {
  std::vector<NodeRow> rows(nodes.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Node node = nodes[k];
    rows[k] = {node.begin.x,        node.begin.y,      node.rho,      node.shared, node.begin1.segment,
               node.begin2.segment, node.begin1.t,     node.begin2.t, node.end.x,  node.end.y,
               node.end1.segment,   node.end2.segment, node.end1.t,   node.end2.t, nodes.rank2(k)};
  }
  return array_of(std::move(rows));
}

}  // namespace lober::python
