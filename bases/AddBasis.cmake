# SPDX-License-Identifier: Apache-2.0
# awd_add_basis(<name> <source>...): the plugin <name>.so, target awd-basis-<name>, in the folder
# where libawd looks for modules first. A plugin needs awd/basis.h alone and exports its entry
# point alone.
set(awd_include_folder ${CMAKE_CURRENT_LIST_DIR}/../include)

function(awd_add_basis name)
  set(target awd-basis-${name})
  add_library(${target} MODULE ${ARGN})
  target_link_libraries(${target} PRIVATE awd-settings)
  target_include_directories(${target} PRIVATE ${awd_include_folder})
  target_compile_options(${target} PRIVATE -fvisibility=hidden
    $<$<COMPILE_LANGUAGE:CXX>:-fvisibility-inlines-hidden>)
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name} PREFIX "" SUFFIX .so
    LIBRARY_OUTPUT_DIRECTORY $<TARGET_FILE_DIR:awd>/awd/bases-${AWD_BASIS_ABI})
endfunction()
