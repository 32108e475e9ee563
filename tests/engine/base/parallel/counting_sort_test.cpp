// The sort by key against the standard's stable one.
#include "engine/base/parallel/counting_sort.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/parallel/parallel.hpp"
#include "tests/kernels/random_doubles.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

TEST(CountingSort, SortsStablyByKey) {
  Random random(seed());
  for (const std::size_t size : {0U, 1U, 2U, 2047U, 2048U, 40000U, 100000U}) {
    for (const std::uint32_t largest : {0U, 1U, 2047U, 2048U, 100000U, 0xfffffffeU}) {
      Buffer<KeyedNumber> expected(size);
      for (std::uint32_t k = 0; k < size; ++k) {
        expected[k] = {static_cast<std::uint32_t>(random.unit() * (largest + 1.0)), k};
      }
      const Buffer<KeyedNumber> unsorted = expected;
      std::stable_sort(expected.begin(), expected.end(),
                       [](const KeyedNumber& x, const KeyedNumber& y) { return x.key < y.key; });
      Buffer<KeyedNumber> items;
      with_threads(7, [&] { items = sorted_by_key(size, largest, [&](std::size_t k) { return unsorted[k].key; }); });
      const bool same =
          std::equal(items.begin(), items.end(), expected.begin(), expected.end(),
                     [](const KeyedNumber& x, const KeyedNumber& y) { return x.key == y.key && x.number == y.number; });
      EXPECT_TRUE(same) << size << " items, largest key " << largest;
    }
  }
}

}  // namespace
}  // namespace lober::test
