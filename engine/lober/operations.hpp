// The operations of the engine, described once: each with its inputs, its options and the parts of its result.
//
// The program, the batch, the C interface and the Python module follow from this table: to parse, check, print, store
// and document, they walk over it. C++ programs call the functions of the other headers, which an operation calls.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lober/base/agreement.hpp"
#include "lober/base/export.hpp"
#include "lober/base/progress.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/densify.hpp"
#include "lober/curve/point.hpp"
#include "lober/dynamics/fixed_points.hpp"
#include "lober/dynamics/levels.hpp"
#include "lober/dynamics/manifolds.hpp"
#include "lober/dynamics/orbits.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/overlay/index.hpp"
#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"
#include "lober/overlay/smooth.hpp"
#include "lober/tangle/manifold_tangle.hpp"
#include "lober/tangle/tangle.hpp"
#include "lober/transport/melnikov.hpp"
#include "lober/transport/monte_carlo.hpp"
#include "lober/transport/sweep.hpp"
#include "lober/transport/transport.hpp"

namespace lober::operations {

// ---------------------------------------------------------------------------------------------------------- options

using OptionValue = std::variant<bool, std::int64_t, double, std::string, Point, Rectangle, std::vector<double>>;

/// An option. The type of `fallback` is the type of the option; a whole number is taken for a double too, and numbers
/// for a point or a rectangle: x0, y0, x1, y1. A key "parameters.*" stands for any number of options "parameters.NAME"
/// without a fallback.
struct OptionSpec {
  std::string key;
  OptionValue fallback;
  std::string meaning = {};               ///< a phrase: "number of iterates n"
  std::vector<std::string> choices = {};  ///< allowed values of a string; empty: any string
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool above_min = false;  ///< min itself is excluded
  bool optional = false;   ///< absent unless given: `fallback` has its type, `otherwise` says what is done without it
  bool required = false;   ///< optional, but a value has to be given
  std::string otherwise = {};
  std::string value = {};  ///< name of the value in help texts: "N"

  [[nodiscard]] bool family() const { return key.ends_with(".*"); }
  [[nodiscard]] bool is_for(std::string_view wanted) const {
    return wanted == key || (family() && wanted.starts_with(std::string_view(key).substr(0, key.size() - 1)));
  }
};

struct OptionSetting {
  std::string key;
  OptionValue value;
};

/// All options of an operation, each with its value. Cheap to share, never changed.
class LOBER_API Options {
 public:
  Options() = default;
  /// Every option has its fallback, except for the settings, where the last one for a key counts. Throws UsageError
  /// "key: what is wrong".
  Options(std::span<const OptionSpec> specs, std::span<const OptionSetting> settings);

  [[nodiscard]] bool flag(std::string_view key) const { return std::get<bool>(at(key)); }
  [[nodiscard]] std::int64_t whole(std::string_view key) const { return std::get<std::int64_t>(at(key)); }
  [[nodiscard]] double real(std::string_view key) const { return std::get<double>(at(key)); }
  [[nodiscard]] const std::string& text(std::string_view key) const { return std::get<std::string>(at(key)); }
  [[nodiscard]] std::optional<Point> point(std::string_view key) const;
  /// The value of an option; null if it is absent: all options of the specs are there, except those without a fallback
  /// that were not given.
  [[nodiscard]] const OptionValue* find(std::string_view key) const;
  /// The options whose keys begin with "prefix.", which is left out, in the order of their names.
  [[nodiscard]] std::vector<std::pair<std::string, double>> reals_of(std::string_view prefix) const;

  /// All settings in the order of the specs.
  [[nodiscard]] std::span<const OptionSetting> settings() const { return *settings_; }
  /// "areas_only=false index=auto": the same for the same values, whether they were given or not.
  [[nodiscard]] std::string to_string() const;

 private:
  [[nodiscard]] const OptionValue& at(std::string_view key) const;

