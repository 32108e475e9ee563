# Writes lober_build.hpp, only if it changes: version, commit, compiler and flags of this build.
#   cmake -DSOURCE=... -DOUTPUT=... -DVERSION=... -DCOMPILER=... -DFLAGS=... -P build_info.cmake
cmake_minimum_required(VERSION 3.25)
# A copy of the sources without a repository says in a file which commit it is of (scripts/packages.sh); a repository around
# it is another one.
set(commit unknown)
if(EXISTS "${SOURCE}/.git")
  execute_process(COMMAND git -C "${SOURCE}" describe --always --abbrev=12 --exclude=* --dirty=+changes
                  OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
elseif(EXISTS "${SOURCE}/COMMIT")
  file(STRINGS "${SOURCE}/COMMIT" found LIMIT_COUNT 1)
endif()
if(NOT found STREQUAL "")
  set(commit "${found}")
endif()
# Where it was built does not change what is built.
string(REGEX REPLACE " *-f[a-z]+-prefix-map=[^ ]+" "" FLAGS "${FLAGS}")
string(STRIP "${FLAGS}" FLAGS)
string(REPLACE "\"" "" FLAGS "${FLAGS}")
file(CONFIGURE OUTPUT "${OUTPUT}" @ONLY CONTENT
"#define LOBER_BUILD_VERSION \"@VERSION@\"
#define LOBER_BUILD_COMMIT \"@commit@\"
#define LOBER_BUILD_COMPILER \"@COMPILER@\"
#define LOBER_BUILD_FLAGS \"@FLAGS@\"
")
