// What the engine can do, described once: each operation with its inputs, its options and what its result consists of.
//
// The program, the batch, the C interface and the Python module follow from this table: what they parse, check, print,
// store and document is a walk over it. C++ programs call the functions of the other headers, which an operation calls.
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

#include "lober/agreement.hpp"
#include "lober/curve.hpp"
#include "lober/densify.hpp"
#include "lober/export.hpp"
#include "lober/fixed_points.hpp"
#include "lober/index.hpp"
#include "lober/interior.hpp"
#include "lober/levels.hpp"
#include "lober/manifold_tangle.hpp"
#include "lober/manifolds.hpp"
#include "lober/melnikov.hpp"
#include "lober/monte_carlo.hpp"
#include "lober/orbits.hpp"
#include "lober/overlay.hpp"
#include "lober/point.hpp"
#include "lober/progress.hpp"
#include "lober/regions.hpp"
#include "lober/smooth.hpp"
#include "lober/sweep.hpp"
#include "lober/systems.hpp"
#include "lober/tangle.hpp"
#include "lober/transport.hpp"

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
  std::vector<std::string> choices = {};  ///< of a string; empty: any
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool above_min = false;  ///< min itself is excluded
  bool optional = false;   ///< not there unless it is given: `fallback` says its type, `otherwise` what happens then
  bool required = false;   ///< optional, but there has to be one
  std::string otherwise = {};
  std::string value = {};  ///< what a help calls it: "N"

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
  /// Every option at its fallback, but for the settings, of which the last one for a key counts. Throws UsageError
  /// "key: what is wrong".
  Options(std::span<const OptionSpec> specs, std::span<const OptionSetting> settings);

  [[nodiscard]] bool flag(std::string_view key) const { return std::get<bool>(at(key)); }
  [[nodiscard]] std::int64_t whole(std::string_view key) const { return std::get<std::int64_t>(at(key)); }
  [[nodiscard]] double real(std::string_view key) const { return std::get<double>(at(key)); }
  [[nodiscard]] const std::string& text(std::string_view key) const { return std::get<std::string>(at(key)); }
  [[nodiscard]] std::optional<Point> point(std::string_view key) const;
  /// Null for one that is not there: all of the specs are, but for those without a fallback that were not given.
  [[nodiscard]] const OptionValue* find(std::string_view key) const;
  /// Those whose keys begin with "prefix.", which is left out; by name.
  [[nodiscard]] std::vector<std::pair<std::string, double>> reals_of(std::string_view prefix) const;

  /// In the order of the specs.
  [[nodiscard]] std::span<const OptionSetting> settings() const { return *settings_; }
  /// "areas_only=false index=auto": the same for the same values, whatever was spelled out.
  [[nodiscard]] std::string to_string() const;

 private:
  [[nodiscard]] const OptionValue& at(std::string_view key) const;

  std::shared_ptr<const std::vector<OptionSetting>> settings_ = std::make_shared<const std::vector<OptionSetting>>();
};

/// "key=value key=value".
[[nodiscard]] LOBER_API std::string to_string(std::span<const OptionSetting> settings);
/// A value as Options::to_string has it: numbers in the shortest form that reads back to the same bits, points as
/// "x,y", rectangles as "x0,y0,x1,y1".
[[nodiscard]] LOBER_API std::string to_string(const OptionValue& value);
/// Those of a point, a rectangle or a list; none of another value.
[[nodiscard]] LOBER_API std::vector<double> numbers_of(const OptionValue& value);
/// The value of an option that is written as text: "true", "1e-5", "0.5,-1". Throws UsageError "key: what is wrong".
[[nodiscard]] LOBER_API OptionValue option_value(const OptionSpec& spec, std::string_view key, const std::string& text);

// ----------------------------------------------------------------------------------------------------------- inputs

enum class InputKind : std::uint8_t {
  closed_curve,
  open_curve,
  curve,  ///< closed or open, which an option says; nothing is looked for among its segments
  points,
  system,
};

