// MATLAB's MAT files of versions 4 and 5 to 7, which matio reads; those of 7.3 are HDF5.
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>

#include "engine/files/byte_order.hpp"
#include "engine/files/formats/arrays.hpp"
#include "engine/files/formats/libraries.hpp"
#include "engine/files/formats/memory_file.hpp"
#include "engine/files/formats/readers.hpp"
#if LOBER_HAS_MATIO
#include <matio.h>
#endif

namespace lober::detail {
namespace {

constexpr std::string_view mat73_head = "MATLAB 7.3";

}  // namespace

#if LOBER_HAS_MATIO
namespace {

struct Matio {
  LOBER_LOADED(matio_library, Mat_LogInitFunc);
  LOBER_LOADED(matio_library, Mat_Open);
  LOBER_LOADED(matio_library, Mat_Close);
  LOBER_LOADED(matio_library, Mat_VarReadNextInfo);
  LOBER_LOADED(matio_library, Mat_VarRead);
  LOBER_LOADED(matio_library, Mat_VarFree);
  LOBER_LOADED(matio_library, Mat_VarGetStructFieldnames);
  LOBER_LOADED(matio_library, Mat_VarGetNumberOfFields);
  LOBER_LOADED(matio_library, Mat_VarGetStructFieldByIndex);

  Matio() {
    Mat_LogInitFunc("lober", [](int, char*) {});  // it prints nothing
  }
};

const Matio& matio() {
  static const Matio loaded;
  return loaded;
}

// Version 4: each variable is five words (type, rows, columns, whether it is complex, length of its name), its name and
// its numbers. matio believes any length.
void require_sound_version4(std::span<const std::byte> bytes, const std::string& path) {
  constexpr std::size_t head = 20, max_name = 64;
  constexpr std::array<std::size_t, 6> sizes{8, 4, 4, 2, 2, 1};  // bytes of a number, by the tens of the type
  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return std::size_t{value};
  };
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t left = bytes.size() - at;
    const bool has_head = left >= head;
    const std::size_t type = has_head ? word(at) / 10 % 10 : sizes.size();
    const std::size_t name = has_head ? word(at + 16) : 0, rows = has_head ? word(at + 4) : 0;
    const std::size_t numbers =
        ArrayInfo{{}, {rows, has_head ? word(at + 8) : 0, has_head && word(at + 12) != 0 ? 2U : 1U}}.size();
    if (type >= sizes.size() || name > max_name || name > left - head || numbers > (left - head - name) / sizes[type]) {
      throw DataError(path + ": is a MAT file of version 4 that is damaged or cut off at byte " + std::to_string(at));
    }
    at += head + name + numbers * sizes[type];
  }
}

// Versions 5 to 7: behind a head of 128 bytes elements, each with its type and its length, and padded to eight bytes
// unless it is compressed. Where the file is cut off, matio reads what memory holds.
void require_sound_version5(std::span<const std::byte> bytes, const std::string& path) {
  constexpr std::size_t head = 128, order_at = 126, tag = 8;
  constexpr std::uint32_t compressed = 15;
  const auto fail = [&](std::size_t at) {
    throw DataError(path + ": is a MAT file that is damaged or cut off at byte " + std::to_string(at));
  };
  if (bytes.size() < head) fail(bytes.size());
  const bool swap = bytes[order_at] == std::byte{'M'};  // "MI", and "IM" in the order of this machine
  const auto word = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return swap ? reversed_bytes(value) : value;
  };
  for (std::size_t at = head; at < bytes.size();) {
    if (bytes.size() - at < tag) fail(at);
    const std::size_t length = word(at + 4), padding = word(at) == compressed ? 0 : (8 - length % 8) % 8;
    if (length + padding > bytes.size() - at - tag) fail(at);
    at += tag + length + padding;
  }
}

using Variable = std::unique_ptr<matvar_t, void (*)(matvar_t*)>;

template <typename T>
void copy_numbers(const void* from, Buffer<double>& to) {
  const T* const numbers = static_cast<const T*>(from);
  for (std::size_t k = 0; k < to.size(); ++k) to[k] = static_cast<double>(numbers[k]);
}

using CopyNumbers = void (*)(const void*, Buffer<double>&);

// How the numbers of a class lie in memory; null for cells, texts and objects.
CopyNumbers copier_of(matio_classes kind) {
  switch (kind) {
    case MAT_C_DOUBLE:
      return copy_numbers<double>;
    case MAT_C_SINGLE:
      return copy_numbers<float>;
    case MAT_C_INT8:
      return copy_numbers<std::int8_t>;
    case MAT_C_UINT8:
      return copy_numbers<std::uint8_t>;
    case MAT_C_INT16:
      return copy_numbers<std::int16_t>;
    case MAT_C_UINT16:
      return copy_numbers<std::uint16_t>;
    case MAT_C_INT32:
      return copy_numbers<std::int32_t>;
    case MAT_C_UINT32:
      return copy_numbers<std::uint32_t>;
    case MAT_C_INT64:
      return copy_numbers<std::int64_t>;
    case MAT_C_UINT64:
      return copy_numbers<std::uint64_t>;
    default:
      return nullptr;
  }
}

