// Common areas of the insides of boundaries and of their images, row after row (private to transport/).
//
// Rows share work: on a cylinder row n takes the loops from q to f^m(q) and from q to f^-k(q), m + k = n, and row n + 1
// one of them again, each with the insides of all boundaries (cylinder.hpp).
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "engine/dynamics/transport/turnstile/cylinder.hpp"

namespace lober::detail {

class InsidesInCommon {
 public:
  /// f^m(c) and f^n(d), by the numbers of boundaries. `at_rest` is their common area for m = n = 0, and not used in the
  /// plane.
  struct Pair {
    std::size_t c, d;
    int m, n;
    Measured at_rest;
  };
  /// The common area of the insides of each pair; of those that run round only differences mean something. The
  /// boundaries are those of the call before, or grown farther. The same bits as without a call before.
  [[nodiscard]] std::vector<Measured> of(std::span<const Barrier* const> barriers, std::span<const Pair> pairs);
  /// The number of loops taken with the inside of a boundary so far.
  [[nodiscard]] std::size_t loops_taken() const { return loops_taken_; }

 private:
  // The inside of f^n(B(q)) less that of B(q): winding numbers of a loop, with a sign.
  struct Change {
    std::size_t barrier = 0;
    int images = 0;
    int sign = 1;
    std::shared_ptr<const std::vector<Point>> loop;  // the same object as in the row before if it has the same points
  };
  struct Taken {
    std::shared_ptr<const std::vector<Point>> loop;
    std::size_t inside = 0;
    ProductOnCylinder product;
  };

  [[nodiscard]] static Change change_after(std::span<const Barrier* const> barriers, std::size_t number, int images);
  [[nodiscard]] std::vector<Change> changes_of(std::span<const Barrier* const> barriers,
                                               std::span<const Pair> pairs) const;
  void forget_what_changed(std::span<const Barrier* const> barriers);

  std::vector<std::vector<Point>> outlines_;  // outlines of the boundaries, as insides
  std::vector<Change> changes_;               // changes of the last row
  std::vector<Taken> taken_;                  // likewise
  std::size_t loops_taken_ = 0;
};

}  // namespace lober::detail
