#include "engine/operations/overlay_fields.hpp"

#include <algorithm>
#include <memory>
#include <mutex>

#include "engine/operations/curve_fields.hpp"
#include "engine/operations/schema.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

// ------------------------------------------------------------------------------------------------------- crossings

struct NumberedNode {
  const CurveOverlay* overlay;
  std::size_t number;
  Node node;
};
struct Nodes {
  const CurveOverlay* overlay;
  [[nodiscard]] std::size_t size() const { return overlay->nodes.size(); }
  NumberedNode operator[](std::size_t k) const { return {overlay, k, overlay->nodes[k]}; }
};

template <Point Node::*at, Position Node::*on1, Position Node::*on2>
void add_place(Schema<NumberedNode>& schema) {
  schema.field("x", "length", "x of the point, rounded to double", [](const NumberedNode& n) { return (n.node.*at).x; })
      .field("y", "length", "y of the point, rounded to double", [](const NumberedNode& n) { return (n.node.*at).y; })
      .field("segment1", "", "segment of C1, from 0", [](const NumberedNode& n) { return (n.node.*on1).segment; })
      .field("t1", "", "in [0, 1) along it", [](const NumberedNode& n) { return (n.node.*on1).t; })
      .field("segment2", "", "segment of C2, from 0", [](const NumberedNode& n) { return (n.node.*on2).segment; })
      .field("t2", "", "in [0, 1) along it", [](const NumberedNode& n) { return (n.node.*on2).t; });
}

Schema<NumberedNode> node_schema() {
  Schema<NumberedNode> end, made;
  add_place<&Node::end, &Node::end1, &Node::end2>(end);
  made.field("index", "", "from 0 in order along C1", &NumberedNode::number)
      .field("kind", "", "crossing, touch or shared_arc",
             [](const NumberedNode& n) {
               return n.node.shared != 0 ? "shared_arc" : n.node.rho != 0 ? "crossing" : "touch";
             })
      .field("rho", "", "1: C1 leaves the region of C2; -1: it enters; 0: it does not cross",
             [](const NumberedNode& n) { return n.node.rho; });
  add_place<&Node::begin, &Node::begin1, &Node::begin2>(made);
  made.field("shared", "", "1: an arc that both share in the same direction; -1: in opposite directions",
             [](const NumberedNode& n) { return n.node.shared != 0 ? std::optional(n.node.shared) : std::nullopt; })
      .if_asked_for()
      .object("end", "end of a shared arc along C1", end,
              [](const NumberedNode& n) { return n.node.shared != 0 ? &n : nullptr; })
      .if_asked_for()
      .field("class", "", "equivalence class under sigma; a touch has none",
             [](const NumberedNode& n) {
               const auto& classes = n.overlay->classes;
               return classes.empty() || classes[n.number] == Overlay::no_class ? std::nullopt
                                                                                : std::optional(classes[n.number]);
             })
      .or_null()
      .field("order2", "", "its position in order along C2, from 0",
             [](const NumberedNode& n) { return n.overlay->nodes.rank2(n.number); });
  return made;
}

Schema<CurveOverlay> crossings_schema() {
  Schema<CurveOverlay> made;
  made.parts(meetings_schema(), [](const CurveOverlay& o) { return &o.nodes; })
      .field("classes", "", "number of classes of sigma of A1 \\ A2",
             [](const CurveOverlay& o) { return o.has_pieces ? std::optional(o.class_count) : std::nullopt; })
      .if_asked_for()
      .list("list", "all nodes in order along C1", node_schema(), [](const CurveOverlay& o) { return Nodes{&o}; });
  return made;
}

// ------------------------------------------------------------------------------------------------------------ sigma

using Steps = std::vector<SigmaStep>;

