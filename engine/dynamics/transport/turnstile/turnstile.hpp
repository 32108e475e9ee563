// The turnstile of a boundary: the lobes through which all fluid crosses it.
//
// With c the function that is 1 inside B(q) and 0 outside, g = c - c o f is 1 on L12(1), which leaves in the next step,
// -1 on L21(1), which comes in, and 0 elsewhere. It is also the sum of the functions of the lobes from f^-1(q) to q,
// with a sign each, however these overlap one another or loop: B(f^-1(q)) becomes B(q) lobe by lobe. So
//   mu(L12(1)) = (int g^2 + int g) / 2,   mu(L21(1)) = (int g^2 - int g) / 2,
// and with two boundaries c, d the common area C(n) = int c o f^-n d obeys (Rom-Kedar & Wiggins 1990, in other words)
//   C(n + 1) - 2 C(n) + C(n - 1) = - int g_c o f^-n g_d,   n >= 1:
// four sums of overlaps, of L12(1) and L21(1) of c, carried n steps on, with L12(1) and L21(1) of d.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/dynamics/transport/tangles/barrier.hpp"

namespace lober::detail {

/// int g o f^-m g.
[[nodiscard]] inline Measured balance(const TurnstileOverlaps& common) {
  return common[0][0] - common[0][1] - common[1][0] + common[1][1];
}

class Turnstile {
 public:
  /// Needs the lobes from f^-1(q) to q. One pass over the crossings. Throws DataError without them.
  explicit Turnstile(Barrier barrier);

  [[nodiscard]] const Barrier& barrier() const { return barrier_; }
  /// mu(L12(1)) and mu(L21(1)).
  [[nodiscard]] Measured flux12() const;
  [[nodiscard]] Measured flux21() const;
  /// Sums of the areas of the lobes that leave and that enter, each counted fully.
  [[nodiscard]] Measured lobe_area12() const { return lobe_area(true); }
  [[nodiscard]] Measured lobe_area21() const { return lobe_area(false); }
  /// Numbers of the lobes of L12(1) (leaving) or L21(1).
  [[nodiscard]] const std::vector<std::size_t>& lobes(bool leaving) const { return lobes_[leaving ? 0 : 1]; }
  [[nodiscard]] std::size_t moved(std::size_t lobe, int images) const {
    return lobe + static_cast<std::size_t>(static_cast<std::ptrdiff_t>(barrier_.period) * images);
  }

  /// Whether the curves reach far enough for overlaps(m).
  [[nodiscard]] bool reaches(int m) const { return m <= barrier_.images_before() - 1 + barrier_.images_after(); }
  /// The four sums; f may be applied to both sides of an intersection as often as one likes, so that no lobe is
  /// followed for longer than need be.
  [[nodiscard]] TurnstileOverlaps overlaps(int m) const;

 private:
  [[nodiscard]] Measured common(std::size_t i, std::size_t j) const;
  [[nodiscard]] Measured area(std::size_t lobe) const;
  [[nodiscard]] Measured lobe_area(bool leaving) const;
  [[nodiscard]] double area_here(std::size_t lobe) const;
  [[nodiscard]] Measured within_reason(Measured common, std::size_t i, std::size_t j) const;

  Barrier barrier_;
  std::array<std::vector<std::size_t>, 2> lobes_;
  std::vector<LobeOverlap> common_;
  std::vector<bool> far_;  // by lobe: whether it leaves Barrier::fine; empty where that is everywhere
};

/// How many images back the first of two sets goes when f^m of the second meets it, of `before` and `after` that there
/// are: half of m as far as possible.
[[nodiscard]] int split_images(int m, int before, int after);

/// int g_c o f^-m g_d of two different boundaries: overlays of their lobes.
[[nodiscard]] Measured balance(const Turnstile& c, const Turnstile& d, int m);
/// int (c o f^-1 - c) d: what of the lobes of c, once they have passed its boundary, lies inside that of d.
[[nodiscard]] Measured first_gain(const Turnstile& c, const Turnstile& d);

}  // namespace lober::detail
