# Flags of our own targets. They sit on the targets and not on a linked interface library, so that
# nothing of them leaks into the exported package.

# -ffp-contract=off: the error bounds of the predicates hold for plain IEEE operations.
function(cover_target target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wconversion -ffp-contract=off)
  target_compile_features(${target} PUBLIC cxx_std_20)
  if(COVER_HARDENING)
    # As packages of Debian are built. C functions are checked only where there is optimization.
    target_compile_options(${target} PRIVATE -fstack-protector-strong
      $<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE> $<$<NOT:$<CONFIG:Debug>>:-D_FORTIFY_SOURCE=2>)
    target_compile_definitions(${target} PRIVATE _GLIBCXX_ASSERTIONS)
    target_link_options(${target} PRIVATE -Wl,-z,relro,-z,now)
  endif()
endfunction()

# With COVER_UNITY_BUILD, files of one folder are compiled together, 16 at most: a whole build
# takes half as long, and after a change of one file 16 are compiled again. Names in anonymous
# namespaces must differ within a folder then. Further arguments begin the paths of files that stay
# alone.
function(cover_unity target)
  if(NOT COVER_UNITY_BUILD)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    cmake_path(GET source PARENT_PATH folder)
    set(alone FALSE)
    foreach(path ${ARGN})
      if(source MATCHES "^${path}")
        set(alone TRUE)
      endif()
    endforeach()
    if(alone OR NOT source MATCHES "\\.cpp$")
      continue()
    endif()
    string(MAKE_C_IDENTIFIER "of_${folder}" group)
    math(EXPR count "0${count_${group}} + 1")
    set(count_${group} ${count})
    math(EXPR part "${count} / 16")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${group}_${part}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
