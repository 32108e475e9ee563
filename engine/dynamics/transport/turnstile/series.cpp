// Rows of the table of transport, one after the other.

#include <algorithm>
#include <limits>

#include "engine/base/parallel/parallel.hpp"
#include "engine/dynamics/transport/turnstile/series.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

constexpr Measured unknown_area{std::numeric_limits<double>::quiet_NaN(), 0};

std::vector<Turnstile> turnstiles_of(const std::vector<Barrier>& barriers) {
  std::vector<Turnstile> turnstiles;
  turnstiles.reserve(barriers.size());
  for (const Barrier& barrier : barriers) turnstiles.emplace_back(barrier);
  return turnstiles;
}

}  // namespace

TransportSeries::TransportSeries(const std::vector<Barrier>& barriers)
    : partition_(barriers), total_(partition_.size()) {
  for (std::size_t i = 0; i < partition_.size(); ++i) total_(i, i) = partition_.regions()[i].area;
  extend(barriers);
}

void TransportSeries::extend(const std::vector<Barrier>& barriers) {
  turnstiles_ = turnstiles_of(barriers);
  enclosed_.clear();
  drift_.clear();
  for (const Turnstile& turnstile : turnstiles_) {
    enclosed_.push_back(enclosed_area(turnstile.barrier()));
    const Measured leaving = turnstile.flux12(), entering = turnstile.flux21();
    drift_.push_back({leaving.value - entering.value, std::max(leaving.error, entering.error)});
  }
}

bool TransportSeries::reaches_next() const {
  for (const Turnstile& c : turnstiles_) {
    for (const Turnstile& d : turnstiles_) {
      const int before = d.barrier().images_before(), after = c.barrier().images_after();
      // first_gain looks at the image of the lobes.
      if (n_ + 1 > before + after || (&c != &d && after < 1)) return false;
    }
  }
  return true;
}

void TransportSeries::advance() {
  const std::size_t count = turnstiles_.size();
  if (n_ == 0) gains_.resize(count * count);
  for_each_block(count * count, 1, [&](std::size_t k, std::size_t) {
    const Turnstile &c = turnstiles_[k / count], &d = turnstiles_[k % count];
    if (n_ == 0) {
      gains_[k] = &c == &d ? -1 * c.flux21() : first_gain(c, d);
    } else {
      gains_[k] = gains_[k] - (&c == &d ? balance(c.overlaps(n_)) : balance(c, d, n_));
    }
  });
  ++n_;
}

Measured TransportSeries::gain(std::size_t c, std::size_t d) const {
  if (d == 0) return c == 0 ? Measured{} : drift_[c - 1];
  return c == 0 ? Measured{} : gains_[(c - 1) * turnstiles_.size() + d - 1];
}

RegionMatrix TransportSeries::by_boundaries(int n) {
  const std::size_t count = turnstiles_.size();
  std::vector<const Barrier*> barriers;
  for (const Turnstile& turnstile : turnstiles_) barriers.push_back(&turnstile.barrier());
  std::vector<InsidesInCommon::Pair> pairs(count * count);
  std::vector<char> crossed(count * count);
  for_each_block(count * count, 1, [&](std::size_t k, std::size_t) {
    const std::size_t c = k / count, d = k % count;
    const int back = split_images(n, barriers[d]->images_before(), barriers[c]->images_after());
    pairs[k] = {c, d, n - back, -back, partition_.at_rest(c, d)};
    crossed[k] = closure_is_crossed(*barriers[c], n - back) || closure_is_crossed(*barriers[d], -back);
  });
  std::vector<InsidesInCommon::Pair> known;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!crossed[k]) known.push_back(pairs[k]);
  }
  const std::vector<Measured> found = insides_.of(barriers, known);
  std::vector<Measured> common(count * count, unknown_area);
  for (std::size_t k = 0; k < known.size(); ++k) common[known[k].c * count + known[k].d] = found[k];
  RegionMatrix areas(partition_.size());
  for (std::size_t i = 0; i < areas.size(); ++i) {
    for (std::size_t j = 0; j < areas.size(); ++j) {
      areas(i, j) = partition_.combine(i, j, [&](std::size_t c, std::size_t d) {
        if (c == 0 && d == 0) return unknown_area;
        return c == 0 ? enclosed_[d - 1] : d == 0 ? enclosed_[c - 1] : common[(c - 1) * count + d - 1];
      });
      // The area of the lower end of a cylinder is that of the part that was cut off.
      if (i == j && !partition_.regions()[i].bounded) areas(i, j) = unknown_area;
    }
  }
  return areas;
}

TransportStep TransportSeries::next() {
  if (!reaches_next()) {
    throw DataError("transport: the manifolds do not reach far enough for n = " + std::to_string(n_ + 1));
  }
  advance();
  TransportStep step;
  step.n = n_;
  step.flux = RegionMatrix(partition_.size());
  for (std::size_t i = 0; i < partition_.size(); ++i) {
    for (std::size_t j = 0; j < partition_.size(); ++j) {
      step.flux(i, j) = partition_.combine(i, j, [&](std::size_t c, std::size_t d) { return gain(c, d); });
      total_(i, j) = total_(i, j) + step.flux(i, j);
    }
  }
  step.total = total_;
  step.overlaps = turnstiles_.front().overlaps(n_ - 1);
  step.by_boundaries = by_boundaries(n_);
  return step;
}

}  // namespace lober::detail
