awd_unit_test(guide field_bytes_test.cpp field_test.cpp hemisphere_test.cpp patch_table_test.cpp
  spatial_tree_test.cpp)
target_link_libraries(unit-guide PRIVATE unit-families)