  std::shared_ptr<const std::vector<OptionSetting>> settings_ = std::make_shared<const std::vector<OptionSetting>>();
};

/// The settings as "key=value key=value".
[[nodiscard]] LOBER_API std::string to_string(std::span<const OptionSetting> settings);
/// A value as Options::to_string has it: numbers in the shortest form that reads back to the same bits, points as
/// "x,y", rectangles as "x0,y0,x1,y1".
[[nodiscard]] LOBER_API std::string to_string(const OptionValue& value);
/// The numbers of a point, a rectangle or a list; empty for any other value.
[[nodiscard]] LOBER_API std::vector<double> numbers_of(const OptionValue& value);
/// The value of an option that is written as text: "true", "1e-5", "0.5,-1". Throws UsageError "key: what is wrong".
[[nodiscard]] LOBER_API OptionValue option_value(const OptionSpec& spec, std::string_view key, const std::string& text);

// ----------------------------------------------------------------------------------------------------------- inputs

enum class InputKind : std::uint8_t {
  closed_curve,
  open_curve,
  curve,  ///< closed or open, as an option says; its segments are not searched
  points,
  system,
};

struct InputSpec {
  std::string name;
  InputKind kind = InputKind::system;
  std::string meaning;
  bool optional = false;  ///< only the last inputs can be
};

/// A system with its parameters, and a way to change them.
struct SystemInput {
  std::shared_ptr<const System> system;
  IntegrationOptions integration{};  ///< options with which it was made
  /// The same system with other values of some parameters; empty where the parameters cannot be changed.
  std::function<System(const ParameterValues& changed)> with{};
};
/// A built-in system or a library by its name.
[[nodiscard]] LOBER_API SystemInput system_input(const std::string& name, const ParameterValues& values,
                                                 const IntegrationOptions& integration = {});

/// A curve with the facts that are known about it already.
struct CurveInput {
  CurveView curve{};
  std::string name{};                        ///< name in messages; empty: that of the InputSpec
  const IndexedCurve* index = nullptr;       ///< index of a curve that is validated
  const DiscretisationSums* sums = nullptr;  ///< sums for the overlay's estimate
  bool simple = false;                       ///< known to be simple
};

/// The points stay the caller's for as long as the operation runs and its value is used. Where an operation takes a
/// curve, points count as a curve.
using Input = std::variant<SystemInput, CurveInput, std::span<const Point>>;

// ---------------------------------------------------------------------------------------------------------- results

enum class FieldKind : std::uint8_t {
  number,  ///< double, or Measured: with its error bar
  whole,   ///< an integer
  flag,    ///< true or false
  text,
  lines,    ///< texts
  numbers,  ///< doubles
  wholes,   ///< integers
  point,    ///< x and y
  matrix,   ///< numbers, row by row, with or without bars
  object,   ///< named fields
  list,     ///< objects with the same fields
  points,   ///< points of a curve
};

struct Matrix {
  std::size_t rows = 0, columns = 0;
  std::vector<Measured> entries;
};

/// The value of a field; std::monostate: not known, or not asked for.
using FieldValue =
    std::variant<std::monostate, double, Measured, std::int64_t, bool, std::string, std::vector<std::string>,
                 std::vector<double>, std::vector<std::int64_t>, Point, std::vector<Point>, Matrix>;

struct Field;

/// The fields of an object, which copies share: a range of `const Field`.
class LOBER_API Fields {
 public:
  Fields() = default;
  Fields(std::vector<Field> fields);  // NOLINT(google-explicit-constructor)
  [[nodiscard]] const Field* begin() const { return data(); }
  [[nodiscard]] const Field* end() const;
  [[nodiscard]] const Field* data() const;
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] bool empty() const { return size() == 0; }

 private:
  std::shared_ptr<const std::vector<Field>> fields_;
};

