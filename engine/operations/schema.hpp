// The fields of a result (private to operations/): each is a member or a function of the C++ result, whose type says
// what kind of field it is.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/operations/is_optional.hpp"
#include "lober/operations.hpp"

namespace lober::detail::table {
using namespace operations;

template <typename T>
constexpr FieldKind kind_of() {
  if constexpr (is_optional<T>::value) {
    return kind_of<typename T::value_type>();
  } else if constexpr (std::same_as<T, bool>) {
    return FieldKind::flag;
  } else if constexpr (std::integral<T>) {
    return FieldKind::whole;
  } else if constexpr (std::floating_point<T> || std::same_as<T, Measured>) {
    return FieldKind::number;
  } else if constexpr (std::same_as<T, std::vector<std::string>>) {
    return FieldKind::lines;
  } else if constexpr (std::same_as<T, std::vector<double>>) {
    return FieldKind::numbers;
  } else if constexpr (std::same_as<T, std::vector<std::int64_t>>) {
    return FieldKind::wholes;
  } else if constexpr (std::same_as<T, Point>) {
    return FieldKind::point;
  } else if constexpr (std::same_as<T, std::vector<Point>>) {
    return FieldKind::points;
  } else if constexpr (std::same_as<T, RegionMatrix> || std::same_as<T, Matrix>) {
    return FieldKind::matrix;
  } else {
    static_assert(std::convertible_to<T, std::string>,
                  "a field is a number, Measured, a flag, text, texts, numbers, a Point, points or a matrix");
    return FieldKind::text;
  }
}

template <typename T>
FieldValue value_of(const T& value) {
  if constexpr (is_optional<T>::value) {
    return value ? value_of(*value) : FieldValue{};
  } else if constexpr (std::integral<T> && !std::same_as<T, bool>) {
    return static_cast<std::int64_t>(value);
  } else if constexpr (std::floating_point<T>) {
    return static_cast<double>(value);
  } else if constexpr (std::same_as<T, RegionMatrix>) {
    if (value.size() == 0) return {};
    Matrix matrix{value.size(), value.size(), {}};
    for (std::size_t i = 0; i < value.size(); ++i) {
      for (std::size_t j = 0; j < value.size(); ++j) matrix.entries.push_back(value(i, j));
    }
    return matrix;
  } else if constexpr (kind_of<T>() == FieldKind::text) {
    return std::string(value);
  } else {
    return value;
  }
}

template <typename T>
constexpr bool is_number() {
  const FieldKind kind = kind_of<T>();
  return kind == FieldKind::number || kind == FieldKind::whole || kind == FieldKind::flag;
}

template <typename T>
Measured number_of(const T& value) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if constexpr (is_optional<T>::value) {
    return value ? number_of(*value) : Measured{unknown, unknown};
  } else if constexpr (std::same_as<T, Measured>) {
    return value;
  } else {
    return {static_cast<double>(value), unknown};
  }
}

template <typename T>
constexpr bool has_bar = false;
template <>
inline constexpr bool has_bar<Measured> = true;
template <>
inline constexpr bool has_bar<std::optional<Measured>> = true;
template <>
inline constexpr bool has_bar<RegionMatrix> = true;