struct InputSpec {
  std::string name;
  InputKind kind = InputKind::system;
  std::string meaning;
  bool optional = false;  ///< only the last ones are
};

/// A system with its parameters, and its relatives.
struct SystemInput {
  std::shared_ptr<const System> system;
  IntegrationOptions integration{};  ///< with which it was made
  /// The same with other values of some parameters; empty where there are no others.
  std::function<System(const ParameterValues& changed)> with{};
};
/// A built-in system or a library by its name.
[[nodiscard]] LOBER_API SystemInput system_input(const std::string& name, const ParameterValues& values,
                                                 const IntegrationOptions& integration = {});

/// A curve with what is known of it already.
struct CurveInput {
  CurveView curve{};
  std::string name{};                        ///< in messages; empty: that of the InputSpec
  const IndexedCurve* index = nullptr;       ///< of a curve that is validated
  const DiscretisationSums* sums = nullptr;  ///< of the overlay's estimate
  bool simple = false;                       ///< known to be
};

/// The points stay those of the caller, for as long as the operation runs and its value is used. Where an operation
/// takes a curve, points are one.
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
  points,   ///< of a curve
};

struct Matrix {
  std::size_t rows = 0, columns = 0;
  std::vector<Measured> entries;
};

/// Nothing: not known, or not asked for.
using FieldValue =
    std::variant<std::monostate, double, Measured, std::int64_t, bool, std::string, std::vector<std::string>,
                 std::vector<double>, std::vector<std::int64_t>, Point, std::vector<Point>, Matrix>;

/// A part of a result: what it is called and means, and how it is got out of an object of the type it belongs to.
struct Field {
  std::string name;
  FieldKind kind = FieldKind::number;
  std::string unit = {};  ///< "area": of the coordinates squared; "length", "time", "action", ""
  std::string meaning = {};
  std::string bar = {};             ///< what the error bar of a number or a matrix is called; empty: it has none
  std::vector<Field> members = {};  ///< of an object, or of each element of a list
  bool in_json = true;              ///< false for the points of curves and what else is as long
  bool null = false;                ///< null in JSON where nothing of it is known; else left out there

  using Use = std::function<void(const void* part)>;
  /// Of a list. May be looked at from several threads at the same time.
  struct Elements {
    std::size_t size = 0;
    bool known = true;  ///< false where it was not asked for
    std::function<void(std::size_t element, const Use& use)> at{};
  };
  std::function<FieldValue(const void* whole)> get{};             ///< empty for objects and lists
  std::function<void(const void* whole, const Use& use)> part{};  ///< of an object; no call where it is not known
  std::function<Elements(const void* whole)> elements{};          ///< of a list

  /// The object, if it is known, or each element of the list.
  void each(const void* whole, const Use& use) const {
    if (part) return part(whole, use);
    const Elements all = elements(whole);
    for (std::size_t k = 0; k < all.size; ++k) all.at(k, use);
  }
};