/// A part of a result: its name, its meaning, and how it is read from an object of the type it belongs to.
struct Field {
  std::string name;
  FieldKind kind = FieldKind::number;
  std::string unit = {};  ///< "area": coordinates squared; "length", "time", "action", ""
  std::string meaning = {};
  std::string bar = {};  ///< name of the error bar of a number or a matrix; empty: there is none
  Fields members = {};   ///< fields of an object, or of each element of a list
  bool in_json = true;   ///< false for the points of curves and fields as long
  bool null = false;     ///< null in JSON where it is not known; if false, left out there

  using Use = std::function<void(const void* part)>;
  /// The elements of a list. May be read from several threads at the same time.
  struct Elements {
    std::size_t size = 0;
    bool known = true;  ///< false where it was not asked for
    std::function<void(std::size_t element, const Use& use)> at{};
  };
  std::function<FieldValue(const void* whole)> get{};  ///< empty for objects and lists
  /// The same of a number, a whole one or a flag, for those who read millions: NaN where it is not known.
  std::function<Measured(const void* whole)> number{};
  std::function<void(const void* whole, const Use& use)> part{};  ///< for an object; no call where it is not known
  /// Its address, null where it is not known, if the object lies in the whole; empty if it is made when asked for.
  std::function<const void*(const void* whole)> address{};
  std::function<Elements(const void* whole)> elements{};  ///< for a list

  /// Calls `use` with the object, if it is known, or with each element of the list.
  void each(const void* whole, const Use& use) const {
    if (part) return part(whole, use);
    const Elements all = elements(whole);
    for (std::size_t k = 0; k < all.size; ++k) all.at(k, use);
  }
};

inline Fields::Fields(std::vector<Field> fields)
    : fields_(std::make_shared<const std::vector<Field>>(std::move(fields))) {}
inline const Field* Fields::data() const {
  return fields_ ? fields_->data() : nullptr;
}
inline std::size_t Fields::size() const {
  return fields_ ? fields_->size() : 0;
}
inline const Field* Fields::end() const {
  return data() + size();
}

/// The field at "turnstile.flux12", or the one whose bar is at "turnstile.flux12_error". Throws UsageError for a path
/// that leads nowhere.
[[nodiscard]] LOBER_API const Field& field_at(std::span<const Field> fields, std::string_view path);
/// The way to numbers of a result, found once: "turnstile.flux12" or "turnstile.flux12_error".
class LOBER_API NumberPath {
 public:
  /// Throws UsageError for a path that leads nowhere. The fields have to outlive it.
  NumberPath(std::span<const Field> fields, std::string_view path);
  /// One number for each element of lists: "steps.T21". NaN where it is not known.
  [[nodiscard]] std::vector<double> all(const void* whole) const;
  /// The first of them; NaN where there is none.
  [[nodiscard]] double first(const void* whole) const;
  [[nodiscard]] const Field& field() const { return *fields_.back(); }

 private:
  std::vector<const Field*> fields_;
  bool bar_ = false;
};
/// NumberPath(fields, path).all(whole).
[[nodiscard]] LOBER_API std::vector<double> numbers_at(std::span<const Field> fields, const void* whole,
                                                       std::string_view path);

/// The members of an object in JSON, without the braces: numbers with the digits that give them back, null for those
/// that are not finite; members that are not known are null where Field::null is set, else left out. Members of the
/// outermost object, and elements of lists that are not within others, have lines of their own. Long lists are
/// formatted in parallel and handed on in parts, so that none stands in memory as a whole.
LOBER_API void write_json_members(std::span<const Field> fields, const void* whole,
                                  const std::function<void(std::string_view)>& write);
[[nodiscard]] LOBER_API std::string json_members(std::span<const Field> fields, const void* whole);
/// The same as an object in one line.
[[nodiscard]] LOBER_API std::string json_object(std::span<const Field> fields, const void* whole);
/// A schema (JSON Schema 2020-12) of these members.
[[nodiscard]] LOBER_API std::string json_schema(std::span<const Field> fields);

