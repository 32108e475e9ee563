// The curves that an operation is given (private to operations/).
#pragma once

#include <span>

#include "engine/operations/option_list.hpp"

namespace lober::detail::table {

/// How::index.
template <typename How>
OptionList<How>& add_index_option(OptionList<How>& list) {
  return list.choice("index", &How::index, all_index_kinds,
                     "index that proposes which segments can meet; the results do not depend on it");
}

/// Throws UsageError unless there are as many inputs as the operation takes, each of its kind. Operations are called
/// with such inputs only (table.cpp).
void require_inputs(const operations::Operation& operation, std::span<const operations::Input> inputs);

/// Input number k, which is a curve or points, as a curve; one that may be open (InputKind::curve) stays so. Throws
/// DataError naming the input.
[[nodiscard]] CurveView curve_at(const operations::Operation& operation, std::span<const operations::Input> inputs,
                                 std::size_t k, bool closed);
/// Input number k, which is a curve or points, as that curve with its index. A curve whose index is given has been
/// validated; others are, DataError naming the input.
[[nodiscard]] IndexedCurve indexed_curve(const operations::Operation& operation,
                                         std::span<const operations::Input> inputs, std::size_t k);
/// Whether the index of input number k is given.
[[nodiscard]] bool is_indexed(std::span<const operations::Input> inputs, std::size_t k);
/// Whether input number k is known to be simple.
[[nodiscard]] bool known_simple(std::span<const operations::Input> inputs, std::size_t k);
/// The sums of input number k for the estimate of the discretisation, where they are known; else null.
[[nodiscard]] const DiscretisationSums* known_sums(std::span<const operations::Input> inputs, std::size_t k);
/// Input number k, which is points. Throws DataError for one that is not finite.
[[nodiscard]] std::span<const Point> points_at(const operations::Operation& operation,
                                               std::span<const operations::Input> inputs, std::size_t k);

}  // namespace lober::detail::table
