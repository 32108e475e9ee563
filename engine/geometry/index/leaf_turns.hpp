// Where a leaf that turns back may meet itself (private to index/).
#pragma once

#include <cstdint>

#include "kernels/box.hpp"
#include "kernels/point.hpp"

namespace lober::detail {

/// Bit j is set unless segment j of a leaf certainly meets none before it in more than a common end. Folds end in
/// leaves that go one way along an axis and then the other; there most bits are clear.
[[nodiscard]] std::uint32_t segments_meeting_earlier(const Point* points, const Box& box);

}  // namespace lober::detail
