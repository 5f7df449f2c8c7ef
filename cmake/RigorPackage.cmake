# What is installed: rigor::geometry (shapes alone) and rigor::rigor (everything), each one library, the public headers with
# what they include, files for find_package and pkg-config, and packages made of these (docs/cpp.md).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# Symbols of shared libraries carry major and minor version, as the names of the files do: a program that was linked with
# another version is told so by the loader.
set(rigor_symbols RIGOR_${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/rigor_symbols.map CONTENT "${rigor_symbols} { global: *; };\n")

# What a library is made of, however it is linked.
function(rigor_library_target target output folder)
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${output} LINKER_LANGUAGE CXX INSTALL_RPATH $ORIGIN
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    ARCHIVE_OUTPUT_DIRECTORY ${folder} LIBRARY_OUTPUT_DIRECTORY ${folder})
  get_target_property(type ${target} TYPE)
  if(type STREQUAL SHARED_LIBRARY)
    target_link_options(${target} PRIVATE -Wl,--version-script=${PROJECT_BINARY_DIR}/rigor_symbols.map -Wl,--no-undefined)
  endif()
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include>)
  target_link_libraries(${target} PUBLIC Eigen3::Eigen PRIVATE fmt::fmt)
endfunction()

# Shared libraries of the same objects beside static ones, for a test: a link each.
set(rigor_tries_shared OFF)
if(RIGOR_BUILD_TESTS AND NOT BUILD_SHARED_LIBS AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  set(rigor_tries_shared ON)
endif()

# rigor_library(name output layer...): one library of the objects of these layers.
function(rigor_library name output)
  set(objects "")
  foreach(layer ${ARGN})
    list(APPEND objects $<TARGET_OBJECTS:rigor_${layer}>)
  endforeach()
  set(target rigor_library_${name})
  add_library(${target} ${objects})
  add_library(rigor::${name} ALIAS ${target})
  rigor_library_target(${target} ${output} ${PROJECT_BINARY_DIR}/lib)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  if(rigor_tries_shared)
    add_library(${target}_shared SHARED ${objects})
    rigor_library_target(${target}_shared ${output} ${PROJECT_BINARY_DIR}/shared)
  endif()
  if(RIGOR_INSTALL)
    install(TARGETS ${target} EXPORT rigor_${name})
    install(EXPORT rigor_${name} NAMESPACE rigor:: FILE rigor-${name}.cmake
      DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/rigor)
  endif()
endfunction()

rigor_library(geometry rigor_geometry core math geometry)
rigor_library(rigor rigor solver model dynamics contact bulk sim io view api)
set(kinds "")
if(rigor_tries_shared)
  set(kinds _shared)
endif()
foreach(kind IN LISTS kinds ITEMS "")
  target_link_libraries(rigor_library_geometry${kind} PRIVATE ${QHULL_LIBRARY})
  target_link_libraries(rigor_library_rigor${kind} PUBLIC rigor_library_geometry${kind}
    PRIVATE yaml-cpp ${HDF5_C_LIBRARIES} PNG::PNG ZLIB::ZLIB TBB::tbb Threads::Threads)
endforeach()

if(NOT RIGOR_INSTALL)
  return()
endif()

# The public headers, and the headers that these include, each in its place.
function(rigor_headers_from result)
  set(waiting ${ARGN})
  set(found "")
  while(waiting)
    list(POP_FRONT waiting header)
    if(header IN_LIST found)
      continue()
    endif()
    list(APPEND found ${header})
    file(STRINGS ${PROJECT_SOURCE_DIR}/${header} lines REGEX "^#include \"rigor/")
    foreach(line ${lines})
      string(REGEX REPLACE "^#include \"(.*)\".*$" "\\1" included "${line}")
      list(APPEND waiting ${included})
    endforeach()
  endwhile()
  set(${result} ${found} PARENT_SCOPE)
endfunction()

file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/public_headers.txt public_headers REGEX "^rigor/")
rigor_headers_from(installed_headers ${public_headers})
foreach(header ${installed_headers})
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${folder})
endforeach()

# find_package(rigor): the other libraries are found again only for static ones, which have to be linked with them.
set(cmake_folder ${CMAKE_INSTALL_LIBDIR}/cmake/rigor)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/rigorConfig.cmake.in ${PROJECT_BINARY_DIR}/rigorConfig.cmake
  INSTALL_DESTINATION ${cmake_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/rigorConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/rigorConfig.cmake ${PROJECT_BINARY_DIR}/rigorConfigVersion.cmake
  DESTINATION ${cmake_folder})

# pkg-config: with static libraries the others belong to what a program links.
set(pc_private "-lfmt -lqhull_r -lyaml-cpp -lpng -lz -ltbb -lpthread")
foreach(library ${HDF5_C_LIBRARIES})
  string(APPEND pc_private " ${library}")
endforeach()
set(pc_libs "-L\${libdir} -lrigor -lrigor_geometry")
if(NOT BUILD_SHARED_LIBS)
  string(APPEND pc_libs " ${pc_private}")
  set(pc_private "")
endif()
file(RELATIVE_PATH pc_up /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(${CMAKE_CURRENT_LIST_DIR}/rigor.pc.in ${PROJECT_BINARY_DIR}/rigor.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/rigor.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# `make package`: a Debian package and a tarball.
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME rigor)
set(CPACK_PACKAGE_CONTACT "the authors of Rigor <rigor@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libeigen3-dev, libfmt-dev, libqhull-dev, libyaml-cpp-dev, libhdf5-dev, libpng-dev, \
zlib1g-dev, libtbb-dev")
# Of what is installed alone: not of the tests.
set(CMAKE_SKIP_PACKAGE_ALL_DEPENDENCY ON)
include(CPack)
