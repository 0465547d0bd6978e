#Families to test with : the Haar plugin, linked in under another name, and honest B - splines.
add_library(unit - families OBJECT ${PROJECT_SOURCE_DIR} / bases / haar /
                       haar.c ${PROJECT_SOURCE_DIR} / tests / plugins / honest.c)
    set_source_files_properties(
        ${PROJECT_SOURCE_DIR} / bases / haar /
            haar.c PROPERTIES COMPILE_DEFINITIONS awdBasisModule_v1 = haarModule)
        target_link_libraries(unit - families PUBLIC awd - settings)
            target_include_directories(unit - families PUBLIC ${PROJECT_SOURCE_DIR} /
                                                  include ${PROJECT_SOURCE_DIR} / tests)

                awd_unit_test(density axis_test.cpp gram_test.cpp projection_test
                                  .cpp square_density_test.cpp square_statistics_test.cpp)
                    target_link_libraries(unit - density PRIVATE unit - families)
