# `cmake --install` and the package that find_package(lober) loads.
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY LOBER_LIBRARIES)
install(TARGETS lober_kernels ${libraries} EXPORT loberTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/engine/lober DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
if(TARGET lober)
  install(TARGETS lober RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
if(TARGET lober_mpi)
  install(TARGETS lober_mpi RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(EXPORT loberTargets NAMESPACE lober:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/lober)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/loberConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/loberConfig.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/lober)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/loberConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/loberConfig.cmake ${PROJECT_BINARY_DIR}/loberConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/lober)
