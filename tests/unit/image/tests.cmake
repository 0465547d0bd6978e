# SPDX-License-Identifier: Apache-2.0
awd_unit_test(image c_interface_test.cpp exr_check_test.cpp exr_deep_test.cpp exr_files.cpp
  exr_names_test.cpp exr_read_test.cpp exr_write_test.cpp false_colour_test.cpp
  image_test.cpp png_write_test.cpp)
find_package(OpenEXR REQUIRED)
find_package(PNG REQUIRED)
target_link_libraries(unit-image PRIVATE OpenEXR::OpenEXR PNG::PNG)
