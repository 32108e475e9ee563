#include "engine/operations/lobe_fields.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/stopwatch.hpp"
#include "engine/operations/curve_fields.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

template <typename T>
std::optional<T> if_true(bool condition, T value) {
  return condition ? std::optional<T>(std::move(value)) : std::nullopt;
}

Schema<Pip> tangle_pip() {
  Schema<Position> position;
  position.field("segment", "", "number of the segment, from 0", &Position::segment)
      .field("t", "", "position in [0, 1) along the segment", &Position::t);
  Schema<Pip> made;
  made.field("x", "length", "x of the pip", [](const Pip& p) { return p.at.x; })
      .field("y", "length", "y of the pip", [](const Pip& p) { return p.at.y; })
      .object("u", "its position on U", position, &Pip::u)
      .object("s", "its position on S", position, &Pip::s)
      .field("rho", "", "1: S passes from the right of U to its left; -1: from left to right", &Pip::rho)
      .field("crossing", "", "its number among all crossings, in order along U", &Pip::node);
  return made;
}

struct NumberedLobe {
  const CurveTangle* tangle;
  std::size_t number;

  [[nodiscard]] const Lobe& lobe() const { return tangle->lobes[number]; }
  [[nodiscard]] const LobeShape& shape() const { return tangle->shapes[number]; }
};
struct NumberedLobes {
  const CurveTangle* tangle;
  [[nodiscard]] std::size_t size() const { return tangle->lobes.size(); }
  NumberedLobe operator[](std::size_t k) const { return {tangle, k}; }
};

Schema<NumberedLobe> tangle_lobe() {
  using One = NumberedLobe;
  Schema<One> made;
  made.field("index", "", "its number, from 0 outward along U", &One::number)
      .field("area", "area", "signed area, positive where the lobe lies on the left of U",
             [](const One& l) { return l.lobe().area; })
      .field("inside", "area", "area of the part inside the boundary; not known without one",
             [](const One& l) { return l.lobe().inside; })
      .field("outside", "area", "area of the part outside the boundary", [](const One& l) { return l.lobe().outside; })
      .field("perimeter", "length", "perimeter of the polygon", [](const One& l) { return l.shape().perimeter; })
      .field("simple", "", "whether its two arcs meet nowhere but at its pips",
             [](const One& l) { return l.lobe().simple; })
      .field("label", "", "the region that it leaves, the region that it enters, and when: L12(1)",
             [](const One& l) {
               const std::string label = text(l.tangle->images.labels[l.number]);
               return if_true(!label.empty(), label);
             })
      .field("width", "length", "mean width of a thin lobe, 2 |area| / perimeter",
             [](const One& l) { return l.shape().width; })
      .field("centroid", "length", "centroid of the polygon", [](const One& l) { return l.shape().centroid; })
      .field("rounding", "area", "bound on |area - exact area of the polygon|",
             [](const One& l) { return l.tangle->rounding(l.lobe().area); })
      .field("discretisation", "area",
             "estimate of |area of the polygon - area between smooth curves|; with smooth, of the error of the latter",
             [](const One& l) { return l.tangle->discretisation(l.number); })
      .field("polygon_area", "area", "signed area of the polygon; with smooth",
             [](const One& l) { return if_true(l.tangle->smooth, l.lobe().polygon_area); })
      .field("parts_error", "area", "estimate of the error of inside and of outside; with smooth",
             [](const One& l) { return if_true(l.tangle->smooth, l.tangle->parts_error(l.number)); })
      .field("pieces", "area", "area of each simple polygon of a lobe that is not simple", [](const One& l) {
        return l.lobe().simple ? std::nullopt : std::optional(lobe_pieces(*l.tangle, l.number));
      });
  return made;
}

Schema<CurveTangle> tangle_bip() {
  const auto at = [](const CurveTangle& t) { return t.pips[t.boundary->bip].at; };
  Schema<CurveTangle> made;
  made.field("index", "", "number of the pip", [](const CurveTangle& t) { return t.boundary->bip; })
      .field("x", "length", "x of the pip", [at](const CurveTangle& t) { return at(t).x; })
      .field("y", "length", "y of the pip", [at](const CurveTangle& t) { return at(t).y; });
  return made;
}

