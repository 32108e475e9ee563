// HDF5, and what is HDF5: NetCDF-4, and MAT files of version 7.3. The library of The HDF Group reads them, from memory.
#include <algorithm>
#include <array>
#include <optional>

#include "engine/files/formats/array_choice.hpp"
#include "engine/files/formats/arrays.hpp"
#include "engine/files/formats/conventions.hpp"
#include "engine/files/formats/hdf5_library.hpp"
#include "engine/files/formats/readers.hpp"

namespace lober::detail {
namespace {

std::string without_hdf5(const std::string& path) {
  return path + ": this is an HDF5 file (as NetCDF-4 and MATLAB 7.3 are), " + hdf5_library.reason_it_is_missing();
}

}  // namespace

#if LOBER_HAS_HDF5
namespace {

hid_t opened_image(std::span<const std::byte> bytes) {
  constexpr std::size_t increment = std::size_t{1} << 16;
  const Handle access(hdf5().H5Pcreate(hdf5().file_access), hdf5().H5Pclose);
  hdf5().H5Pset_fapl_core(access.id(), increment, 0);
  hdf5().H5Pset_file_image(access.id(), const_cast<std::byte*>(bytes.data()), bytes.size());
  constexpr unsigned read_only = 0;  // H5F_ACC_RDONLY, which calls functions of the library
  return hdf5().H5Fopen("lober-image", read_only, access.id());
}

constexpr std::array numeric_attributes{"_FillValue",  "missing_value", "valid_min", "valid_max",
                                        "valid_range", "scale_factor",  "add_offset"};
constexpr std::array text_attributes{"_Unsigned", "sample_dimension", "instance_dimension", "cf_role"};

Conventions conventions_of(hid_t set) {
  Conventions known;
  for (const char* const name : numeric_attributes) heed(known, name, numbers_of_attribute(set, name));
  for (const char* const name : text_attributes) {
    if (const std::string text = text_of_attribute(set, name); !text.empty()) heed(known, name, text);
  }
  return known;
}

// The names of real and imaginary part in a type, as h5py, MATLAB and Octave have them; empty for another type.
std::vector<std::string> parts_of_complex(hid_t type) {
  constexpr std::array<std::array<std::string_view, 2>, 3> known{{{"r", "i"}, {"real", "imag"}, {"re", "im"}}};
  if (hdf5().H5Tget_class(type) != H5T_COMPOUND || hdf5().H5Tget_nmembers(type) != 2) return {};
  std::vector<std::string> names;
  for (const unsigned member : {0U, 1U}) {
    if (hdf5().H5Tget_member_class(type, member) != H5T_FLOAT) return {};
    char* const name = hdf5().H5Tget_member_name(type, member);
    if (name == nullptr) return {};
    names.emplace_back(name);
    hdf5().H5free_memory(name);
  }
  const bool is_known = std::any_of(known.begin(), known.end(), [&](const auto& pair) {
    return same_in_any_case(names[0], pair[0]) && same_in_any_case(names[1], pair[1]);
  });
  return is_known ? names : std::vector<std::string>{};
}

class Hdf5File final : public ArrayFile {
 public:
  // `matlab`: groups are structures, s.x in place of /s/x, and lists are those of cells and arrays of structures.
  Hdf5File(std::span<const std::byte> bytes, const std::string& path, bool matlab)
      : path_(path), matlab_(matlab), file_(opened_image(bytes), hdf5().H5Fclose) {
    if (!file_.is_open()) throw DataError(path + ": is an HDF5 file that is damaged or cut off");
    Visit all{*this, "", false};
    std::vector<std::string> links;
    if (hdf5().H5Ovisit2(file_.id(), H5_INDEX_NAME, H5_ITER_NATIVE, add_object, &all, H5O_INFO_BASIC) < 0 ||
        visit_links(links) < 0) {
      throw DataError(path + ": the groups of the HDF5 file cannot be read; it is damaged");
    }
    for (const std::string& link : links) {  // some lead nowhere
      Visit linked{*this, "/" + link, true};
      hdf5().H5Ovisit_by_name2(file_.id(), link.c_str(), H5_INDEX_NAME, H5_ITER_NATIVE, add_object, &linked,
                               H5O_INFO_BASIC, H5P_DEFAULT);
    }
  }

  [[nodiscard]] const std::vector<ArrayInfo>& arrays() const override { return arrays_; }

