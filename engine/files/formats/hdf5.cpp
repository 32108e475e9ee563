// HDF5, and what is HDF5: NetCDF-4, and MAT files of version 7.3. The library of The HDF Group reads them, from memory.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "engine/files/formats/arrays.hpp"
#include "engine/files/formats/libraries.hpp"
#include "engine/files/formats/readers.hpp"
#if LOBER_HAS_HDF5
#include <hdf5.h>
#endif

namespace lober::detail {
namespace {

std::string without_hdf5(const std::string& path) {
  return path + ": this is an HDF5 file (as NetCDF-4 and MATLAB 7.3 are), " + hdf5_library.reason_it_is_missing();
}

}  // namespace

#if LOBER_HAS_HDF5
namespace {

#if H5_VERSION_GE(1, 12, 0)
using ObjectInfo = H5O_info1_t;
#else
using ObjectInfo = H5O_info_t;
#endif

struct Hdf5 {
  LOBER_LOADED(hdf5_library, H5open);
  LOBER_LOADED(hdf5_library, H5Pcreate);
  LOBER_LOADED(hdf5_library, H5Pset_fapl_core);
  LOBER_LOADED(hdf5_library, H5Pset_file_image);
  LOBER_LOADED(hdf5_library, H5Pclose);
  LOBER_LOADED(hdf5_library, H5Fopen);
  LOBER_LOADED(hdf5_library, H5Fclose);
  LOBER_LOADED(hdf5_library, H5Ovisit2);
  LOBER_LOADED(hdf5_library, H5Dopen2);
  LOBER_LOADED(hdf5_library, H5Dclose);
  LOBER_LOADED(hdf5_library, H5Dget_type);
  LOBER_LOADED(hdf5_library, H5Dget_space);
  LOBER_LOADED(hdf5_library, H5Dget_storage_size);
  LOBER_LOADED(hdf5_library, H5Dread);
  LOBER_LOADED(hdf5_library, H5Sclose);
  LOBER_LOADED(hdf5_library, H5Sget_simple_extent_type);
  LOBER_LOADED(hdf5_library, H5Sget_simple_extent_ndims);
  LOBER_LOADED(hdf5_library, H5Sget_simple_extent_dims);
  LOBER_LOADED(hdf5_library, H5Tclose);
  LOBER_LOADED(hdf5_library, H5Tget_class);
  LOBER_LOADED(hdf5_library, H5Aexists);
  LOBER_LOADED(hdf5_library, H5Aopen);
  LOBER_LOADED(hdf5_library, H5Aclose);
  LOBER_LOADED(hdf5_library, H5Aget_type);
  LOBER_LOADED(hdf5_library, H5Aget_space);
  LOBER_LOADED(hdf5_library, H5Aread);
  LOBER_LOADED(hdf5_library, H5Sget_simple_extent_npoints);
  LOBER_LOADED(hdf5_library, H5Eset_auto2);
  hid_t native_double, file_access;

