# Writes lober_build.hpp, only if it changes: version, commit, compiler and flags of this build.
#   cmake -DSOURCE=... -DOUTPUT=... -DVERSION=... -DCOMPILER=... -DFLAGS=... -P build_info.cmake
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND git -C "${SOURCE}" rev-parse --short=12 HEAD
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
execute_process(COMMAND git -C "${SOURCE}" status --porcelain --untracked-files=no
                OUTPUT_VARIABLE changes OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(commit STREQUAL "")
  set(commit unknown)
elseif(NOT changes STREQUAL "")
  string(APPEND commit "+changes")
endif()
string(REPLACE "\"" "" FLAGS "${FLAGS}")
file(CONFIGURE OUTPUT "${OUTPUT}" @ONLY CONTENT
"#define LOBER_BUILD_VERSION \"@VERSION@\"
#define LOBER_BUILD_COMMIT \"@commit@\"
#define LOBER_BUILD_COMPILER \"@COMPILER@\"
#define LOBER_BUILD_FLAGS \"@FLAGS@\"
")
