// Parts of results that operations on two curves have in common (private to operations/).
#pragma once

#include "engine/operations/schema.hpp"
#include "lober/overlay/areas.hpp"
#include "lober/overlay/counts.hpp"
#include "lober/overlay/crossings.hpp"

namespace lober::detail::table {

/// The seven areas.
[[nodiscard]] const Schema<Areas>& areas_schema();
/// Fields for how often two curves meet.
[[nodiscard]] Schema<Crossings> meetings_schema();
/// Work of a search for crossings.
[[nodiscard]] const Schema<ContactCounts>& counts_schema();
/// The index that was used, that work, and the work of the check whether the curves are simple: of OverlayStatistics
/// and InteriorStatistics.
template <typename Statistics>
[[nodiscard]] Schema<Statistics> search_schema() {
  Schema<Statistics> check;
  check.field("boxes_tested", "", "pairs of boxes", [](const Statistics& s) { return s.check_simple.boxes_tested; })
      .field("pairs_tested", "", "pairs of segments that were decided", &Statistics::check_simple_pairs)
      .field("skipped_blocks", "", "blocks of the curves whose box meets nothing",
             [](const Statistics& s) { return s.check_simple.blocks_skipped; });
  Schema<Statistics> made;
  made.field("index", "", "index that was used", [](const Statistics& s) { return std::string(name(s.index)); })
      .parts(counts_schema(), [](const Statistics& s) { return &s.counts; })
      .object("check_simple", "the search of each curve against itself", check, [](const Statistics& s) { return &s; });
  return made;
}

/// Adds "orientation1" and "orientation2" of a result that has them.
template <typename T>
void add_orientations(Schema<T>& schema) {
  schema
      .field("orientation1", "", "orientation of C1 as given: 1 counter-clockwise, -1 clockwise, 0 without area",
             [](const T& t) { return static_cast<std::int64_t>(t.orientation1); })
      .field("orientation2", "", "orientation of C2",
             [](const T& t) { return static_cast<std::int64_t>(t.orientation2); });
}

/// |a - b|, area by area.
[[nodiscard]] Areas distance(const Areas& a, const Areas& b);
/// Compares two routes to the seven areas; `bar` is of their differences.
void compare_areas(Agreement& agreement, const std::string& first_by, const std::string& second_by, const Areas& first,
                   const Areas& second, const Areas& bar);
/// Area by area.
[[nodiscard]] Areas sum(const Areas& a, const Areas& b);
[[nodiscard]] Areas larger(const Areas& a, const Areas& b);
[[nodiscard]] Areas scaled(double factor, const Areas& areas);

}  // namespace lober::detail::table
