// MATLAB's MAT files of versions 4 and 5 to 7, which matio reads; those of 7.3 are HDF5.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>

#include "engine/files/formats/arrays.hpp"
#include "engine/files/formats/libraries.hpp"
#include "engine/files/formats/mat_checks.hpp"
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
  LOBER_LOADED(matio_library, Mat_VarGetCell);

  Matio() {
    Mat_LogInitFunc("lober", [](int, char*) {});  // it prints nothing
  }
};

const Matio& matio() {
  static const Matio loaded;
  return loaded;
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
        add(variable.get(), name, {name, no_field});
      }
    }
  }

  [[nodiscard]] const std::vector<ArrayInfo>& arrays() const override { return arrays_; }
  [[nodiscard]] bool curves_are_columns() const override { return true; }

  [[nodiscard]] Buffer<double> numbers(std::size_t index) override {
    const ArrayInfo& array = arrays_[index];
    require_that_it_can_hold(array);
    const Variable whole(matio().Mat_VarRead(file_.get(), places_[index].variable.c_str()), matio().Mat_VarFree);
    const std::vector<matvar_t*> elements = elements_of(whole.get(), places_[index].field);
    if (array.pieces.empty()) {
      if (elements.size() != 1) damaged(array.name);
      return numbers_of(elements[0], array);
    }
    Buffer<double> all;
    for (matvar_t* const one : elements) {
      const std::optional<ArrayInfo> element = info_of(one, array.name);
      if (!element) damaged(array.name);
      if (element->size() > 0) append_element(all, numbers_of(one, *element), *element, array);
    }
    if (all.size() != array.size() * (array.is_complex ? 2 : 1)) damaged(array.name);
    return all;
  }

 private:
  static constexpr std::size_t no_field = static_cast<std::size_t>(-1);

  struct Location {
    std::string variable;
    std::size_t field;
  };

  [[noreturn]] void damaged(const std::string& name) const {
    throw DataError(path_ + ": array " + name + " cannot be read: the MAT file is damaged or cut off");
  }

  // Version 4 is not compressed.
  void require_that_it_can_hold(const ArrayInfo& array) const {
    if (is_version4_ ? array.size() <= file_size_ : can_hold(file_size_, array.size())) return;
    throw DataError(path_ + ": array " + array.name + " has more numbers than the MAT file can hold; it is damaged");
  }

  static std::vector<std::size_t> shape_of(const matvar_t& variable) {
    if (variable.rank < 1 || variable.dims == nullptr) return {};
    return {variable.dims, variable.dims + variable.rank};
  }

  // Nothing for a variable that is not numbers. Elements of lists that are not there are empty.
  static std::optional<ArrayInfo> info_of(const matvar_t* variable, const std::string& name) {
    if (variable == nullptr || variable->class_type == MAT_C_EMPTY) return ArrayInfo{name, {0}};
    if (copier_of(variable->class_type) == nullptr) return std::nullopt;
    ArrayInfo array{name, shape_of(*variable)};
    array.is_complex = variable->isComplex != 0;
    return array;
  }

  [[nodiscard]] Buffer<double> numbers_of(const matvar_t* found, const ArrayInfo& array) const {
    const CopyNumbers copy = found == nullptr ? nullptr : copier_of(found->class_type);
    if (copy == nullptr || found->data == nullptr || shape_of(*found) != array.shape ||
        (found->isComplex != 0) != array.is_complex ||
        found->nbytes / static_cast<std::size_t>(std::max(found->data_size, 1)) < array.size()) {
      damaged(array.name);
    }
    Buffer<double> numbers(array.size());
    if (!array.is_complex) {
      copy(found->data, numbers);
      return last_axis_fastest(numbers, array.shape);
    }
    const auto* const parts = static_cast<const mat_complex_split_t*>(found->data);
    if (parts->Re == nullptr || parts->Im == nullptr) damaged(array.name);
    copy(parts->Re, numbers);
    Buffer<double> imaginary(array.size());
    copy(parts->Im, imaginary);
    return interleaved(last_axis_fastest(numbers, array.shape), last_axis_fastest(imaginary, array.shape));
  }

  // The variable, or its field in each structure of an array, or the cells of either.
  static std::vector<matvar_t*> elements_of(matvar_t* variable, std::size_t field) {
    if (variable == nullptr) return {};
    constexpr std::size_t max_elements = std::size_t{1} << 20;
    const std::size_t count = ArrayInfo{{}, shape_of(*variable)}.size();
    if (count > max_elements) return {};
    if (field != no_field) {
      if (variable->class_type != MAT_C_STRUCT || field >= matio().Mat_VarGetNumberOfFields(variable)) return {};
      if (count == 1) return elements_of(matio().Mat_VarGetStructFieldByIndex(variable, field, 0), no_field);
    } else if (variable->class_type != MAT_C_CELL) {
      return {variable};
    }
    std::vector<matvar_t*> elements;
    for (std::size_t k = 0; k < count && variable->data != nullptr; ++k) {
      elements.push_back(field == no_field ? matio().Mat_VarGetCell(variable, static_cast<int>(k))
                                           : matio().Mat_VarGetStructFieldByIndex(variable, field, k));
    }
    return elements;
  }

  void add(matvar_t* variable, const std::string& name, const Location& location) {
    const std::vector<matvar_t*> elements = elements_of(variable, location.field);
    const bool is_list = elements.size() != 1 || elements[0] != field_of(variable, location.field);
    std::vector<ArrayInfo> infos;
    for (const matvar_t* const element : elements) {
      std::optional<ArrayInfo> info = info_of(element, name);
      if (!info) return;
      infos.push_back(std::move(*info));
    }
    std::optional<ArrayInfo> array = infos.empty() ? std::nullopt
                                     : is_list     ? array_of_list(name, infos)
                                                   : std::optional(infos[0]);
    if (!array) return;
    arrays_.push_back(std::move(*array));
    places_.push_back(location);
  }

  static matvar_t* field_of(matvar_t* variable, std::size_t field) {
    return field == no_field ? variable : matio().Mat_VarGetStructFieldByIndex(variable, field, 0);
  }

  // s.x, s.y, of one structure or of each in an array.
  void add_fields(matvar_t* variable, const std::string& name) {
    char* const* const names = matio().Mat_VarGetStructFieldnames(variable);
    const std::size_t count = matio().Mat_VarGetNumberOfFields(variable);
    const std::size_t structures = ArrayInfo{{}, shape_of(*variable)}.size();
    if (structures == 0 || variable->data == nullptr) return;
    for (std::size_t k = 0; names != nullptr && k < count; ++k) {
      if (names[k] != nullptr) add(variable, name + "." + names[k], {name, k});
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
