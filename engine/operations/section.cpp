// `section`: orbits of a system's map, and when they leave. Its value is a SystemSection.
#include <algorithm>
#include <cmath>

#include "engine/operations/option_list.hpp"
#include "engine/operations/outcome_of.hpp"
#include "engine/operations/picture_size.hpp"
#include "engine/operations/schema.hpp"
#include "engine/operations/system_of.hpp"
#include "engine/operations/table.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/orbits.hpp"

namespace lober::operations {

std::vector<std::uint64_t> ExitTimes::counts() const {
  std::vector<std::uint64_t> counts(1);
  for (const std::uint32_t time : times) {
    if (time == stays) continue;
    if (time >= counts.size()) counts.resize(time + std::size_t{1});
    ++counts[time];
  }
  return counts;
}

std::uint64_t ExitTimes::staying() const {
  return static_cast<std::uint64_t>(std::count(times.begin(), times.end(), stays));
}

}  // namespace lober::operations

namespace lober::detail::table {
namespace {

constexpr double exit_cell = 4;  // pixels of a picture

struct SectionHow {
  std::size_t orbits = 1000, iterates = 1000;
  std::optional<Rectangle> box{};
  bool lifted = false, exit_times = false;
};

const OptionList<SectionHow>& section_options() {
  static const OptionList<SectionHow> options = [] {
    OptionList<SectionHow> list;
    list.option("orbits", &SectionHow::orbits, "number of orbits, whose first points are spread evenly over the box",
                {.min = 1, .max = 1e9, .value = "N"})
        .option("iterates", &SectionHow::iterates, "number of iterates of each orbit",
                {.min = 1, .max = 1e7, .value = "M"})
        .option("box", &SectionHow::box,
                "corners of the box in which orbits start and which is drawn, x0 < x1 and y0 < y1",
                {.otherwise = "the whole region of interest of the system, usually its window"})
        .option("lifted", &SectionHow::lifted,
                "whether to leave lifted angles as they come (default: points of a map that repeats after a shift, "
                "such as 2 pi, are shifted into one cell from the left side of the box on, and from its lower side "
                "where both coordinates are angles)")
        .option("exit_times", &SectionHow::exit_times,
                "whether to compute after how many crossings of the section orbits leave, the first point being "
                "crossing 1: one orbit begins in each cell of a grid on the box, as in a picture, in place of those "
                "of orbits; for systems whose orbits escape");
    return list;
  }();
  return options;
}

// ---------------------------------------------------------------------------------------------------------- result

struct Leaving {
  std::size_t crossings;
  std::uint64_t orbits;
};

std::vector<Leaving> leaving(const ExitTimes& times) {
  std::vector<Leaving> list;
  const std::vector<std::uint64_t> counts = times.counts();
  for (std::size_t n = 1; n < counts.size(); ++n) list.push_back({n, counts[n]});
  return list;
}

std::vector<Field> section_fields() {
  Schema<Leaving> leaves;
  leaves.field("crossings", "", "number of crossings after which orbits leave", &Leaving::crossings)
      .field("orbits", "", "number of orbits that leave then", &Leaving::orbits);
  Schema<ExitTimes> times;
  times.field("columns", "", "number of cells across", &ExitTimes::columns)
      .field("rows", "", "number of cells up", &ExitTimes::rows)
      .list("leaving", "orbits that leave after 1, 2, ... crossings", leaves, leaving)
      .field("staying", "", "number of orbits that do not leave", &ExitTimes::staying);
  Schema<SystemSection> made;
  made.field("points", "", "number of points of all orbits", &SystemSection::points)
      .field("points_in_box", "", "number of points in the box", &SystemSection::inside)
      .field("lost_orbits", "", "number of orbits that cannot be followed to the end, or that leave",
             &SystemSection::lost)
      .field("unreached_starts", "", "number of starts that the energy does not reach or the section excludes",
             &SystemSection::unreached)
      .object("exit_times", "times at which orbits leave, where they were asked for", times,
              [](const SystemSection& s) { return s.exit_times ? &*s.exit_times : nullptr; })
      .field("orbits", "length", "points of the orbits, iterates + 1 of each, NaN from where it is lost",
             &SystemSection::kept);
  return made.fields();
}

// ------------------------------------------------------------------------------------------------------------- run

Buffer<Point> middles(const Rectangle& box, std::size_t columns, std::size_t rows) {
  const auto middle = [](double low, double high, std::size_t k, std::size_t cells) {
    const double t = (static_cast<double>(k) + 0.5) / static_cast<double>(cells);
    return low * (1 - t) + high * t;
  };
  Buffer<Point> points(columns * rows);
  for (std::size_t k = 0; k < points.size(); ++k) {
    points[k] = {middle(box.min_x, box.max_x, k % columns, columns), middle(box.min_y, box.max_y, k / columns, rows)};
  }
  return points;
}

Rectangle box_of(const SectionHow& how, const System& system, const OrbitOptions& orbits) {
  if (how.box) return *how.box;
  // One cell of what repeats, exactly.
  Rectangle box = system.picture;
  if (orbits.lattice.x > 0) box.max_x = box.min_x + orbits.lattice.x;
  if (orbits.second_lattice.y > 0) box.max_y = box.min_y + orbits.second_lattice.y;
  return box;
}

// Adds an orbit to the counts.
void add(SystemSection& found, std::span<const Point> orbit, bool reached) {
  const auto lost = std::find_if(orbit.begin(), orbit.end(), [](const Point& point) { return std::isnan(point.x); });
  if (found.exit_times) {
    found.exit_times->times.push_back(!reached              ? ExitTimes::none
                                      : lost == orbit.end() ? ExitTimes::stays
                                                            : static_cast<std::uint32_t>(lost - orbit.begin()));
  }
  // Such a start is not a point of the section.
  if (!reached) {
    ++found.unreached;
    return;
  }
  found.lost += std::isnan(orbit.back().x) ? 1U : 0U;
  for (const Point& point : orbit) {
    const double x = (point.x - found.box.min_x) / found.box.width();
    const double y = (point.y - found.box.min_y) / found.box.height();
    if (std::isnan(x) || std::isnan(y)) continue;
    ++found.points;
    found.inside += x >= 0 && x < 1 && y >= 0 && y < 1 ? 1U : 0U;
  }
}

Outcome run_section(std::span<const Input> inputs, const Options& options, const Context& context) {
  const System& system = *system_of(inputs).system;
  const auto* given = inputs.size() == 2 ? std::get_if<std::span<const Point>>(&inputs[1]) : nullptr;
  const SectionHow how = section_options().how(options);
  if (how.exit_times && given != nullptr) {
    throw UsageError("option \"exit_times\" and points to start from cannot be given together: orbits begin in cells");
  }
  SystemSection found;
  found.options.iterates = how.iterates;
  if (!how.lifted) {
    found.options.lattice = system.lattice;
    found.options.second_lattice = system.second_lattice;
  }
  found.box = box_of(how, system, found.options);
  found.options.origin = {found.box.min_x, found.box.min_y};
  Buffer<Point> own;
  if (how.exit_times) {
    const PictureSize size = picture_size(found.box);
    found.exit_times = ExitTimes{found.box,
                                 static_cast<std::size_t>(size.width / exit_cell),
                                 static_cast<std::size_t>(size.height / exit_cell),
                                 {}};
    own = middles(found.box, found.exit_times->columns, found.exit_times->rows);
  } else if (given == nullptr) {
    own = spread_points(found.box, how.orbits);
  }
  const std::span<const Point> starts = given != nullptr ? *given : std::span<const Point>(own);
  found.orbits = starts.size();
  const std::size_t each = how.iterates + 1;
  follow_orbits(*system.map, starts, found.options, [&](std::size_t first, std::span<const Point> points) {
    const std::size_t count = points.size() / each;
    found.reached.clear();
    for (std::size_t k = 0; k < count; ++k) {
      const std::span<const Point> orbit = points.subspan(k * each, each);
      found.reached.push_back(system.map->is_defined_at(orbit.front()));
      add(found, orbit, found.reached.back());
    }
    found.first = first;
    found.block = points;
    if (context.on_part) {
      context.on_part(&found);
    } else {
      found.kept.insert(found.kept.end(), points.begin(), points.end());
    }
    const double done = static_cast<double>(first + count) / static_cast<double>(starts.size());
    return context.progress(done, "orbits");
  });
  found.block = {};
  Outcome outcome = outcome_of(std::move(found), options);
  const auto& result = outcome.as<SystemSection>();
  outcome.chosen.push_back({"orbits", static_cast<std::int64_t>(result.orbits)});
  outcome.chosen.push_back({"box", result.box});
  outcome.chosen.push_back({"lattice", result.options.lattice});
  outcome.chosen.push_back({"second_lattice", result.options.second_lattice});
  return outcome;
}

}  // namespace

Operation section_operation() {
  Operation operation;
  operation.name = "section";
  operation.title = "orbits of a system's map: a Poincare section, and when orbits leave";
  operation.summary = "Follows orbits of a map, or of a flow's Poincare map, and counts their points.";
  operation.compares = false;
  operation.inputs = {{"system", InputKind::system, "the system whose orbits they are"},
                      {"starts", InputKind::points, "first points of orbits, in place of those of orbits", true}};
  operation.options = section_options().specs();
  operation.result = section_fields();
  operation.examples = {{{"standard K=1.2"}, {}, "orbits from points spread over the window"},
                        {{"ovp"}, {{"orbits", std::int64_t{100}}}, "a hundred orbits of the vortex pair"}};
  operation.run = run_section;
  return operation;
}

}  // namespace lober::detail::table
