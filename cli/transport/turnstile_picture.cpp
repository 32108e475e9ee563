// The picture of turnstiles in the plane, of `lober transport`: that of the first boundary with its images and
// pre-images, and of further boundaries the turnstile alone.

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "cli/picture/area_box.hpp"
#include "cli/picture/system_figure.hpp"
#include "cli/tangle/tangle_figure.hpp"
#include "cli/transport/transport_report.hpp"
#include "lober/base/error.hpp"
#include "lober/overlay/overlay.hpp"

namespace lober::cli {
namespace {

// The lobes from f^-before(q) to f^after(q) that leave the region, or that enter it.
std::vector<std::size_t> lobes_between(const ManifoldTangle& manifolds, int before, int after, bool leaving) {
  std::vector<std::size_t> lobes;
  for (std::size_t k = manifolds.image_of_bip(-before); k < manifolds.image_of_bip(after); ++k) {
    if ((manifolds.tangle.images.labels[k].from == 1) == leaving) lobes.push_back(k);
  }
  return lobes;
}

// The common parts of lobes of the two lists, as polygons. Lobes that fall into pieces are left out.
std::vector<std::vector<Point>> common_pieces(const Tangle& tangle, std::span<const std::size_t> first,
                                              std::span<const std::size_t> second) {
  std::vector<std::vector<Point>> polygons;
  for (const LobeOverlap& both : overlaps(tangle)) {
    const auto in = [](std::span<const std::size_t> list, std::size_t k) {
      return std::find(list.begin(), list.end(), k) != list.end();
    };
    if (!(in(first, both.i) && in(second, both.j)) && !(in(first, both.j) && in(second, both.i))) continue;
    const std::vector<Point> one = lobe_outline(tangle, both.i), other = lobe_outline(tangle, both.j);
    try {
      const Overlay found = overlay(ClosedCurve::borrow(one), ClosedCurve::borrow(other));
      const std::size_t pieces = found.pieces(Pairing::intersection).size();
      for (std::size_t k = 0; k < pieces; ++k) {
        for (std::vector<Point>& loop : outline(found, Pairing::intersection, k)) polygons.push_back(std::move(loop));
      }
    } catch (const NotSimpleError&) {
      continue;
    }
  }
  return polygons;
}

Layer lobes_layer(const Tangle& tangle, std::span<const std::size_t> lobes, const char* name, std::string legend,
                  const char* colour, double opacity) {
  Layer layer = fill_layer(name, std::move(legend), colour);
  layer.opacity = opacity;
  for (const std::size_t k : lobes) {
    layer.lines.push_back(polyline(lobe_outline(tangle, k), true, text(tangle.images.labels[k])));
  }
  return layer;
}

// The numbers of the regions inside and outside of a boundary, from 1.
std::array<int, 2> regions_at(const Transport& found, std::size_t boundary) {
  std::array<int, 2> numbers{1, 2};
  for (std::size_t k = 0; k < found.regions.size(); ++k) {
    const int coefficient = found.regions[k].coefficients[boundary + 1];
    if (coefficient != 0) numbers[coefficient > 0 ? 0 : 1] = static_cast<int>(k + 1);
  }
  return numbers;
}

// The turnstile of one boundary, with the numbers that regions have among all boundaries.
class Turnstile {
 public:
  Turnstile(const Transport& found, std::size_t boundary)
      : boundary_(found.boundaries[boundary]),
        tangle_(boundary_.manifolds->tangle),
        regions_(regions_at(found, boundary)),
        outwards_(lobes_between(*boundary_.manifolds, 1, 0, true)),
        inwards_(lobes_between(*boundary_.manifolds, 1, 0, false)) {}

