# Compiles the sources of a target together, whole folders in units of 10 to 16 files: the headers that they share are
# read once a unit, which is most of what compiling them takes. Names in unnamed namespaces are therefore unique within a
# target. Off in the preset `debug` and where clang-tidy reads: there each file is compiled by itself, and a missing #include
# is an error. Files with options of their own stay alone.
function(lober_unity target)
  if(NOT LOBER_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  set(unit 0)
  set(files 0)
  set(folder "")
  foreach(source ${sources})
    get_source_file_property(group ${source} UNITY_GROUP)
    if(group)
      continue()  # as in another target of this folder
    endif()
    cmake_path(GET source PARENT_PATH its_folder)
    if((files GREATER_EQUAL 10 AND NOT its_folder STREQUAL folder) OR files GREATER_EQUAL 16)
      math(EXPR unit "${unit} + 1")
      set(files 0)
    endif()
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP unit_${unit})
    math(EXPR files "${files} + 1")
    set(folder ${its_folder})
  endforeach()
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