Schema<CurveTangle> tangle_boundary() {
  Schema<CurveTangle> made;
  made.field("area", "area", "area that the boundary encloses; where it crosses itself, of what it winds round",
             [](const CurveTangle& t) { return t.boundary->area; })
      .field("rounding", "area", "bound on |area - exact area of the polygon|",
             [](const CurveTangle& t) { return t.rounding(t.boundary->area); })
      .field("discretisation", "area",
             "estimate of |area of the polygon - area between smooth curves|; with smooth, of the error of the latter",
             &CurveTangle::boundary_discretisation)
      .field("points", "", "number of points of its polygon",
             [](const CurveTangle& t) { return boundary_outline(t).size(); })
      .field("orientation", "", "orientation of the polygon along U: clockwise or counter_clockwise",
             [](const CurveTangle& t) { return t.boundary->orientation > 0 ? "counter_clockwise" : "clockwise"; })
      .field("crosses_itself", "", "whether the path that closes it meets the manifolds",
             [](const CurveTangle& t) { return t.boundary->crosses_itself; })
      .field("closure", "length", "corners of that path", &CurveTangle::closure)
      .in_json()
      .field("outline", "length", "the polygon", [](const CurveTangle& t) { return boundary_outline(t); });
  return made;
}

Schema<Images> tangle_images() {
  Schema<Images> made;
  made.field("period", "", "number of pips from one to its image",
             [](const Images& i) { return if_true(i.period > 0, i.period); })
      .or_null()
      .field("given", "", "whether it was given; else it was inferred from the areas", &Images::given)
      .field("reason", "", "why it is not known", [](const Images& i) { return if_true(!i.reason.empty(), i.reason); })
      .field("compared", "", "number of lobes whose image is seen too", &Images::compared);
  return made;
}

bool has_turnstile(const Images& images) {
  return images.turnstile_begin < images.turnstile_end;
}

Schema<Images> tangle_turnstile() {
  Schema<Images> made;
  made.field("lobes", "", "numbers of the lobes between f^-1(bip) and the bip",
             [](const Images& i) {
               std::vector<std::int64_t> lobes;
               for (std::size_t k = i.turnstile_begin; k < i.turnstile_end; ++k)
                 lobes.push_back(static_cast<std::int64_t>(k));
               return lobes;
             })
      .field("lobe_area12", "area", "sum of the lobes that leave the region inside, each counted fully",
             [](const Images& i) { return if_true(has_turnstile(i), i.lobe_area12); })
      .or_null()
      .field("lobe_area21", "area", "sum of the lobes that enter it, each counted fully",
             [](const Images& i) { return if_true(has_turnstile(i), i.lobe_area21); })
      .or_null()
      .field("reason", "", "why they are not known", [](const Images& i) {
        if (i.period == 0) return std::optional(i.reason);
        return if_true(!has_turnstile(i), std::string("fewer pips before the bip than from a pip to its image"));
      });
  return made;
}

Schema<LobeOverlap> tangle_overlap() {
  Schema<LobeOverlap> made;
  made.field("i", "", "number of a lobe", &LobeOverlap::i)
      .field("j", "", "number of another one, i < j", &LobeOverlap::j)
      .field("area", "area", "area that the lobes have in common", &LobeOverlap::area)
      .field("error", "area", "bound on rounding; with smooth, an estimate against the smooth curves",
             &LobeOverlap::error)
      .field("perimeter", "length", "perimeter of their common region", &LobeOverlap::perimeter);
  return made;
}

// The largest over all lobes.
template <typename Of>
auto worst_lobe(Of of) {
  return [of](const CurveTangle& t) {
    double largest = 0;
    for (std::size_t k = 0; k < t.lobes.size(); ++k) largest = std::max(largest, of(t, k));
    return largest;
  };
}

Schema<CurveTangle> tangle_errors() {
  Schema<CurveTangle> rounding, discretisation, consistency;
  rounding
      .field("lobe", "area", "error of the worst lobe",
             worst_lobe([](const CurveTangle& t, std::size_t k) { return t.rounding(t.lobes[k].area); }))
      .field(
          "boundary", "area", "error of the boundary",
          [](const CurveTangle& t) { return t.boundary ? std::optional(t.rounding(t.boundary->area)) : std::nullopt; })
      .or_null();
  discretisation
      .field("lobe", "area", "error of the worst lobe",
             worst_lobe([](const CurveTangle& t, std::size_t k) { return t.discretisation(k); }))
      .field("boundary", "area", "error of the boundary",
             [](const CurveTangle& t) { return t.boundary ? std::optional(t.boundary_discretisation) : std::nullopt; })
      .or_null();
  consistency
      .field("inside_plus_outside", "area", "largest | |area| - inside - outside | of a lobe",
             worst_lobe([](const CurveTangle& t, std::size_t k) {
               const Lobe& lobe = t.lobes[k];
               return std::fabs(std::fabs(lobe.area) - lobe.inside - lobe.outside);
             }))
      .field("area_change", "",
             "largest difference in signed area of a lobe and its image, relative to the mean lobe; 0 if the map "
             "preserves area",
             [](const CurveTangle& t) {
               return if_true(t.images.period != 0 && t.images.compared > 0, t.images.area_change);
             })
      .or_null()
      .field(
          "turnstile_sum", "",
          "largest sum of signed areas from a pip to its image, relative to the mean lobe; 0 if the map preserves area",
          [](const CurveTangle& t) { return if_true(t.images.period != 0, t.images.turnstile_sum); })
      .or_null();
  Schema<CurveTangle> made;
  const auto whole = [](const CurveTangle& t) { return &t; };
  made.object("rounding", "bound on |area - exact area of the polygons as given|", rounding, whole)
      .object("discretisation",
              "estimate of |area of the polygon - area between smooth curves through the same points|; with smooth, of "
              "|area - area between the smooth curves|",
              discretisation, whole)
      .object("consistency", "numbers that should be zero", consistency, whole);
  return made;
}