  [[nodiscard]] const Tangle& tangle() const { return tangle_; }
  [[nodiscard]] int inside() const { return regions_[0]; }
  [[nodiscard]] const std::vector<std::size_t>& outwards() const { return outwards_; }  ///< lobes
  [[nodiscard]] const std::vector<std::size_t>& inwards() const { return inwards_; }
  /// "L12": from the region inside to that outside, or back.
  [[nodiscard]] std::string name(bool leaving) const {
    return "L" + std::to_string(regions_[leaving ? 0 : 1]) + std::to_string(regions_[leaving ? 1 : 0]);
  }
  [[nodiscard]] LobeLabel label(std::size_t lobe) const {
    LobeLabel label = tangle_.images.labels[lobe];
    const bool leaving = label.from == 1;
    label.from = regions_[leaving ? 0 : 1];
    label.to = regions_[leaving ? 1 : 0];
    return label;
  }
  void add_to(Figure& figure) const {
    for (const bool outwards : {true, false}) {
      // As region 1 sees it, if that is on one side.
      const bool leaves = outwards ? regions_[1] != 1 : regions_[1] == 1;
      const std::string lobe = name(outwards) + "(1)";
      const double area = (outwards ? boundary_.flux12 : boundary_.flux21).value;
      figure.layers.push_back(lobes_layer(tangle_, outwards ? outwards_ : inwards_, lobe.c_str(),
                                          lobe + (leaves ? ", leaves, area " : ", enters, area ") + rounded(area),
                                          leaves ? palette::leaving : palette::entering, 0.75));
    }
  }
  void add_names(Figure& figure, std::span<const std::size_t> lobes, double size) const {
    for (const std::size_t k : lobes) {
      figure.labels.push_back({.position = FigureLabel::Position::inside,
                               .text = lobe_text(label(k)),
                               .polygon = polyline(lobe_outline(tangle_, k), true),
                               .size = size});
    }
  }

