# SPDX-License-Identifier: Apache-2.0
awd_unit_test(util
  atomic_file_test.cpp
  bytes_test.cpp
  context_test.cpp
  digest_test.cpp
  error_test.cpp
  file_bytes_test.cpp
  memory_test.cpp
  parallel_test.cpp
  random_test.cpp
  ref_test.cpp
  small_matrix_test.cpp
  sobol_test.cpp
  vec_test.cpp)
