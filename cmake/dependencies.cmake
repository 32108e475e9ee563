# Libraries of others, with the least version that is accepted. lober is tested with the versions of Debian 12, so these
# are the least where nothing says that an older one would do.
set(LOBER_NEEDS_TBB 2021.8)
set(LOBER_NEEDS_nanoflann 1.4.2...<1.5)  # 1.5 renamed SearchParams; Debian's 1.4.3 calls itself 1.4.2
set(LOBER_NEEDS_Eigen3 3.4)
set(LOBER_NEEDS_Boost 1.74)
set(LOBER_NEEDS_SQLite3 3.27)            # VACUUM INTO
set(LOBER_NEEDS_tomlplusplus 3.3)
set(LOBER_NEEDS_CLI11 2.1)
set(LOBER_NEEDS_nlohmann_json 3.11)
set(LOBER_NEEDS_spdlog 1.10)

# A macro, as what find_package sets belongs to the folder that calls it.
macro(lober_find package)
  find_package(${package} ${LOBER_NEEDS_${package}} REQUIRED)
endmacro()

# SHA-256. Nettle has no package for CMake.
macro(lober_find_nettle)
  find_library(LOBER_NETTLE nettle REQUIRED)
  find_path(LOBER_NETTLE_HEADERS nettle/sha2.h REQUIRED)
endmacro()