 private:
  const TransportBoundary& boundary_;
  const Tangle& tangle_;
  std::array<int, 2> regions_;
  std::vector<std::size_t> outwards_, inwards_;
};

// p_1, p_2, ... for all saddles, each once, from the left.
void name_saddles(Figure& figure) {
  std::vector<Point> saddles;
  for (const Layer& layer : figure.layers) {
    if (layer.name == "saddles") saddles.insert(saddles.end(), layer.points.begin(), layer.points.end());
  }
  std::sort(saddles.begin(), saddles.end(), [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  saddles.erase(std::unique(saddles.begin(), saddles.end()), saddles.end());
  for (std::size_t k = 0; k < saddles.size(); ++k) {
    figure.labels.push_back({.text = "p_{" + std::to_string(k + 1) + "}", .at = saddles[k], .radius = 2.2, .size = 8});
  }
}

// The names of the regions of a plane: of those inside one boundary, and of the one outside of all.
void add_region_names(Figure& figure, const Transport& found, std::span<const Turnstile> turnstiles) {
  std::vector<Point> all;  // even-odd: outlines, with a way from the first to each other one and back
  for (const Turnstile& turnstile : turnstiles) {
    const std::vector<Point> outline = boundary_outline(turnstile.tangle());
    figure.labels.push_back({.position = FigureLabel::Position::inside,
                             .text = "R_{" + std::to_string(turnstile.inside()) + "}",
                             .polygon = polyline(outline, true),
                             .size = 9});
    all.insert(all.end(), outline.begin(), outline.end());
    all.push_back(outline.front());
    all.push_back(all.front());
  }
  for (std::size_t k = 0; k < found.regions.size(); ++k) {
    if (found.regions[k].coefficients[0] == 0) continue;
    figure.labels.push_back({.position = FigureLabel::Position::outside,
                             .text = "R_{" + std::to_string(k + 1) + "}",
                             .polygon = polyline(all, true),
                             .size = 9});
  }
}

}  // namespace

Figure turnstile_figure(const TransportReport& report, const PictureRequest& how) {
  const Transport& found = report.result();
  std::vector<Turnstile> turnstiles;
  for (std::size_t k = 0; k < found.boundaries.size(); ++k) turnstiles.emplace_back(found, k);
  const Turnstile& first = turnstiles.front();
  const ManifoldTangle& manifolds = report.manifolds();
  const Tangle& tangle = manifolds.tangle;
  // As the overlaps are computed: nothing is followed for longer than half of the iterates.
  const int n = static_cast<int>(found.steps.size()), before = 1 + (n - 1) / 2,
            after = std::max(0, n - 1 - (n - 1) / 2);
  const auto leaving = lobes_between(manifolds, before, 0, true), entering = lobes_between(manifolds, 1, after, false);
  Figure figure{.what = "Turnstile of " + report.system.info.name, .title = system_title(report.system.info)};
  name_axes(figure, report.system);
  std::vector<std::vector<Point>> shown;
  const auto show = [&](const Tangle& of, std::span<const std::size_t> lobes) {
    for (const std::size_t k : lobes) shown.push_back(lobe_outline(of, k));
  };
  Rectangle boundaries;
  for (const Turnstile& turnstile : turnstiles) {
    shown.push_back(boundary_outline(turnstile.tangle()));
    boundaries = include(boundaries, shown.back());
    show(turnstile.tangle(), &turnstile == &first ? std::span(leaving) : std::span(turnstile.outwards()));
    show(turnstile.tangle(), turnstile.inwards());
  }
  figure.window = with_margin(box_about(boundaries, area_box(shown)));
  for (std::size_t k = 0; k < turnstiles.size(); ++k) {
    add_boundary(figure, turnstiles[k].tangle(), std::fabs(found.boundaries[k].enclosed.value));
  }
  const auto others = [](const std::vector<std::size_t>& all, const std::vector<std::size_t>& without) {
    std::vector<std::size_t> rest;
    std::copy_if(all.begin(), all.end(), std::back_inserter(rest),
                 [&](std::size_t k) { return std::find(without.begin(), without.end(), k) == without.end(); });
    return rest;
  };
  for (const Turnstile& turnstile : turnstiles) turnstile.add_to(figure);
  const auto pre_images = others(leaving, first.outwards()), images = others(entering, first.inwards());
  const auto add = [&](std::span<const std::size_t> lobes, const std::string& name, const char* colour) {
    if (!lobes.empty()) figure.layers.push_back(lobes_layer(tangle, lobes, name.c_str(), name, colour, 0.3));
  };
  add(pre_images, "pre-images of " + first.name(true) + "(1)", palette::leaving);
  add(images, "images of " + first.name(false) + "(1)", palette::entering);
  Layer common = fill_layer("overlaps", "overlaps", palette::common);
  common.opacity = 0.8;
  for (std::vector<Point>& polygon : common_pieces(tangle, leaving, entering)) {
    common.lines.push_back(polyline(std::move(polygon), true));
  }
  if (!common.lines.empty()) figure.layers.push_back(std::move(common));
  for (const Turnstile& turnstile : turnstiles) add_manifolds(figure, turnstile.tangle());
  const bool labels = how.labels_for(leaving.size() + entering.size());
  Layer pips = dot_layer("pips", "pips of the turnstile", {}, 1.3), bips = dot_layer("bip", "bip q", {}, 1.8);
  bips.hollow = true;
  for (std::size_t k = 0; k < turnstiles.size(); ++k) {
    for (const ConnectingOrbit& orbit : found.boundaries[k].manifolds->orbits) pips.points.push_back(orbit.at);
    const Tangle& of = turnstiles[k].tangle();
    if (!of.boundary) continue;
    bips.points.push_back(of.pips[of.boundary->bip].at);
    const std::string name = turnstiles.size() == 1 ? "q" : "q_{" + std::to_string(turnstiles[k].inside()) + "}";
    if (labels) figure.labels.push_back({.text = name, .at = bips.points.back(), .radius = 2.2});
  }
  for (const Turnstile& turnstile : turnstiles) {
    const Tangle& of = turnstile.tangle();
    // Boundaries that share their saddles are named once.
    const bool same = &turnstile != &first && of.u().points.front() == tangle.u().points.front() &&
                      of.s().points.front() == tangle.s().points.front();
    if (!same) add_saddles(figure, of, labels && turnstiles.size() == 1);
  }
  figure.layers.push_back(std::move(pips));
  if (!bips.points.empty()) figure.layers.push_back(std::move(bips));
  if (!labels) return figure;
  if (turnstiles.size() > 1) name_saddles(figure);
  if (report.system.lattice == Point{}) add_region_names(figure, found, turnstiles);
  for (const Turnstile& turnstile : turnstiles) {
    turnstile.add_names(figure, turnstile.outwards(), 7.5);
    turnstile.add_names(figure, turnstile.inwards(), 7.5);
  }
  first.add_names(figure, pre_images, 6.5);
  first.add_names(figure, images, 6.5);
  return figure;
}

}  // namespace lober::cli
