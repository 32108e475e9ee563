// Curves: points, closed and open ones that own or borrow them, their files, densification, and curves for drawings.
#pragma once

#include "lober/curve/curve.hpp"
#include "lober/curve/cylinders.hpp"
#include "lober/curve/densify.hpp"
#include "lober/curve/drawing.hpp"
#include "lober/curve/files.hpp"
#include "lober/curve/formats.hpp"
#include "lober/curve/periods.hpp"
#include "lober/curve/point.hpp"
#include "lober/curve/table_file.hpp"
#include "lober/curve/zone_names.hpp"