// ------------------------------------------------------------------------------------------------ values of results

/// The result of "overlay".
struct CurveOverlay : Overlay {
  bool has_pieces = true;                 ///< whether pieces were asked for
  std::optional<Areas> discretisation{};  ///< estimates of |area of the polygons - between smooth curves|
  std::optional<Areas> consistency{};     ///< |area - by the interior function|
  std::optional<SmoothAreas> smooth{};
  std::optional<std::array<std::vector<SigmaStep>, 2>> steps{};  ///< sigma of A1 \ A2 and of A2 \ A1
  Agreement agreement{};
  double verify_seconds = 0, smooth_seconds = 0;
};
/// The result of "interior".
struct CurveInterior : InteriorAreas {
  std::optional<Areas> splitting{};    ///< where segments were not split: |area - area with split segments|
  std::optional<Areas> consistency{};  ///< |area - by the overlay|
  Agreement agreement{};
  double verify_seconds = 0;
};
/// The result of "densify" and "simplify".
struct RefinedCurve : DensifiedCurve {
  struct Step {
    std::string name;          ///< "simplify", "criteria", "passes" or "crossings"
    std::size_t points = 0;    ///< number of points after the step
    std::uint32_t rounds = 0;  ///< number of rounds that it took
  };
  std::size_t given = 0;                    ///< number of points
  std::vector<Step> steps{};                ///< in order
  std::optional<DensifiedCurve> against{};  ///< the other curve with the crossings inserted
  /// Number of diagnostics of the criteria, by DiagnosticCause, and of their segments; there are no diagnostics
  /// themselves where a later step has changed the numbers of segments.
  std::array<std::size_t, all_diagnostic_causes.size()> places{};
  std::size_t segments_with_diagnostics = 0;
};
/// The result of "regions".
struct CurveRegions {
  Regions regions;
  FillRule rule = FillRule::nonzero;
  Areas areas{}, rounding{};                            ///< by the rule
  std::optional<std::array<RegionPieces, 4>> pieces{};  ///< in the order of all_pairings
};
/// The result of "grow".
struct SystemManifold : GrownManifold {
  LocalManifold local{};  ///< near the saddle
  Branch branch = Branch::plus;
  double local_seconds = 0, growth_seconds = 0;
};
/// The result of "winding".
struct CurveWinding {
  struct Count {
    int winding;
    std::size_t points;
  };
  std::span<const Point> points;
  std::vector<Winding> windings;      ///< winding number of each point
  std::vector<InteriorValue> values;  ///< J at each point
  std::vector<Count> counts;          ///< ascending; points on the curve are not counted
  std::size_t on = 0;                 ///< points on the curve
  double difference = 0;              ///< the largest |J / 2 pi - winding number|
  double bar = 0;                     ///< bound on the difference
  Agreement agreement;                ///< points where the difference exceeds the bound
};
/// The result of "image".
struct CurveImages {
  struct One {
    CurveImage image{};
    std::size_t curve = 0;  ///< 1: the second boundary of a cylinder
    std::vector<ImagePart> parts{};
    double length = 0;  ///< length of all parts together
    /// Signed area of an image that is whole and meets the tolerance everywhere; the error is the area that a polygon
    /// may leave out: the tolerance times its length.
    std::optional<Measured> area{};

    [[nodiscard]] LOBER_API std::string name() const;  ///< "f^-2", for a second curve "f^-2 boundary 2"
  };
  std::string what{};           ///< "circle of radius 0.1 about (1, 0)"; empty where a curve was given
  bool closed = true;           ///< whether the curve is closed
  std::vector<One> images{};    ///< in the order of iterates; of two curves, those of the first one come first
  Rectangle box{};              ///< the box in which the tolerance holds
  bool preserves_area = false;  ///< the map has an action
  Agreement agreement{};        ///< areas of images against that of the first
  double curve_seconds = 0, image_seconds = 0;
};
/// The result of "tangle".
struct CurveTangle : Tangle {
  bool smooth = false;              ///< whether areas are those of smooth curves
  std::vector<LobeShape> shapes{};  ///< shape of each lobe
  double boundary_discretisation = 0;
  std::optional<std::vector<LobeOverlap>> overlaps{};  ///< where they were asked for
  Agreement agreement{};
  double measures_seconds = 0, overlaps_seconds = 0;