/// The field at "turnstile.flux12", or whose bar is at "turnstile.flux12_error". Throws UsageError for a path that
/// leads nowhere.
[[nodiscard]] LOBER_API const Field& field_at(std::span<const Field> fields, std::string_view path);
/// The way to numbers of a result, found once: "turnstile.flux12" or "turnstile.flux12_error".
class LOBER_API NumberPath {
 public:
  /// Throws UsageError for a path that leads nowhere. The fields have to stay.
  NumberPath(std::span<const Field> fields, std::string_view path);
  /// One for each element of lists: "steps.T21". NaN for what is not known.
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
/// that are not finite; members that are not known are null where Field::null, else left out. Members of the outermost
/// object, and elements of lists that are not within others, have lines of their own. Long lists are formatted in
/// parallel and handed on in parts, so that none stands in memory as a whole.
LOBER_API void write_json_members(std::span<const Field> fields, const void* whole,
                                  const std::function<void(std::string_view)>& write);
[[nodiscard]] LOBER_API std::string json_members(std::span<const Field> fields, const void* whole);
/// The same as an object in one line.
[[nodiscard]] LOBER_API std::string json_object(std::span<const Field> fields, const void* whole);
/// A schema (JSON Schema 2020-12) of these members.
[[nodiscard]] LOBER_API std::string json_schema(std::span<const Field> fields);

// ------------------------------------------------------------------------------------------------ values of results

/// Of "overlay".
struct CurveOverlay : Overlay {
  bool has_pieces = true;                 ///< whether they were asked for
  std::optional<Areas> discretisation{};  ///< estimates of |area of the polygons - between smooth curves|
  std::optional<Areas> consistency{};     ///< |area - by the interior function|
  std::optional<SmoothAreas> smooth{};
  std::optional<std::array<std::vector<SigmaStep>, 2>> steps{};  ///< sigma of A1 \ A2 and of A2 \ A1
  Agreement agreement{};
  double verify_seconds = 0, smooth_seconds = 0;
};
/// Of "interior".
struct CurveInterior : InteriorAreas {
  std::optional<Areas> splitting{};    ///< where segments were not split: |area - area where they are|
  std::optional<Areas> consistency{};  ///< |area - by the overlay|
  Agreement agreement{};
  double verify_seconds = 0;
};
/// Of "densify" and "simplify".
struct RefinedCurve : DensifiedCurve {
  struct Step {
    std::string name;          ///< "simplify", "criteria", "passes" or "crossings"
    std::size_t points = 0;    ///< after it
    std::uint32_t rounds = 0;  ///< that it took
  };
  std::size_t given = 0;                    ///< number of points
  std::vector<Step> steps{};                ///< in order
  std::optional<DensifiedCurve> against{};  ///< the other curve with the crossings inserted
  /// Of the criteria, by DiagnosticCause, and of their segments; the diagnostics themselves are none where a later step
  /// has changed the numbers of segments.
  std::array<std::size_t, all_diagnostic_causes.size()> places{};
  std::size_t segments_with_diagnostics = 0;
};
/// Of "regions".
struct CurveRegions {
  Regions regions;
  FillRule rule = FillRule::nonzero;
  Areas areas{}, rounding{};                            ///< by the rule
  std::optional<std::array<RegionPieces, 4>> pieces{};  ///< in the order of all_pairings
};
/// Of "grow".
struct SystemManifold : GrownManifold {
  LocalManifold local{};  ///< near the saddle
  Branch branch = Branch::plus;
  double local_seconds = 0, growth_seconds = 0;
};
/// Of "winding".
struct CurveWinding {
  struct Count {
    int winding;
    std::size_t points;
  };
  std::span<const Point> points;
  std::vector<Winding> windings;      ///< of each point
  std::vector<InteriorValue> values;  ///< J at each point
  std::vector<Count> counts;          ///< ascending; of points that are not on the curve
  std::size_t on = 0;                 ///< points on the curve
  double difference = 0;              ///< the largest |J / 2 pi - winding number|
  double bar = 0;                     ///< what it may be
  Agreement agreement;                ///< points where it is more
};
/// Of "image".
struct CurveImages {
  struct One {
    CurveImage image{};
    std::size_t curve = 0;  ///< 1: of the second boundary of a cylinder
    std::vector<ImagePart> parts{};
    double length = 0;  ///< of all parts together
    /// Signed, of an image that is whole and meets the tolerance everywhere; the error is what a polygon may leave out:
    /// the tolerance times its length.
    std::optional<Measured> area{};

