#include "lober/transport/monte_carlo.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

#include "engine/base/parallel/parallel.hpp"
#include "kernels/box.hpp"
#include "kernels/splitmix.hpp"
#include "lober/base/error.hpp"
#include "lober/overlay/index.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr std::size_t trajectories_a_block = 2048;  // trajectories a block

struct SectionCurve {
  IndexedCurve curve;
  Box box;
  int direction;
  explicit SectionCurve(const TubeCurve& c) : curve(c.view()), box(box_of(c.image.points)), direction(c.direction) {}
  [[nodiscard]] bool holds(Point p) const { return meet(box, Box::of(p, p)) && contains(curve, p); }
};

class TrajectoryCounter {
 public:
  TrajectoryCounter(const Flow& flow, const Escape& result, const MonteCarloOptions& options)
      : flow_(flow), result_(result), options_(options), both_(result.section) {
    both_.direction = 0;
    for (const Bottleneck& bottleneck : result.bottlenecks) {
      entries_.emplace_back(bottleneck.entry[0]);
      exits_.emplace_back(bottleneck.exit[0]);
    }
    for (const EscapeFraction& row : result.table) most_ = std::max(most_, row.iterates);
  }

  // counts[exit][m]; the last entry counts lost trajectories.
  [[nodiscard]] std::vector<std::uint64_t> count(std::size_t entry, std::uint64_t begin, std::uint64_t end) const {
    std::vector<std::uint64_t> counts(columns() + 1);
    const int start = entries_[entry].direction;
    Section lifted = both_;
    lifted.direction = start;
    std::vector<FlowState> states;
    for (std::uint64_t k = begin; k < end; ++k) {
      states.push_back(flow_.on_section(lifted, result_.energy, sample(entry, k)));
    }
    for (int m = 0; m <= most_ && !states.empty(); ++m) {
      const int here = m % 2 == 0 ? start : -start;
      std::erase_if(states, [&](const FlowState& state) { return leaves(state, here, m, counts); });
      if (m < most_) flow_.to_section(states, {}, both_, 1, options_.integration);
    }
    return counts;
  }
  [[nodiscard]] std::uint64_t in(const std::vector<std::uint64_t>& counts, std::size_t exit, int m) const {
    return counts[exit * static_cast<std::size_t>(most_ + 1) + static_cast<std::size_t>(m)];
  }
  [[nodiscard]] std::size_t columns() const { return exits_.size() * static_cast<std::size_t>(most_ + 1); }

 private:
  [[nodiscard]] bool leaves(const FlowState& state, int direction, int m, std::vector<std::uint64_t>& counts) const {
    const Point p{state[static_cast<std::size_t>(both_.chart_x)], state[static_cast<std::size_t>(both_.chart_y)]};
    if (!std::isfinite(p.x)) {
      ++counts.back();
      return true;
    }
    for (std::size_t j = 0; j < exits_.size(); ++j) {
      if (exits_[j].direction != direction || !exits_[j].holds(p)) continue;
      ++counts[j * static_cast<std::size_t>(most_ + 1) + static_cast<std::size_t>(m)];
      return true;
    }
    return false;
  }

  [[nodiscard]] Point sample(std::size_t entry, std::uint64_t k) const {
    const SectionCurve& curve = entries_[entry];
    std::uint64_t bits = mixed(options_.seed ^ mixed(k * result_.bottlenecks.size() + entry));
    for (;;) {
      bits = mixed(bits);
      const double x = unit(bits);
      bits = mixed(bits);
      const Point p{curve.box.min_x() + x * curve.box.width(), curve.box.min_y() + unit(bits) * curve.box.height()};
      if (curve.holds(p)) return p;
    }
  }

  const Flow& flow_;
  const Escape& result_;
  const MonteCarloOptions& options_;
  Section both_;
  std::vector<SectionCurve> entries_, exits_;
  int most_ = 0;
};

}  // namespace

MonteCarlo monte_carlo(const Flow& flow, const Escape& result, const MonteCarloOptions& options) {
  if (options.trajectories == 0) throw UsageError("a Monte Carlo check needs trajectories");
  const TrajectoryCounter counter(flow, result, options);
  const std::size_t bottlenecks = result.bottlenecks.size();
  const std::size_t blocks = (options.trajectories + trajectories_a_block - 1) / trajectories_a_block;
  std::vector<std::vector<std::uint64_t>> counts(bottlenecks, std::vector<std::uint64_t>(counter.columns() + 1));
  std::mutex mutex;
  std::size_t done = 0;
  for_each_block(bottlenecks * blocks, 1, [&](std::size_t k, std::size_t) {
    const std::size_t entry = k / blocks;
    const std::uint64_t begin = (k % blocks) * trajectories_a_block;
    const auto here =
        counter.count(entry, begin, std::min<std::uint64_t>(begin + trajectories_a_block, options.trajectories));
    // Sums of whole numbers do not depend on their order.
    const std::lock_guard lock(mutex);
    for (std::size_t i = 0; i < here.size(); ++i) counts[entry][i] += here[i];
    ++done;
    if (options.progress && !options.progress(static_cast<double>(done) / static_cast<double>(bottlenecks * blocks))) {
      throw Cancelled();
    }
  });
  MonteCarlo check;
  check.trajectories = options.trajectories;
  for (const auto& of_entry : counts) check.lost += of_entry.back();
  const auto total = static_cast<double>(options.trajectories);
  for (const EscapeFraction& row : result.table) {
    MonteCarloFraction found;
    found.count = counter.in(counts[row.entry], row.exit, row.iterates);
    found.fraction = static_cast<double>(found.count) / total;
    const double expected = row.is_known() ? row.fraction : found.fraction;
    found.standard_error = std::sqrt(std::max(expected * (1 - expected), 0.0) / total);
    // Where the table says nothing leaves, one trajectory that does is as much as one standard error.
    const double scale = std::max(found.standard_error, 1 / total);
    if (row.is_known()) {
      check.largest_deviation = std::max(check.largest_deviation, std::fabs(found.fraction - row.fraction) / scale);
    }
    check.table.push_back(found);
  }
  return check;
}

void compare(const Escape& result, const MonteCarlo& counted, Agreement& agreement) {
  constexpr double standard_errors = 5, handful = 12;
  const auto total = static_cast<double>(counted.trajectories);
  for (std::size_t k = 0; k < result.table.size(); ++k) {
    const EscapeFraction& row = result.table[k];
    const MonteCarloFraction& here = counted.table[k];
    const double chance = standard_errors * here.standard_error + (handful + static_cast<double>(counted.lost)) / total;
    agreement.compare({name(row), "curves", "trajectories", row.fraction, here.fraction, row.error + chance});
  }
}

}  // namespace lober
