# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts where, by component: runtime, development, bases, refit, tools and
# python. Nothing knows the prefix, so the tree can be moved.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/awd)
set(module_folder ${CMAKE_INSTALL_LIBDIR}/awd) # libawd looks for modules beside itself
set(components runtime development bases)

install(TARGETS awd EXPORT awd-targets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  COMPONENT runtime NAMELINK_COMPONENT development)
install(DIRECTORY include/awd DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
  FILES_MATCHING PATTERN *.h PATTERN *.hpp)

get_property(bases DIRECTORY bases PROPERTY SUBDIRECTORIES)
foreach(folder ${bases})
  get_property(modules DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  install(TARGETS ${modules}
    LIBRARY DESTINATION ${module_folder}/bases-${AWD_BASIS_ABI} COMPONENT bases)
endforeach()

if(TARGET awd-refit)
  list(APPEND components refit)
  install(TARGETS awd-refit LIBRARY DESTINATION ${module_folder} COMPONENT refit)
endif()

if(TARGET awd-program)
  list(APPEND components tools)
  file(RELATIVE_PATH to_library ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set_target_properties(awd-program PROPERTIES INSTALL_RPATH $ORIGIN/${to_library})
  install(TARGETS awd-program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
endif()

if(IS_DIRECTORY ${PROJECT_SOURCE_DIR}/bindings/python/awd)
  list(APPEND components python)
  set(AWD_INSTALL_PYTHONDIR lib/python3/dist-packages CACHE STRING
    "Folder of Python packages; this one is Debian's")
  install(DIRECTORY bindings/python/awd DESTINATION ${AWD_INSTALL_PYTHONDIR} COMPONENT python
    FILES_MATCHING PATTERN *.py PATTERN *.pyi PATTERN py.typed PATTERN __pycache__ EXCLUDE)
endif()

# What awdConfig.cmake looks for.
set(awd_has_render FALSE)
if(AWD_RENDER)
  set(awd_has_render TRUE)
endif()
set(bases_file ${module_folder}/bases-${AWD_BASIS_ABI}/linear-bspline.so)
set(refit_file ${module_folder}/refit-${AWD_REFIT_ABI}.so)
configure_package_config_file(lib/awdConfig.cmake.in ${PROJECT_BINARY_DIR}/awdConfig.cmake
  INSTALL_DESTINATION ${package_folder} PATH_VARS bases_file refit_file)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/awdConfigVersion.cmake
  COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/awdConfig.cmake ${PROJECT_BINARY_DIR}/awdConfigVersion.cmake
  bases/AddBasis.cmake DESTINATION ${package_folder} COMPONENT development)
install(EXPORT awd-targets NAMESPACE awd:: FILE awdTargets.cmake DESTINATION ${package_folder}
  COMPONENT development)

foreach(folder INCLUDEDIR LIBDIR)
  file(RELATIVE_PATH from_prefix ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_${folder}})
  set(awd_pc_${folder} \${prefix}/${from_prefix})
endforeach()
file(RELATIVE_PATH awd_pc_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" awd_pc_prefix ${awd_pc_prefix})
configure_file(lib/awd.pc.in ${PROJECT_BINARY_DIR}/awd.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/awd.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT development)

if(PROJECT_IS_TOP_LEVEL)
  include(lib/Packages.cmake)
endif()