  /// The error of a lobe's area against the smooth curves through the points: estimated from the polygon, or, when
  /// areas are those of smooth curves, by how far these can be trusted.
  [[nodiscard]] double discretisation(std::size_t lobe) const {
    return smooth ? lobes[lobe].smooth_error : shapes[lobe].discretisation;
  }
};
/// The result of "manifold_tangle".
struct SystemTangle : CurveTangle {
  std::shared_ptr<const ManifoldTangle> manifolds{};
  double growth_seconds = 0;
};
/// The lobes of a turnstile to first order in the size of the system's perturbation, a parameter, beside their areas.
struct MelnikovComparison {
  std::string parameter;
  double eps = 0;  ///< its value
  Melnikov function;
  Melnikov::Sides estimate, exact;  ///< `exact` by action, where the map has one
};
/// The result of "transport".
struct SystemTransport : Transport {
  std::optional<MelnikovComparison> melnikov{};  ///< where it was asked for
};
/// The result of "curve_transport".
struct CurveTransport : TransportOfCurves {
  std::size_t period = 0;  ///< number of pips from one to its image
  std::string why{};       ///< the limit, with the number of rows
};
/// The result of "escape".
struct SystemEscape : Escape {
  std::optional<MonteCarlo> counted{};  ///< where trajectories were followed
  std::uint64_t seed = 1;               ///< seed of their random numbers
};
/// The result of "fixed_points": the points that were found, and the box that was searched.
struct SystemFixedPoints : FixedPointSearch {
  Rectangle box{};
  int period = 1, turns = 0;
};
/// A level of the result of "levels".
struct SystemLevel {
  double value = 0;
  std::optional<Point> saddle{};  ///< the saddle that the level goes through
  std::vector<LevelCurve> curves{};

  [[nodiscard]] LOBER_API std::size_t closed() const;  ///< number of closed curves
  [[nodiscard]] LOBER_API std::size_t points() const;  ///< number of points of all curves
};
struct SystemLevels {
  std::vector<Equilibrium> saddles{};
  std::vector<SystemLevel> levels{};        ///< by value, ascending
  std::shared_ptr<const LevelGrid> grid{};  ///< grid on which the energy was evaluated
};
/// The number of crossings of the section after which orbits leave that begin in the middle of each cell of a grid.
struct ExitTimes {
  Rectangle window{};
  std::size_t columns = 0, rows = 0;
  std::vector<std::uint32_t> times{};  ///< row by row from below; the start is the first crossing
  static constexpr std::uint32_t none = 0, stays = 0xffffffff;  ///< section not reached; orbit does not leave

  [[nodiscard]] std::uint32_t of(std::size_t column, std::size_t row) const { return times[row * columns + column]; }
  /// Number of cells that leave after each number of crossings, from 0 (not on the section) on; the rest stay.
  [[nodiscard]] LOBER_API std::vector<std::uint64_t> counts() const;
  [[nodiscard]] LOBER_API std::uint64_t staying() const;
};
/// The result of "section". Context::on_part gets it with each block of orbits.
struct SystemSection {
  Rectangle box{};
  OrbitOptions options{};
  std::size_t orbits = 0, lost = 0, unreached = 0;  ///< numbers of orbits
  std::uint64_t points = 0, inside = 0;             ///< points of all orbits, and those in the box
  std::optional<ExitTimes> exit_times{};            ///< where they were asked for
  std::vector<Point> kept{};                        ///< points of all orbits; empty where on_part takes them
  // In on_part: a block as follow_orbits gives it, and which of its starts are points of the section.
  std::size_t first = 0;
  std::span<const Point> block{};
  std::vector<bool> reached{};
};
/// The result of "sweep".
struct SystemSweep : Sweep {
  std::string parameter{};
  std::string no_zero{};  ///< why no zero was found, where zeros were looked for; else empty
  /// For each row, where it was asked for: area of the lobes of one side to first order; NaN where it is not known.
  std::optional<std::vector<double>> first_order{};
  Agreement agreement{};  ///< rows that disagree are failures
  std::vector<std::string> remarks{};
};

