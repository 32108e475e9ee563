# Headers of the standard library that almost every file reads, directly or not: half the time of a compilation without
# much optimisation. On in the presets but `debug`; there, and where clang-tidy reads, a missing #include is an error.
# Further arguments: more of them; without, the libraries of engine/ share what base compiled.
set(LOBER_COMMON_HEADERS <algorithm> <array> <atomic> <cmath> <functional> <memory> <mutex> <optional> <span> <string>
    <string_view> <vector>)
function(lober_precompile target)
  if(NOT LOBER_PRECOMPILE)
    return()
  endif()
  # False alarms of GCC 12 on std::string (its bug 105651), which in a precompiled header is not a system header to it.
  target_compile_options(${target} PRIVATE "$<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-array-bounds>")
  if(TARGET lober_base AND NOT ARGN AND NOT target STREQUAL "lober_base")
    target_precompile_headers(${target} REUSE_FROM lober_base)
  else()
    target_precompile_headers(${target} PRIVATE ${LOBER_COMMON_HEADERS} ${ARGN})
  endif()
endfunction()

# Flags of our own code. `lober_own_code(TARGET)` is called on every target that we compile.
#
# -ffp-contract=off: the predicates and the error-free transforms in kernels/ are theorems about a
# fixed sequence of roundings. A compiler that fuses a*b - c*d into an FMA changes that sequence, and
# with it signs that must be exact and bits that must not depend on the machine. Where an FMA is
# wanted it is written out (kernels/simd.hpp). There is no -ffast-math anywhere, for the same reason.
#
# -fno-math-errno, -fno-trapping-math: nobody reads errno or the exception flags. No result changes, and loops with
# square roots and choices become vectors.
function(lober_own_code target)
  set_target_properties(${target} PROPERTIES CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow
    $<$<BOOL:${LOBER_WERROR}>:-Werror>
    -ffp-contract=off -fno-math-errno -fno-trapping-math)
  # -Wno-psabi: compilers warn that vector types are passed differently by builds with and without AVX; ours
  # never cross a translation unit. -Wno-restrict: a false alarm of GCC 12 on std::string (its bug 105651). To Clang
  # -Wconversion means changes of sign too, to GCC it does not.
  target_compile_options(${target} PRIVATE -Wno-psabi $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
                                           $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>)
  if(LOBER_BUILD_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
  if(LOBER_SANITIZE)
    if(LOBER_SANITIZE MATCHES "thread")
      if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
        message(FATAL_ERROR "ThreadSanitizer needs clang: GCC cannot leave oneTBB's headers out (cmake/tsan-ignore.txt)")
      endif()
      target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/cmake/tsan-ignore.txt>)
    endif()
    # Instrumented code makes GCC see uninitialised values that are not there.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    target_compile_options(${target} PUBLIC -fsanitize=${LOBER_SANITIZE} -fno-omit-frame-pointer)
    if(NOT LOBER_SANITIZE STREQUAL "thread")
      target_compile_options(${target} PUBLIC -fno-sanitize-recover=all)
    endif()
    target_link_options(${target} PUBLIC -fsanitize=${LOBER_SANITIZE})
  endif()
endfunction()

# What users of any form of the library need: C++20, and <lober/...>. The rest of engine/ and kernels/ is private, and not
# installed.
function(lober_interface target scope)
  target_compile_features(${target} ${scope} cxx_std_20)
  target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/engine>)
endfunction()

# A static library whose objects can also be part of a shared one (engine/shared.cmake).
function(lober_archive target name)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON
                        CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  lober_interface(${target} PUBLIC)
  lober_own_code(${target})
  set_property(GLOBAL APPEND PROPERTY LOBER_ARCHIVES ${target})
endfunction()
