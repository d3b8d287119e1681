# Everything of the project with a call per basic block, which bench_operations counts:
#   cmake --preset release -B build/operations -DCMAKE_PROJECT_INCLUDE=tests/bench/operations.cmake
# With -DCOVER_UNITY_BUILD=ON it takes half as long; what is inlined, and so counted, differs little.
set(COVER_COUNT_OPERATIONS ON)
add_compile_options(-fsanitize-coverage=trace-pc)