Schema<Steps> steps_schema() {
  Schema<SigmaStep> step;
  step.field("crossing", "", "its number", &SigmaStep::crossing)
      .field("rho", "", "1 or -1", &SigmaStep::rho)
      .field("along1", "", "the next crossing along C1 in the direction of the pairing", &SigmaStep::along1)
      .field("along2", "", "the next crossing along C2 in the direction of the pairing", &SigmaStep::along2)
      .field("sigma", "", "along1 where rho is 1, else along2", &SigmaStep::sigma)
      .field("class", "", "class of sigma, from 0", &SigmaStep::class_number)
      .field("s", "area", "S, the integral of x dy - y dx from the crossing to its sigma", &SigmaStep::s);
  Schema<Steps> made;
  made.field("classes", "", "number of classes",
             [](const Steps& steps) {
               std::size_t count = 0;
               for (const SigmaStep& one : steps) count = std::max(count, one.class_number + std::size_t{1});
               return count;
             })
      .field("half_sum", "area", "half the sum of S: the area",
             [](const Steps& steps) {
               double sum = 0;
               for (const SigmaStep& one : steps) sum += one.s;
               return sum / 2;
             })
      .list("list", "all crossings in order along C1", step, [](const Steps& steps) -> const Steps& { return steps; });
  return made;
}

Schema<CurveOverlay> sigma_schema() {
  Schema<CurveOverlay> made;
  made.object("c1_minus_c2", "steps of A1 \\ A2", steps_schema(), [](const CurveOverlay& o) { return &(*o.steps)[0]; })
      .object("c2_minus_c1", "steps of A2 \\ A1", steps_schema(), [](const CurveOverlay& o) { return &(*o.steps)[1]; });
  return made;
}

// ----------------------------------------------------------------------------------------------------------- pieces

// The pieces of one pairing. Centroids and slivers take a pass over the curves: found when somebody asks for them.
class MeasuredPieces {
 public:
  MeasuredPieces(const CurveOverlay& overlay, Pairing pairing) : lazy_(std::make_shared<Lazy>(overlay, pairing)) {}

  struct Element {
    const MeasuredPieces* all;
    std::uint32_t number;
    Piece piece;

    [[nodiscard]] Point centroid() const { return all->lazy_->centroid(number); }
    [[nodiscard]] bool sliver() const { return all->lazy_->is_sliver(number); }
  };
  [[nodiscard]] std::size_t size() const { return lazy_->pieces().size(); }
  Element operator[](std::size_t k) const { return {this, static_cast<std::uint32_t>(k), lazy_->pieces()[k]}; }

 private:
  class Lazy {
   public:
    Lazy(const CurveOverlay& overlay, Pairing pairing) : overlay_(overlay), pairing_(pairing) {}
    [[nodiscard]] const Pieces& pieces() const { return overlay_.pieces(pairing_); }
    [[nodiscard]] Point centroid(std::uint32_t k) {
      std::call_once(with_centroids_, [this] { centroids_ = centroids(overlay_, pairing_); });
      return centroids_[k];
    }
    [[nodiscard]] bool is_sliver(std::uint32_t k) {
      std::call_once(with_slivers_, [this] { slivers_ = find_slivers(overlay_, pairing_).pieces; });
      return std::binary_search(slivers_.begin(), slivers_.end(), k);
    }

   private:
    const CurveOverlay& overlay_;
    Pairing pairing_;
    std::once_flag with_centroids_, with_slivers_;
    std::vector<Point> centroids_;
    std::vector<std::uint32_t> slivers_;
  };
  std::shared_ptr<Lazy> lazy_;
};

Schema<MeasuredPieces::Element> piece_schema() {
  using Element = MeasuredPieces::Element;
  Schema<Element> made;
  made.field("area", "area", "area of the piece", [](const Element& e) { return e.piece.area; })
      .field("centroid", "length", "centroid of the piece", &Element::centroid)
      .field("crossings", "", "numbers of the nodes on its boundary, in the order of a walk that keeps it on the left",
             [](const Element& e) {
               return std::vector<std::int64_t>(e.piece.crossings.begin(), e.piece.crossings.end());
             })
      .field("holes", "", "number of its holes", [](const Element& e) { return e.piece.holes; })
      .field("sliver", "", "whether it is at most as wide as the rounding of its vertices", &Element::sliver);
  return made;
}

Schema<CurveOverlay> pieces_schema() {
  Schema<CurveOverlay> made;
  for (const Pairing pairing : all_pairings) {
    made.list(std::string(name(pairing)), "connected components", piece_schema(),
              [pairing](const CurveOverlay& o) { return MeasuredPieces(o, pairing); });
  }
  return made;
}

