awd_unit_test(refit ceres_solver_test.cpp descent_test.cpp free_solver_test.cpp
  interior_point_test.cpp module_test.cpp problem_check_test.cpp)
target_link_libraries(unit-refit PRIVATE awd-refit-solvers)
target_include_directories(unit-refit PRIVATE ${PROJECT_SOURCE_DIR}/tests)
set_property(SOURCE refit/module_test.cpp PROPERTY COMPILE_DEFINITIONS
  AWD_REFIT_MODULE="$<TARGET_FILE:awd-refit>")
add_dependencies(unit-refit awd-refit)

# Whatever Ceres brings, the module exports its entry alone.
add_test(NAME unit/refit/exports COMMAND sh -c
  "test \"$(${CMAKE_NM} -D --defined-only $<TARGET_FILE:awd-refit> | sed 's/.* //')\" = \
awdRefitModule_v${AWD_REFIT_ABI}")
