// Runs of vertices in common, against comparing them one by one.
#include "kernels/common_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "kernels/eight.hpp"
#include "tests/kernels/random_doubles.hpp"
#include "tests/kernels/vector_copies.hpp"

namespace lober::test {
namespace {

std::size_t common_one_by_one(const Point* a, const Point* b, int direction, std::size_t count) {
  std::size_t n = 0;
  while (n < count && a[n + 1] == b[direction * static_cast<std::ptrdiff_t>(n + 1)] && !(a[n + 1] == a[n])) ++n;
  return n;
}

void check_runs(const KernelTable& copy) {
  Random random(seed());
  for (int k = 0; k < 3000; ++k) {
    const std::size_t count = random.index(60);
    const int direction = random.chance(0.5) ? 1 : -1;
    std::vector<Point> a(count + 1);
    for (Point& point : a) point = {random.unit(), random.unit()};
    if (random.chance(0.3)) a[random.index(a.size())].x = 0.0;
    std::vector<Point> b = a;
    for (Point& point : b) {
      if (point.x == 0) point.x = -0.0;  // the same place
    }
    if (random.chance(0.7)) {
      Point& other = b[random.index(b.size())];
      (random.chance(0.5) ? other.x : other.y) += 0x1p-53;
    }
    if (count > 0 && random.chance(0.3)) {
      const std::size_t repeated = random.index(count);
      a[repeated + 1] = b[repeated + 1] = a[repeated];
    }
    if (direction < 0) std::reverse(b.begin(), b.end());
    const Point* const start = direction > 0 ? b.data() : b.data() + count;
    const std::size_t found = copy.common_vertices(a.data(), start, direction, count);
    const std::size_t expected = common_one_by_one(a.data(), start, direction, count);
    ASSERT_LE(found, expected) << "try " << k;
    ASSERT_LT(expected - found, eight / 2) << "try " << k;
  }
}

TEST(CommonVertices, AreThoseOneByOne) {
  check_runs(baseline_kernels);
}
TEST(CommonVertices, AreSoFromTheOtherCopies) {
  if (vector_copies().empty()) GTEST_SKIP() << "this processor has no AVX2 and FMA: only one copy can run";
  for (const KernelTable* copy : vector_copies()) check_runs(*copy);
}

}  // namespace
}  // namespace lober::test
