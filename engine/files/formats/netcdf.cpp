// NetCDF in its classic formats, CDF-1, CDF-2 and CDF-5, as Unidata's "NetCDF Classic Format Specification" describes
// them: a head of dimensions, attributes and variables, then big-endian numbers. NetCDF-4 is HDF5. Unidata's library is
// not used here, as heads that are damaged end the process in it.
#include <algorithm>
#include <cstdint>
#include <optional>

#include "engine/files/byte_order.hpp"
#include "engine/files/formats/arrays.hpp"
#include "engine/files/formats/conventions.hpp"
#include "engine/files/formats/readers.hpp"
#include "engine/files/text_points.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {
namespace {

// A type of numbers by its code; characters and unknown codes have no `load`.
struct NumberType {
  double (*load)(const std::byte*, bool swap) = nullptr;
  std::size_t size = 1;
  bool is_float = false, is_signed = true;
};

NumberType number_type(std::uint32_t code) {
  constexpr std::uint32_t characters = 2;
  switch (code) {
    case 1:
      return {load_number<std::int8_t, std::uint8_t>, 1};
    case 3:
      return {load_number<std::int16_t, std::uint16_t>, 2};
    case 4:
      return {load_number<std::int32_t, std::uint32_t>, 4};
    case 5:
      return {load_number<float, std::uint32_t>, 4, true};
    case 6:
      return {load_number<double, std::uint64_t>, 8, true};
    case 7:
      return {load_number<std::uint8_t, std::uint8_t>, 1, false, false};
    case 8:
      return {load_number<std::uint16_t, std::uint16_t>, 2, false, false};
    case 9:
      return {load_number<std::uint32_t, std::uint32_t>, 4, false, false};
    case 10:
      return {load_number<std::int64_t, std::uint64_t>, 8};
    case 11:
      return {load_number<std::uint64_t, std::uint64_t>, 8, false, false};
    default:
      return {nullptr, code == characters ? std::size_t{1} : std::size_t{0}};
  }
}

constexpr bool swaps = std::endian::native == std::endian::little;

std::size_t padded(std::size_t size) {
  return (size + 3) / 4 * 4;
}

class NetCdfFile final : public ArrayFile {
 public:
  NetCdfFile(std::span<const std::byte> bytes, const std::string& path) : bytes_(bytes), path_(path) {
    constexpr std::uint32_t dimensions_tag = 10, variables_tag = 11;
    version_ = std::to_integer<unsigned>(bytes[3]);
    const std::size_t records = count();
    for (std::size_t left = list(dimensions_tag); left > 0; --left) {
      std::string name = text();
      dimensions_.push_back({std::move(name), count()});
    }
    (void)attributes();
    for (std::size_t left = list(variables_tag); left > 0; --left) read_variable();
    place_records(records);
  }

  [[nodiscard]] const std::vector<ArrayInfo>& arrays() const override { return arrays_; }

  [[nodiscard]] Buffer<double> numbers(std::size_t index) override {
    const Variable& variable = variables_[places_[index]];
    const std::size_t size = arrays_[index].size();
    if (size == 0) return {};
    // A variable without records is one that is in a single piece.
    const std::size_t pieces = variable.has_records ? records_ : 1, in_piece = size / pieces;
    const std::size_t step = variable.has_records ? record_size_ : 0, length = in_piece * variable.type.size;
    if (variable.begin > bytes_.size() || length > bytes_.size() - variable.begin ||
        (pieces > 1 && step > (bytes_.size() - variable.begin - length) / (pieces - 1))) {
      fail("ends in the numbers of " + arrays_[index].name);
    }
    Buffer<double> numbers(size);
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      const std::byte* const from = bytes_.data() + variable.begin + piece * step;
      for (std::size_t k = 0; k < in_piece; ++k) {
        numbers[piece * in_piece + k] = variable.type.load(from + k * variable.type.size, swaps);
      }
    }
    const NumberType& type = variable.type;
    apply_conventions(numbers, variable.attributes, {type.size, type.is_float, type.is_signed}, true);
    return numbers;
  }

  // Rows of characters: the names of curves.
  [[nodiscard]] std::vector<std::string> texts(std::string_view name) override {
    const auto found = std::find_if(variables_.begin(), variables_.end(), [&](const Variable& one) {
      return one.name == name && one.type.load == nullptr && one.dimensions.size() == 2;
    });
    if (found == variables_.end()) return {};
    const std::size_t rows = found->has_records ? records_ : dimensions_[found->dimensions[0]].size;
    const std::size_t width = dimensions_[found->dimensions[1]].size, step = found->has_records ? record_size_ : width;
    if (found->begin > bytes_.size() || width > bytes_.size() - found->begin || width == 0 ||
        (rows > 1 && step > (bytes_.size() - found->begin - width) / (rows - 1))) {
      fail("ends in the texts of " + found->name);
    }
    std::vector<std::string> texts;
    for (std::size_t row = 0; row < rows; ++row) {
      const char* const from = reinterpret_cast<const char*>(bytes_.data() + found->begin + row * step);
      const std::string_view text(from, width);
      texts.emplace_back(without_blanks(text.substr(0, text.find('\0'))));
    }
    return texts;
  }

  [[nodiscard]] std::string names_of_curves() const override {
    const auto found =
        std::find_if(variables_.begin(), variables_.end(), [](const Variable& one) { return one.attributes.is_name; });
    return found == variables_.end() ? std::string() : found->name;
  }

 private:
  struct Dimension {
    std::string name;
    std::size_t size;  // 0: that of the records
  };
  struct Variable {
    std::string name;
    std::vector<std::size_t> dimensions;  // by their numbers
    Conventions attributes;
    NumberType type;
    std::size_t begin = 0;
    bool has_records = false;
  };

