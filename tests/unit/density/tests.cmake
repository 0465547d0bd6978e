# Families to test with: the Haar plugin, linked in under another name, and honest B-splines.
add_library(unit-families OBJECT ${PROJECT_SOURCE_DIR}/bases/haar/haar.c)
target_compile_definitions(unit-families PRIVATE awdBasisModule_v1=haarModule)
target_link_libraries(unit-families PUBLIC awd-settings awd-test-bases)

awd_unit_test(density axis_test.cpp gram_test.cpp projection_test.cpp square_density_test.cpp
  square_statistics_test.cpp)
target_link_libraries(unit-density PRIVATE unit-families)
