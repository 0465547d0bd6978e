# SPDX-License-Identifier: Apache-2.0
# `cpack` in the build folder makes a Debian package of each component. Configured with
# CMAKE_INSTALL_PREFIX=/usr, libraries go where Debian has them: lib/<architecture>.
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_CONTACT "the maintainers of libawd")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The command needs libawd, of which no installed package knows.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/lib)
file(WRITE ${PROJECT_BINARY_DIR}/shlibs
  "libawd ${AWD_ABI} libawd${AWD_ABI} (>= ${PROJECT_VERSION})\n")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/shlibs)

# awd_package(<component> <package> <section> <text> [<field> <packages>]...)
function(awd_package component package section text)
  if(NOT component IN_LIST components)
    return()
  endif()
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} RENAME copyright
    COMPONENT ${component})
  string(TOUPPER ${component} component)
  set(CPACK_COMPONENT_${component}_DESCRIPTION "This package has ${text}." PARENT_SCOPE)
  set(pairs NAME ${package} SECTION ${section} ${ARGN})
  while(pairs)
    list(POP_FRONT pairs field value)
    set(CPACK_DEBIAN_${component}_PACKAGE_${field} "${value}" PARENT_SCOPE)
  endwhile()
endfunction()

# Without bases a host has those alone that it brings itself.
set(library "libawd${AWD_ABI} (= ${PROJECT_VERSION})")
awd_package(runtime libawd${AWD_ABI} libs "the shared library"
  RECOMMENDS libawd-bases SUGGESTS libawd-refit)
awd_package(development libawd-dev libdevel "what programs that use libawd are built with"
  DEPENDS "${library}" RECOMMENDS libawd-bases SUGGESTS libawd-refit)
awd_package(bases libawd-bases libs "the bases that densities are made of")
awd_package(refit libawd-refit libs "the module that fits densities by least squares"
  DEPENDS "${library}")
awd_package(tools awd-tools graphics "the command awd, which renders and compares"
  DEPENDS "${library}, libawd-bases" SUGGESTS libawd-refit)
awd_package(python python3-awd python "the Python package awd" ARCHITECTURE all
  DEPENDS "${library}, libawd-bases, python3:any, python3-numpy"
  SUGGESTS "libawd-refit, python3-matplotlib")
include(CPack)