/// The fields of a T, in order. A getter is a member, or a function of a const T&.
template <typename T>
class Schema {
 public:
  template <typename Get>
  Schema& field(std::string name, std::string unit, std::string meaning, Get get, std::string bar = {}) {
    using Value = std::remove_cvref_t<std::invoke_result_t<const Get&, const T&>>;
    Field made{std::move(name), kind_of<Value>(), std::move(unit), std::move(meaning)};
    made.in_json = made.kind != FieldKind::points;
    made.null = made.kind == FieldKind::text;
    if (has_bar<Value>) made.bar = bar.empty() ? made.name + "_error" : std::move(bar);
    if constexpr (is_number<Value>()) {
      made.number = [get](const void* whole) { return number_of(std::invoke(get, *static_cast<const T*>(whole))); };
    }
    made.get = [get = std::move(get)](const void* whole) {
      return value_of(std::invoke(get, *static_cast<const T*>(whole)));
    };
    add(std::move(made));
    return *this;
  }
  /// The field before is null in JSON where nothing of it is known, as texts and objects are.
  Schema& or_null() {
    last().null = true;
    return *this;
  }
  /// The field before is left out there.
  Schema& if_asked_for() {
    last().null = false;
    return *this;
  }
  /// The field before is in JSON although it is points.
  Schema& in_json() {
    last().in_json = true;
    return *this;
  }
  /// The field before is too long for JSON.
  Schema& not_in_json() {
    last().in_json = false;
    return *this;
  }
  /// The getter returns a U, a reference or a pointer to one; null where it is not known.
  template <typename U, typename Get>
  Schema& object(std::string name, std::string meaning, const Schema<U>& members, Get get) {
    Field made{std::move(name), FieldKind::object, {}, std::move(meaning), {}, members.shared()};
    made.null = true;
    using Found = std::invoke_result_t<const Get&, const T&>;
    if constexpr (std::is_convertible_v<Found, const U*>) {
      made.address = [get](const void* whole) -> const void* {
        const U* const part = std::invoke(get, *static_cast<const T*>(whole));
        return part;
      };
    } else if constexpr (std::is_lvalue_reference_v<Found> &&
                         std::is_convertible_v<std::add_pointer_t<Found>, const U*>) {
      made.address = [get](const void* whole) -> const void* {
        const U& part = std::invoke(get, *static_cast<const T*>(whole));
        return &part;
      };
    }
    made.part = [get = std::move(get)](const void* whole, const Field::Use& use) {
      auto&& part = std::invoke(get, *static_cast<const T*>(whole));
      if constexpr (std::is_pointer_v<std::remove_cvref_t<decltype(part)>>) {
        if (part != nullptr) use(part);
      } else {
        const U& object = part;
        use(&object);
      }
    };
    add(std::move(made));
    return *this;
  }
  /// The getter returns an object that has a size and elements by number, each a U or a reference to one; or a
  /// reference to it, or to an optional one, which is null in JSON where it is not there.
  template <typename U, typename Get>
  Schema& list(std::string name, std::string meaning, const Schema<U>& members, Get get) {
    Field made{std::move(name), FieldKind::list, {}, std::move(meaning), {}, members.shared()};
    made.null = is_optional<std::remove_cvref_t<std::invoke_result_t<const Get&, const T&>>>::value;
    made.elements = [get = std::move(get)](const void* whole) -> Field::Elements {
      decltype(auto) found = std::invoke(get, *static_cast<const T*>(whole));
      using Range = std::remove_cvref_t<decltype(found)>;
      if constexpr (is_optional<Range>::value) {
        static_assert(std::is_reference_v<decltype(found)>, "a list that may not be there is part of the result");
        return found ? elements_of<U>(part_of_result(*found)) : Field::Elements{.known = false};
      } else if constexpr (std::is_reference_v<decltype(found)>) {
        return elements_of<U>(part_of_result(found));
      } else {
        return elements_of<U>(std::make_shared<const Range>(std::move(found)));
      }
    };
    add(std::move(made));
    return *this;
  }
  /// The fields of a part, as if they were those of the whole. The getter returns a pointer.
  template <typename U, typename Get>
  Schema& parts(const Schema<U>& members, Get get) {
    for (Field field : members.fields()) {
      const auto part = [get](const void* whole) -> const void* {
        return std::invoke(get, *static_cast<const T*>(whole));
      };
      if (field.get) field.get = [part, inner = field.get](const void* whole) { return inner(part(whole)); };
      if (field.number) field.number = [part, inner = field.number](const void* whole) { return inner(part(whole)); };
      if (field.part) {
        field.part = [part, inner = field.part](const void* whole, const Field::Use& use) { inner(part(whole), use); };
      }
      if (field.address) {
        field.address = [part, inner = field.address](const void* whole) { return inner(part(whole)); };
      }
      if (field.elements) {
        field.elements = [part, inner = field.elements](const void* whole) { return inner(part(whole)); };
      }
      add(std::move(field));
    }
    return *this;
  }
  [[nodiscard]] const std::vector<Field>& fields() const { return fields_; }
  /// The same, which all objects and lists with them share.
  [[nodiscard]] const Fields& shared() const {
    if (shared_.empty()) shared_ = fields_;
    return shared_;
  }

 private:
  // Owns nothing.
  template <typename Range>
  static std::shared_ptr<const Range> part_of_result(const Range& range) {
    return {std::shared_ptr<const void>(), &range};
  }
  template <typename U, typename Range>
  static Field::Elements elements_of(std::shared_ptr<const Range> range) {
    const std::size_t size = range->size();
    return {size, true, [range = std::move(range)](std::size_t k, const Field::Use& use) {
              const U& element = (*range)[k];
              use(&element);
            }};
  }

  void add(Field field) {
    shared_ = {};
    fields_.push_back(std::move(field));
  }
  Field& last() {
    shared_ = {};
    return fields_.back();
  }

  std::vector<Field> fields_;
  mutable Fields shared_;
};

}  // namespace lober::detail::table
