// The kernels that are compiled once for each instruction set, as one table a set (kernels/all.inl), and the table that
// runs.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/bent_slab.hpp"
#include "kernels/box_pyramid.hpp"
#include "kernels/common_run.hpp"
#include "kernels/cpu.hpp"
#include "kernels/crossing_parameters.hpp"
#include "kernels/fold_chart.hpp"
#include "kernels/frame_filter.hpp"
#include "kernels/graded.hpp"
#include "kernels/interpolation.hpp"
#include "kernels/leaf.hpp"
#include "kernels/moments.hpp"
#include "kernels/pair_filter.hpp"
#include "kernels/ray.hpp"
#include "kernels/sagitta.hpp"
#include "kernels/segment_boxes.hpp"
#include "kernels/segment_flags.hpp"
#include "kernels/shoelace.hpp"
#include "kernels/smooth_approach.hpp"
#include "kernels/smooth_segment.hpp"
#include "kernels/strip.hpp"
#include "kernels/turning.hpp"

namespace lober::detail {

/// Each is described where the function of its name is declared; those without one are parts of such functions.
struct KernelTable {
  RayProgress (*follow_ray)(Point point, const RayTree& tree, std::uint32_t level, std::uint32_t* list,
                            std::size_t count);
  HeightCrossings (*crossings_of_height)(const Point* points, Point point);
  void (*chebyshev_points)(const Point* coefficients, std::size_t degrees, double centre, double half_width,
                           const double* parameters, std::size_t size, Point* points);
  std::size_t (*common_vertices)(const Point* a, const Point* b, int direction, std::size_t count);
  unsigned (*eight_parameters)(const SegmentCrossing* crossings, double scale, CrossingParameters* parameters);
  void (*chart_leaf)(const Point* points, const Box& box, const Box& window, const FoldChart& chart,
                     ChartedLeaf& charted);
  void (*frames_of_leaves)(const Point* const* points, const Box* const* boxes, FourFrames& frames);
  void (*join_frames)(const FourFrames* const* below, const Chord* chords, const Box* const* boxes, FourFrames& frames);
  SplitCounts (*boxes_below_first)(BoxLevel first, BoxLevel second, const NodePair* pairs, std::size_t count, Keep keep,
                                   NodePair* kept, NodePair* split);
  SplitCounts (*boxes_below_second)(BoxLevel first, BoxLevel second, const NodePair* pairs, std::size_t count,
                                    Keep keep, NodePair* kept, NodePair* split);
  SplitCounts (*framed_below_first)(FramedLevel first, FramedLevel second, const NodePair* pairs, std::size_t count,
                                    Keep keep, NodePair* kept, NodePair* split);
  SplitCounts (*framed_below_second)(FramedLevel first, FramedLevel second, const NodePair* pairs, std::size_t count,
                                     Keep keep, NodePair* kept, NodePair* split);
  void (*subdivide)(const CubicPiece& piece, std::uint32_t parts, std::uint32_t first, std::uint32_t last, Point* out);
  void (*summarise_leaves)(const Point* points, std::size_t first, std::size_t count, Box* boxes, DD* sums,
                           std::uint8_t* flags);
  Moments (*moments_of_quarters)(const Point* points, std::size_t quarter, Point origin, double factor);
  void (*filter_pairs)(SegmentSource first, SegmentSource second, const SegmentPair* pairs, std::size_t count,
                       PairVerdict* verdicts);
  void (*twice_chord_areas)(const Point* points, std::size_t count, double* areas);
  void (*add_arc_measures)(const Point* points, std::size_t count, Point origin, ArcMeasures& sums);
  void (*segment_boxes)(const Point* points, SegmentBoxes& boxes);
  void (*bent_slab)(const Point* points, BentSlab& slab);
  std::uint32_t (*segments_meeting)(const BentSlab& slab, const Point* points);
  std::size_t (*meeting_segments)(const SegmentBoxes& a, std::uint32_t a_begin, const Point* b, const Box& b_box,
                                  std::uint32_t b_begin, SegmentPair* pairs, std::uint32_t wanted);
  DD (*shoelace_prefixes)(const Point* points, Point origin, DD start, const DD* extra, LeafPrefixes& prefixes);
  DD (*shoelace_of_leaf)(const Point* points, Point origin);
  void (*sums_at)(const LeafPrefixes& prefixes, const std::uint32_t* segments, const DD* t, std::size_t count,
                  DD* sums);
  void (*add_sines)(double* y, const double* x, double factor, std::size_t count);
  void (*leaf_strip)(const Point* points, Strip& strip);
  void (*join_strips)(const Strip* below, std::size_t count, Strip* above);
  std::size_t (*keep_near_strip)(const Strip* first, const Strip* second, NodePair* pairs, std::size_t count);
  void (*turns_along)(const Point* points, std::size_t segments, double* lengths, double* curvatures);
  void (*parts_needed)(const double* lengths, const double* curvatures, std::size_t count, PartsAsked asked,
                       double* parts);
  bool (*fit_smooth_segments)(const Point* const* windows, std::size_t count, SmoothSegment* segments);
  void (*approach_crossings)(SmoothPair* pairs, const std::uint32_t* numbers, std::size_t count,
                             const SmoothSegment* shapes1, const SmoothSegment* shapes2);
  void (*end_arcs)(const SmoothPair* pairs, std::size_t count, const SmoothSegment* shapes1,
                   const SmoothSegment* shapes2, EndOfArcs* ends);
  StraightSegments (*smooth_chord_areas)(const Point* points, std::size_t count, double* areas, double* errors,
                                         std::uint8_t* smooth);
  std::int64_t (*flag_segments)(const SegmentRow& row, const SegmentBounds& bounds, std::int64_t* flags);
  bool (*surely_fine)(const PointRow& row, const SegmentBounds& bounds, PartsAsked asked);
  LengthInBox (*length_in_box)(const Point* points, std::size_t count, const Box& box);
  void (*place_graded)(const GradedRow& row, double* places);
};

extern const KernelTable baseline_kernels, avx2_kernels, avx512_kernels;

/// The copies of the instruction set that runs (kernels/cpu.hpp).
[[nodiscard]] inline const KernelTable& kernels() noexcept {
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return avx512_kernels;
    case InstructionSet::avx2:
      return avx2_kernels;
    case InstructionSet::baseline:
      break;
  }
  return baseline_kernels;
}

}  // namespace lober::detail
