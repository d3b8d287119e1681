# Flags of our own targets. They sit on the targets and not on a linked interface library, so that
# nothing of them leaks into the exported package.

# -ffp-contract=off: the error bounds of the predicates hold for plain IEEE operations.
function(cover_target target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wconversion -ffp-contract=off)
  target_compile_features(${target} PUBLIC cxx_std_20)
endfunction()
