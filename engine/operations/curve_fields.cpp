#include "engine/operations/curve_fields.hpp"

#include <algorithm>
#include <cmath>

namespace lober::detail::table {
using namespace operations;
namespace {

struct NamedArea {
  const char* key;
  const char* label;  // in messages
  double Areas::*member;
  const char* meaning;
};
constexpr std::array<NamedArea, 7> named_areas{
    {{"c1", "C1", &Areas::c1, "the region of C1"},
     {"c2", "C2", &Areas::c2, "the region of C2"},
     {"intersection", "C1 and C2", &Areas::intersection, "the region in both"},
     {"union", "C1 or C2", &Areas::union_, "the region in one of them or in both"},
     {"c1_minus_c2", "C1 \\ C2", &Areas::c1_minus_c2, "the region in C1 and not in C2"},
     {"c2_minus_c1", "C2 \\ C1", &Areas::c2_minus_c1, "the region in C2 and not in C1"},
     {"symmetric_difference", "either, not both", &Areas::symmetric_difference, "the region in one of them only"}}};

template <typename Combine>
Areas combined(const Areas& a, const Areas& b, const Combine& combine) {
  Areas result;
  for (const NamedArea& area : named_areas) result.*area.member = combine(a.*area.member, b.*area.member);
  return result;
}

}  // namespace

const Schema<Areas>& areas_schema() {
  static const Schema<Areas> schema = [] {
    Schema<Areas> made;
    for (const NamedArea& area : named_areas) made.field(area.key, "area", area.meaning, area.member);
    return made;
  }();
  return schema;
}

Schema<Crossings> meetings_schema() {
  Schema<Crossings> made;
  made.field("count", "", "number of crossings", &Crossings::crossings)
      .field("contacts", "", "number of points where the curves touch", &Crossings::touches)
      .field("shared_arcs", "", "number of arcs that the curves share", &Crossings::shared_arcs)
      .field("same_curve", "", "whether the curves are one and the same", &Crossings::same_curve);
  return made;
}

const Schema<ContactCounts>& counts_schema() {
  using Counts = ContactCounts;
  static const Schema<Counts> schema = [] {
    Schema<Counts> skipped;
    skipped
        .field("blocks", "", "blocks of the first curve whose box meets nothing",
               [](const Counts& c) { return c.search.blocks_skipped; })
        .field("shared_vertices", "", "vertices of shared arcs that were recognised as runs", &Counts::shared_vertices);
    Schema<Counts> made;
    made.field("boxes_tested", "", "pairs of boxes", [](const Counts& c) { return c.search.boxes_tested; })
        .field("pairs_tested", "", "pairs of segments that the index proposed",
               [](const Counts& c) { return c.search.pairs_proposed; })
        .field("filter_failures", "", "signs that doubles could not decide",
               [](const Counts& c) { return c.predicates.filter_failures; })
        .field("exact_calls", "", "signs that took exact arithmetic",
               [](const Counts& c) { return c.predicates.exact_calls; })
        .field("exact_parameters", "", "crossings too shallow for double-double", &Counts::exact_parameters)
        .field("exact_orders", "", "pairs of crossings on one segment that were ordered by exact arithmetic",
               &Counts::exact_orders)
        .object("skipped", "parts that were not looked at", skipped, [](const Counts& c) { return &c; });
    return made;
  }();
  return schema;
}

Areas distance(const Areas& a, const Areas& b) {
  return combined(a, b, [](double x, double y) { return std::fabs(x - y); });
}

Areas sum(const Areas& a, const Areas& b) {
  return combined(a, b, [](double x, double y) { return x + y; });
}

Areas larger(const Areas& a, const Areas& b) {
  return combined(a, b, [](double x, double y) { return std::max(x, y); });
}

Areas scaled(double factor, const Areas& areas) {
  return combined(areas, areas, [factor](double x, double) { return factor * x; });
}

void compare_areas(Agreement& agreement, const std::string& first_by, const std::string& second_by, const Areas& first,
                   const Areas& second, const Areas& bar) {
  for (const NamedArea& area : named_areas) {
    agreement.compare({std::string("area of ") + area.label, first_by, second_by, first.*area.member,
                       second.*area.member, bar.*area.member});
  }
}

}  // namespace lober::detail::table
