# SPDX-License-Identifier: Apache-2.0
# awd_add_basis(<name> <source>...): the plugin <name>.so, target awd-basis-<name>. A plugin needs
# awd/basis.h alone, links nothing, and exports its entry point alone. Part of our build and, by
# find_package(awd), of others'.
function(awd_add_basis name)
  set(target awd-basis-${name})
  add_library(${target} MODULE ${ARGN})
  target_include_directories(${target} PRIVATE
    $<TARGET_PROPERTY:awd::awd,INTERFACE_INCLUDE_DIRECTORIES>)
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name} PREFIX "" SUFFIX .so
    C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()
