# translations/*.ts become .qm files inside ductus_widgets. `cmake --build . --target update_translations` reads
# the sources for new texts; tests/translations fails until they are translated.
find_package(Qt6 6.4 REQUIRED COMPONENTS LinguistTools)

set(languages en fr de es ja)
set(qm_dir ${CMAKE_CURRENT_BINARY_DIR}/translations)
set(qm_files)
set(update_commands)
foreach(part common sketchsurfacer layerpainter doodlestudio)
    set(source_dir ${PROJECT_SOURCE_DIR}/apps/${part})
    if(part STREQUAL "common")
        set(source_dir ${PROJECT_SOURCE_DIR}/common)
    endif()
    foreach(language ${languages})
        set(ts ${PROJECT_SOURCE_DIR}/translations/${part}_${language}.ts)
        set(qm ${qm_dir}/${part}_${language}.qm)
        add_custom_command(OUTPUT ${qm}
            COMMAND ${CMAKE_COMMAND} -E make_directory ${qm_dir}
            COMMAND Qt6::lrelease -silent ${ts} -qm ${qm}
            DEPENDS ${ts} VERBATIM)
        list(APPEND qm_files ${qm})
        set(plural)
        if(language STREQUAL "en")
            set(plural -pluralonly) # the sources are English
        endif()
        # Without places: a moved line is no change of a translation.
        list(APPEND update_commands COMMAND Qt6::lupdate -silent -no-obsolete -locations none ${plural}
            -I ${PROJECT_SOURCE_DIR}/common -I ${PROJECT_SOURCE_DIR}/apps ${source_dir} -extensions cpp,h
            -source-language en -target-language ${language} -ts ${ts})
    endforeach()
endforeach()
qt_add_resources(ductus_widgets translations PREFIX /ductus BASE ${CMAKE_CURRENT_BINARY_DIR} FILES ${qm_files})
add_custom_target(update_translations ${update_commands} VERBATIM)