  [[nodiscard]] Buffer<double> numbers(std::size_t index) override {
    const ArrayInfo& array = arrays_[index];
    if (array.pieces.empty()) {
      return numbers_of(Handle(hdf5().H5Dopen2(file_.id(), sets_[index].c_str(), H5P_DEFAULT), hdf5().H5Dclose), array);
    }
    Buffer<double> all;
    for (const hobj_ref_t& reference : elements_of(sets_[index])) {
      const Handle set = referred(reference);
      const std::optional<ArrayInfo> element = info_of(set, array.name);
      if (!element) damaged(array.name);
      if (element->size() > 0) append_element(all, numbers_of(set, *element), *element, array);
    }
    const std::size_t expected = array.size() * (array.is_complex ? 2 : 1);
    if (all.size() != expected) damaged(array.name);
    return all;
  }

  [[nodiscard]] std::vector<std::string> texts(std::string_view name) override {
    const Handle set(hdf5().H5Dopen2(file_.id(), std::string(name).c_str(), H5P_DEFAULT), hdf5().H5Dclose);
    return set.is_open() ? texts_of_dataset(set.id()) : std::vector<std::string>{};
  }

  [[nodiscard]] std::string names_of_curves() const override { return names_of_curves_; }

 private:
  // A walk through groups, whose names begin with `prefix`.
  struct Visit {
    Hdf5File& file;
    std::string prefix;
    bool is_link;
  };

  static herr_t add_object(hid_t, const char* name, const ObjectInfo* info, void* visit) noexcept {
    try {
      if (info->type != H5O_TYPE_DATASET) return 0;
      const Visit& of = *static_cast<Visit*>(visit);
      of.file.add_dataset(std::string_view(name) == "." ? of.prefix : of.prefix + "/" + name, of.is_link);
      return 0;
    } catch (...) {
      return -1;
    }
  }

  static herr_t add_link(hid_t, const char* name, const LinkInfo* info, void* links) noexcept {
    try {
      if (info->type == H5L_TYPE_SOFT) static_cast<std::vector<std::string>*>(links)->emplace_back(name);
      return 0;
    } catch (...) {
      return -1;
    }
  }

  [[nodiscard]] herr_t visit_links(std::vector<std::string>& links) const {
#if H5_VERSION_GE(1, 12, 0)
    return hdf5().H5Lvisit1(file_.id(), H5_INDEX_NAME, H5_ITER_NATIVE, add_link, &links);
#else
    return hdf5().H5Lvisit(file_.id(), H5_INDEX_NAME, H5_ITER_NATIVE, add_link, &links);
#endif
  }

  [[noreturn]] void damaged(const std::string& name) const {
    throw DataError(path_ + ": dataset " + name +
                    " cannot be read: it is damaged, or compressed by a filter that is not installed");
  }

  // Nothing for a dataset without real or complex numbers.
  [[nodiscard]] std::optional<ArrayInfo> info_of(const Handle& set, const std::string& name) const {
    if (!set.is_open()) return std::nullopt;
    const Handle type(hdf5().H5Dget_type(set.id()), hdf5().H5Tclose);
    const std::optional<std::vector<std::size_t>> shape = shape_of_dataset(set.id());
    if (!type.is_open() || !shape) return std::nullopt;
    const H5T_class_t kind = hdf5().H5Tget_class(type.id());
    ArrayInfo array{name, *shape};
    array.is_complex = kind == H5T_COMPOUND && !parts_of_complex(type.id()).empty();
    if (kind != H5T_FLOAT && kind != H5T_INTEGER && !array.is_complex) return std::nullopt;
    if (matlab_ && text_of_attribute(set.id(), "MATLAB_class") == "char") return std::nullopt;
    if (matlab_ && hdf5().H5Aexists(set.id(), "MATLAB_empty") > 0) array.shape = {0};  // its numbers are its shape
    return array;
  }

  void add_dataset(const std::string& path, bool is_link) {
    if (matlab_ && (path.starts_with("/#refs#/") || path.starts_with("/#subsystem#/"))) return;
    const Handle set(hdf5().H5Dopen2(file_.id(), path.c_str(), H5P_DEFAULT), hdf5().H5Dclose);
    if (!set.is_open()) return;
    std::string name = path;
    if (matlab_) {
      name.erase(0, 1);
      std::replace(name.begin(), name.end(), '/', '.');
    }
    const Conventions conventions = conventions_of(set.id());
    if (conventions.is_name && names_of_curves_.empty()) names_of_curves_ = name;
    std::optional<ArrayInfo> array = info_of(set, name);
    if (!array && matlab_) array = list_of(path, name);
    if (!array) return;
    // An axis of a grid in NetCDF is a dataset of its own.
    if (hdf5().H5Aexists(set.id(), "REFERENCE_LIST") > 0) array->axes = {name};
    array->role = role_by(conventions);
    array->is_link = is_link;
    arrays_.push_back(std::move(*array));
    sets_.push_back(path);
  }

