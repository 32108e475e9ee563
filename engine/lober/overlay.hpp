// Two curves together: where they cross, the lobes between them and their areas, by polygons and by smooth curves, and
// for curves that cross themselves the regions by winding numbers.
#pragma once

#include "lober/overlay/areas.hpp"
#include "lober/overlay/counts.hpp"
#include "lober/overlay/crossings.hpp"
#include "lober/overlay/index.hpp"
#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlap_matrix.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"
#include "lober/overlay/segment_pair.hpp"
#include "lober/overlay/smooth.hpp"
