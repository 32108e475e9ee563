// Runs of vertices that two curves have in common, as a search finds them in a block of C1 (private to geometry/).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "kernels/common_run.hpp"
#include "lober/curve/curve.hpp"

namespace lober::detail {

/// Vertices first .. last of C1 are vertices of C2 one by one.
struct CommonRun {
  std::uint32_t first;
  std::uint32_t last;
  int direction;  ///< +1 if C2 runs from first to last, else -1
};

/// How far a run may go along a step to the next vertices.
enum class RunStep : std::uint8_t { not_there, there_at_last, on };
/// The step of a run that goes as far as the vertices are the same: of such a run many are compared at a time.
struct EveryStep {
  RunStep operator()(std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t) const { return RunStep::on; }
};

class CommonRuns {
 public:
  /// Vertex i of C1 is vertex j of C2: follows both as long as they have the same vertices, up to vertex `end` of C1.
  /// step(last, other, next, next_other) says of each vertex, and of that of C2, whether the run goes to the next ones.
  /// The run becomes one of these; nothing where there is none.
  template <typename Step>
  std::optional<CommonRun> follow(const CurveView& c1, const CurveView& c2, std::uint32_t i, std::uint32_t j,
                                  std::uint32_t end, const Step& step) {
    for (const int direction : {1, -1}) {
      const std::uint32_t last = last_of(c1, c2, i, j, end, direction, step);
      if (last == i) continue;
      runs_.push_back({i, last, direction});
      covered_begin_ = i;
      covered_end_ = last;
      return runs_.back();
    }
    return std::nullopt;
  }
  /// Whether the segment of C1 is in the run that was followed last; nothing before covered_end() is wanted.
  [[nodiscard]] bool covers(std::uint32_t segment) const { return segment >= covered_begin_ && segment < covered_end_; }
  [[nodiscard]] std::uint32_t covered_end() const { return covered_end_; }

  /// Joins those that overlap, in order along C1: when all have been found.
  void merge();
  [[nodiscard]] const std::vector<CommonRun>& runs() const { return runs_; }
  /// Whether the segment begins inside one of the merged runs, their first vertices excluded.
  [[nodiscard]] bool has_inside(std::uint32_t segment) const;

 private:
  static constexpr std::uint32_t no_vertex = 0xffffffff;
  static std::uint32_t next_of(const CurveView& curve, std::uint32_t vertex, int direction) {
    const auto last = static_cast<std::uint32_t>(curve.points.size() - 1);
    if (direction > 0) return vertex < last ? vertex + 1 : (curve.closed ? 0 : no_vertex);
    return vertex > 0 ? vertex - 1 : (curve.closed ? last : no_vertex);
  }

  // Vertices that follow in the run, without those that a curve closes with, and up to where a known run begins.
  [[nodiscard]] std::size_t many_after(const CurveView& c1, const CurveView& c2, std::uint32_t last,
                                       std::uint32_t other, std::uint32_t end, int direction) const {
    constexpr std::size_t few = 8;
    std::size_t count = std::min(end - last, static_cast<std::uint32_t>(c1.points.size() - 1) - last);
    count = std::min<std::size_t>(count, direction > 0 ? c2.points.size() - 1 - other : other);
    if (!runs_.empty() && runs_.back().direction == direction && runs_.back().first > last) {
      count = std::min<std::size_t>(count, runs_.back().first - last);
    }
    return count < few ? 0 : common_vertices(&c1.points[last], &c2.points[other], direction, count);
  }

  template <typename Step>
  std::uint32_t last_of(const CurveView& c1, const CurveView& c2, std::uint32_t i, std::uint32_t j, std::uint32_t end,
                        int direction, const Step& step) const {
    std::uint32_t last = i, other = j;
    while (last < end) {
      // A run that is known already (pairs may come in descending order) is taken over whole.
      if (!runs_.empty() && runs_.back().first == last && runs_.back().direction == direction) return runs_.back().last;
      if constexpr (std::is_same_v<Step, EveryStep>) {
        const auto many = static_cast<std::uint32_t>(many_after(c1, c2, last, other, end, direction));
        last += many;
        other += direction > 0 ? many : -many;
        if (many > 0) continue;
      }
      const std::uint32_t next = last + 1 == c1.points.size() ? 0 : last + 1;
      const std::uint32_t next_other = next_of(c2, other, direction);
      if (next_other == no_vertex) break;
      const Point here = c1.points[next];
      if (!(here == c2.points[next_other]) || here == c1.points[last]) break;
      const RunStep goes = step(last, other, next, next_other);
      if (goes == RunStep::not_there) break;
      other = next_other;
      ++last;
      if (goes == RunStep::there_at_last) break;
    }
    return last;
  }

  std::vector<CommonRun> runs_;
  std::uint32_t covered_begin_ = 0, covered_end_ = 0;
};

}  // namespace lober::detail
