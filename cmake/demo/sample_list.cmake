# Reading resources/samples/samples.json: an object with the array "samples".

# read_samples(FILE): sets samples (a JSON array) and last_sample (its last index) for the caller.
function(read_samples file)
    file(READ ${file} json)
    string(JSON list ERROR_VARIABLE error GET "${json}" samples)
    if(NOT error)
        string(JSON count ERROR_VARIABLE error LENGTH "${list}")
    endif()
    if(error OR count EQUAL 0)
        message(FATAL_ERROR "${file}: no samples (${error})")
    endif()
    math(EXPR last "${count} - 1")
    set(samples "${list}" PARENT_SCOPE)
    set(last_sample ${last} PARENT_SCOPE)
endfunction()

# json_text(OUT JSON PATH...): the value as text; empty where there is none, or where it is null.
function(json_text out json)
    string(JSON value ERROR_VARIABLE error GET "${json}" ${ARGN})
    if(error)
        set(value "")
    endif()
    set(${out} "${value}" PARENT_SCOPE)
endfunction()

# sample_field(OUT INDEX NAME): one field of a sample as text; lists come joined by commas.
function(sample_field out index name)
    json_text(value "${samples}" ${index} ${name})
    string(JSON kind ERROR_VARIABLE error TYPE "${samples}" ${index} ${name})
    if(kind STREQUAL "ARRAY")
        string(REGEX REPLACE "[][ \n\"]" "" value "${value}")
    endif()
    set(${out} "${value}" PARENT_SCOPE)
endfunction()
