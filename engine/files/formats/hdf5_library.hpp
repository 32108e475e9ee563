// The functions of the HDF5 library that are used, and handles of its objects.
#pragma once

#include "engine/files/formats/libraries.hpp"
#if LOBER_HAS_HDF5
#include <hdf5.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lober::detail {

#if H5_VERSION_GE(1, 12, 0)
using ObjectInfo = H5O_info1_t;
using LinkInfo = H5L_info1_t;
#else
using ObjectInfo = H5O_info_t;
using LinkInfo = H5L_info_t;
#endif

/// Loaded when it is first asked for.
struct Hdf5 {
  LOBER_LOADED(hdf5_library, H5open);
  LOBER_LOADED(hdf5_library, H5Pcreate);
  LOBER_LOADED(hdf5_library, H5Pset_fapl_core);
  LOBER_LOADED(hdf5_library, H5Pset_file_image);
  LOBER_LOADED(hdf5_library, H5Pclose);
  LOBER_LOADED(hdf5_library, H5Fopen);
  LOBER_LOADED(hdf5_library, H5Fclose);
  LOBER_LOADED(hdf5_library, H5Ovisit2);
  LOBER_LOADED(hdf5_library, H5Ovisit_by_name2);
#if H5_VERSION_GE(1, 12, 0)
  LOBER_LOADED(hdf5_library, H5Lvisit1);
#else
  LOBER_LOADED(hdf5_library, H5Lvisit);
#endif
  LOBER_LOADED(hdf5_library, H5Dopen2);
  LOBER_LOADED(hdf5_library, H5Dclose);
  LOBER_LOADED(hdf5_library, H5Dget_type);
  LOBER_LOADED(hdf5_library, H5Dget_space);
  LOBER_LOADED(hdf5_library, H5Dget_storage_size);
  LOBER_LOADED(hdf5_library, H5Dread);
  LOBER_LOADED(hdf5_library, H5Dvlen_reclaim);
  LOBER_LOADED(hdf5_library, H5Sclose);
  LOBER_LOADED(hdf5_library, H5Sget_simple_extent_type);
  LOBER_LOADED(hdf5_library, H5Sget_simple_extent_ndims);
  LOBER_LOADED(hdf5_library, H5Sget_simple_extent_dims);
  LOBER_LOADED(hdf5_library, H5Tclose);
  LOBER_LOADED(hdf5_library, H5Tget_class);
  LOBER_LOADED(hdf5_library, H5Tget_size);
  LOBER_LOADED(hdf5_library, H5Tget_sign);
  LOBER_LOADED(hdf5_library, H5Tget_nmembers);
  LOBER_LOADED(hdf5_library, H5Tget_member_class);
  LOBER_LOADED(hdf5_library, H5Tget_member_name);
  LOBER_LOADED(hdf5_library, H5Tis_variable_str);
  LOBER_LOADED(hdf5_library, H5Tcreate);
  LOBER_LOADED(hdf5_library, H5Tinsert);
  LOBER_LOADED(hdf5_library, H5Rdereference2);
  LOBER_LOADED(hdf5_library, H5Oclose);
  LOBER_LOADED(hdf5_library, H5free_memory);
  LOBER_LOADED(hdf5_library, H5Aexists);
  LOBER_LOADED(hdf5_library, H5Aopen);
  LOBER_LOADED(hdf5_library, H5Aclose);
  LOBER_LOADED(hdf5_library, H5Aget_type);
  LOBER_LOADED(hdf5_library, H5Aget_space);
  LOBER_LOADED(hdf5_library, H5Aread);
  LOBER_LOADED(hdf5_library, H5Sget_simple_extent_npoints);
  LOBER_LOADED(hdf5_library, H5Eset_auto2);
  hid_t native_double, file_access, object_reference;

  Hdf5() {
    H5open();  // gives the identifiers below their values
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    native_double = *static_cast<const hid_t*>(hdf5_library.symbol("H5T_NATIVE_DOUBLE_g"));
    object_reference = *static_cast<const hid_t*>(hdf5_library.symbol("H5T_STD_REF_OBJ_g"));
    file_access = *static_cast<const hid_t*>(hdf5_library.symbol("H5P_CLS_FILE_ACCESS_ID_g"));
  }
};

inline const Hdf5& hdf5() {
  static const Hdf5 loaded;
  return loaded;
}

/// An object of the library, closed at the end.
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

/// The number or numbers of an attribute of an object, the text of one; empty where it has none. Throw nothing.
[[nodiscard]] std::vector<double> numbers_of_attribute(hid_t object, const char* name);
[[nodiscard]] std::string text_of_attribute(hid_t object, const char* name);

/// The texts of a dataset of strings, or rows of characters; empty where it is something else, or beyond all measure.
[[nodiscard]] std::vector<std::string> texts_of_dataset(hid_t set);

/// The axes of a dataset; nothing where it has no numbers at all.
[[nodiscard]] std::optional<std::vector<std::size_t>> shape_of_dataset(hid_t set);

}  // namespace lober::detail
#endif
