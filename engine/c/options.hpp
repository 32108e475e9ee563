// Options of the C interface: a text of words NAME=VALUE (private to engine/c).
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lober/base/threads.hpp"

namespace lober::detail::c {

/// The words of a text in their order. Throws UsageError for one that is not of the form NAME=VALUE, or comes twice.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> words_of(const char* text);
/// Throws UsageError that names the option.
[[nodiscard]] double number_of(const std::string& name, const std::string& value);

/// Each option is asked for once, with its default; require_all_known() then refuses those that nobody asked for.
class Options {
 public:
  explicit Options(const char* text) : words_(words_of(text)) {}

  [[nodiscard]] double number(const std::string& name, double otherwise);
  [[nodiscard]] std::int64_t integer(const std::string& name, std::int64_t otherwise, std::int64_t least = 0,
                                     std::int64_t most = 2'000'000'000);
  [[nodiscard]] bool flag(const std::string& name, bool otherwise);
  [[nodiscard]] std::optional<std::string> text(const std::string& name);
  [[nodiscard]] int threads() { return static_cast<int>(integer("threads", 0, 0, max_threads)); }
  void require_all_known() const;

 private:
  [[noreturn]] static void refuse(const std::string& name, const std::string& value, const std::string& wanted);

  std::vector<std::pair<std::string, std::string>> words_;
  std::set<std::string> known_;
};

}  // namespace lober::detail::c
