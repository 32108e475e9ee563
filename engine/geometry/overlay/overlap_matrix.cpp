#include "lober/overlay/overlap_matrix.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>

#include "engine/base/parallel/isolated.hpp"
#include "engine/base/parallel/parallel.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/geometry/index/box_tree.hpp"
#include "engine/geometry/overlay/box_set.hpp"
#include "lober/overlay/index.hpp"
#include "lober/overlay/overlay.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
// Points of the curves of a piece of a loop: far above what it costs to begin one.
constexpr std::size_t points_a_block = std::size_t{1} << 14;

std::size_t grain_for(std::size_t count, std::size_t points) {
  return std::clamp(points_a_block / std::max<std::size_t>(points / std::max<std::size_t>(count, 1), 1), std::size_t{1},
                    std::size_t{256});
}

std::size_t points_of(std::span<const CurveView> curves) {
  std::size_t points = 0;
  for (const CurveView& curve : curves) points += curve.points.size();
  return points;
}

// One of the sets, indexed.
struct IndexedSet {
  std::vector<std::optional<IndexedCurve>> curves;  // none for one that cannot be used
  std::vector<std::string> errors;                  // empty where it can
  std::vector<double> areas;
  std::vector<Box> boxes;  // empty ones for curves that cannot be used
};

void index_curve(const CurveView& curve, std::size_t number, bool check_simple, IndexedSet& set) {
  const std::string name = "curve " + std::to_string(number);
  try {
    require_enough_vertices(curve, name);
    IndexedCurve indexed(curve);
    if (!indexed.finite()) validate(curve, name);
    if (check_simple) (void)require_simple(indexed, 1);
    set.areas[number] = std::fabs(signed_area(curve));
    set.boxes[number] = indexed.tree().box();
    set.curves[number] = std::move(indexed);
  } catch (const NotSimpleError& error) {
    set.errors[number] = name + ": is not simple: segments " + std::to_string(error.segment1) + " and " +
                         std::to_string(error.segment2) + " meet";
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    set.errors[number] = error.what();
  }
}

IndexedSet indexed_set(std::span<const CurveView> curves, bool check_simple) {
  for (std::size_t k = 0; k < curves.size(); ++k) {
    if (!curves[k].closed) throw UsageError("curve " + std::to_string(k) + " is open, closed curves are needed");
  }
  if (curves.size() > std::numeric_limits<std::uint32_t>::max()) throw DataError("there are more than 2^32 curves");
  IndexedSet set;
  set.curves.resize(curves.size());
  set.errors.resize(curves.size());
  set.areas.assign(curves.size(), not_known);
  set.boxes.resize(curves.size());
  for_each_block(curves.size(), grain_for(curves.size(), points_of(curves)), [&](std::size_t begin, std::size_t end) {
    run_isolated([&] {
      for (std::size_t k = begin; k < end; ++k) index_curve(curves[k], k, check_simple, set);
    });
  });
  return set;
}

// Calls the progress of the caller now and then, one thread at a time.
class PairProgress {
 public:
  PairProgress(const Progress& progress, std::size_t pairs) : progress_(progress), pairs_(pairs) {}
  void add(std::size_t pairs) {
    const std::size_t done = done_ += pairs;
    if (!progress_) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock || (watch_.seconds() < last_ + 0.1 && done < pairs_)) return;
    last_ = watch_.seconds();
    if (!progress_(static_cast<double>(done) / static_cast<double>(pairs_))) throw Cancelled();
  }

 private:
  const Progress& progress_;
  std::size_t pairs_;
  std::atomic<std::size_t> done_{0};
  std::mutex mutex_;
  Stopwatch watch_;
  double last_ = -1;
};

struct Pair {
  std::uint32_t row, column;
};

