# Families to test with: the plugins, linked in under other names, and honest B-splines.
add_library(unit-families OBJECT)
foreach(plugin haar/haar flatlet/flatlet linear-bspline/linear multiwavelet/multiwavelet
    quadratic-bspline/quadratic)
  set(source ${PROJECT_SOURCE_DIR}/bases/${plugin}.c)
  cmake_path(GET source STEM stem)
  target_sources(unit-families PRIVATE ${source})
  set_property(SOURCE ${source} PROPERTY COMPILE_DEFINITIONS awdBasisModule_v1=${stem}Module)
endforeach()
target_link_libraries(unit-families PUBLIC awd-settings awd-test-bases)

awd_unit_test(density axis_test.cpp bases_test.cpp binned_sum_test.cpp density_test.cpp
  gram_test.cpp inverse_cdf_test.cpp leaf_sampler_test.cpp nodal_square_test.cpp
  normal_pattern_test.cpp parabola_test.cpp
  passes_test.cpp projection_test.cpp refit_solvers_test.cpp refit_test.cpp settings_test.cpp
  square_density_test.cpp square_statistics_test.cpp square_sums_test.cpp tensor_test.cpp
  tree_descent_test.cpp tree_index_test.cpp tree_matrices_test.cpp tree_test.cpp wavelet_test.cpp)
target_link_libraries(unit-density PRIVATE unit-families)