  [[noreturn]] void fail(const std::string& what) const { throw DataError(path_ + ": the NetCDF file " + what); }

  std::span<const std::byte> take(std::size_t size) {
    if (size > bytes_.size() - at_) fail("ends in its head");
    at_ += size;
    return bytes_.subspan(at_ - size, size);
  }

  std::uint32_t word() {
    return static_cast<std::uint32_t>(load_number<std::uint32_t, std::uint32_t>(take(4).data(), swaps));
  }

  std::size_t wide_word() {
    const std::size_t high = word();
    return high << 32 | word();
  }

  // A size or a number of something.
  std::size_t count() { return version_ == 5 ? wide_word() : word(); }

  std::string text() {
    const std::size_t size = count();
    if (size > bytes_.size() - at_) fail("ends in its head");
    const std::string_view name(reinterpret_cast<const char*>(take(padded(size)).data()), size);
    return std::string(name.substr(0, name.find('\0')));
  }

  // The length of a list, which has a tag unless it is empty.
  std::size_t list(std::uint32_t tag) {
    const std::uint32_t found = word();
    const std::size_t length = count();
    if ((found != tag && (found != 0 || length != 0)) || length > bytes_.size()) fail("has a damaged head");
    return length;
  }

  Conventions attributes() {
    constexpr std::uint32_t attributes_tag = 12;
    Conventions known;
    for (std::size_t left = list(attributes_tag); left > 0; --left) {
      const std::string name = text();
      const NumberType type = number_type(word());
      const std::size_t length = count();
      if (type.size == 0 || length > bytes_.size()) fail("has a damaged head");
      const std::span<const std::byte> values = take(padded(length * type.size));
      if (type.load == nullptr) {
        const std::string_view text(reinterpret_cast<const char*>(values.data()), length);
        heed(known, name, text.substr(0, text.find('\0')));
        continue;
      }
      constexpr std::size_t max_heeded = 64;  // missing values
      std::vector<double> numbers(std::min(length, max_heeded));
      for (std::size_t k = 0; k < numbers.size(); ++k) {
        numbers[k] = type.load(values.data() + k * type.size, swaps);
      }
      heed(known, name, numbers);
    }
    return known;
  }

  void read_variable() {
    Variable variable;
    variable.name = text();
    const std::size_t axes = count();
    if (axes > bytes_.size()) fail("has a damaged head");
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const std::size_t number = count();
      if (number >= dimensions_.size())
        fail("has a variable, " + quoted_text(variable.name) + ", with a dimension that is not there");
      variable.dimensions.push_back(number);
    }
    variable.has_records = axes > 0 && dimensions_[variable.dimensions[0]].size == 0;
    variable.attributes = attributes();
    variable.type = number_type(word());
    if (variable.type.size == 0) fail("has a variable, " + quoted_text(variable.name) + ", of an unknown type");
    (void)count();  // its size, which the largest do not have
    variable.begin = version_ == 1 ? word() : wide_word();
    variables_.push_back(std::move(variable));
  }

  // Elements of a variable, or of one of its records; the largest number where that is beyond any memory.
  [[nodiscard]] std::size_t elements(const Variable& variable) const {
    ArrayInfo array{{}, {}};
    for (std::size_t axis = variable.has_records ? 1 : 0; axis < variable.dimensions.size(); ++axis) {
      array.shape.push_back(dimensions_[variable.dimensions[axis]].size);
    }
    return array.size();
  }

  // Records hold a piece of each variable that has them; a single such variable is not padded.
  void place_records(std::size_t stated) {
    const std::size_t of_records = static_cast<std::size_t>(
        std::count_if(variables_.begin(), variables_.end(), [](const Variable& one) { return one.has_records; }));
    std::size_t first = bytes_.size();
    for (const Variable& variable : variables_) {
      if (!variable.has_records) continue;
      first = std::min(first, variable.begin);
      const std::size_t count = elements(variable);
      if (count > bytes_.size() / variable.type.size) {  // a record that the file cannot hold
        record_size_ = bytes_.size() + 1;
        break;
      }
      const std::size_t size = count * variable.type.size;
      record_size_ += of_records > 1 ? padded(size) : size;
    }
    constexpr std::size_t being_written = 0xFFFFFFFF;
    const std::size_t present = record_size_ == 0 ? 0 : (bytes_.size() - first) / record_size_;
    records_ = stated >= being_written ? present : stated;
    for (std::size_t k = 0; k < variables_.size(); ++k) {
      const Variable& variable = variables_[k];
      if (variable.type.load == nullptr) continue;
      ArrayInfo array{variable.name, {}};
      for (const std::size_t number : variable.dimensions) {
        const Dimension& dimension = dimensions_[number];
        array.shape.push_back(dimension.size == 0 ? records_ : dimension.size);
        array.axes.push_back(dimension.name);
      }
      array.role = role_by(variable.attributes);
      arrays_.push_back(std::move(array));
      places_.push_back(k);
    }
  }

  std::span<const std::byte> bytes_;
  const std::string& path_;
  unsigned version_ = 1;
  std::size_t at_ = 4;  // in the head
  std::vector<Dimension> dimensions_;
  std::vector<Variable> variables_;
  std::size_t records_ = 0, record_size_ = 0;
  std::vector<ArrayInfo> arrays_;
  std::vector<std::size_t> places_;  // the variable of each array
};

}  // namespace

void read_netcdf(const FileSource& source, CurveFile& file) {
  NetCdfFile arrays(source.bytes, file.path);
  read_arrays(arrays, source.columns, file);
}

}  // namespace lober::detail