// The pairs whose boxes meet, by row and column; of one set each once.
std::vector<Pair> meeting_pairs(const IndexedSet& first, const IndexedSet& second, bool one_set) {
  const BoxSet boxes(second.boxes);
  constexpr std::size_t grain = 64;
  std::vector<std::vector<Pair>> parts((first.boxes.size() + grain - 1) / grain);
  for_each_block(first.boxes.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> found;
    for (std::size_t row = begin; row < end; ++row) {
      if (!first.curves[row]) continue;
      found.clear();
      boxes.find(first.boxes[row], found);
      std::sort(found.begin(), found.end());
      for (const std::uint32_t column : found) {
        if (!one_set || column >= row) parts[begin / grain].push_back({static_cast<std::uint32_t>(row), column});
      }
    }
  });
  std::size_t size = 0;
  for (const auto& part : parts) size += part.size();
  std::vector<Pair> pairs;
  pairs.reserve(size);
  for (const auto& part : parts) pairs.insert(pairs.end(), part.begin(), part.end());
  return pairs;
}

struct Measured2 {
  double value, bound;
};

Measured2 measured(const Overlay& found, OverlapMeasure measure) {
  const Areas &area = found.areas, &bound = found.rounding;
  switch (measure) {
    case OverlapMeasure::intersection:
      return {area.intersection, bound.intersection};
    case OverlapMeasure::union_:
      return {area.union_, bound.union_};
    case OverlapMeasure::c1_minus_c2:
      return {area.c1_minus_c2, bound.c1_minus_c2};
    case OverlapMeasure::c2_minus_c1:
      return {area.c2_minus_c1, bound.c2_minus_c1};
    case OverlapMeasure::symmetric_difference:
      return {area.symmetric_difference, bound.symmetric_difference};
    case OverlapMeasure::crossings:
      return {static_cast<double>(found.nodes.crossings()), 0};
    case OverlapMeasure::touches:
      return {static_cast<double>(found.nodes.touches()), 0};
    case OverlapMeasure::shared_arcs:
      return {static_cast<double>(found.nodes.shared_arcs()), 0};
  }
  return {not_known, not_known};
}

// The measure when the curves change their roles.
OverlapMeasure mirrored(OverlapMeasure measure) {
  if (measure == OverlapMeasure::c1_minus_c2) return OverlapMeasure::c2_minus_c1;
  return measure == OverlapMeasure::c2_minus_c1 ? OverlapMeasure::c1_minus_c2 : measure;
}

// The overlays of all pairs: whether a pair has an entry, and its numbers.
class PairOverlays {
 public:
  PairOverlays(const IndexedSet& first, const IndexedSet& second, const std::vector<Pair>& pairs,
               std::vector<OverlapMeasure> measures)
      : first_(first),
        second_(second),
        pairs_(pairs),
        measures_(std::move(measures)),
        meets_(pairs.size(), 0),
        numbers_(pairs.size() * measures_.size()) {}

  void run(std::size_t grain, bool keep_going, PairProgress& progress) {
    for_each_block(pairs_.size(), grain, [&](std::size_t begin, std::size_t end) {
      run_isolated([&] {
        for (std::size_t k = begin; k < end; ++k) overlay_pair(k, keep_going);
      });
      progress.add(end - begin);
    });
    std::sort(failures_.begin(), failures_.end(),
              [](const auto& a, const auto& b) { return a.row != b.row ? a.row < b.row : a.column < b.column; });
  }

  [[nodiscard]] bool meets(std::size_t pair) const { return meets_[pair] != 0; }
  [[nodiscard]] const Measured2& number(std::size_t pair, std::size_t measure) const {
    return numbers_[pair * measures_.size() + measure];
  }
  std::vector<OverlapMatrix::Failure>& failures() { return failures_; }

 private:
  void overlay_pair(std::size_t k, bool keep_going) {
    const Pair pair = pairs_[k];
    Measured2* const at = &numbers_[k * measures_.size()];
    try {
      OverlayOptions how;
      how.pieces = false;
      how.check_simple = false;
      const Overlay found = overlay(*first_.curves[pair.row], *second_.curves[pair.column], how);
      // A region that is not empty has a bound, though its computed area may be 0.
      meets_[k] = found.nodes.size() > 0 || found.rounding.intersection > 0 || found.areas.intersection > 0 ? 1 : 0;
      for (std::size_t m = 0; m < measures_.size(); ++m) at[m] = measured(found, measures_[m]);
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      std::string message =
          "curves " + std::to_string(pair.row) + " and " + std::to_string(pair.column) + ": " + error.what();
      if (!keep_going) throw DataError(message);
      meets_[k] = 1;
      std::fill_n(at, measures_.size(), Measured2{not_known, not_known});
      const std::lock_guard lock(mutex_);
      failures_.push_back({pair.row, pair.column, std::move(message)});
    }
  }

