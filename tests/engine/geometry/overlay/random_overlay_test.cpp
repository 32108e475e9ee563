// The engine against the exact oracle on every family of random pairs, as generated, and moved and scaled,
// and with the curves exchanged and listed differently.
//
// LOBER_RANDOM_PAIRS  how many pairs as generated, over all families (default 100000)
// LOBER_SEED          the first seed (default 0)
// LOBER_FAILURES      folder for pairs that fail, with the smallest pair that still does (see pair_file.hpp)
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <mutex>
#include <string>
#include <utility>

#include "engine/base/parallel/parallel.hpp"
#include "tests/environment.hpp"
#include "tests/oracle/exact_curve.hpp"
#include "tests/oracle/families.hpp"
#include "tests/oracle/judge.hpp"
#include "tests/oracle/pair_file.hpp"

namespace lober::oracle {
using namespace lober::detail;
namespace {

class Tally {
 public:
  void add(const CurvePair& pair) {
    const Verdict verdict = try_pair(pair);
    const std::lock_guard lock(mutex_);
    ++tried_;
    relative_error_ = std::max(relative_error_, verdict.relative_error);
    small_error_ = std::max(small_error_, verdict.small_error);
    point_error_ = std::max(point_error_, verdict.point_error);
    if (verdict.complaints.empty()) return;
    // A handful is enough to study; the count goes on.
    if (++failed_ <= 3) report(pair, verdict);
  }

  void skip() {
    const std::lock_guard lock(mutex_);
    ++skipped_;
  }

  void print(const std::string& family) const {
    std::printf(
        "%-18s %zu overlays, %zu wrong; %zu moved pairs not simple; worst errors: area %.2e of itself, "
        "small area %.2e of the box, place %.2e\n",
        family.c_str(), tried_, failed_, skipped_, relative_error_, small_error_, point_error_);
  }

  [[nodiscard]] std::size_t failed() const { return failed_; }

 private:
  static void report(const CurvePair& pair, const Verdict& verdict) {
    const auto fails = [](const CurvePair& smaller) { return !try_pair(smaller).complaints.empty(); };
    CurvePair smallest = minimised(pair, fails);
    const std::string path = write_pair(pair, verdict.complaints);
    smallest.family += " smallest";
    const std::string smallest_path = write_pair(smallest, try_pair(smallest).complaints);
    ADD_FAILURE() << pair.family << ", seed " << pair.seed << "\n"
                  << verdict.complaints << "written to " << path << "\nsmallest pair that fails in " << smallest_path
                  << "\n"
                  << as_source(smallest) << try_pair(smallest).complaints;
  }

  std::mutex mutex_;
  std::size_t tried_ = 0, failed_ = 0, skipped_ = 0;
  double relative_error_ = 0, small_error_ = 0, point_error_ = 0;
};

class RandomOverlay : public testing::TestWithParam<Family> {};

TEST_P(RandomOverlay, AgreesWithTheExactOne) {
  const std::uint64_t first = from_environment("LOBER_SEED", 0);
  const std::uint64_t wanted = from_environment("LOBER_RANDOM_PAIRS", 100000);
  const std::uint64_t count = (wanted + families().size() - 1) / families().size();
  Tally tally;
  for_each_block(count, 1, [&](std::size_t k, std::size_t) {
    const std::uint64_t seed = first + k;
    const CurvePair pair = make_curve_pair(GetParam(), seed);
    tally.add(pair);
    if (seed % 2 == 0) {
      const CurvePair moved_pair = transformed(pair);
      if (is_simple(moved_pair.first) && is_simple(moved_pair.second)) {
        tally.add(moved_pair);
      } else {
        tally.skip();
      }
    }
    if (seed % 4 == 1) tally.add(rearranged(pair));
  });
  tally.print(std::string(GetParam().name));
  EXPECT_EQ(tally.failed(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Families, RandomOverlay, testing::ValuesIn(families().begin(), families().end()),
                         [](const auto& member) { return std::string(member.param.name); });

}  // namespace
}  // namespace lober::oracle
