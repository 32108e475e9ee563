// Libraries of others that are loaded when the first file needs them: whoever has no such file neither installs them
// nor waits for them at each start.
#pragma once

#include <mutex>
#include <string>
#include <string_view>

namespace lober::detail {

/// A shared library that may be there or not.
class OptionalLibrary {
 public:
  /// `file` is the name by which the system finds it, such as libz.so.1, or empty where its headers were not there when
  /// lober was built; `package` is Debian's, `headers` the package that a build needs.
  constexpr OptionalLibrary(std::string_view file, std::string_view package, std::string_view headers)
      : file_(file), package_(package), headers_(headers) {}

  [[nodiscard]] constexpr bool is_built_in() const { return !file_.empty(); }
  [[nodiscard]] constexpr std::string_view package() const { return package_; }

  /// Loads it. Thread-safe.
  [[nodiscard]] bool is_present() const;
  /// Why `is_present` is false, and what to do, as the end of a message; empty where it is there.
  [[nodiscard]] std::string reason_it_is_missing() const;

  /// One of its functions. Throws DataError where the library, or the function, is not there.
  template <typename Function>
  [[nodiscard]] Function function(const char* name) const {
    return reinterpret_cast<Function>(symbol(name));
  }
  /// The address of a variable or a function.
  [[nodiscard]] void* symbol(const char* name) const;

 private:
  std::string_view file_, package_, headers_;
};

/// Held while a library works that is not made for several threads: the HDF5 of Debian, and those built on it.
[[nodiscard]] std::mutex& one_thread_at_a_time();

}  // namespace lober::detail

// A member that holds a function of a library: LOBER_LOADED(library, zip_close).
// NOLINTNEXTLINE(bugprone-macro-parentheses): a name that is declared takes none
#define LOBER_LOADED(library, name) decltype(&::name) name = (library).function<decltype(&::name)>(#name)
