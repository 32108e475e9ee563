// The bottlenecks of a well with their tubes, from which curves are cut (private to escape/).
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/base/text.hpp"
#include "engine/dynamics/escape/cut_images.hpp"
#include "lober/base/error.hpp"
#include "lober/overlay/smooth.hpp"
#include "lober/transport/escape.hpp"

namespace lober::detail {

// Cut images are measured as polygons and end where a strip is cut off: they need not be as fine as whole ones.
inline constexpr double cut_coarseness = 10;
// Trajectories that are followed for each point of a curve: those that show where points are needed, and the points.
inline constexpr double evaluations_a_point = 2;

// The work under way: when all is expected to be done, by a watch, and the work that all curves may take
// (PlanarMap::work).
struct EscapeWork {
  double end;
  Stopwatch watch;
  double left = std::numeric_limits<double>::infinity();
};

// The middles of `count` equal parts of [0, 1].
template <std::size_t count>
std::array<double, count> middles() {
  std::array<double, count> u{};
  for (std::size_t k = 0; k < count; ++k) u[k] = (static_cast<double>(k) + 0.5) / count;
  return u;
}

// Reports the step being done, from any thread, one at a time.
class Reporter {
 public:
  explicit Reporter(const EscapeOptions& options) : options_(options) {}
  void begin(const EscapeWork& work) {
    work_ = work;
    (*this)("tubes");
  }
  void operator()(const std::string& what) const {
    if (!options_.progress) return;
    const std::lock_guard lock(mutex_);
    const double now = work_.watch.seconds();
    const double fraction = work_.end > 0 ? std::min(now / work_.end, 0.99) : 0;
    if (!options_.progress(fraction, what)) {
      refused_ = true;
      throw Cancelled();
    }
  }
  /// Whether the caller's progress has said no.
  [[nodiscard]] bool refused() const { return refused_; }

 private:
  const EscapeOptions& options_;
  EscapeWork work_{};
  mutable std::mutex mutex_;
  mutable std::atomic<bool> refused_{false};
};

class Bottlenecks {
 public:
  Bottlenecks(const Flow& flow, const Section& cut_by, double energy, std::span<const FlowState> guesses,
              const EscapeOptions& options);

  std::vector<Bottleneck> list;

  // Saddles below the energy that are none of these, by the coordinate across the section.
  [[nodiscard]] std::vector<SaddlePoint> also_open() const;

  // E and X. A curve is closed only if every trajectory gets to the section: a few show before points are put in
  // vain next to those that do not, as beside a collision.
  void cut_first();

  // One more image of every E and of every X that has fewer than so many: whole as long as the image before meets no
  // end of the well, which cuts the next one; cut ones only if asked for.
  void carry(int images, bool cut_too, const EscapeWork& work);

  // Expected needs of the next images: points of the largest one, crossings of trajectories of all; whether not even
  // cutting can be afforded.
  struct Ahead {
    double points = 0, crossings = 0;
    bool too_much = false;
  };
  // Whole images grow by a factor much like the one before. Cut ones do not, but how many trajectories one takes to
  // begin with shows once the image before it is cut, which is done here if they are wanted, with the work that is
  // left.
  [[nodiscard]] Ahead look_ahead(int images, bool cut_too, double left);
  // Crossings of trajectories that were followed for the curves so far, and the work of it (PlanarMap::work).
  [[nodiscard]] double crossings_so_far() const;
  [[nodiscard]] double work_so_far() const;

  [[noreturn]] void throw_outside() const;

  // Whether the caller's progress has cancelled.
  [[nodiscard]] bool refused() const { return report_.refused(); }

  // Whether a tube could not be carried on because that takes too much work, or too many points.
  [[nodiscard]] bool out_of_work() const;
  [[nodiscard]] bool out_of_points() const;

 private:
  // The share that each curve may take of the work that is left: one may need more than the others do.
  [[nodiscard]] double share_of(double left) const { return 2 * left / static_cast<double>(carried_.size()); }

  // The curves that have been cut from a tube.
  struct Carried {
    std::vector<TubeCurve>* curves;
    Branch branch;
    std::unique_ptr<CutImages> cutting;                              // once one is cut
    bool ended = false, out_of_points = false, out_of_work = false;  // the next one cannot be found
    double work = 0;                                                 // work of whole curves
  };

  // E and X of every bottleneck, and what cut images need.
  void find_ends();

  // A tube whose image is far larger than the flow allows, and all of whose trajectories are lost, does not enter the
  // well: the section has met its branch on the other side of the bottleneck first.
  void require_in_well(std::size_t k) const;

  // Name of tube k: "the unstable tube of the bottleneck (1, 0.5)".
  [[nodiscard]] std::string name_of_tube(std::size_t k) const;

  // Advice for a section or saddles that do not serve.
  [[nodiscard]] std::string way_on() const;

  // Saddles of rank 1 below the energy, by Newton's method from a grid about the named ones: a help for a message.
  [[nodiscard]] std::vector<SaddlePoint> open_saddles() const;

  void carry_one(std::size_t k, bool cut_too);

  // Its images are cut from the next one on.
  void begin_cutting(std::size_t k);

  [[nodiscard]] bool meets_an_end(const TubeCurve& curve, bool entry) const;

  [[nodiscard]] CutImageOptions cut_image_options() const;

  static std::string name_of_saddle(const SaddlePoint& saddle);

  // All bottlenecks are open, or there is nothing to escape by.
  static void require_energy_above(std::span<const SaddlePoint> saddles, double energy);

  // Orbits shrink with the square root of the energy above the saddle, which is a difference of rounded numbers.
  static double least_energy(const SaddlePoint& saddle);
  static std::string text_of_least(const SaddlePoint& saddle) { return format_rounded(least_energy(saddle), 9); }
  // A failure near a saddle's energy is put down to that.
  template <typename Function>
  static void near_saddle(const SaddlePoint& saddle, double energy, const Function& function) {
    try {
      function();
    } catch (const DataError& error) {
      const double least = least_energy(saddle);
      throw DataError("at the energy " + format_number(energy) + ", " + format_rounded(energy - saddle.energy) +
                      " above that of the saddle " + name_of_saddle(saddle) + ", " + format_number(saddle.energy) +
                      ": " + error.what() +
                      (energy < least ? "; orbits so near to the saddle are lost in rounding: energies from about " +
                                            text_of_least(saddle) + " on can be used"
                                      : ""));
    }
  }

  void find_orbits(std::span<const FlowState> guesses, double energy);

  // Trajectories beside an orbit that crosses the section cross it too, turn after turn: their crossings do not count
  // what enters the well.
  void require_off_section() const;

  void find_tubes();

  // Calls body(k) for tube k = 2 * bottleneck + (0: unstable, 1: stable), in parallel.
  template <typename Body>
  void for_each_tube(const Body& body) {
    for_each_block(carried_.size(), 1, [&](std::size_t k, std::size_t) { body(k); });
  }

  void measure_defects();

  const Flow& flow_;
  Section section_;
  const EscapeOptions& options_;
  Reporter report_;
  std::vector<std::optional<Tube>> tubes_;
  std::vector<Carried> carried_;
  std::vector<TubeCurve> entries_, exits_;  // E and X of all
  std::vector<BottleneckTubes> ends_;
  TubeCurveOptions tracing_;
  double least_area_ = std::numeric_limits<double>::infinity();
};

}  // namespace lober::detail
