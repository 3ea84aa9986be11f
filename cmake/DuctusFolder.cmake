# ductus_folder(NAME LINK targets...): all .cpp files below this folder become the static library ductus_NAME,
# all foo_test.cpp files become Qt Test programs registered with ctest as NAME/foo (NAME/sub/foo in subfolders).
function(ductus_folder name)
    cmake_parse_arguments(ARG "" "" "LINK;PRIVATE_LINK;TEST_LINK" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    set(tests ${sources})
    list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
    list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")
    add_library(ductus_${name} STATIC ${sources})
    target_include_directories(ductus_${name} PUBLIC ${PROJECT_SOURCE_DIR}/common)
    target_link_libraries(ductus_${name} PUBLIC ${ARG_LINK} PRIVATE ${ARG_PRIVATE_LINK})
    foreach(test ${tests})
        file(RELATIVE_PATH relative ${CMAKE_CURRENT_SOURCE_DIR} ${test})
        string(REGEX REPLACE "_test\\.cpp$" "" relative ${relative})
        ductus_test(${name}/${relative} ${test} LINK ductus_${name} ${ARG_TEST_LINK})
    endforeach()
endfunction()

# ductus_test(CTEST_NAME SOURCE LINK targets...): one Qt Test program.
function(ductus_test ctest_name source)
    cmake_parse_arguments(ARG "" "TIMEOUT" "LINK" ${ARGN})
    string(REPLACE "/" "_" target "test_${ctest_name}")
    add_executable(${target} ${source})
    set_target_properties(${target} PROPERTIES AUTOMOC ON RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
    target_link_libraries(${target} PRIVATE ${ARG_LINK} Qt6::Core Qt6::Test)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests) # #include "support/mesh_zoo.h"
    # The folder with other people's files; tests that need it skip with a message when it is absent.
    target_compile_definitions(${target} PRIVATE DUCTUS_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
        DUCTUS_SHARED_DATA="${PROJECT_SOURCE_DIR}/../shared/data")
    # moc of Qt 6.4 stops at libstdc++'s <compare> ("Parse error at std") unless this macro is empty.
    set_target_properties(${target} PROPERTIES AUTOMOC_MOC_OPTIONS "-D_GLIBCXX_VISIBILITY=")
    add_test(NAME ${ctest_name} COMMAND ${target})
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 300)
    endif()
    set_tests_properties(${ctest_name} PROPERTIES TIMEOUT ${ARG_TIMEOUT})
endfunction()