class MatFile final : public ArrayFile {
 public:
  MatFile(const std::string& in_memory, const FileSource& source, const std::string& path)
      : path_(path),
        file_size_(source.bytes.size()),
        is_version4_(!source.text().starts_with("MATLAB")),
        file_(matio().Mat_Open(in_memory.c_str(), MAT_ACC_RDONLY), matio().Mat_Close) {
    if (file_ == nullptr) throw DataError(path + ": is a MAT file that is damaged or cut off");
    for (;;) {
      const Variable variable(matio().Mat_VarReadNextInfo(file_.get()), matio().Mat_VarFree);
      if (variable == nullptr) break;
      if (variable->name == nullptr) continue;
      const std::string name = variable->name;
      if (variable->class_type == MAT_C_STRUCT) {
        add_fields(variable.get(), name);
      } else {
        add(*variable, name, name, no_field);
      }
    }
  }

  [[nodiscard]] const std::vector<ArrayInfo>& arrays() const override { return arrays_; }
  [[nodiscard]] bool curves_are_columns() const override { return true; }

  [[nodiscard]] Buffer<double> numbers(std::size_t index) override {
    const Location& place = places_[index];
    require_that_it_can_hold(arrays_[index]);
    const Variable whole(matio().Mat_VarRead(file_.get(), place.variable.c_str()), matio().Mat_VarFree);
    const matvar_t* found = whole.get();
    if (whole != nullptr && place.field != no_field) {
      found = matio().Mat_VarGetStructFieldByIndex(whole.get(), place.field, 0);
    }
    const ArrayInfo& array = arrays_[index];
    const CopyNumbers copy = found == nullptr ? nullptr : copier_of(found->class_type);
    if (copy == nullptr || found->data == nullptr || shape_of(*found) != array.shape ||
        found->nbytes / static_cast<std::size_t>(std::max(found->data_size, 1)) < array.size()) {
      throw DataError(path_ + ": array " + array.name + " cannot be read: the MAT file is damaged or cut off");
    }
    Buffer<double> numbers(array.size());
    copy(found->data, numbers);
    return last_axis_fastest(numbers, array.shape);
  }

 private:
  static constexpr std::size_t no_field = static_cast<std::size_t>(-1);

  struct Location {
    std::string variable;
    std::size_t field;
  };

  // Version 4 is not compressed.
  void require_that_it_can_hold(const ArrayInfo& array) const {
    if (is_version4_ ? array.size() <= file_size_ : can_hold(file_size_, array.size())) return;
    throw DataError(path_ + ": array " + array.name + " has more numbers than the MAT file can hold; it is damaged");
  }

  static std::vector<std::size_t> shape_of(const matvar_t& variable) {
    if (variable.rank < 1 || variable.dims == nullptr) return {};
    return {variable.dims, variable.dims + variable.rank};
  }

  void add(const matvar_t& variable, const std::string& name, const std::string& whole, std::size_t field) {
    if (copier_of(variable.class_type) == nullptr || variable.isComplex != 0) return;
    arrays_.push_back({name, shape_of(variable)});
    places_.push_back({whole, field});
  }

  // Those of a single structure: s.x, s.y.
  void add_fields(matvar_t* variable, const std::string& name) {
    if (ArrayInfo{{}, shape_of(*variable)}.size() != 1) return;
    char* const* const names = matio().Mat_VarGetStructFieldnames(variable);
    const std::size_t count = matio().Mat_VarGetNumberOfFields(variable);
    for (std::size_t k = 0; names != nullptr && k < count; ++k) {
      const matvar_t* const field = matio().Mat_VarGetStructFieldByIndex(variable, k, 0);
      if (field != nullptr && names[k] != nullptr) add(*field, name + "." + names[k], name, k);
    }
  }

  const std::string& path_;
  std::size_t file_size_;
  bool is_version4_;
  std::unique_ptr<mat_t, int (*)(mat_t*)> file_;
  std::vector<ArrayInfo> arrays_;
  std::vector<Location> places_;  // those of arrays_
};

}  // namespace

void read_mat(const FileSource& source, CurveFile& file) {
  if (source.text().starts_with(mat73_head)) return read_mat73(source, file);
  if (!matio_library.is_present()) {
    throw DataError(file.path + ": this is a MATLAB MAT file, " + matio_library.reason_it_is_missing());
  }
  const bool is_version4 = !source.text().starts_with("MATLAB");
  is_version4 ? require_sound_version4(source.bytes, file.path) : require_sound_version5(source.bytes, file.path);
  const std::lock_guard lock(one_thread_at_a_time());
  const MemoryFile in_memory(file.path, source.bytes);
  MatFile arrays(in_memory.path(), source, file.path);
  read_arrays(arrays, source.columns, file);
}
#else
void read_mat(const FileSource& source, CurveFile& file) {
  if (source.text().starts_with(mat73_head)) return read_mat73(source, file);
  throw DataError(file.path + ": this is a MATLAB MAT file, " + matio_library.reason_it_is_missing());
}
#endif

}  // namespace lober::detail
