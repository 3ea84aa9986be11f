# cmake -D SAMPLES=samples.json -D LIST=out -P list_samples.cmake
# Writes one line a sample for ./run: id, file, boundary stroke ids, symmetry, title; separated by the character 0x1f.
string(ASCII 31 separator)
include(${CMAKE_CURRENT_LIST_DIR}/sample_list.cmake)
read_samples(${SAMPLES})

set(lines "")
foreach(i RANGE ${last_sample})
    sample_field(id ${i} id)
    sample_field(file ${i} file)
    sample_field(boundary ${i} boundaryStrokes)
    sample_field(symmetry ${i} symmetry)
    sample_field(title ${i} title)
    if(NOT id MATCHES "^[A-Za-z0-9_-]+$" OR file STREQUAL "")
        message(FATAL_ERROR "${SAMPLES}: sample ${i} needs an id of letters, digits, - and _, and a file")
    endif()
    string(APPEND lines "${id}${separator}${file}${separator}${boundary}${separator}${symmetry}${separator}${title}\n")
endforeach()
file(WRITE ${LIST} "${lines}")
