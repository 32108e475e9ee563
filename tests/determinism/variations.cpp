#include "tests/determinism/variations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "engine/parallel/parallel.hpp"

namespace lober {
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
  std::vector<Variation> list;
  const auto add = [&](InstructionSet isa, int threads, IndexKind index) {
    if (indexes || index == IndexKind::tree) list.push_back({isa, threads, index});
  };
  if (std::getenv("LOBER_ALL_VARIATIONS") != nullptr) {
    for (const InstructionSet isa : sets) {
      for (const IndexKind index : all_indexes) {
        for (const int threads : all_threads) add(isa, threads, index);
      }
    }
    return list;
  }
  add(sets.front(), 1, IndexKind::tree);
  add(sets.front(), 2, IndexKind::kd);
  add(sets.front(), 7, IndexKind::grid);
  add(sets.front(), indexes ? 7 : 2, IndexKind::tree);
  for (std::size_t k = 1; k < sets.size(); ++k) add(sets[k], 7, IndexKind::tree);
  add(sets.back(), 2, IndexKind::grid);
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

}  // namespace lober
