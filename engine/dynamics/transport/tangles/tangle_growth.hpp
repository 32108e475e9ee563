// Two manifolds grown together, no farther than their tangle is asked for (private to engine/).
//
// First the turnstile: U and S are grown piece by piece until they cross, one crossing is chosen as the bip q, and S is
// followed to f^-1(q). Then their splitting (splitting.hpp) tells how fine polygons have to be for their crossings to
// be those of the manifolds, and both are grown anew if they are coarser. The pips of one iterate are counted in three
// ways: by polygons, by zeros of the splitting, and by the orbits through them, which have to be different, in
// order, and the last one the image of the first. From then on only pieces are added.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/stopwatch.hpp"
#include "engine/dynamics/manifolds/manifold_growth.hpp"
#include "engine/dynamics/transport/tangles/splitting.hpp"
#include "engine/dynamics/transport/tangles/tangle_box.hpp"
#include "kernels/box.hpp"
#include "lober/tangle/manifold_tangle.hpp"

namespace lober::detail {

/// The local manifolds of U and S; those of a homoclinic tangle have one saddle, to the bit. Throws as local_manifold.
[[nodiscard]] std::pair<LocalManifold, LocalManifold> local_manifolds(const PlanarMap& map,
                                                                      const Connection& connection,
                                                                      const LocalManifoldOptions& of_u = {},
                                                                      const LocalManifoldOptions& of_s = {});

/// A bip as an orbit that is known: where it lies on both manifolds.
struct KnownBip {
  ManifoldPosition u, s;
};

/// Where the growth of a tangle begins if its local manifolds are known, and perhaps its bip and orbits on them through
/// its pips.
struct KnownStart {
  LocalManifold local_u, local_s;
  std::optional<KnownBip> bip;
  std::vector<ConnectingOrbit> orbits;
};

class TangleGrowth {
 public:
  /// Finds the turnstile; without a search, if the bip is known, and then no more of the manifolds than it takes: such
  /// a tangle cannot be grown on. The map must outlive it. Throws as grow_tangle.
  TangleGrowth(const PlanarMap& map, const Connection& connection, const ManifoldTangleOptions& options,
               const KnownStart* known = nullptr);

  /// Grows on until the pips f^-before(q) to f^after(q) are there. False when they cannot be reached: limit() says why,
  /// and the earlier tangle is still there. Throws Cancelled.
  bool grow_to(int before, int after);
  /// Why the last call could not go on; empty if it could.
  [[nodiscard]] const std::string& limit() const { return limit_; }

  /// The tangle grown so far. Valid until the next call of grow_to.
  [[nodiscard]] const ManifoldTangle& current() const { return *result_; }
  [[nodiscard]] std::unique_ptr<ManifoldTangle> take() { return std::move(result_); }

 private:
  // One manifold, and how far it has been grown.
  struct Side {
    LocalManifold local;
    Branch branch{};
    GrowthOptions options;
    std::optional<ManifoldGrowth> growth;
    std::size_t compressed = 0;  // points
    // Points with which it was seen not to cross itself, and what that took; points are only ever added.
    std::size_t simple = 0;
    std::size_t folds_seen = 0;  // number of points with which its folds were looked at
    SimpleCheck check;
  };
  struct Time {
    double u, s;
  };
  struct Halfway {
    std::size_t pip;
    double ahead;  // logarithm of the length of U up to it over that of S
  };
  // Pips are followed farther than to where they are by this, in images.
  static constexpr double beyond = 0.02;
  // Manifolds that end at a known bip are longer than it takes by this factor, and by twice `beyond` at least.
  static constexpr double spare = 1.1;
  // Polygons are finer than the splitting by this factor.
  static constexpr double finer_than_splitting = 30;

  // Where manifolds are followed exactly: the scene, or a strip along the lattice.
  [[nodiscard]] Box followed() const {
    return options_.lattice == Point{} ? box_ : strip_along(box_, options_.lattice);
  }

