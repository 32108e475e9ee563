// The options of an operation (private to operations/): each is a member of the options of the C++ interface, whose
// type and default are its own.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/operations/is_optional.hpp"
#include "engine/operations/last_derived.hpp"
#include "lober/operations.hpp"

namespace lober::detail::table {
using namespace operations;

/// The properties of an option in a table, beside its member.
struct OptionForm {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool above_min = false;
  std::string otherwise = {};  ///< what is done without an optional one; empty: it is required
  std::string value = {};
  std::vector<std::string> choices = {};  ///< allowed values of a text
};

/// The options of a How, and what moves their values into one.
template <typename How>
class OptionList {
 public:
  template <typename Base, typename Member>
  requires std::derived_from<How, Base> OptionList& option(std::string key, Member Base::*member, std::string meaning,
                                                           OptionForm form = {}) {
    OptionSpec spec;
    spec.key = std::move(key);
    spec.meaning = std::move(meaning);
    spec.min = form.min;
    spec.max = form.max;
    spec.above_min = form.above_min;
    spec.otherwise = std::move(form.otherwise);
    spec.value = std::move(form.value);
    spec.choices = std::move(form.choices);
    if constexpr (is_optional<Member>::value) {
      spec.optional = true;
      spec.required = spec.otherwise.empty();
      spec.fallback = typename Member::value_type{};
    } else if constexpr (std::same_as<Member, bool> || std::floating_point<Member> ||
                         std::same_as<Member, std::string>) {
      spec.fallback = How{}.*member;
    } else {
      static_assert(
          std::integral<Member>,
          "an option is a flag, a number, text, or an optional one of these, of a Point, a Rectangle or numbers");
      spec.fallback = static_cast<std::int64_t>(How{}.*member);
      if (std::unsigned_integral<Member>) spec.min = std::max(spec.min, 0.0);
      if constexpr (sizeof(Member) < sizeof(std::int64_t)) {
        spec.max = std::min(spec.max, static_cast<double>(std::numeric_limits<Member>::max()));
      }
    }
    setters_.push_back([key = spec.key, member](How& how, const Options& options) {
      const OptionValue* const value = options.find(key);
      if (value == nullptr) return;
      if constexpr (is_optional<Member>::value) {
        how.*member = std::get<typename Member::value_type>(*value);
      } else if constexpr (std::integral<Member> && !std::same_as<Member, bool>) {
        how.*member = static_cast<Member>(std::get<std::int64_t>(*value));
      } else {
        how.*member = std::get<Member>(*value);
      }
    });
    specs_.push_back(std::move(spec));
    return *this;
  }
  /// A member of an enumeration, by the names that `name` has of its values.
  template <typename Base, typename Enum, std::size_t size>
  requires std::derived_from<How, Base> OptionList& choice(std::string key, Enum Base::*member,
                                                           const std::array<Enum, size>& all, std::string meaning) {
    return add_choice({std::move(key), std::string(name(How{}.*member)), std::move(meaning)}, member, all);
  }
  /// An option that need not be given; `otherwise` says what is done then.
  template <typename Base, typename Enum, std::size_t size>
  requires std::derived_from<How, Base> OptionList& choice(std::string key, std::optional<Enum> Base::*member,
                                                           const std::array<Enum, size>& all, std::string meaning,
                                                           std::string otherwise) {
    OptionSpec spec{std::move(key), std::string(), std::move(meaning)};
    spec.optional = true;
    spec.otherwise = std::move(otherwise);
    return add_choice(std::move(spec), member, all);
  }
  [[nodiscard]] const std::vector<OptionSpec>& specs() const { return specs_; }
  [[nodiscard]] How how(const Options& options) const {
    thread_local LastDerived<How> last;
    return last.of(options, this, [&](const Options& given) {
      How made{};
      for (const auto& set : setters_) set(made, given);
      return made;
    });
  }

 private:
  // Member: an Enum or an optional one.
  template <typename Base, typename Member, typename Enum, std::size_t size>
  OptionList& add_choice(OptionSpec spec, Member Base::*member, const std::array<Enum, size>& all) {
    for (const Enum one : all) spec.choices.emplace_back(name(one));
    setters_.push_back([key = spec.key, member, all](How& how, const Options& options) {
      if (is_optional<Member>::value && options.find(key) == nullptr) return;
      const std::string& given = options.text(key);
      for (const Enum one : all) {
        if (name(one) == given) how.*member = one;
      }
    });
    specs_.push_back(std::move(spec));
    return *this;
  }

  std::vector<OptionSpec> specs_;
  std::vector<std::function<void(How&, const Options&)>> setters_;
};

}  // namespace lober::detail::table
