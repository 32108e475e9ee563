# liblober.so: the objects of all enabled libraries in one. They use each other's internals, which therefore need not be
# exported (docs/design-notes.md). lober::geometry and so on then all mean this library.
get_property(archives GLOBAL PROPERTY LOBER_ARCHIVES)
list(REMOVE_ITEM archives lober_engine)
add_library(lober_shared SHARED)
foreach(archive ${archives})
  target_sources(lober_shared PRIVATE $<TARGET_OBJECTS:${archive}>)
endforeach()
lober_interface(lober_shared PUBLIC)
lober_own_code(lober_shared)
target_link_libraries(lober_shared PRIVATE TBB::tbb TBB::tbbmalloc ${CMAKE_DL_LIBS})
if(LOBER_BUILD_FILES)
  target_link_libraries(lober_shared PRIVATE ${LOBER_NETTLE})
endif()
if(LOBER_BUILD_BATCH)
  target_link_libraries(lober_shared PRIVATE SQLite::SQLite3)
endif()

# While the major version is 0, a new minor version is another library (docs/stability.md).
set(soversion ${PROJECT_VERSION_MAJOR})
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(soversion ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
endif()
set_target_properties(lober_shared PROPERTIES OUTPUT_NAME lober EXPORT_NAME shared LINKER_LANGUAGE CXX
                      VERSION ${PROJECT_VERSION} SOVERSION ${soversion})
# Hidden visibility says nothing about templates of the standard library that are instantiated here; a list of what is
# exported does. Nothing may be left undefined either.
if(UNIX AND NOT APPLE)
  set(exports ${CMAKE_CURRENT_BINARY_DIR}/exports.map)
  configure_file(exports.map.in ${exports} @ONLY)
  target_link_options(lober_shared PRIVATE -Wl,--version-script=${exports})
  if(NOT LOBER_SANITIZE)
    target_link_options(lober_shared PRIVATE -Wl,--no-undefined)
  endif()
  set_target_properties(lober_shared PROPERTIES LINK_DEPENDS ${exports})
endif()

foreach(component ${components} engine)
  add_library(lober_${component}_shared INTERFACE)
  set_target_properties(lober_${component}_shared PROPERTIES EXPORT_NAME ${component})
  target_link_libraries(lober_${component}_shared INTERFACE lober_shared)
  set_property(GLOBAL APPEND PROPERTY LOBER_SHARED_TARGETS lober_${component}_shared)
endforeach()
set_property(GLOBAL APPEND PROPERTY LOBER_SHARED_TARGETS lober_shared)