Schema<CurveTangle> tangle_statistics() {
  Schema<SimpleCheck> check;
  check.field("boxes_tested", "", "pairs of boxes", [](const SimpleCheck& c) { return c.search.boxes_tested; })
      .field("pairs_tested", "", "pairs of segments that were decided", &SimpleCheck::pairs)
      .field("skipped_blocks", "", "blocks of the curves whose box meets nothing",
             [](const SimpleCheck& c) { return c.search.blocks_skipped; });
  Schema<CurveTangle> made;
  made.field("index", "", "index that was used", [](const CurveTangle& t) { return std::string(name(t.index)); })
      .field("fallback_segments", "", "segments that stay straight; with smooth",
             [](const CurveTangle& t) { return if_true(t.smooth, t.fallback_segments); })
      .field("fallback_pips", "", "pips that stay where the polygons have them; with smooth",
             [](const CurveTangle& t) { return if_true(t.smooth, t.fallback_pips); })
      .parts(counts_schema(), [](const CurveTangle& t) { return &t.nodes.counts(); })
      .object("check_simple", "the search of each curve against itself", check, &CurveTangle::check_simple);
  return made;
}

}  // namespace

Schema<CurveTangle> lobes_schema() {
  const auto whole = [](const CurveTangle& t) { return &t; };
  const auto bounded = [](const CurveTangle& t) { return t.boundary ? &t : nullptr; };
  Schema<CurveTangle> counts;
  counts.field("pips", "", "number of pips", [](const CurveTangle& t) { return t.pips.size(); })
      .field("lobes", "", "number of lobes", [](const CurveTangle& t) { return t.lobes.size(); })
      .field("bip", "", "number of the bip; -1 without one",
             [](const CurveTangle& t) { return t.boundary ? static_cast<std::int64_t>(t.boundary->bip) : -1; })
      .field("period", "", "number of pips from one to its image; 0 where it is not known",
             [](const CurveTangle& t) { return t.images.period; });
  Schema<CurveTangle> made;
  made.object("counts", "number of crossings", counts, whole)
      .not_in_json()
      .object("crossings", "where U and S meet", meetings_schema(), &CurveTangle::nodes)
      .list("pips", "primary intersections, outward along U", tangle_pip(), &CurveTangle::pips)
      .list("lobes", "lobes, each between a pip and the next one", tangle_lobe(),
            [](const CurveTangle& t) { return NumberedLobes{&t}; })
      .object("bip", "the pip at which the boundary passes from U to S", tangle_bip(), bounded)
      .object("boundary", "U up to the bip and S from there", tangle_boundary(), bounded)
      .object("images", "the action of the map on lobes, as far as it is known", tangle_images(), &CurveTangle::images)
      .object("turnstile", "its lobes", tangle_turnstile(), &CurveTangle::images)
      .list("overlaps", "pairs of lobes that have something in common; with overlaps", tangle_overlap(),
            &CurveTangle::overlaps)
      .field("remarks", "", "remarks on unusual manifolds", &CurveTangle::remarks)
      .object("error", "error bars of the areas", tangle_errors(), whole)
      .object("statistics", "work that was done", tangle_statistics(), whole);
  return made;
}

void measure_lobes(CurveTangle& tangle, bool with_overlaps) {
  const Stopwatch measures;
  tangle.shapes = lobe_shapes(tangle);
  if (tangle.boundary)
    tangle.boundary_discretisation = tangle.smooth ? tangle.boundary->smooth_error : boundary_discretisation(tangle);
  tangle.measures_seconds = measures.seconds();
  if (!with_overlaps) return;
  const Stopwatch watch;
  tangle.overlaps = lober::overlaps(tangle);
  tangle.overlaps_seconds = watch.seconds();
}

}  // namespace lober::detail::table
