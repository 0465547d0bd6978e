# SPDX-License-Identifier: Apache-2.0
awd_unit_test(basis
  bernstein_test.cpp
  cell_test.cpp
  check_test.cpp
  checks_test.cpp
  family_test.cpp
  library_folder_test.cpp
  module_test.cpp
  quadrature_test.cpp
  registry_test.cpp
  self_test_test.cpp
  trust_test.cpp)
target_include_directories(unit-basis PRIVATE ${PROJECT_SOURCE_DIR}/tests)
target_link_libraries(unit-basis PRIVATE awd-test-bases)
target_compile_definitions(unit-basis PRIVATE AWD_HAAR_FILE="$<TARGET_FILE:awd-basis-haar>")
add_dependencies(unit-basis awd-basis-haar)
