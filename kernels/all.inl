// All kernels of one instruction set, and their table. baseline.cpp, avx2.cpp and avx512.cpp include this file with
// other compiler flags and another LOBER_KERNELS, the name of the table; whatever it holds is in unnamed namespaces or
// always inlined (kernels/inline.hpp). All copies give the same bits.
#pragma once

#include "kernels/bent_slab.inl"
#include "kernels/box_pyramid.inl"
#include "kernels/chebyshev.inl"
#include "kernels/common_run.inl"
#include "kernels/crossing_parameters.inl"
#include "kernels/fold_chart.inl"
#include "kernels/frame_filter.inl"
#include "kernels/graded.inl"
#include "kernels/interpolation.inl"
#include "kernels/join_strips.inl"
#include "kernels/kernel_table.hpp"
#include "kernels/leaf.inl"
#include "kernels/leaf_strip.inl"
#include "kernels/moments.inl"
#include "kernels/pair_filter.inl"
#include "kernels/ray.inl"
#include "kernels/sagitta.inl"
#include "kernels/segment_boxes.inl"
#include "kernels/segment_flags.inl"
#include "kernels/shoelace.inl"
#include "kernels/sine.inl"
#include "kernels/smooth_approach.inl"
#include "kernels/smooth_segment.inl"
#include "kernels/strip_filter.inl"
#include "kernels/turning.inl"

namespace lober::detail {

const KernelTable LOBER_KERNELS{
    .follow_ray = follow_ray_down,
    .crossings_of_height = crossings_of_leaf,
    .chebyshev_points = evaluate_chebyshev,
    .common_vertices = count_common,
    .eight_parameters = eight_parameters,
    .chart_leaf = chart_of_leaf,
    .frames_of_leaves = put_frames_of_leaves,
    .join_frames = put_joined_frames,
    .boxes_below_first = split_pairs<BoxPairs, true>,
    .boxes_below_second = split_pairs<BoxPairs, false>,
    .framed_below_first = split_pairs<FramePairs, true>,
    .framed_below_second = split_pairs<FramePairs, false>,
    .subdivide = subdivide_with,
    .summarise_leaves = summarise,
    .moments_of_quarters = moments_of_quarters,
    .filter_pairs = filter_all_pairs,
    .twice_chord_areas = areas_of_all,
    .add_arc_measures = arc_sums,
    .segment_boxes = all_segment_boxes,
    .bent_slab = fit_bent_slab,
    .segments_meeting = meeting_bent_slab,
    .meeting_segments = find_meeting,
    .shoelace_prefixes = prefixes_of,
    .shoelace_of_leaf = sum_of_leaf,
    .sums_at = all_sums_at,
    .add_sines = add_all_sines,
    .leaf_strip = fit_strip,
    .join_strips = join_all,
    .keep_near_strip = keep_strips,
    .turns_along = all_turns_along,
    .parts_needed = all_parts_needed,
    .fit_smooth_segments = fit_windows,
    .approach_crossings = approach_all,
    .end_arcs = end_all_arcs,
    .smooth_chord_areas = fit_all,
    .flag_segments = flag_all_segments,
    .surely_fine = all_surely_fine,
    .length_in_box = sum_in_box,
    .place_graded = place_all_graded,
};

}  // namespace lober::detail
