// Images of what has entered, after part of it has left (private to escape/).
//
// Where the image A of an entry region meets an exit X, the map f to the next crossing ends: outside X, close to its
// rim, trajectories pass the bottleneck's orbit without leaving and come back close to the rim of E, after the more
// turns about the orbit the closer they were. So f(A \ X) winds about E without end. It is cut off at a rim that f can
// carry over: X_I holds X and a strip around it, made of the trajectories with s w = I next to the orbit (s, w the
// parameters of its local manifolds, whose product the return map keeps). These cross the section in a closed curve
// about X on their way to the orbit, and in one about E on their way back. The boundary of A is followed outside X_I; a
// stretch within is replaced by one along the rim, in such a way that the whole winds about X zero times. That is the
// boundary of A \ X_I for every count that weighs area by winding numbers, and its image is as good. Cut off is at most
// the area of the strip, each time.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "lober/tubes.hpp"

namespace lober {

/// Both tubes of a bottleneck, towards the section.
struct NeckTubes {
  const Tube* unstable = nullptr;
  const Tube* stable = nullptr;
  Branch in = Branch::plus, out = Branch::plus;
  int exit_direction = 0;   ///< in which X is crossed
  int entry_direction = 0;  ///< in which E is crossed
};

struct TornOptions {
  TubeCurveOptions tracing;
  double strip = 0;  ///< area between X and X_I
};

/// Goes on where the whole images of E (`entry`) or X of bottleneck `neck` end; `last` is the last of them, number
/// `level`, which is torn by its next step. Each image is a closed curve that may cross itself and have corners;
/// `complete` is false and `torn` true. Flow, section and the tubes must outlive it.
class TornImages {
 public:
  /// Throws DataError when the rim of a tube cannot be followed; Cancelled.
  TornImages(const Flow& flow, const Section& section, std::span<const NeckTubes> necks, std::size_t neck, bool entry,
             const TubeCurve& last, int level, const IntegrationOptions& integration, const TornOptions& options);
  ~TornImages();
  TornImages(const TornImages&) = delete;
  TornImages& operator=(const TornImages&) = delete;

  /// Cuts the present image where it has left, and says how many trajectories the next one takes to begin with: about
  /// half of all that it will take. Throws Cancelled.
  std::size_t prepare();
  /// The next image; none where trajectories cannot be followed, or at options.tracing.most_points. Throws Cancelled.
  [[nodiscard]] std::optional<TubeCurve> next();
  /// Whether the last `next` came to options.tracing.most_points.
  [[nodiscard]] bool out_of_points() const;

 private:
  class Tearing;
  std::unique_ptr<Tearing> tearing_;
};

}  // namespace lober