  void begin(double tolerance);
  [[nodiscard]] bool ends_too_early();
  [[nodiscard]] std::uint64_t images() const;
  [[nodiscard]] double images_left() const;
  bool grow(Side& side, double end);
  void find_pips();
  bool refine(Side& side, std::vector<std::uint32_t> segments, const Box& box);
  bool refine_flat_pips();
  [[nodiscard]] std::vector<std::uint32_t> segments_that_cross(Side& side) const;
  std::optional<Point> refine_until_simple(Side& side);
  void refine_near(Side& side, Point saddle, double apart);
  void refine_folds(Side& side);
  [[nodiscard]] static double distance_at(const Side& side, double time);
  void look();
  bool find_crossing();
  bool box_is_too_small();
  bool find_turnstile(std::string& trouble);
  void require_bip_as_asked() const;
  void require_known_lobes() const;
  [[nodiscard]] std::string of_saddles() const;
  [[nodiscard]] double stretching() const;
  [[nodiscard]] std::string of_stretching() const;
  // The tolerance of the present polygons, and the one asked for.
  [[nodiscard]] std::string tolerance_text() const;
  bool towards_a_crossing();
  [[nodiscard]] static bool newest_meets(const Side& one, const Side& other);
  [[nodiscard]] std::size_t wanted_pip() const;
  [[nodiscard]] Halfway halfway() const;
  [[nodiscard]] std::size_t nearest(Point point) const;
  [[nodiscard]] std::size_t nearest(Time time) const;
  [[nodiscard]] std::pair<ManifoldPosition, ManifoldPosition> positions_of(std::size_t pip) const;
  [[nodiscard]] Time time_of_pip(std::size_t pip) const;
  [[nodiscard]] std::optional<std::size_t> image_of_bip(int steps, double close) const;
  [[nodiscard]] std::optional<double> tolerance_for_splitting();
  [[nodiscard]] std::string trouble_with_pips();
  [[nodiscard]] ConnectingOrbit orbit_through(std::size_t pip) const;
  [[nodiscard]] bool lobes_are_thin() const;
  [[nodiscard]] std::string by_action() const;
  [[nodiscard]] bool grow_between(int before, int after);
  // Segments of both manifolds, with all translates that they may meet; 0 in a plane that does not repeat itself.
  [[nodiscard]] double segments_to_compare() const;
  [[nodiscard]] bool compares_too_much(double segments);
  [[nodiscard]] double segments_expected() const;
  void lend();
  // Not checked where a limit ended the work: the part grown last belongs to no row.
  void finish(bool check_simple = true);
  void rest();
  void report();

  const PlanarMap& map_;
  ManifoldTangleOptions options_;
  std::optional<Point> bip_near_, near_;
  std::optional<Time> known_bip_;
  std::vector<ConnectingOrbit> known_orbits_;
  bool ends_at_bip_ = false;    // manifolds do, as the known bip says
  std::vector<Point> closure_;  // closure of the connection
  std::string caution_;         // likewise
  Side u_, s_;
  Box box_;  // box of the scene
  int enlargements_ = 0;
  double tolerance_ = 0, finest_ = 0;
  std::uint64_t work_before_ = 0;
  double begun_ = 0;              // when growth did, by watch_, later by what was not growth
  std::uint64_t work_after_ = 0;  // when it ended for now
  double ended_ = 0;
  double compared_ = 0, compared_before_ = 0;  // segments compared with translates, lately and before that
  bool out_of_work_ = false;
  std::uint64_t images_before_ = 0;  // taken by manifolds that were given up
  int before_ = 1, after_ = 0;       // that are there
  Tangle found_;
  std::size_t bip_ = 0;
  std::uint32_t period_ = 0;
  std::optional<Splitting> splitting_;
  std::vector<ConnectingOrbit> orbits_;
  std::string limit_;
  std::unique_ptr<ManifoldTangle> result_;
  Stopwatch watch_;
};

}  // namespace lober::detail
