// Names that the examples in the comments of public headers use as if the reader had them.
#pragma once

#include <atomic>

#include "lober/curve/curve.hpp"
#include "lober/dynamics/flow.hpp"
#include "lober/dynamics/planar_map.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/overlay/overlay.hpp"

#define EXAMPLE_NAMES                                                                                              \
  const lober::ClosedCurve &c1, const lober::ClosedCurve &c2, const lober::ClosedCurve &curve, lober::Point point, \
      const lober::ClosedCurve &first, const lober::ClosedCurve &second, const lober::OpenCurve &u,                \
      const lober::OpenCurve &s, const lober::PlanarMap &map, lober::Point saddle, const lober::Flow &flow,        \
      double time, const lober::Rectangle &window, double energy

template <typename... Values>
void use(const Values&...) {}
template <typename Points>
void draw(const Points&) {}
