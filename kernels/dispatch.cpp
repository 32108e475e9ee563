// The functions of kernels that have a copy for each instruction set: each calls the copy that runs.
#include <array>

#include "kernels/kernel_table.hpp"
#include "kernels/sine.hpp"

namespace lober::detail {

static_assert(leaf_size == 32, "a leaf's segments are the bits of a 32-bit word");

RayProgress follow_ray(Point point, const RayTree& tree, std::uint32_t level, std::uint32_t* list, std::size_t count) {
  return kernels().follow_ray(point, tree, level, list, count);
}

HeightCrossings crossings_of_height(const Point* points, Point point) {
  return kernels().crossings_of_height(points, point);
}

std::size_t common_vertices(const Point* a, const Point* b, int direction, std::size_t count) {
  return kernels().common_vertices(a, b, direction, count);
}

void chart_leaf(const Point* points, const Box& box, const Box& window, const FoldChart& chart, ChartedLeaf& charted) {
  kernels().chart_leaf(points, box, window, chart, charted);
}

void frames_of_leaves(const std::array<const Point*, nodes_at_once>& points,
                      const std::array<const Box*, nodes_at_once>& boxes, FourFrames& frames) {
  kernels().frames_of_leaves(points.data(), boxes.data(), frames);
}

void join_frames(const std::array<const FourFrames*, nodes_at_once>& below,
                 const std::array<Chord, nodes_at_once>& chords, const std::array<const Box*, nodes_at_once>& boxes,
                 FourFrames& frames) {
  kernels().join_frames(below.data(), chords.data(), boxes.data(), frames);
}

SplitCounts pairs_below_first(BoxLevel first, BoxLevel second, const NodePair* pairs, std::size_t count, Keep keep,
                              NodePair* kept, NodePair* split) {
  return kernels().boxes_below_first(first, second, pairs, count, keep, kept, split);
}

SplitCounts pairs_below_second(BoxLevel first, BoxLevel second, const NodePair* pairs, std::size_t count, Keep keep,
                               NodePair* kept, NodePair* split) {
  return kernels().boxes_below_second(first, second, pairs, count, keep, kept, split);
}

SplitCounts pairs_below_first(FramedLevel first, FramedLevel second, const NodePair* pairs, std::size_t count,
                              Keep keep, NodePair* kept, NodePair* split) {
  return kernels().framed_below_first(first, second, pairs, count, keep, kept, split);
}

SplitCounts pairs_below_second(FramedLevel first, FramedLevel second, const NodePair* pairs, std::size_t count,
                               Keep keep, NodePair* kept, NodePair* split) {
  return kernels().framed_below_second(first, second, pairs, count, keep, kept, split);
}

std::size_t keep_near(const Strip* first, const Strip* second, NodePair* pairs, std::size_t count) {
  return kernels().keep_near_strip(first, second, pairs, count);
}

void leaf_strip(const Point* points, Strip& strip) {
  kernels().leaf_strip(points, strip);
}

void join_strips(const Strip* below, std::size_t count, Strip* above) {
  kernels().join_strips(below, count, above);
}

void subdivide(const CubicPiece& piece, std::uint32_t parts, std::uint32_t first, std::uint32_t last, Point* out) {
  kernels().subdivide(piece, parts, first, last, out);
}

void summarise_leaves(const Point* points, std::size_t first, std::size_t count, Box* boxes, DD* sums,
                      std::uint8_t* flags) {
  kernels().summarise_leaves(points, first, count, boxes, sums, flags);
}

void filter_pairs(SegmentSource first, SegmentSource second, const SegmentPair* pairs, std::size_t count,
                  PairVerdict* verdicts) {
  kernels().filter_pairs(first, second, pairs, count, verdicts);
}

void twice_chord_areas(const Point* points, std::size_t count, double* areas) {
  kernels().twice_chord_areas(points, count, areas);
}

double twice_chord_area(Point p0, Point p1, Point p2, Point p3) {
  const Point points[4] = {p0, p1, p2, p3};
  double area = 0;
  kernels().twice_chord_areas(points, 1, &area);
  return area;
}

void add_arc_measures(const Point* points, std::size_t count, Point origin, ArcMeasures& sums) {
  kernels().add_arc_measures(points, count, origin, sums);
}

void segment_boxes(const Point* points, SegmentBoxes& boxes) {
  kernels().segment_boxes(points, boxes);
}

void bent_slab(const Point* points, BentSlab& slab) {
  kernels().bent_slab(points, slab);
}

std::uint32_t segments_meeting(const BentSlab& slab, const Point* points) {
  return kernels().segments_meeting(slab, points);
}

std::size_t meeting_segments(const SegmentBoxes& a, std::uint32_t a_begin, const Point* b, const Box& b_box,
                             std::uint32_t b_begin, SegmentPair* pairs, std::uint32_t wanted) {
  return kernels().meeting_segments(a, a_begin, b, b_box, b_begin, pairs, wanted);
}

DD shoelace_prefixes(const Point* points, Point origin, DD start, const DD* extra, LeafPrefixes& prefixes) {
  return kernels().shoelace_prefixes(points, origin, start, extra, prefixes);
}

DD shoelace_of_leaf(const Point* points, Point origin) {
  return kernels().shoelace_of_leaf(points, origin);
}

void sums_at(const LeafPrefixes& prefixes, const std::uint32_t* segments, const DD* t, std::size_t count, DD* sums) {
  kernels().sums_at(prefixes, segments, t, count, sums);
}

void add_sines(double* y, const double* x, double factor, std::size_t count) {
  kernels().add_sines(y, x, factor, count);
}

void turns_along(const Point* points, std::size_t segments, double* lengths, double* curvatures) {
  kernels().turns_along(points, segments, lengths, curvatures);
}

void parts_needed(const double* lengths, const double* curvatures, std::size_t count, PartsAsked asked, double* parts) {
  kernels().parts_needed(lengths, curvatures, count, asked, parts);
}

bool fit_smooth_segments(const Point* const* windows, std::size_t count, SmoothSegment* segments) {
  return kernels().fit_smooth_segments(windows, count, segments);
}

void approach_crossings(SmoothPair* pairs, const std::uint32_t* numbers, std::size_t count,
                        const SmoothSegment* shapes1, const SmoothSegment* shapes2) {
  kernels().approach_crossings(pairs, numbers, count, shapes1, shapes2);
}

void end_arcs(const SmoothPair* pairs, std::size_t count, const SmoothSegment* shapes1, const SmoothSegment* shapes2,
              EndOfArcs* ends) {
  kernels().end_arcs(pairs, count, shapes1, shapes2, ends);
}

StraightSegments smooth_chord_areas(const Point* points, std::size_t count, double* areas, double* errors,
                                    std::uint8_t* smooth) {
  return kernels().smooth_chord_areas(points, count, areas, errors, smooth);
}

std::int64_t flag_segments(const SegmentRow& row, const SegmentBounds& bounds, std::int64_t* flags) {
  return kernels().flag_segments(row, bounds, flags);
}

bool surely_fine(const PointRow& row, const SegmentBounds& bounds, PartsAsked asked) {
  return kernels().surely_fine(row, bounds, asked);
}

LengthInBox length_in_box(const Point* points, std::size_t count, const Box& box) {
  return kernels().length_in_box(points, count, box);
}

void place_graded(const GradedRow& row, double* places) {
  kernels().place_graded(row, places);
}

}  // namespace lober::detail
