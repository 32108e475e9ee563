#include "engine/files/formats/mat_lists.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>

#include "engine/files/byte_order.hpp"
#include "engine/files/formats/gzip.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

constexpr std::uint32_t matrix = 14, compressed = 15;
constexpr std::uint32_t cell_class = 1, struct_class = 2, object_class = 3;
constexpr std::size_t tag_size = 8, max_depth = 32;
constexpr std::size_t max_ratio = 1032;  // by deflate, of zeros

struct Element {
  std::uint32_t type = 0;
  std::span<const std::byte> content;
};

// Elements one behind the other, each with its type and its length, and padded to eight bytes; short ones have both in
// one word, and at most four bytes behind it.
class Elements {
 public:
  Elements(std::span<const std::byte> rest, bool swap) : rest_(rest), swap_(swap) {}

  [[nodiscard]] std::size_t left() const { return rest_.size(); }
  [[nodiscard]] std::uint32_t word(std::span<const std::byte> from, std::size_t at) const {
    std::uint32_t value = 0;
    std::memcpy(&value, from.data() + at, sizeof value);
    return swap_ ? reversed_bytes(value) : value;
  }

  // Nothing where one ends behind the others.
  std::optional<Element> next() {
    constexpr std::size_t max_short = 4;
    if (rest_.size() < tag_size) return std::nullopt;
    const std::uint32_t first = word(rest_, 0);
    if (const std::size_t size = first >> 16; size != 0) {
      if (size > max_short) return std::nullopt;
      const Element found{first & 0xFFFF, rest_.subspan(max_short, size)};
      rest_ = rest_.subspan(tag_size);
      return found;
    }
    const std::size_t size = word(rest_, 4);
    if (size > rest_.size() - tag_size) return std::nullopt;
    const Element found{first, rest_.subspan(tag_size, size)};
    rest_ = rest_.subspan(std::min(tag_size + (size + 7) / 8 * 8, rest_.size()));
    return found;
  }

 private:
  std::span<const std::byte> rest_;
  bool swap_;
};

bool is_list(std::uint32_t array_class) {
  return array_class == cell_class || array_class == struct_class || array_class == object_class;
}

// The product of the dimensions, as far as it is at most `limit`.
std::optional<std::size_t> count_of(const Element& dimensions, const Elements& elements, std::size_t limit) {
  std::size_t count = 1;
  bool is_empty = false;
  for (std::size_t at = 0; at + 4 <= dimensions.content.size(); at += 4) {
    const std::size_t size = elements.word(dimensions.content, at);
    is_empty = is_empty || size == 0;
    if (size != 0 && count > limit / size)
      count = limit + 1;  // an empty dimension may follow
    else
      count *= std::max<std::size_t>(size, 1);
  }
  if (is_empty) return 0;
  return count <= limit ? std::optional(count) : std::nullopt;
}

// How many fields each structure has: their names have all the same length.
std::optional<std::size_t> fields_of_structure(Elements& elements) {
  const std::optional<Element> length = elements.next();
  if (!length || length->content.size() != 4) return std::nullopt;
  const std::size_t size = elements.word(length->content, 0);
  const std::optional<Element> names = elements.next();
  if (!names || size == 0) return std::nullopt;
  return names->content.size() / size;
}

bool is_sound_matrix(std::span<const std::byte> content, bool swap, std::size_t depth) {
  if (content.empty()) return true;
  Elements elements(content, swap);
  const std::optional<Element> flags = elements.next();
  if (!flags || flags->content.size() < 4) return false;
  const std::uint32_t array_class = elements.word(flags->content, 0) & 0xFF;
  if (!is_list(array_class)) return true;
  if (depth == max_depth) return false;
  const std::optional<Element> dimensions = elements.next(), name = elements.next();
  if (!dimensions || !name) return false;
  if (array_class == object_class && !elements.next()) return false;  // the name of its class
  const std::optional<std::size_t> fields = array_class == cell_class ? 1 : fields_of_structure(elements);
  if (!fields) return false;
  const std::size_t max_elements = elements.left() / tag_size;
  const std::optional<std::size_t> count = count_of(*dimensions, elements, max_elements);
  if (!count || (*fields != 0 && *count > max_elements / *fields)) return false;
  for (std::size_t k = 0; k < *count * *fields; ++k) {
    const std::optional<Element> one = elements.next();
    if (!one || one->type != matrix || !is_sound_matrix(one->content, swap, depth + 1)) return false;
  }
  return true;
}

// Numbers are not expanded: the head tells what the element is.
bool is_sound_compressed(std::span<const std::byte> content, bool swap) {
  constexpr std::size_t head_size = tag_size + 16;
  const std::optional<Buffer<std::byte>> head = inflated(content, head_size);
  if (!head) return true;  // matio cannot read it either
  if (head->size() < head_size) return false;
  const Elements words(*head, swap);
  if (words.word(*head, 0) != matrix || !is_list(words.word(*head, 2 * tag_size) & 0xFF)) return true;
  const std::size_t size = words.word(*head, 4) + tag_size;
  if (size / max_ratio > content.size()) return false;
  const std::optional<Buffer<std::byte>> whole = inflated(content, size + 1);  // to its end, where the checksum is
  return whole && whole->size() == size && is_sound_matrix(std::span(*whole).subspan(tag_size), swap, 0);
}

}  // namespace

bool is_sound_list(std::uint32_t type, std::span<const std::byte> content, bool swap) {
  if (type == matrix) return is_sound_matrix(content, swap, 0);
  if (type != compressed) return true;
  try {
    return is_sound_compressed(content, swap);
  } catch (const DataError&) {
    return false;
  }
}

}  // namespace lober::detail