  const IndexedSet &first_, &second_;
  const std::vector<Pair>& pairs_;
  std::vector<OverlapMeasure> measures_;
  std::vector<char> meets_;
  std::vector<Measured2> numbers_;
  std::mutex mutex_;
  std::vector<OverlapMatrix::Failure> failures_;
};

// Entries of the pairs that meet; of one set, on both sides of the diagonal.
void fill(OverlapMatrix& result, const std::vector<Pair>& pairs, const PairOverlays& found, bool one_set,
          std::span<const OverlapMeasure> measures, std::span<const std::size_t> across) {
  result.begin.assign(result.rows + 1, 0);
  const auto mirrors = [&](const Pair& pair) { return one_set && pair.row != pair.column; };
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!found.meets(k)) continue;
    ++result.begin[pairs[k].row + std::size_t{1}];
    if (mirrors(pairs[k])) ++result.begin[pairs[k].column + std::size_t{1}];
  }
  for (std::size_t row = 0; row < result.rows; ++row) result.begin[row + 1] += result.begin[row];
  const std::size_t entries = result.begin.back();
  result.column.resize(entries);
  for (const OverlapMeasure measure : measures) {
    result.numbers.push_back({measure, std::vector<double>(entries), {}});
    if (!is_count(measure)) result.numbers.back().bounds.resize(entries);
  }
  std::vector<std::size_t> next(result.begin.begin(), result.begin.end() - 1);
  const auto put = [&](std::size_t row, std::uint32_t column, std::size_t pair, bool mirror) {
    const std::size_t entry = next[row]++;
    result.column[entry] = column;
    for (std::size_t m = 0; m < result.numbers.size(); ++m) {
      const Measured2& number = found.number(pair, mirror ? across[m] : m);
      result.numbers[m].values[entry] = number.value;
      if (!result.numbers[m].bounds.empty()) result.numbers[m].bounds[entry] = number.bound;
    }
  };
  // Pairs ascend by row, so a row has its entries on the left of the diagonal before its own.
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!found.meets(k)) continue;
    put(pairs[k].row, pairs[k].column, k, false);
    if (mirrors(pairs[k])) put(pairs[k].column, pairs[k].row, k, true);
  }
}

void take_failures(OverlapMatrix& result, const IndexedSet& set, bool of_rows, bool keep_going, const char* which) {
  for (std::size_t k = 0; k < set.errors.size(); ++k) {
    if (set.errors[k].empty()) continue;
    std::string message = which + set.errors[k];
    if (!keep_going) throw DataError(message);
    OverlapMatrix::Failure failure;
    (of_rows ? failure.row : failure.column) = k;
    failure.message = std::move(message);
    result.failures.push_back(std::move(failure));
  }
}

