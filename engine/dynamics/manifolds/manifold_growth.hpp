// A manifold grown piece by piece (private to engine/).
//
// Time on a manifold is counted in its own images (LocalManifold::image): the local manifold ends at time 0, its image
// under k of them at time k, and the point F^k(P(s)) has the time k + log(s / reach) / log(factor). A generation is
// traced in as many pieces of equal duration as keep the stretching in each below `stretching`: a saddle whose
// multiplier is 1e9 makes a curve of length 1e9 in one iterate, of which a tangle needs the first thousandth.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "engine/dynamics/manifolds/trace.hpp"
#include "lober/dynamics/manifolds.hpp"

namespace lober::detail {

class ManifoldGrowth {
 public:
  /// The map, the local manifold and the options must outlive it. No point lies beyond options.iterates and
  /// options.length, if they are set. Throws UsageError for a tolerance or for sizes that make no sense.
  ManifoldGrowth(const PlanarMap& map, const LocalManifold& local, Branch branch, const GrowthOptions& options);

  /// Grows on until the time is `end` or more (piece by piece: it is a multiple of piece() then), or something stops
  /// it. The same points, bit for bit, whether they are grown in one call or in several.
  GrowthStop grow_to(double end);
  /// Lets the curve end at this time, in its own images, where that is not the end of a piece: before any is grown.
  /// Growth stops there for good.
  void end_at(double end) { limit_ = std::min(limit_, std::max(end, 0.0)); }
  /// Puts points into segments of the curve, so that each becomes `parts`: images of parameters in between, as far as
  /// these can be told apart. Segments ascend and lie apart from tears. Returns the numbers of the new points,
  /// ascending; none when nothing can be gained or points run out. Cost: one pass over the curve.
  std::vector<std::size_t> refine(std::span<const std::uint32_t> segments, int parts);

  /// Time of the end of the curve; negative before anything has been grown.
  [[nodiscard]] double time() const { return std::min(time_at(pieces_done_), limit_); }
  /// Duration of a piece.
  [[nodiscard]] double piece() const { return 1.0 / pieces_; }
  /// The reason why it stopped; `iterates` as long as it can go on.
  [[nodiscard]] GrowthStop stop() const { return stop_; }
  /// Points that the piece would need that was not grown because max_points or max_images would be exceeded.
  [[nodiscard]] double points_needed() const { return points_needed_; }
  [[nodiscard]] GrownManifold& grown() { return result_; }
  [[nodiscard]] const GrownManifold& grown() const { return result_; }

 private:
  void set_up_tracing();
  [[nodiscard]] double time_at(int pieces) const { return static_cast<double>(pieces - 1) / pieces_; }
  [[nodiscard]] double part_begin(int part) const;
  void grow_piece();
  // Points of the generation before, which show how a section of this one bends.
  struct Guide {
    std::span<const double> parameters;
    std::span<const Point> points;
    Beyond beyond;
  };
  void link(std::vector<Guide>& guides, int generation, int part);
  [[nodiscard]] Point local_point(double parameter) const;
  static void split(const Samples& samples, std::vector<Guide>& guides);
  /// The size of the result.
  struct Size {
    std::size_t points, diagnostics, generations;
    double length;
  };
  [[nodiscard]] Size size() const;
  void make_room_for(std::size_t points);
  void cut_back_to(const Size& before);
  void end_generation();
  [[nodiscard]] CurveFunction image(int generation) const;
  // Told of steps of the map; may throw to cancel.
  using Counted = std::function<void(std::uint64_t steps)>;
  void count(std::uint64_t steps);
  [[nodiscard]] GrowthProgress so_far() const;
  void report(const GrowthProgress& progress) const;
  // Evaluations of the vector field so far; any thread may ask.
  [[nodiscard]] double map_work() const;
  [[nodiscard]] bool out_of_work() const;
  [[nodiscard]] Samples first_guide(double end) const;
  // For a section; a trace may end where it is so long.
  struct Limits {
    std::size_t points;
    double length;
  };
  [[nodiscard]] Limits limits_left(int generation) const;
  [[nodiscard]] Samples part_of_local(const Samples& samples, int part) const;
  [[nodiscard]] Samples carried(const Guide& guide, int generation, double end, Beyond& beyond,
                                const Counted& counted) const;
  [[nodiscard]] Trace traced_section(const Guide& guide, int generation, double end, const Limits& limits,
                                     const Counted& counted) const;
  [[nodiscard]] std::optional<Trace> traced_within_limits(const Guide& guide, int generation, double end);
  [[nodiscard]] std::vector<Samples> appended_together(std::span<const Guide> guides, int generation, double end);
  [[nodiscard]] bool append(const Trace& trace, int generation);
  [[nodiscard]] double counted_length(const Point* points, std::size_t count) const;
  void add_length(std::size_t begin);
  void end_at_length(int generation);
  [[nodiscard]] Samples kept_as_guide(Samples samples, int generation);
  [[nodiscard]] bool is_alive(const Samples& samples) const;
  void add_to_generation(const Samples& samples);

  const PlanarMap& map_;
  const LocalManifold& local_;
  const GrowthOptions& options_;
  double side_;
  std::uint64_t work_before_;
  int steps_ = 1;
  double ratio_ = 1;  // ratio of the parameters at the ends of a fundamental segment
  int pieces_ = 1;    // pieces of a generation
  TraceOptions trace_options_;
  Box range_;  // where the manifold is followed on: the box, with what is about the saddle if that lies outside
  std::size_t max_points_ = 0;

  double limit_ = std::numeric_limits<double>::infinity();  // limit of time, from options.iterates

  int pieces_done_ = 0;          // the local manifold is the first
  std::size_t generations_ = 0;  // begun
  // The sections in which each piece of the generation before and of this one was traced; parameters > 0.
  std::vector<std::vector<Samples>> previous_, current_;
  // The second point of the guides of a generation, and the last but one of those of the piece before this one.
  Point second_, last_but_one_;
  double stretched_ = 1;          // points of the piece that was grown last for each of its guides
  bool goes_on_ = false;          // whether any of this generation is left to grow
  double generation_length_ = 0;  // up to the tolerance; no more is asked
  int short_generations_ = 0;
  GrowthStop stop_ = GrowthStop::iterates;
  double points_needed_ = 0;
  GrownManifold result_;
};

}  // namespace lober::detail
