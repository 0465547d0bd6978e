awd_unit_test(guide continuation_test.cpp exchange_visitors_test.cpp field_bytes_test.cpp field_test.cpp hemisphere_test.cpp
  light_choice_test.cpp light_sums_test.cpp patch_table_test.cpp
  spatial_tree_test.cpp)
target_link_libraries(unit-guide PRIVATE unit-families)
