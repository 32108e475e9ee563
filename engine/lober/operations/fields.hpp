// The fields of a result: names, units and meanings, and how each is read from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/base/measured.hpp"
#include "lober/curve/point.hpp"

namespace lober::operations {

/// Kind of a field.
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

/// A matrix of numbers, with or without error bars.
struct Matrix {
  std::size_t rows = 0, columns = 0;  ///< its shape
  std::vector<Measured> entries;      ///< row by row
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
  /// The fields in their order.
  Fields(std::vector<Field> fields);  // NOLINT(google-explicit-constructor)
  /// The first field.
  [[nodiscard]] const Field* begin() const { return data(); }
  /// The end of the fields.
  [[nodiscard]] const Field* end() const;
  /// The fields, one after the other.
  [[nodiscard]] const Field* data() const;
  /// Number of fields.
  [[nodiscard]] std::size_t size() const;
  /// Whether there is no field.
  [[nodiscard]] bool empty() const { return size() == 0; }

 private:
  std::shared_ptr<const std::vector<Field>> fields_;
};

/// A part of a result: its name, its meaning, and how it is read from an object of the type it belongs to.
struct Field {
  std::string name;                    ///< its name in the JSON
  FieldKind kind = FieldKind::number;  ///< its kind
  std::string unit = {};               ///< "area": coordinates squared; "length", "time", "action", ""
  std::string meaning = {};            ///< a phrase
  std::string bar = {};                ///< name of the error bar of a number or a matrix; empty: there is none
  Fields members = {};                 ///< fields of an object, or of each element of a list
  bool in_json = true;                 ///< false for the points of curves and fields as long
  bool null = false;                   ///< null in JSON where it is not known; if false, left out there

  using Use = std::function<void(const void* part)>;  ///< a function of a part of a result
  /// The elements of a list. May be read from several threads at the same time.
  struct Elements {
    std::size_t size = 0;  ///< number of elements
    bool known = true;     ///< false where it was not asked for
    /// Calls `use` with an element.
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
  /// The field at the end of the path.
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
/// The members of a JSON object, for each field of the whole.
[[nodiscard]] LOBER_API std::string json_members(std::span<const Field> fields, const void* whole);
/// The same as an object in one line.
[[nodiscard]] LOBER_API std::string json_object(std::span<const Field> fields, const void* whole);
/// A schema (JSON Schema 2020-12) of these members.
[[nodiscard]] LOBER_API std::string json_schema(std::span<const Field> fields);

}  // namespace lober::operations