  // The references of a dataset to others; empty where it has none, or more than can be meant.
  [[nodiscard]] std::vector<hobj_ref_t> elements_of(const std::string& path) const {
    constexpr std::size_t max_elements = std::size_t{1} << 20;
    const Handle set(hdf5().H5Dopen2(file_.id(), path.c_str(), H5P_DEFAULT), hdf5().H5Dclose);
    const Handle type(hdf5().H5Dget_type(set.id()), hdf5().H5Tclose);
    const std::optional<std::vector<std::size_t>> shape = shape_of_dataset(set.id());
    if (!shape || hdf5().H5Tget_class(type.id()) != H5T_REFERENCE ||
        hdf5().H5Tget_size(type.id()) != sizeof(hobj_ref_t)) {
      return {};
    }
    const std::size_t count = ArrayInfo{{}, *shape}.size();
    if (count == 0 || count > max_elements) return {};
    std::vector<hobj_ref_t> all(count);
    const hid_t of_reference = hdf5().object_reference;
    if (hdf5().H5Dread(set.id(), of_reference, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()) < 0) return {};
    return all;
  }

  [[nodiscard]] Handle referred(const hobj_ref_t& reference) const {
    // An object that is not a dataset has no type and no shape.
    return {hdf5().H5Rdereference2(file_.id(), H5P_DEFAULT, H5R_OBJECT, &reference), hdf5().H5Oclose};
  }

  [[nodiscard]] std::optional<ArrayInfo> list_of(const std::string& path, const std::string& name) const {
    std::vector<ArrayInfo> elements;
    for (const hobj_ref_t& reference : elements_of(path)) {
      std::optional<ArrayInfo> element = info_of(referred(reference), name);
      if (!element) return std::nullopt;
      elements.push_back(std::move(*element));
    }
    return elements.empty() ? std::nullopt : array_of_list(name, elements);
  }

  [[nodiscard]] Buffer<double> numbers_of(const Handle& set, const ArrayInfo& array) const {
    // Parts that were never written take no room in the file.
    constexpr std::size_t always_fits = std::size_t{64} << 20;
    if (set.is_open() && array.size() > always_fits && !can_hold(hdf5().H5Dget_storage_size(set.id()), array.size())) {
      throw DataError(path_ + ": dataset " + array.name +
                      " was hardly written: the file holds next to nothing of its " + std::to_string(array.size()) +
                      " numbers");
    }
    if (!set.is_open()) damaged(array.name);
    const Handle type(hdf5().H5Dget_type(set.id()), hdf5().H5Tclose);
    Buffer<double> numbers(array.size() * (array.is_complex ? 2 : 1));
    hid_t in_memory = hdf5().native_double;
    std::optional<Handle> of_complex;
    if (array.is_complex) {
      of_complex.emplace(hdf5().H5Tcreate(H5T_COMPOUND, 2 * sizeof(double)), hdf5().H5Tclose);
      in_memory = of_complex->id();
      std::size_t at = 0;
      for (const std::string& part : parts_of_complex(type.id())) {
        hdf5().H5Tinsert(in_memory, part.c_str(), at, hdf5().native_double);
        at += sizeof(double);
      }
    }
    if (hdf5().H5Dread(set.id(), in_memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) < 0) damaged(array.name);
    if (array.is_complex) return numbers;
    const bool is_float = hdf5().H5Tget_class(type.id()) == H5T_FLOAT;
    const StoredType stored{hdf5().H5Tget_size(type.id()), is_float,
                            is_float || hdf5().H5Tget_sign(type.id()) != H5T_SGN_NONE};
    const bool is_netcdf =
        hdf5().H5Aexists(file_.id(), "_NCProperties") > 0 || hdf5().H5Aexists(set.id(), "DIMENSION_LIST") > 0;
    apply_conventions(numbers, conventions_of(set.id()), stored, is_netcdf);
    return numbers;
  }

  const std::string& path_;
  bool matlab_;
  Handle file_;
  std::vector<ArrayInfo> arrays_;
  std::vector<std::string> sets_;  // those of arrays_, by their paths
  std::string names_of_curves_;
};

void read(const FileSource& source, bool matlab, CurveFile& file) {
  if (!hdf5_library.is_present()) throw DataError(without_hdf5(file.path));
  const std::lock_guard lock(one_thread_at_a_time());
  Hdf5File arrays(source.bytes, file.path, matlab);
  read_arrays(arrays, source.columns, file);
}

}  // namespace

void read_hdf5(const FileSource& source, CurveFile& file) {
  read(source, false, file);
}

// MATLAB's first axis is HDF5's last: its columns, which are curves, are rows here.
void read_mat73(const FileSource& source, CurveFile& file) {
  read(source, true, file);
}
#else
void read_hdf5(const FileSource&, CurveFile& file) {
  throw DataError(without_hdf5(file.path));
}
void read_mat73(const FileSource&, CurveFile& file) {
  throw DataError(without_hdf5(file.path));
}
#endif

}  // namespace lober::detail
