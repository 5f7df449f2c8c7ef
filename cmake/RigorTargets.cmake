# Compile options of all our code: warnings are errors (when RIGOR_WERROR), and no contraction of a*b+c,
# so that every compiler and optimisation level gives the same bits.
option(RIGOR_WERROR "Treat warnings as errors" ${PROJECT_IS_TOP_LEVEL})

function(rigor_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
    -Wno-missing-field-initializers -ffp-contract=off $<$<BOOL:${RIGOR_WERROR}>:-Werror>)
  # g++ looks through its memory for what it may free again and again while the templates of Eigen fill it, and finds
  # little: without that below 1 GiB it takes a sixth less time and a sixth more memory.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1048576>)
  # Lanes are passed between our own sources only: that g++ 4.5 passed them otherwise is nothing to tell.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-psabi>)
  # g++ 12 at -O3 sees overlaps and overruns inside std::string where there are none (GCC bugs 105329 and 105651);
  # clang++ and the address sanitizer watch in its place.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-array-bounds;-Wno-stringop-overflow>)
endfunction()

# The program, the libraries and the Python module take the same objects: position-independent, with references within the
# library that stay direct, which costs nothing that can be measured.
function(rigor_position_independent target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -fno-semantic-interposition)
endfunction()

# Eigen is in nearly every file: one precompiled header serves all layers and the program.
add_library(rigor_pch STATIC ${CMAKE_CURRENT_LIST_DIR}/pch.cpp)
target_link_libraries(rigor_pch PUBLIC Eigen3::Eigen)
target_precompile_headers(rigor_pch PRIVATE <Eigen/Dense> <string> <vector>)
rigor_compile_options(rigor_pch)
rigor_position_independent(rigor_pch)

# Up to twelve sources of a folder are compiled as one: they include nearly the same, so that it takes less than half the time
# of twelve. What lies in unnamed namespaces must therefore have different names within a room. Off: one by one, for clang-tidy.
option(RIGOR_UNITY "Compile the sources of a room in batches" ON)
set(RIGOR_BATCH_SIZE 12)

# rigor_batches(target sources...): the sources of the target are compiled in batches, each of one folder, and those of a folder
# of nearly equal numbers of sources.
function(rigor_batches target)
  if(NOT RIGOR_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # A source in a batch is an included file: g++ warns of classes of this file alone whose members have unnamed types.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  set(rooms "")
  foreach(source ${ARGN})
    get_filename_component(folder ${source} DIRECTORY)
    get_filename_component(room ${folder} NAME)
    list(APPEND rooms ${room})
    list(APPEND sources_of_${room} ${source})
  endforeach()
  list(REMOVE_DUPLICATES rooms)
  foreach(room ${rooms})
    list(LENGTH sources_of_${room} count)
    math(EXPR batches "(${count} + ${RIGOR_BATCH_SIZE} - 1) / ${RIGOR_BATCH_SIZE}")
    set(place 0)
    foreach(source ${sources_of_${room}})
      math(EXPR batch "${place} * ${batches} / ${count}")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${room}_${batch})
      math(EXPR place "${place} + 1")
    endforeach()
  endforeach()
endfunction()

# rigor_layer(name deps...): the static library rigor_<name> of all sources in rigor/<name>/ and its rooms.
function(rigor_layer name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rigor/${name}/*.cpp)
  add_library(rigor_${name} STATIC ${sources})
  target_include_directories(rigor_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(rigor_${name} PUBLIC Eigen3::Eigen)
  foreach(dependency ${ARGN})
    target_link_libraries(rigor_${name} PUBLIC rigor_${dependency})
  endforeach()
  rigor_compile_options(rigor_${name})
  rigor_position_independent(rigor_${name})
  target_precompile_headers(rigor_${name} REUSE_FROM rigor_pch)
  rigor_batches(rigor_${name} ${sources})
endfunction()

# rigor_lane_kernels(name): in rigor/<name>/ files *_avx2.cpp and *_portable.cpp have the kernels of one target each
# (docs/decisions/0012). Each is compiled by itself. The portable ones, for processors without AVX2, are compiled with -O1:
# vectors that such a processor does not have are so much code that -O3 takes several times as long, for little speed.
function(rigor_lane_kernels name)
  file(GLOB_RECURSE kernels CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rigor/${name}/*_avx2.cpp
    ${PROJECT_SOURCE_DIR}/rigor/${name}/*_portable.cpp)
  set_source_files_properties(${kernels} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  list(FILTER kernels INCLUDE REGEX "_portable\\.cpp$")
  set_source_files_properties(${kernels} PROPERTIES COMPILE_OPTIONS $<$<NOT:$<CONFIG:Debug>>:-O1>)
endfunction()

# rigor_embed_text(target file header function): function(), declared in the header, returns the text of the file.
function(rigor_embed_text target file header function)
  set(source ${PROJECT_BINARY_DIR}/embedded/${function}.cpp)
  set(script ${PROJECT_SOURCE_DIR}/cmake/EmbedText.cmake)
  add_custom_command(OUTPUT ${source} DEPENDS ${PROJECT_SOURCE_DIR}/${file} ${script}
    COMMAND ${CMAKE_COMMAND} -DINPUT=${PROJECT_SOURCE_DIR}/${file} -DOUTPUT=${source} -DHEADER=${header}
      -DFUNCTION=${function} -P ${script})
  target_sources(${target} PRIVATE ${source})
endfunction()

# Twelve test files are compiled as one: they include nearly the same, so that it takes less than half the time of twelve. Each has a namespace
# of its own, rigor::<file>, in which its unnamed one lies. Off: one by one, for work on a single test file, and for clang-tidy.
option(RIGOR_UNITY_TESTS "Compile test files in batches" ON)

# rigor_tests(folder layer...): one test program of all tests/<folder>/*.cpp.
function(rigor_tests folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${folder}/*.cpp)
  if(NOT sources)
    return()
  endif()
  set(target rigor_test_${folder})
  add_executable(${target} ${sources})
  rigor_compile_options(${target})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${target} PRIVATE GTest::gtest_main nlohmann_json::nlohmann_json)
  foreach(layer ${ARGN})
    target_link_libraries(${target} PRIVATE rigor_${layer})
  endforeach()
  target_compile_definitions(${target} PRIVATE RIGOR_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data"
    RIGOR_SOURCE_DIR="${PROJECT_SOURCE_DIR}" RIGOR_PROGRAM="${CMAKE_BINARY_DIR}/rigor")
  target_precompile_headers(${target} REUSE_FROM rigor_test_pch)
  # Tests of solver/ have each their own expressions of Eigen: a batch of six would take more than 2 GB.
  set(batch_size 12)
  if(folder STREQUAL solver)
    set(batch_size 4)
  endif()
  if(RIGOR_UNITY_TESTS)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch_size})
  endif()
  # As in rigor_compile_options: in a batch g++ 12 sees moved strings read beyond their end, too, and the other
  # alternatives of a variant read.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overread -Wno-maybe-uninitialized>)
  gtest_discover_tests(${target} TEST_PREFIX "${folder}: " DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 300)
endfunction()
