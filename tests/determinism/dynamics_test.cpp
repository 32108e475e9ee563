// Tangles and grown manifolds: the same bits whatever the threads, the index, the instruction set.
#include <gtest/gtest.h>

#include "lober/dynamics/manifolds.hpp"
#include "lober/dynamics/systems.hpp"
#include "tests/determinism/hash.hpp"
#include "tests/determinism/results.hpp"
#include "tests/determinism/variations.hpp"
#include "tests/engine/geometry/tangle/tangle_scenes.hpp"

namespace lober::detail {
namespace {

TEST(DynamicsDeterminism, TangleOfAHundredThousandPips) {
  const ManifoldPair pair = leaning_fingers(100'000, 5, 0.3);
  expect_same(true, [&](IndexKind index) { return tangle_hash(open(pair.u), open(pair.s), index); });
}

TEST(DynamicsDeterminism, TangleOfAMillionPoints) {
  oracle::Random random(4);
  const ManifoldPair pair = random_manifolds(random, 1'000'000, 4);
  expect_same(true, [&](IndexKind index) { return tangle_hash(open(pair.u), open(pair.s), index); });
}

void expect_same_growth(const char* name, const ParameterValues& parameters, GrowthOptions options,
                        std::size_t at_least) {
  const System system = make_system(name, parameters);
  std::size_t points = 0;
  expect_same(false, [&](IndexKind) {
    const LocalManifold local = local_manifold(*system.map, system.connection->from, ManifoldSide::unstable);
    const GrownManifold grown = grow(*system.map, local, Branch::plus, options);
    points = grown.points.size();
    Hash hash;
    hash.add_all(grown.points);
    hash.add_all(grown.parameters);
    hash.add_all(grown.generation_begin);
    return hash.value();
  });
  EXPECT_GE(points, at_least);
}

TEST(DynamicsDeterminism, ManifoldOfAMap) {
  GrowthOptions options;
  options.tolerance = 1e-9;
  options.length = 300;
  expect_same_growth("standard", {{"K", 2.0}}, options, 1'000);
}

TEST(DynamicsDeterminism, ManifoldOfAFlow) {
  GrowthOptions options;
  options.tolerance = 1e-6;
  options.iterates = 5;
  expect_same_growth("ovp", {{"gamma", 0.5}, {"eps", 0.1}}, options, 1'000);
}

}  // namespace
}  // namespace lober::detail
