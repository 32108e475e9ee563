// Callbacks that throw or ask to stop, at any instant: the caller gets the exception, and the next call is as good as
// if nothing had been.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "lober/curve/densify.hpp"
#include "lober/dynamics/manifolds.hpp"
#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"
#include "lober/tangle/tangle.hpp"
#include "tests/oracle/random.hpp"
#include "tests/shapes.hpp"
#include "tests/views.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

using Callback = std::function<bool(double)>;

const Points wavy1 = wavy_circle(4000, 0.1, 40), wavy2 = wavy_circle(3000, 0.1, 30, 0.1);

// U and S that cross a thousand times.
Points sine_line() {
  Points points;
  for (int k = 0; k <= 5000; ++k) points.push_back({0.004 * k, std::sin(0.6 * k)});
  return points;
}
const Points unstable = sine_line(), stable{{30, 0.25}, {-1, 0.25}};

// A function with a callback; what it gives in a few numbers.
struct CallbackFunction {
  const char* name;
  std::function<std::vector<double>(const Callback&)> call;
};

const std::vector<CallbackFunction>& callback_functions() {
  static const std::vector<CallbackFunction> all{
      {"overlay",
       [](const Callback& progress) {
         OverlayOptions options;
         options.progress = progress;
         const Overlay result = overlay(CurveView{wavy1}, CurveView{wavy2}, options);
         return std::vector{result.areas.union_, result.areas.c1_minus_c2, static_cast<double>(result.nodes.size())};
       }},
      {"interior_areas",
       [](const Callback& progress) {
         InteriorOptions options;
         options.progress = progress;
         const InteriorAreas result = interior_areas(CurveView{wavy1}, CurveView{wavy2}, options);
         return std::vector{result.areas.union_, result.areas.c1_minus_c2, result.q1};
       }},
      {"regions",
       [](const Callback& progress) {
         RegionOptions options;
         options.progress = progress;
         const Regions result = regions(CurveView{wavy1}, CurveView{wavy2}, options);
         return std::vector{result.areas(FillRule::nonzero).union_, static_cast<double>(result.counts().nodes)};
       }},
      {"tangle",
       [](const Callback& progress) {
         TangleOptions options;
         options.progress = progress;
         const Tangle result = tangle(CurveView{unstable, false}, CurveView{stable, false}, options);
         return std::vector{static_cast<double>(result.pips.size()), static_cast<double>(result.nodes.size()),
                            result.lobes.at(0).area};
       }},
  };
  return all;
}

struct Mine : std::runtime_error {
  Mine() : std::runtime_error("mine") {}
};

int calls_of(const CallbackFunction& function) {
  int calls = 0;
  (void)function.call([&](double) { return ++calls > 0; });
  return calls;
}

TEST(Callbacks, WhatOneThrowsReachesTheCallerWhereverItIs) {
  for (const CallbackFunction& function : callback_functions()) {
    const std::vector<double> expected = function.call({});
    const int calls = calls_of(function);
    EXPECT_GE(calls, 3) << function.name;
    for (int at = 1; at <= calls; ++at) {
      int call = 0;
      const Callback throwing = [&](double) {
        if (++call == at) throw Mine();
        return true;
      };
      EXPECT_THROW((void)function.call(throwing), Mine) << function.name << " " << at;
      EXPECT_EQ(call, at) << "called again after it threw";
    }
    EXPECT_EQ(function.call({}), expected) << function.name;
  }
}

TEST(Callbacks, FractionsAscendFromZeroToOne) {
  for (const CallbackFunction& function : callback_functions()) {
    std::vector<double> seen;
    (void)function.call([&](double fraction) {
      seen.push_back(fraction);
      return true;
    });
    EXPECT_EQ(seen.front(), 0) << function.name;
    EXPECT_EQ(seen.back(), 1) << function.name;
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end())) << function.name;
  }
}

TEST(Callbacks, AskingToStopGivesCancelledWhereverItIs) {
  for (const CallbackFunction& function : callback_functions()) {
    const int calls = calls_of(function);
    for (int at = 1; at <= calls; ++at) {
      int call = 0;
      EXPECT_THROW((void)function.call([&](double) { return ++call < at; }), Cancelled) << function.name << " " << at;
      EXPECT_EQ(call, at);
    }
  }
}

// From another thread, at any instant: the call is cancelled or gives what it always gives.
TEST(Callbacks, CancellationAtRandomInstantsLeavesResultsAlone) {
  oracle::Random random(7);
  for (const CallbackFunction& function : callback_functions()) {
    const std::vector<double> expected = function.call({});
    int cancelled = 0, finished = 0;
    for (int attempt = 0; attempt < 12; ++attempt) {
      std::atomic<bool> stop{false};
      std::thread other([&, wait = random.integer(0, 5000)] {
        std::this_thread::sleep_for(std::chrono::microseconds(wait));
        stop = true;
      });
      try {
        EXPECT_EQ(function.call([&](double) { return !stop; }), expected) << function.name;
        ++finished;
      } catch (const Cancelled&) {
        ++cancelled;
      }
      other.join();
    }
    EXPECT_EQ(cancelled + finished, 12);
    EXPECT_EQ(function.call({}), expected) << function.name;
  }
}

// The function of a curve runs in many threads at a time.
TEST(Callbacks, WhatTheFunctionOfACurveThrowsReachesTheCaller) {
  const auto circle = [](int, std::span<const double> t, std::span<Point> points) {
    for (std::size_t k = 0; k < t.size(); ++k) points[k] = {std::cos(t[k]), std::sin(t[k])};
  };
  const std::array<double, 2> ends{0, 2 * std::numbers::pi};
  const ImageOptions options{.tolerance = 1e-9};
  const auto once = [](const CurveImage&) { return false; };
  const std::size_t expected = images_of(circle, ends, options, once)[0].points.size();
  for (const int at : {1, 2, 5}) {
    std::atomic<int> calls{0};
    const auto throwing = [&](int curve, std::span<const double> t, std::span<Point> points) {
      if (++calls == at) throw Mine();
      circle(curve, t, points);
    };
    EXPECT_THROW((void)images_of(throwing, ends, options, once), Mine) << at;
  }
  EXPECT_EQ(images_of(circle, ends, options, once)[0].points.size(), expected);
}

}  // namespace
}  // namespace lober::test
