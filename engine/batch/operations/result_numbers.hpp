// The columns of a job's result: numbers that stand in few objects.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "lober/base/buffer.hpp"
#include "lober/operations.hpp"

namespace lober::detail {

/// The same numbers as operations::NumberPath::first, for many paths: each object on the way is looked for once.
class ResultNumbers {
 public:
  /// The fields have to outlive it.
  explicit ResultNumbers(std::span<const operations::Field> fields) : fields_(fields) {}
  /// Throws UsageError for a path that leads nowhere. Returns the field at its end.
  const operations::Field& add(std::string_view path);
  [[nodiscard]] std::size_t size() const { return size_; }
  /// The numbers in the order in which their paths were added.
  [[nodiscard]] Buffer<double> operator()(const void* whole) const;

 private:
  struct Object {
    std::uint32_t outer;  ///< number of the object that it is a part of; 0: the whole
    const operations::Field* field;
  };
  struct Number {
    std::uint32_t object, index;
    const operations::Field* field;
    bool bar;
  };
  struct Path {  ///< one through a list, or through an object that is made when it is asked for
    std::uint32_t index;
    operations::NumberPath path;
  };
  [[nodiscard]] std::uint32_t object(std::uint32_t outer, const operations::Field& field);

  std::span<const operations::Field> fields_;
  std::vector<Object> objects_;
  std::vector<Number> numbers_;
  std::vector<Path> paths_;
  std::uint32_t size_ = 0;
};

}  // namespace lober::detail