  Hdf5() {
    H5open();  // gives the identifiers below their values
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    native_double = *static_cast<const hid_t*>(hdf5_library.symbol("H5T_NATIVE_DOUBLE_g"));
    file_access = *static_cast<const hid_t*>(hdf5_library.symbol("H5P_CLS_FILE_ACCESS_ID_g"));
  }
};

const Hdf5& hdf5() {
  static const Hdf5 loaded;
  return loaded;
}

// An object of the library, closed at the end.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  [[nodiscard]] hid_t id() const { return id_; }
  [[nodiscard]] bool is_open() const { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

hid_t opened_image(std::span<const std::byte> bytes) {
  constexpr std::size_t increment = std::size_t{1} << 16;
  const Handle access(hdf5().H5Pcreate(hdf5().file_access), hdf5().H5Pclose);
  hdf5().H5Pset_fapl_core(access.id(), increment, 0);
  hdf5().H5Pset_file_image(access.id(), const_cast<std::byte*>(bytes.data()), bytes.size());
  constexpr unsigned read_only = 0;  // H5F_ACC_RDONLY, which calls functions of the library
  return hdf5().H5Fopen("lober-image", read_only, access.id());
}

class Hdf5File final : public ArrayFile {
 public:
  // `matlab`: groups are structures, s.x in place of /s/x.
  Hdf5File(std::span<const std::byte> bytes, const std::string& path, bool matlab)
      : path_(path), matlab_(matlab), file_(opened_image(bytes), hdf5().H5Fclose) {
    if (!file_.is_open()) throw DataError(path + ": is an HDF5 file that is damaged or cut off");
    if (hdf5().H5Ovisit2(file_.id(), H5_INDEX_NAME, H5_ITER_NATIVE, add_object, this, H5O_INFO_BASIC) < 0) {
      throw DataError(path + ": the groups of the HDF5 file cannot be read; it is damaged");
    }
  }

  [[nodiscard]] const std::vector<ArrayInfo>& arrays() const override { return arrays_; }

  [[nodiscard]] Buffer<double> numbers(std::size_t index) override {
    const ArrayInfo& array = arrays_[index];
    const Handle set(hdf5().H5Dopen2(file_.id(), sets_[index].c_str(), H5P_DEFAULT), hdf5().H5Dclose);
    // Parts that were never written take no room in the file.
    constexpr std::size_t always_fits = std::size_t{64} << 20;
    if (set.is_open() && array.size() > always_fits && !can_hold(hdf5().H5Dget_storage_size(set.id()), array.size())) {
      throw DataError(path_ + ": dataset " + array.name +
                      " was hardly written: the file holds next to nothing of its " + std::to_string(array.size()) +
                      " numbers");
    }
    Buffer<double> numbers(array.size());
    if (!set.is_open() ||
        hdf5().H5Dread(set.id(), hdf5().native_double, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) < 0) {
      throw DataError(path_ + ": dataset " + array.name +
                      " cannot be read: it is damaged, or compressed by a filter that is not installed");
    }
    apply_attributes(set, numbers);
    return numbers;
  }

 private:
  static herr_t add_object(hid_t, const char* name, const ObjectInfo* info, void* self) noexcept {
    try {
      if (info->type == H5O_TYPE_DATASET) static_cast<Hdf5File*>(self)->add_dataset(std::string("/") + name);
      return 0;
    } catch (...) {
      return -1;
    }
  }

  void add_dataset(const std::string& name) {
    const Handle set(hdf5().H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), hdf5().H5Dclose);
    if (!set.is_open()) return;
    const Handle type(hdf5().H5Dget_type(set.id()), hdf5().H5Tclose);
    const Handle space(hdf5().H5Dget_space(set.id()), hdf5().H5Sclose);
    if (!type.is_open() || !space.is_open()) return;
    const H5T_class_t kind = hdf5().H5Tget_class(type.id());
    if (kind != H5T_FLOAT && kind != H5T_INTEGER) return;
    if (hdf5().H5Sget_simple_extent_type(space.id()) == H5S_NULL) return;
    const int axes = hdf5().H5Sget_simple_extent_ndims(space.id());
    if (axes < 0) return;
    std::array<hsize_t, H5S_MAX_RANK> sizes{};
    hdf5().H5Sget_simple_extent_dims(space.id(), sizes.data(), nullptr);
    ArrayInfo array{name, {sizes.begin(), sizes.begin() + axes}};
    if (matlab_) {
      array.name.erase(0, 1);
      std::replace(array.name.begin(), array.name.end(), '/', '.');
    }
    // An axis of a grid in NetCDF is a dataset of its own.
    if (hdf5().H5Aexists(set.id(), "REFERENCE_LIST") > 0) array.axes = {name};
    arrays_.push_back(std::move(array));
    sets_.push_back(name);
  }

  // A number that belongs to a dataset; nothing where it has none.
  [[nodiscard]] static std::optional<double> attribute(const Handle& set, const char* name) {
    if (hdf5().H5Aexists(set.id(), name) <= 0) return std::nullopt;
    const Handle found(hdf5().H5Aopen(set.id(), name, H5P_DEFAULT), hdf5().H5Aclose);
    if (!found.is_open()) return std::nullopt;
    const Handle type(hdf5().H5Aget_type(found.id()), hdf5().H5Tclose);
    const Handle space(hdf5().H5Aget_space(found.id()), hdf5().H5Sclose);
    const H5T_class_t kind = hdf5().H5Tget_class(type.id());
    if ((kind != H5T_FLOAT && kind != H5T_INTEGER) || hdf5().H5Sget_simple_extent_npoints(space.id()) != 1) {
      return std::nullopt;
    }
    double value = 0;
    if (hdf5().H5Aread(found.id(), hdf5().native_double, &value) < 0) return std::nullopt;
    return value;
  }

  // The conventions of NetCDF: numbers that stand for none, and packed ones.
  static void apply_attributes(const Handle& set, Buffer<double>& numbers) {
    apply_conventions(numbers, {attribute(set, "_FillValue"), attribute(set, "missing_value")},
                      attribute(set, "scale_factor"), attribute(set, "add_offset"));
  }

  const std::string& path_;
  bool matlab_;
  Handle file_;
  std::vector<ArrayInfo> arrays_;
  std::vector<std::string> sets_;  // those of arrays_, by their paths
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
