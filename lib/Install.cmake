# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts where. Nothing knows the prefix, so the tree can be moved.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/awd)

install(TARGETS awd EXPORT awd-targets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/awd DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.h)

# Where libawd looks for them: beside itself.
get_property(bases DIRECTORY bases PROPERTY SUBDIRECTORIES)
foreach(folder ${bases})
  get_property(modules DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  install(TARGETS ${modules}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/awd/bases-${AWD_BASIS_ABI})
endforeach()

if(TARGET awd-refit)
  install(TARGETS awd-refit LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/awd)
endif()

if(TARGET awd-program)
  file(RELATIVE_PATH to_library ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set_target_properties(awd-program PROPERTIES INSTALL_RPATH $ORIGIN/${to_library})
  install(TARGETS awd-program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

install(EXPORT awd-targets NAMESPACE awd:: FILE awdTargets.cmake DESTINATION ${package_folder})
configure_package_config_file(lib/awdConfig.cmake.in ${PROJECT_BINARY_DIR}/awdConfig.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/awdConfigVersion.cmake
  COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/awdConfig.cmake ${PROJECT_BINARY_DIR}/awdConfigVersion.cmake
  bases/AddBasis.cmake DESTINATION ${package_folder})
