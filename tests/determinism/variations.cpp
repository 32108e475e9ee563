#include "tests/determinism/variations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "engine/base/parallel/parallel.hpp"

namespace lober::detail {
namespace {

constexpr IndexKind all_indexes[] = {IndexKind::tree, IndexKind::grid, IndexKind::kd};
constexpr int all_threads[] = {1, 2, 7};

// Undoes limit_instruction_set at the end of the test.
class BestInstructionSet {
 public:
  BestInstructionSet() = default;
  BestInstructionSet(const BestInstructionSet&) = delete;
  BestInstructionSet& operator=(const BestInstructionSet&) = delete;
  ~BestInstructionSet() { limit_instruction_set(before_); }

 private:
  InstructionSet before_ = instruction_set();
};

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets;
  for (int k = static_cast<int>(processor_instruction_set()); k >= 0; --k) {
    sets.push_back(static_cast<InstructionSet>(k));
  }
  return sets;
}

}  // namespace

std::string text(const Variation& variation) {
  return std::string(instruction_set_names()[static_cast<std::size_t>(variation.isa)]) + ", " +
         std::to_string(variation.threads) + " threads, " + std::string(name(variation.index));
}

std::vector<Variation> variations(bool indexes) {
  const std::vector<InstructionSet> sets = instruction_sets();
  const InstructionSet best = sets.front(), least = sets.back(), middle = sets[sets.size() / 2];
  if (std::getenv("LOBER_ALL_VARIATIONS") == nullptr) {
    const auto index = [&](IndexKind kind) { return indexes ? kind : IndexKind::tree; };
    return {{best, 1, IndexKind::tree},
            {best, 7, IndexKind::tree},
            {middle, 2, index(IndexKind::kd)},
            {least, 7, index(IndexKind::grid)}};
  }
  std::vector<Variation> list;
  for (const InstructionSet isa : sets) {
    for (const IndexKind index : all_indexes) {
      if (!indexes && index != IndexKind::tree) continue;
      for (const int threads : all_threads) list.push_back({isa, threads, index});
    }
  }
  return list;
}

void expect_same(bool indexes, const std::function<std::uint64_t(IndexKind)>& hash) {
  const BestInstructionSet restored;
  std::uint64_t expected = 0;
  bool first = true;
  for (const Variation& variation : variations(indexes)) {
    limit_instruction_set(variation.isa);
    const std::uint64_t found = with_threads(variation.threads, [&] { return hash(variation.index); });
    if (first) expected = found;
    first = false;
    EXPECT_EQ(found, expected) << text(variation);
  }
}

}  // namespace lober::detail
