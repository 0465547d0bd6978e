awd_unit_test(render camera_test.cpp embree_test.cpp film_bytes_test.cpp film_test.cpp geometry_test.cpp lights_test.cpp
  expected_luminance_test.cpp mesh_test.cpp path_test.cpp pieces_test.cpp render_test.cpp scene_test.cpp schedule_test.cpp)
target_link_libraries(unit-render PRIVATE unit-families)
