#include <cstddef>
#include <span>
#include <string>

#include "engine/base/quantities.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/densify.hpp"
#include "lober/overlay/interior.hpp"

namespace lober {
using namespace detail;
namespace {

Point point_between(Point a, Point b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

}  // namespace

std::vector<LabelledPoint> labelled_points(const Crossings& nodes, int curve, const EndsDensification& densification) {
  const CurveView& view = curve == 1 ? nodes.curve1() : nodes.curve2();
  const Buffer<Side> labels = label_vertices(nodes, curve);
  const std::vector<SideChange> changes = side_changes(nodes, curve);
  std::vector<LabelledPoint> points;
  points.reserve(labels.size() + changes.size());
  std::vector<double> meetings, inserted;
  std::size_t next = 0;
  for (std::size_t vertex = 0; vertex < labels.size(); ++vertex) {
    points.push_back({view.points[vertex], labels[vertex]});
    const std::size_t first = next;
    while (next < changes.size() && changes[next].at.segment == vertex) ++next;
    if (first == next) continue;
    const std::span<const SideChange> here = std::span(changes).subspan(first, next - first);
    meetings.clear();
    for (const SideChange& change : here) meetings.push_back(change.at.t);
    inserted.clear();
    parameters_near(meetings, densification.passes, densification.points, inserted);
    Side side = changes[first == 0 ? changes.size() - 1 : first - 1].side;
    const Point a = view.points[vertex], b = view.points[vertex + 1 == labels.size() ? 0 : vertex + 1];
    std::size_t appended = 0;
    const auto insert_before = [&](double end) {
      for (; appended < inserted.size() && inserted[appended] < end; ++appended) {
        points.push_back({point_between(a, b, inserted[appended]), side});
      }
    };
    for (const SideChange& change : here) {
      insert_before(change.at.t);
      if (appended < inserted.size() && inserted[appended] == change.at.t) ++appended;  // the intersection itself
      if (!change.at_vertex) points.push_back({change.point, Side::on});
      side = change.side;
    }
    insert_before(1);
    const std::size_t max_points = InteriorOptions{}.max_points;
    if (points.size() > max_points) {
      throw DataError("the passes would make a curve of more than " + std::to_string(max_points) +
                      " points, the limit; give " + std::string(quantity::passes) + " instead");
    }
  }
  return points;
}

}  // namespace lober
