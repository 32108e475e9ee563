// All methods that are compared in lanes.
#pragma once

#include "bench/integrators/dormand_prince.hpp"
#include "bench/integrators/extrapolated_midpoint.hpp"
#include "bench/integrators/fehlberg.hpp"
#include "bench/integrators/runge_kutta.hpp"
#include "bench/integrators/taylor.hpp"

namespace lober::bench {

template <typename... Methods>
struct MethodList {};

using LaneMethods =
    MethodList<RungeKutta<Fehlberg>, RungeKutta<DormandPrince>, ExtrapolatedMidpoint<5>, ExtrapolatedMidpoint<6>,
               ExtrapolatedMidpoint<7>, Taylor<12>, Taylor<16>, Taylor<20>, Taylor<24>>;

}  // namespace lober::bench