    [[nodiscard]] LOBER_API std::string name() const;  ///< "f^-2", of a second curve "f^-2 boundary 2"
  };
  std::string what{};           ///< "circle of radius 0.1 about (1, 0)"; empty where a curve was given
  bool closed = true;           ///< the curve
  std::vector<One> images{};    ///< in the order of iterates; of two curves, first those of the one
  Rectangle box{};              ///< in which the tolerance holds
  bool preserves_area = false;  ///< the map has an action
  Agreement agreement{};        ///< of areas of images with that of the first
  double curve_seconds = 0, image_seconds = 0;
};
/// Of "tangle".
struct CurveTangle : Tangle {
  bool smooth = false;              ///< areas are those of smooth curves
  std::vector<LobeShape> shapes{};  ///< by lobe
  double boundary_discretisation = 0;
  std::optional<std::vector<LobeOverlap>> overlaps{};  ///< where they were asked for
  Agreement agreement{};
  double measures_seconds = 0, overlaps_seconds = 0;

  /// What the area of a lobe loses against the smooth curves through the points: estimated from the polygon, or, when
  /// areas are those of smooth curves, by how far these can be trusted.
  [[nodiscard]] double discretisation(std::size_t lobe) const {
    return smooth ? lobes[lobe].smooth_error : shapes[lobe].discretisation;
  }
};
/// Of "manifold_tangle".
struct SystemTangle : CurveTangle {
  std::shared_ptr<const ManifoldTangle> manifolds{};
  double growth_seconds = 0;
};
/// Lobes of a turnstile to first order in the parameter that is the size of the system's perturbation, beside their
/// areas.
struct MelnikovComparison {
  std::string parameter;
  double eps = 0;  ///< its value
  Melnikov function;
  Melnikov::Sides estimate, exact;  ///< exact by action, where the map has one
};
/// Of "transport".
struct SystemTransport : Transport {
  std::optional<MelnikovComparison> melnikov{};  ///< where it was asked for
};
/// Of "curve_transport".
struct CurveTransport : TransportOfCurves {
  std::size_t period = 0;  ///< number of pips from one to its image
  std::string why{};       ///< the limit, with the rows that there are
};
/// Of "escape".
struct SystemEscape : Escape {
  std::optional<MonteCarlo> counted{};  ///< where trajectories were followed
  std::uint64_t seed = 1;               ///< of their random numbers
};
/// Of "fixed_points": what was found, and where it was looked for.
struct SystemFixedPoints : FixedPointSearch {
  Rectangle box{};
  int period = 1, turns = 0;
};
/// Of "levels".
struct SystemLevel {
  double value = 0;
  std::optional<Point> saddle{};  ///< that the level goes through
  std::vector<LevelCurve> curves{};

  [[nodiscard]] LOBER_API std::size_t closed() const;  ///< number of curves that are
  [[nodiscard]] LOBER_API std::size_t points() const;  ///< of all curves
};
struct SystemLevels {
  std::vector<Equilibrium> saddles{};
  std::vector<SystemLevel> levels{};        ///< by value, ascending
  std::shared_ptr<const LevelGrid> grid{};  ///< on which the energy was looked at
};
/// After how many crossings of the section orbits leave that begin in the middle of each cell of a grid.
struct ExitTimes {
  Rectangle window{};
  std::size_t columns = 0, rows = 0;
  std::vector<std::uint32_t> times{};  ///< row by row from below; the start is the first crossing
  static constexpr std::uint32_t none = 0, stays = 0xffffffff;  ///< where the section is not reached; where none leaves

