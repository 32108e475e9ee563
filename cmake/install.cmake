# `cmake --install`, the package that find_package(lober) loads, and pkg-config files. Components: lober_runtime (the shared
# library), lober_development, lober_program.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
include(cmake/pkg_config.cmake)

# Installs one form, static or shared. Further arguments: EXCLUDE_FROM_ALL for a form that is only installed by the names
# of its components.
function(lober_install form runtime development)
  get_property(components GLOBAL PROPERTY LOBER_COMPONENTS)
  if(form STREQUAL shared)
    get_property(targets GLOBAL PROPERTY LOBER_SHARED_TARGETS)
  else()
    get_property(targets GLOBAL PROPERTY LOBER_ARCHIVES)
  endif()
  set(package ${PROJECT_BINARY_DIR}/package/${form})
  set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/lober)

  install(TARGETS ${targets} EXPORT lober-${form}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${development} ${ARGN}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${runtime} NAMELINK_COMPONENT ${development} ${ARGN}
          INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/engine/lober DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
          COMPONENT ${development} ${ARGN})
  # Named after the form, as CMake would keep two of one name in one place until they are installed.
  install(EXPORT lober-${form} NAMESPACE lober:: FILE lober-${form}-targets.cmake DESTINATION ${package_folder}
          COMPONENT ${development} ${ARGN})
  list(JOIN components ", " component_names)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/lober-config.cmake.in ${package}/lober-config.cmake
                                INSTALL_DESTINATION ${package_folder} NO_CHECK_REQUIRED_COMPONENTS_MACRO)
  write_basic_package_version_file(${package}/lober-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${package}/lober-config.cmake ${package}/lober-config-version.cmake DESTINATION ${package_folder}
          COMPONENT ${development} ${ARGN})

  lober_pc_files(${form} ${package} "${components}")
  set(files ${package}/lober.pc)
  foreach(component ${components})
    list(APPEND files ${package}/lober-${component}.pc)
  endforeach()
  install(FILES ${files} DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT ${development} ${ARGN})
endfunction()

if(BUILD_SHARED_LIBS)
  lober_install(shared lober_runtime lober_development)
else()
  lober_install(static lober_runtime lober_development)
  if(TARGET lober_shared)
    lober_install(shared lober_shared_form lober_shared_form EXCLUDE_FROM_ALL)  # for our tests
  endif()
endif()
if(TARGET lober)
  install(TARGETS lober RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT lober_program)
endif()
# The program writes its manual pages and completions itself, so they never lag; one for another machine cannot run here.
if(TARGET lober AND NOT CMAKE_CROSSCOMPILING)
  install(CODE "set(program \"$<TARGET_FILE:lober>\")
set(folder \"${PROJECT_BINARY_DIR}/manual\")
include(\"${PROJECT_SOURCE_DIR}/cmake/manual.cmake\")" COMPONENT lober_program)
endif()