Schema<CurveOverlay> counted_pieces() {
  Schema<CurveOverlay> made;
  for (const Pairing pairing : all_pairings) {
    made.field(std::string(name(pairing)), "", "number of pieces",
               [pairing](const CurveOverlay& o) { return o.pieces(pairing).size(); });
  }
  return made;
}

Schema<CurveOverlay> slivers_schema() {
  Schema<Slivers> slivers;
  slivers.field("count", "", "number of them", [](const Slivers& s) { return s.pieces.size(); })
      .field("area", "area", "total area of the slivers", &Slivers::area);
  Schema<CurveOverlay> made;
  for (const Pairing pairing : all_pairings) {
    made.object(std::string(name(pairing)), "pieces no wider than the rounding of their vertices", slivers,
                [pairing](const CurveOverlay& o) { return find_slivers(o, pairing); });
  }
  return made;
}

// ----------------------------------------------------------------------------------------------------------- errors

Schema<SmoothAreas> smooth_schema() {
  Schema<SmoothAreas> made;
  made.object("areas", "between the smooth curves", areas_schema(), &SmoothAreas::areas)
      .object("error", "estimates of |area - area of the curves that the points were taken from|, on the safe side",
              areas_schema(), &SmoothAreas::error)
      .field("fallback_segments", "", "segments that stay straight", &SmoothAreas::fallback_segments)
      .field("fallback_crossings", "", "crossings that stay where the polygons have them",
             &SmoothAreas::fallback_crossings);
  return made;
}

Schema<CurveOverlay> overlay_errors() {
  const auto known = [](const std::optional<Areas>& areas) { return areas ? &*areas : nullptr; };
  Schema<CurveOverlay> made;
  made.object("rounding", "bounds on |area - exact area of the polygons as given|", areas_schema(),
              &CurveOverlay::rounding)
      .object("discretisation",
              "estimates of |area of the polygons - area between smooth curves through the same points|",
              areas_schema(), [known](const CurveOverlay& o) { return known(o.discretisation); })
      .if_asked_for()
      .object("consistency", "|area by the overlay - area by the interior method|; with verify", areas_schema(),
              [known](const CurveOverlay& o) { return known(o.consistency); })
      .if_asked_for();
  return made;
}

}  // namespace

std::vector<Field> overlay_fields() {
  Schema<OverlayStatistics> statistics;
  statistics.parts(search_schema<OverlayStatistics>(), [](const OverlayStatistics& s) { return &s; })
      .field("index_bytes", "", "bytes of memory", &OverlayStatistics::index_bytes);
  const auto with_pieces = [](const CurveOverlay& o) { return o.has_pieces ? &o : nullptr; };
  Schema<CurveOverlay> made;
  made.object("crossings", "where the curves meet", crossings_schema(), [](const CurveOverlay& o) { return &o; })
      .object("sigma", "rho, A, gamma, sigma, class and S of each crossing; with classes", sigma_schema(),
              [](const CurveOverlay& o) { return o.steps ? &o : nullptr; })
      .if_asked_for()
      .object("areas", "areas of the polygons", areas_schema(), &CurveOverlay::areas)
      .object("smooth", "areas between smooth curves; with smooth", smooth_schema(),
              [](const CurveOverlay& o) { return o.smooth ? &*o.smooth : nullptr; })
      .if_asked_for()
      .object("piece_counts", "number of pieces of each pairing; not with areas_only", counted_pieces(), with_pieces)
      .if_asked_for()
      .object("pieces", "pieces of each pairing; not with areas_only", pieces_schema(), with_pieces)
      .if_asked_for()
      .object("slivers", "slivers of each pairing; not with areas_only", slivers_schema(), with_pieces)
      .if_asked_for()
      .object("error", "error bars of the areas", overlay_errors(), [](const CurveOverlay& o) { return &o; })
      .object("statistics", "work that was done", statistics, &CurveOverlay::statistics);
  add_orientations(made);
  return made.fields();
}

}  // namespace lober::detail::table