OverlapMatrix matrix_of(std::span<const CurveView> first, std::span<const CurveView> second, bool one_set,
                        const OverlapOptions& options) {
  OverlapMatrix result;
  result.rows = first.size();
  result.columns = second.size();
  IndexedSet rows = indexed_set(first, options.check_simple);
  IndexedSet other;
  if (!one_set) other = indexed_set(second, options.check_simple);
  IndexedSet& columns = one_set ? rows : other;
  take_failures(result, rows, true, options.keep_going, one_set ? "" : "first set: ");
  if (!one_set) take_failures(result, other, false, options.keep_going, "second set: ");

  const std::vector<Pair> pairs = meeting_pairs(rows, columns, one_set);
  // Those of the other side of the diagonal are computed too.
  std::vector<OverlapMeasure> measures = options.measures;
  std::vector<std::size_t> across;
  for (const OverlapMeasure measure : options.measures) {
    const auto at = std::find(measures.begin(), measures.end(), mirrored(measure));
    across.push_back(static_cast<std::size_t>(at - measures.begin()));
    if (one_set && at == measures.end()) measures.push_back(mirrored(measure));
  }
  PairOverlays overlays(rows, columns, pairs, measures);
  PairProgress progress(options.progress, pairs.size());
  const std::size_t points_a_pair = (points_of(first) / std::max<std::size_t>(first.size(), 1)) +
                                    (points_of(second) / std::max<std::size_t>(second.size(), 1));
  overlays.run(grain_for(1, points_a_pair), options.keep_going, progress);
  fill(result, pairs, overlays, one_set, options.measures, across);
  result.pairs = pairs.size();
  result.failures.insert(result.failures.end(), overlays.failures().begin(), overlays.failures().end());
  if (one_set) columns.areas = rows.areas;
  result.areas = {rows.areas, columns.areas};
  return result;
}

// The measure of two curves without a common point.
double apart(OverlapMeasure measure, double area1, double area2) {
  if (std::isnan(area1) || std::isnan(area2)) return not_known;
  if (is_zero_apart(measure)) return 0;
  if (measure == OverlapMeasure::c1_minus_c2) return area1;
  return measure == OverlapMeasure::c2_minus_c1 ? area2 : area1 + area2;
}

// signed_area is right to 2^-52 of the area, and the sum of two rounds once more; what it loses beyond that, 2^-95 of
// the square of the diameter, is less for every curve whose area exceeds 2^-40 of that square.
double bound_apart(OverlapMeasure measure, double area1, double area2) {
  return apart(measure, area1, area2) * 0x1p-51;
}

template <typename Apart>
std::vector<double> dense_of(const OverlapMatrix& matrix, const std::vector<double>& entries, OverlapMeasure measure,
                             const Apart& otherwise) {
  std::vector<double> all(matrix.rows * matrix.columns);
  for_each_block(matrix.rows, 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      double* const at = &all[row * matrix.columns];
      for (std::size_t column = 0; column < matrix.columns; ++column) {
        at[column] = otherwise(measure, matrix.areas[0][row], matrix.areas[1][column]);
      }
      for (std::size_t k = matrix.begin[row]; k < matrix.begin[row + 1]; ++k) at[matrix.column[k]] = entries[k];
    }
  });
  return all;
}

}  // namespace

std::string_view name(OverlapMeasure measure) {
  constexpr std::array<std::string_view, 8> names{"intersection",         "union",     "c1_minus_c2", "c2_minus_c1",
                                                  "symmetric_difference", "crossings", "touches",     "shared_arcs"};
  return names[static_cast<std::size_t>(measure)];
}

OverlapMeasure overlap_measure(std::string_view given) {
  std::string known;
  for (const OverlapMeasure measure : all_overlap_measures) {
    if (name(measure) == given) return measure;
    known += (known.empty() ? "" : ", ") + std::string(name(measure));
  }
  throw UsageError("\"" + std::string(given) + "\" is not a measure of two curves; there are " + known);
}

std::vector<double> OverlapMatrix::dense(std::size_t measure) const {
  const Numbers& of = numbers.at(measure);
  return dense_of(*this, of.values, of.measure, apart);
}

std::vector<double> OverlapMatrix::dense_bounds(std::size_t measure) const {
  const Numbers& of = numbers.at(measure);
  if (is_count(of.measure)) return std::vector<double>(rows * columns, 0);
  return dense_of(*this, of.bounds, of.measure, bound_apart);
}

OverlapMatrix overlap_matrix(std::span<const CurveView> first, std::span<const CurveView> second,
                             const OverlapOptions& options) {
  return matrix_of(first, second, false, options);
}

OverlapMatrix overlap_matrix(std::span<const CurveView> curves, const OverlapOptions& options) {
  return matrix_of(curves, curves, true, options);
}

}  // namespace lober
