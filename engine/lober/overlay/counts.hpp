// Counts of the work of a search for crossings. They are the same for any number of threads.
#pragma once

#include <cstdint>

namespace lober {

/// Counts of a search for pairs of segments.
struct SearchCounts {
  std::uint64_t boxes_tested = 0;     ///< pairs of boxes of runs of segments, or cells, or distances in the k-d tree
  std::uint64_t pairs_proposed = 0;   ///< pairs of segments handed to the consumer
  std::uint64_t blocks_searched = 0;  ///< blocks of the first curve that had to be looked at
  std::uint64_t blocks_skipped = 0;   ///< blocks whose box meets nothing
  /// Adds the counts of another search.
  SearchCounts& operator+=(const SearchCounts& other) {
    boxes_tested += other.boxes_tested;
    pairs_proposed += other.pairs_proposed;
    blocks_searched += other.blocks_searched;
    blocks_skipped += other.blocks_skipped;
    return *this;
  }
};

/// Counts of the stages of exact predicates.
struct PredicateCounts {
  std::uint64_t filter_failures = 0;  ///< calls that the filter could not decide
  std::uint64_t exact_calls = 0;      ///< those that an exact product of exact differences could not decide either
  /// Adds the counts of other calls.
  PredicateCounts& operator+=(const PredicateCounts& other) {
    filter_failures += other.filter_failures;
    exact_calls += other.exact_calls;
    return *this;
  }
};

/// Counts of the contacts of two curves.
struct ContactCounts {
  SearchCounts search;                 ///< counts of the search
  PredicateCounts predicates;          ///< counts of the predicates
  std::uint64_t exact_parameters = 0;  ///< crossings too shallow for double-double
  std::uint64_t exact_orders = 0;      ///< pairs of crossings on one segment ordered by exact arithmetic
  std::uint64_t comparisons = 0;       ///< pairs of contacts on one segment that sorting compared, along both curves
  std::uint64_t shared_vertices = 0;   ///< vertices of shared arcs recognised as runs and never tested further
};

}  // namespace lober
