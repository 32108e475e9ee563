// The curves of tubes on the section, image by image.
#include "engine/dynamics/escape/bottlenecks.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/growth_forecast.hpp"
#include "engine/base/quantities.hpp"

namespace lober::detail {

Bottlenecks::Bottlenecks(const Flow& flow, const Section& cut_by, double energy, std::span<const FlowState> guesses,
                         const EscapeOptions& options)
    : flow_(flow), section_(cut_by), options_(options), report_(options) {
  find_orbits(guesses, energy);
  require_off_section();
  find_tubes();
}

void Bottlenecks::cut_first() {
  constexpr std::size_t samples = 512;
  for_each_tube([&](std::size_t k) {
    Carried& tube = carried_[k];
    std::array<FlowState, samples> states;
    tubes_[k]->crossings(tube.branch, section_, 1, middles<samples>(), states);
    const auto require_closed = [&](bool closed) {
      if (!closed) throw DataError(name_of_tube(k) + " does not reach the section as a closed curve. " + way_on());
    };
    require_closed(std::all_of(states.begin(), states.end(), [](const FlowState& x) { return std::isfinite(x[0]); }));
    tube.curves->push_back(tubes_[k]->curve(tube.branch, section_, 1, nullptr, tracing_));
    if (tube.curves->back().image.stop == GrowthStop::points) {
      throw DataError(name_of_tube(k) + " takes more points than the " + std::string(quantity::points) + " allows, " +
                      std::to_string(tracing_.max_points));
    }
    require_closed(tube.curves->back().complete);
  });
  measure_defects();
}

void Bottlenecks::carry(int images, bool cut_too, const EscapeWork& work) {
  report_.begin(work);
  // One may need more than the others do: half of the rest for each pair of them.
  const double for_one = 2 * work.crossings_left / static_cast<double>(carried_.size());
  const double affordable = std::max(for_one / (evaluations_a_point * (images + 1)), 2.0);
  const bool fewer = affordable < static_cast<double>(options_.max_points);
  tracing_.max_points = fewer ? static_cast<std::size_t>(affordable) : options_.max_points;
  if (ends_.empty()) find_ends();
  for_each_tube([&](std::size_t k) {
    if (static_cast<int>(carried_[k].curves->size()) <= images) carry_one(k, cut_too);
  });
  measure_defects();
  for (std::size_t k = 0; k < carried_.size(); ++k) require_in_well(k);
}

Bottlenecks::Ahead Bottlenecks::look_ahead(int images, bool cut_too) {
  if (ends_.empty()) find_ends();
  std::vector<double> points(carried_.size(), 0);
  for_each_tube([&](std::size_t k) {
    Carried& tube = carried_[k];
    if (static_cast<int>(tube.curves->size()) > images || tube.ended) return;
    const TubeCurve& last = tube.curves->back();
    if (last.direction == 0) throw DataError("a tube crosses the section in both directions");
    const bool cut = tube.cutting != nullptr || meets_an_end(last, k % 2 == 0);
    if (cut && !cut_too) return;
    if (cut) {
      if (tube.cutting == nullptr) begin_cutting(k);
      points[k] = static_cast<double>(tube.cutting->prepare());
    } else {
      GrowthForecast forecast;
      for (const TubeCurve& curve : *tube.curves) forecast.add(static_cast<double>(curve.image.points.size()));
      points[k] = forecast.next();
    }
  });
  Ahead ahead;
  for (const double here : points) {
    ahead.points = std::max(ahead.points, here);
    ahead.crossings += evaluations_a_point * here * (images + 1);
  }
  return ahead;
}

double Bottlenecks::crossings_so_far() const {
  double sum = 0;
  for (const Carried& tube : carried_) {
    for (std::size_t k = 0; k < tube.curves->size(); ++k) {
      sum += static_cast<double>((*tube.curves)[k].image.images) * static_cast<double>(k + 1);
    }
  }
  return sum;
}

bool Bottlenecks::out_of_points() const {
  return std::any_of(carried_.begin(), carried_.end(), [](const Carried& tube) { return tube.out_of_points; });
}

void Bottlenecks::find_ends() {
  for (const Bottleneck& bottleneck : list) {
    exits_.push_back(bottleneck.exit[0]);
    entries_.push_back(bottleneck.entry[0]);
  }
  for (std::size_t k = 0; k < list.size(); ++k) {
    ends_.push_back({&*tubes_[2 * k], &*tubes_[2 * k + 1], list[k].entry_branch, list[k].exit_branch,
                     list[k].exit[0].direction, list[k].entry[0].direction});
  }
}

void Bottlenecks::require_in_well(std::size_t k) const {
  const Carried& tube = carried_[k];
  const Bottleneck& bottleneck = list[k / 2];
  const TubeCurve& last = tube.curves->back();
  if (tube.curves->size() < 2 || !last.complete || last.area < 2 * bottleneck.area) return;
  constexpr std::size_t samples = 64;
  std::array<FlowState, samples> states;
  tubes_[k]->begin(tube.branch, middles<samples>(), states);
  const double time = (k % 2 == 0 ? 1 : -1) * options_.integration.max_time;
  flow_.integrate(states, 0, time, options_.integration);
  if (std::any_of(states.begin(), states.end(), [](const FlowState& x) { return std::isfinite(x[0]); })) return;
  throw DataError(name_of_tube(k) + " runs to infinity: its image " + std::to_string(tube.curves->size() - 1) +
                  " has the area " + format_rounded(last.area) + " instead of " + format_rounded(bottleneck.area) +
                  ", and all of " + std::to_string(samples) + " trajectories are lost. " + way_on());
}

void Bottlenecks::carry_one(std::size_t k, bool cut_too) {
  Carried& tube = carried_[k];
  if (tube.ended) return;
  const int images = static_cast<int>(tube.curves->size());
  const TubeCurve& last = tube.curves->back();
  if (tube.cutting == nullptr) {
    if (last.direction == 0) throw DataError("a tube crosses the section in both directions");
    if (!meets_an_end(last, k % 2 == 0)) {
      TubeCurve next = tubes_[k]->curve(tube.branch, section_, images + 1, &last, tracing_);
      tube.out_of_points = next.image.stop == GrowthStop::points;
      tube.ended = tube.out_of_points;
      if (next.complete) tube.curves->push_back(std::move(next));
      if (tube.ended || static_cast<int>(tube.curves->size()) > images) return;
    }
    if (!cut_too) return;
    begin_cutting(k);
  }
  if (!cut_too) return;
  std::optional<TubeCurve> next = tube.cutting->next();
  if (next) {
    tube.curves->push_back(std::move(*next));
  } else {
    tube.ended = true;
    tube.out_of_points = tube.cutting->out_of_points();
  }
}

void Bottlenecks::begin_cutting(std::size_t k) {
  Carried& tube = carried_[k];
  try {
    tube.cutting = std::make_unique<CutImages>(flow_, section_, ends_, k / 2, k % 2 == 0, tube.curves->back(),
                                               static_cast<int>(tube.curves->size()) - 1, options_.integration,
                                               cut_image_options());
  } catch (const DataError& error) {
    throw DataError(std::string(error.what()) + ". " + way_on());
  }
}

bool Bottlenecks::meets_an_end(const TubeCurve& curve, bool entry) const {
  const std::vector<TubeCurve>& ends = entry ? exits_ : entries_;
  return std::any_of(ends.begin(), ends.end(), [&](const TubeCurve& exit) {
    return exit.direction == curve.direction && common_area(curve.view(), exit.view()).area > 0;
  });
}

CutImageOptions Bottlenecks::cut_image_options() const {
  CutImageOptions cut;
  cut.tracing = tracing_;
  cut.tracing.tolerance *= cut_coarseness;
  cut.strip = options_.strip * least_area_;
  cut.area = least_area_;
  return cut;
}

void Bottlenecks::measure_defects() {
  for (Bottleneck& bottleneck : list) {
    bottleneck.area_defect = 0;
    for (const auto* curves : {&bottleneck.entry, &bottleneck.exit}) {
      for (const TubeCurve& curve : *curves) {
        if (!curve.complete) continue;
        bottleneck.area_defect = std::max(bottleneck.area_defect, std::fabs(curve.area / bottleneck.area - 1));
      }
    }
  }
}

}  // namespace lober::detail
