// Options as the members of the C++ structs: keyword arguments, each by its own name.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>

namespace lober::python {

/// Takes keyword arguments apart into members, which keep their defaults where nothing is given:
///
///   BatchOptions options;
///   Keywords(given).take("store", options.store).take("output_root", options.output_root).end();
class Keywords {
 public:
  explicit Keywords(const pybind11::dict& given) : rest_(given.attr("copy")()) {}

  /// None is as if it were not given. Throws TypeError for a value that is not of the member's type or out of its
  /// range.
  template <typename Member>
  Keywords& take(const char* name, Member& member) {
    const pybind11::object value = rest_.attr("pop")(name, pybind11::none());
    if (value.is_none()) return *this;
    try {
      member = value.cast<Member>();
    } catch (const pybind11::cast_error&) {
      throw pybind11::type_error(std::string(name) + " cannot be " + pybind11::repr(value).cast<std::string>());
    }
    return *this;
  }
  /// The same for a member of another type than the argument: use(value).
  template <typename Value, typename Use>
  Keywords& take_as(const char* name, const Use& use) {
    std::optional<Value> value;
    take(name, value);
    if (value) use(*value);
    return *this;
  }
  /// Throws TypeError for an argument that nobody has taken.
  void end() const {
    for (const auto& [name, value] : rest_) {
      throw pybind11::type_error("there is no option " + name.cast<std::string>());
    }
  }

 private:
  pybind11::dict rest_;
};

}  // namespace lober::python
