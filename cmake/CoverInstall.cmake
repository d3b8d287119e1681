# What `cmake --install` and `cpack` put where: library, headers, CMake package, pkg-config file,
# program, Python module. The package has two components: cover, and vtk for what needs VTK.
include(CMakePackageConfigHelpers)

set(cover_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/cover)

install(TARGETS cover EXPORT coverTargets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS cover_vtk EXPORT coverVtkTargets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT coverTargets NAMESPACE cover:: DESTINATION ${cover_package_dir})
install(EXPORT coverVtkTargets NAMESPACE cover:: DESTINATION ${cover_package_dir})

# Readers that are there where the libraries are that they read by.
set(cover_readers "")
foreach(reader dxf gdal gmsh)
  string(TOUPPER ${reader} READER)
  if(COVER_WITH_${READER})
    list(APPEND cover_readers ${reader})
    install(TARGETS cover_${reader} EXPORT cover_${reader}Targets
            LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
            FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    install(EXPORT cover_${reader}Targets NAMESPACE cover:: DESTINATION ${cover_package_dir})
  endif()
endforeach()

configure_package_config_file(cmake/coverConfig.cmake.in ${PROJECT_BINARY_DIR}/coverConfig.cmake
                              INSTALL_DESTINATION ${cover_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/coverConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/coverConfig.cmake ${PROJECT_BINARY_DIR}/coverConfigVersion.cmake
        DESTINATION ${cover_package_dir})

# A static library hands its own dependencies on to the final link.
set(cover_pc_libs "-lOpenMeshCore -lfmt -lexpat -lz -llzma -llz4 -lmpfr -lgmp -pthread")
if(BUILD_SHARED_LIBS)
  set(cover_pc_public "-lOpenMeshCore")
  set(cover_pc_private "${cover_pc_libs}")
else()
  set(cover_pc_public "${cover_pc_libs}")
  set(cover_pc_private "")
endif()
# Relative to the file itself, so that the installed tree can be moved.
file(RELATIVE_PATH cover_pc_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/cover.pc.in ${PROJECT_BINARY_DIR}/cover.pc @ONLY)
# By their files: VTK's libraries bear its version in their names, which imported targets do not know.
set(cover_pc_vtk "")
foreach(component ${COVER_VTK_COMPONENTS})
  string(APPEND cover_pc_vtk " $<TARGET_LINKER_FILE:VTK::${component}>")
endforeach()
# For vtk_cover_mesh.hpp.
set(cover_pc_vtk_include "$<JOIN:$<TARGET_PROPERTY:VTK::CommonCore,INTERFACE_INCLUDE_DIRECTORIES>, -I>")
configure_file(cmake/cover-vtk.pc.in ${PROJECT_BINARY_DIR}/cover-vtk.pc.in @ONLY)
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/cover-vtk.pc INPUT ${PROJECT_BINARY_DIR}/cover-vtk.pc.in)
install(FILES ${PROJECT_BINARY_DIR}/cover.pc ${PROJECT_BINARY_DIR}/cover-vtk.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
foreach(reader ${cover_readers})
  set(cover_pc_reader_libs "")
  if(reader STREQUAL "dxf")
    set(cover_pc_reader_libs ${COVER_DXFLIB_LIBRARY})
  elseif(reader STREQUAL "gmsh")
    set(cover_pc_reader_libs ${COVER_GMSH_LIBRARY})
  endif()
  configure_file(cmake/cover-reader.pc.in ${PROJECT_BINARY_DIR}/cover-${reader}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/cover-${reader}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()

install(FILES apps/paraview/cover_reader.py DESTINATION ${CMAKE_INSTALL_DATADIR}/cover/paraview)
# What these pages link to is as far from them as in the sources.
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
foreach(page apps/cover/input.schema.json apps/paraview/cover_reader.py apps/python/cover/__init__.pyi
        libcover/ARCHITECTURE.md libcover/REFERENCES.bib tests/bench/RESULTS.md tests/solvers/layers.py)
  cmake_path(GET page PARENT_PATH folder)
  install(FILES ${page} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder})
endforeach()
install(DIRECTORY libcover/docs DESTINATION ${CMAKE_INSTALL_DOCDIR}/libcover)
install(DIRECTORY samples DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN __pycache__ EXCLUDE)

if(PROJECT_IS_TOP_LEVEL)
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_CONTACT "cover maintainers <maintainers@cover.invalid>")
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  # What is opened and not linked nobody finds by itself.
  foreach(library ${COVER_HDF5_LIBRARY} ${COVER_GDAL_LIBRARY})
    file(REAL_PATH ${library} library)
    execute_process(COMMAND dpkg-query -S ${library} OUTPUT_VARIABLE package OUTPUT_STRIP_TRAILING_WHITESPACE
                    ERROR_QUIET)
    if(package)
      string(REGEX REPLACE ":.*" "" package "${package}")
      list(APPEND cover_opened ${package})
    endif()
  endforeach()
  list(JOIN cover_opened ", " CPACK_DEBIAN_PACKAGE_RECOMMENDS)
  # The headers and the static library are in the same package.
  set(CPACK_DEBIAN_PACKAGE_SUGGESTS
      "libcgal-dev, libopenmesh-dev, libvtk9-dev, libboost-dev, libfmt-dev, nlohmann-json3-dev, libexpat1-dev, zlib1g-dev, liblzma-dev, liblz4-dev, libhdf5-dev, python3-numpy")
  include(CPack)
endif()
