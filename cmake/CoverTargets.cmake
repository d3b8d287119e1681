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

# cover_unity(<target> [ALL] [ALONE <path>...] [BY_FOLDER <path>...]): with COVER_UNITY_BUILD, files of one layer are
# compiled together (of io/, files of one of its folders), or ALL files: a whole build takes half as long, and after a
# change of one file its layer is compiled again. Names in anonymous namespaces must differ within a layer then. Files
# whose paths begin so stay ALONE, or go BY_FOLDER.
function(cover_unity target)
  if(NOT COVER_UNITY_BUILD)
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 1 unity "ALL" "" "ALONE;BY_FOLDER")
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    set(alone FALSE)
    foreach(path ${unity_ALONE})
      if(source MATCHES "^${path}")
        set(alone TRUE)
      endif()
    endforeach()
    if(alone OR NOT source MATCHES "\\.cpp$")
      continue()
    endif()
    cmake_path(GET source PARENT_PATH folder)
    string(REGEX MATCH "^(src/)?(io/)?[^/]*/" layer "${folder}/")
    if(unity_ALL)
      set(layer files)
    endif()
    foreach(path ${unity_BY_FOLDER})
      if(source MATCHES "^${path}")
        set(layer ${folder})
      endif()
    endforeach()
    string(MAKE_C_IDENTIFIER "of_${layer}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${group}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
