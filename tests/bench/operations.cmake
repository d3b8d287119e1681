# Everything of the project with a call per basic block, which bench_operations counts:
#   cmake --preset release -B build/operations -DCMAKE_PROJECT_INCLUDE=tests/bench/operations.cmake
# Not COVER_UNITY_BUILD: bench_operations has a run_all() of its own, which must not be inlined.
set(COVER_COUNT_OPERATIONS ON)
add_compile_options(-fsanitize-coverage=trace-pc)