// ------------------------------------------------------------------------------------------------------- operations

/// Callbacks and limits of a run of an operation. All of them may be left out.
struct Context {
  Progress progress{};
  /// Called with `progress`, where the work done can be counted, in a unit such as "points".
  std::function<void(double amount, std::string_view unit)> count{};
  /// Called from the calling thread with each element of a list that takes long as soon as it is ready, and with all
  /// comparisons so far.
  std::function<void(const Field& list, const void* element, const Agreement& agreement)> on_element{};
  /// Called likewise with all that is known so far: the value of the result, without the later parts.
  std::function<void(const void* so_far)> on_part{};
  /// Whether cancelled work returns the part that is known, where an operation can (escape).
  bool keeps_what_is_known = false;
  std::size_t memory = std::numeric_limits<std::size_t>::max();  ///< bytes that the work may hold, roughly
  /// Called with the bytes that the work does hold, where options decide how many; an exception from it ends the work.
  std::function<void(std::size_t bytes)> holds{};
};

/// A result: an object of a type that the operation knows.
struct Outcome {
  std::shared_ptr<const void> value;
  Agreement agreement;                ///< comparisons of all routes
  std::vector<std::string> remarks;   ///< remarks that a user should read
  std::string incomplete;             ///< why a part is missing that was asked for; empty if nothing is
  std::string failed;                 ///< which of many independent parts failed and why; empty if none did
  Options options;                    ///< options with which it was computed
  std::vector<OptionSetting> chosen;  ///< in place of some options: values that followed from options and inputs

  /// The options, each with the value that was used.
  [[nodiscard]] LOBER_API std::vector<OptionSetting> settings() const;

  /// For callers that know the type: SystemTransport of "transport".
  template <typename T>
  [[nodiscard]] const T& as() const {
    return *static_cast<const T*>(value.get());
  }
};

/// An example of a call. Each face writes it in its own way.
struct Example {
  std::vector<std::string> inputs;  ///< "standard K=1.2", "a.dat"
  std::vector<OptionSetting> options;
  std::string meaning;
};

struct Operation {
  std::string name;
  std::string title;     ///< a phrase of one line
  std::string summary;   ///< a sentence: "Computes ..."
  int revision = 1;      ///< goes into the keys of stored results: raised when numbers change within a version
  bool compares = true;  ///< whether it computes something by two routes
  std::vector<InputSpec> inputs;
  std::vector<OptionSpec> options;
  std::vector<Field> result;
  std::vector<Example> examples;
  /// Approximate number of bytes of the data that it makes of its first input, where options decide that; else empty.
  std::function<double(const Input& first, const Options& options)> result_bytes{};
  /// Throws UsageError for options that do not go together, with this number of inputs; `run` asks it first. May be
  /// empty.
  std::function<void(const Options& options, std::size_t inputs)> check{};
  /// Throws UsageError for inputs that do not fit `inputs`, and whatever the functions throw that it calls.
  std::function<Outcome(std::span<const Input> inputs, const Options& options, const Context& context)> run;
};

/// All operations in the order of their names.
[[nodiscard]] LOBER_API std::span<const Operation> all();
/// The operation with this name. Throws UsageError that lists the existing ones.
[[nodiscard]] LOBER_API const Operation& named(std::string_view name);

}  // namespace lober::operations
