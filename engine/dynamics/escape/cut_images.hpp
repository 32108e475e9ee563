// Images of the entry region after part of it has left (private to escape/).
//
// Where the image A of an entry region meets an exit X, the map f to the next crossing ends: outside X, close to its
// regularising curve, trajectories pass the bottleneck's orbit without leaving and come back close to the regularising
// curve of E, after the more turns about the orbit the closer they were. So f(A \ X) winds about E without end. It is
// cut off at a regularising curve that f can carry over: X_I holds X and a strip around it, made of the trajectories
// with s w = I next to the orbit (s, w the parameters of its local manifolds, whose product the return map keeps).
// These cross the section in a closed curve about X on their way to the orbit, and in one about E on their way back.
// The boundary of A is followed outside X_I; an arc within is replaced by one along the regularising curve, in such
// a way that the whole winds about X zero times. That is the boundary of A \ X_I for every count that weighs area by
// winding numbers, and its image is as good. Cut off is at most the area of the strip, each time.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "engine/dynamics/escape/regularising_curve.hpp"
#include "lober/dynamics/tubes.hpp"

namespace lober::detail {

struct CutImageOptions {
  TubeCurveOptions tracing;
  double strip = 0;  ///< area between X and X_I
  double area = 0;   ///< area of the smallest E
};

/// Goes on where the whole images of E (`entry`) or X of bottleneck `bottleneck` end; `last` is the last of them,
/// number `level`, which is cut by its next step. Each image is a closed curve that may cross itself and have corners;
/// `complete` is false and `cut` true. Flow, section and the tubes must outlive it.
class CutImages {
 public:
  /// Throws DataError when the regularising curve of a tube cannot be followed; Cancelled.
  CutImages(const Flow& flow, const Section& section, std::span<const BottleneckTubes> bottlenecks,
            std::size_t bottleneck, bool entry, const TubeCurve& last, int level, const IntegrationOptions& integration,
            const CutImageOptions& options);
  ~CutImages();
  CutImages(const CutImages&) = delete;
  CutImages& operator=(const CutImages&) = delete;

  /// Cuts the present image where it has left, and says how many trajectories the next one takes to begin with: about
  /// half of all that it will take. None where cutting takes more than this work (PlanarMap::work). Throws Cancelled.
  std::optional<std::size_t> prepare(double max_work);
  /// The next image; none where trajectories cannot be followed, at options.tracing.max_points, or at this work for
  /// it. Throws Cancelled.
  [[nodiscard]] std::optional<TubeCurve> next(double max_work);
  /// Whether the last of both came to options.tracing.max_points, or to its work.
  [[nodiscard]] bool out_of_points() const;
  [[nodiscard]] bool out_of_work() const;
  /// All that this has taken (PlanarMap::work).
  [[nodiscard]] double work() const;

 private:
  class Cutting;
  std::unique_ptr<Cutting> cutting_;
};

}  // namespace lober::detail
