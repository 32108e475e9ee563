// Many curves against many, for C.
#include "lober/overlay/overlap_matrix.hpp"

#include <limits>

#include "engine/c/call.hpp"
#include "engine/c/disagreements.hpp"
#include "engine/c/progress.hpp"
#include "engine/c/result.hpp"
#include "lober/base/error.hpp"

namespace lober::detail::c {
namespace {

// `begin` has count + 1 numbers of points: curve k are points begin[k] to begin[k + 1].
std::vector<CurveView> curves_of(const double* points, const size_t* begin, size_t count, const char* name) {
  if (count == 0) return {};
  if (begin == nullptr) throw UsageError(std::string(name) + ": begin is a null pointer");
  for (size_t k = 0; k < count; ++k) {
    if (begin[k] > begin[k + 1]) {
      throw UsageError(std::string(name) + ": begin[" + std::to_string(k + 1) + "] is less than the one before it");
    }
  }
  const std::span<const Point> all = points_of(points, begin[count], name);
  std::vector<CurveView> curves;
  curves.reserve(count);
  for (size_t k = 0; k < count; ++k) curves.push_back({all.subspan(begin[k], begin[k + 1] - begin[k])});
  return curves;
}

std::vector<OverlapMeasure> measures_of(const std::string& text) {
  std::vector<OverlapMeasure> measures;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    measures.push_back(overlap_measure(std::string_view(text).substr(at, end - at)));
    at = end + 1;
  }
  return measures;
}

template <typename Number>
lober_result::Integers integers_of(const std::vector<Number>& numbers) {
  return {numbers.begin(), numbers.end()};
}

void add_numbers(lober_result& result, OverlapMatrix& found, bool dense) {
  for (std::size_t m = 0; m < found.numbers.size(); ++m) {
    OverlapMatrix::Numbers& numbers = found.numbers[m];
    const std::string name(lober::name(numbers.measure));
    const std::size_t columns = dense ? found.columns : 1;
    result.add(name, dense ? found.dense(m) : std::move(numbers.values), columns);
    if (is_count(numbers.measure)) continue;
    result.add("error.rounding." + name, dense ? found.dense_bounds(m) : std::move(numbers.bounds), columns);
  }
}

void add_failures(lober_result& result, const std::vector<OverlapMatrix::Failure>& failures) {
  lober_result::Integers rows, columns;
  std::vector<std::string> messages;
  const auto number = [](std::size_t curve) {
    return curve == OverlapMatrix::none ? std::int64_t{-1} : static_cast<std::int64_t>(curve);
  };
  for (const OverlapMatrix::Failure& failure : failures) {
    rows.push_back(number(failure.row));
    columns.push_back(number(failure.column));
    messages.push_back(failure.message);
  }
  result.add("failures.row", std::move(rows));
  result.add("failures.column", std::move(columns));
  result.add("failures.message", lines_of(messages));
}

}  // namespace
}  // namespace lober::detail::c

int lober_overlap_matrix(const double* points1, const size_t* begin1, size_t count1, const double* points2,
                         const size_t* begin2, size_t count2, const char* options, lober_result** result) {
  using namespace lober;
  using namespace lober::detail::c;
  return operation(options, result, [&](Options& given) {
    OverlapOptions how;
    how.measures = measures_of(given.text("what").value_or("intersection"));
    how.check_simple = given.flag("check_simple", true);
    how.keep_going = given.flag("keep_going", false);
    const bool dense = given.flag("dense", false);
    if (const std::function<bool(double)> function = progress()) how.progress = function;
    const bool one_set = points2 == nullptr && begin2 == nullptr && count2 == 0;
    return [=](lober_result& made) {
      const std::vector<CurveView> first = curves_of(points1, begin1, count1, "first set");
      const std::vector<CurveView> second = curves_of(points2, begin2, count2, "second set");
      OverlapMatrix found = one_set ? overlap_matrix(first, how) : overlap_matrix(first, second, how);
      if (!dense) {
        made.add("begin", integers_of(found.begin));
        made.add("column", integers_of(found.column));
      }
      add_numbers(made, found, dense);
      made.add("pairs", static_cast<double>(found.pairs));
      add_failures(made, found.failures);
      made.add("areas1", std::move(found.areas[0]));
      made.add("areas2", std::move(found.areas[1]));
    };
  });
}
