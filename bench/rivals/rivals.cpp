#include "bench/rivals/rival.hpp"

namespace lober::bench {
namespace {

constexpr Rival all_rivals[] = {
    {"GEOS", run_geos, 10'000'000, true, false, false},
    {"Boost", run_boost, 10'000'000, true, false, false},
    {"CGAL", run_cgal, 20'000, false, true, false},
    {"quadratic", run_quadratic, 50'000, false, false, true},
};

}  // namespace

std::span<const Rival> rivals() {
  return all_rivals;
}

}  // namespace lober::bench