  [[nodiscard]] std::uint32_t of(std::size_t column, std::size_t row) const { return times[row * columns + column]; }
  /// How many cells leave after each number of crossings, from 0 (not on the section) on; the rest stay.
  [[nodiscard]] LOBER_API std::vector<std::uint64_t> counts() const;
  [[nodiscard]] LOBER_API std::uint64_t staying() const;
};
/// Of "section". Context::on_part gets it with each block of orbits.
struct SystemSection {
  Rectangle box{};
  OrbitOptions options{};
  std::size_t orbits = 0, lost = 0, unreached = 0;  ///< numbers of orbits
  std::uint64_t points = 0, inside = 0;             ///< of all orbits, and in the box
  std::optional<ExitTimes> exit_times{};            ///< where they were asked for
  std::vector<Point> kept{};                        ///< of all orbits; empty where on_part takes them
  // In on_part: a block as of follow_orbits, and which of its starts are points of the section.
  std::size_t first = 0;
  std::span<const Point> block{};
  std::vector<bool> reached{};
};
/// Of "sweep".
struct SystemSweep : Sweep {
  std::string parameter{};
  std::string no_zero{};  ///< why none was found, where zeros were looked for; else empty
  /// Of each row, where it was asked for: area of the lobes of one side to first order; NaN where it is not known.
  std::optional<std::vector<double>> first_order{};
  Agreement agreement{};  ///< rows that disagree are failures
  std::vector<std::string> remarks{};
};

// ------------------------------------------------------------------------------------------------------- operations

/// What an operation is run with. All of it may be left out.
struct Context {
  Progress progress{};
  /// Called with `progress`, where what is done can be counted: "points".
  std::function<void(double amount, std::string_view unit)> count{};
  /// Called from the calling thread with each element of a list that takes long as soon as it is ready, and with all
  /// comparisons so far.
  std::function<void(const Field& list, const void* element, const Agreement& agreement)> on_element{};
  /// Called likewise with all that is known so far: the value of the result, without what comes later.
  std::function<void(const void* so_far)> on_part{};
  /// Whether work that is cancelled returns what is known, where an operation can (escape).
  bool keeps_what_is_known = false;
  std::size_t memory = std::numeric_limits<std::size_t>::max();  ///< bytes that the work may hold, roughly
  /// Called with the bytes that it does hold, where options decide how many; may throw what ends the work.
  std::function<void(std::size_t bytes)> holds{};
};

/// A result: an object of a type that the operation knows.
struct Outcome {
  std::shared_ptr<const void> value;
  Agreement agreement;                ///< of all routes that were compared
  std::vector<std::string> remarks;   ///< what a user should read
  std::string incomplete;             ///< why less came than was asked for; empty if nothing is missing
  std::string failed;                 ///< which of many independent parts failed and why; empty if none did
  Options options;                    ///< with which it was computed
  std::vector<OptionSetting> chosen;  ///< in place of some of them: what followed from them and the inputs

  /// The options, each with the value that was used.
  [[nodiscard]] LOBER_API std::vector<OptionSetting> settings() const;

  /// For callers that know the type: SystemTransport of "transport".
  template <typename T>
  [[nodiscard]] const T& as() const {
    return *static_cast<const T*>(value.get());
  }
};

/// Each face writes it in its own way.
struct Example {
  std::vector<std::string> inputs;  ///< "standard K=1.2", "a.dat"
  std::vector<OptionSetting> options;
  std::string meaning;
};

struct Operation {
  std::string name;
  std::string title;     ///< a phrase, of one line
  std::string summary;   ///< a sentence: "Computes ..."
  int revision = 1;      ///< goes into the keys of stored results: raised when numbers change within a version
  bool compares = true;  ///< whether it computes something by two routes
  std::vector<InputSpec> inputs;
  std::vector<OptionSpec> options;
  std::vector<Field> result;
  std::vector<Example> examples;
  /// Bytes of what it makes of its first input, roughly, where options decide that; else empty.
  std::function<double(const Input& first, const Options& options)> result_bytes{};
  /// Throws UsageError for options that do not go together, with this number of inputs; `run` asks it first. May be
  /// empty.
  std::function<void(const Options& options, std::size_t inputs)> check{};
  /// Throws UsageError for inputs that are not those of `inputs`; what the functions that it calls throw.
  std::function<Outcome(std::span<const Input> inputs, const Options& options, const Context& context)> run;
};

/// In the order of their names.
[[nodiscard]] LOBER_API std::span<const Operation> all();
/// Throws UsageError, naming those that there are.
[[nodiscard]] LOBER_API const Operation& named(std::string_view name);

}  // namespace lober::operations
