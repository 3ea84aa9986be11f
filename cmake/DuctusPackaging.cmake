# What `cmake --install` and the Debian package put where. Component "programs" needs the apps built, component "data"
# only the icons (target ductus_icons); together they are the package that `./run package` makes.
include(GNUInstallDirs)
find_package(Qt6 6.4 REQUIRED COMPONENTS Svg)

set(packaging ${CMAKE_CURRENT_SOURCE_DIR}/packaging)
set(resources ${CMAKE_CURRENT_SOURCE_DIR}/resources)
set(ductus_programs sketchsurfacer layerpainter doodlestudio ductus)
set(ductus_apps SketchSurfacer LayerPainter DoodleStudio)
set(project_type application-vnd.ductus.project+zip)

install(TARGETS ${ductus_programs} RUNTIME COMPONENT programs)

# ---- icons: our own drawings, as they are and in the sizes of the hicolor theme ------------------------------------
add_executable(ductus_draw_icons ${packaging}/icons/draw_icons.cpp)
target_link_libraries(ductus_draw_icons PRIVATE Qt6::Core Qt6::Gui Qt6::Svg)

set(icon_dir ${CMAKE_CURRENT_BINARY_DIR}/icons/hicolor)
set(icon_stamps)
# ductus_icon(SVG CONTEXT NAME)
function(ductus_icon svg context name)
    set(stamp ${icon_dir}/${name}.stamp)
    add_custom_command(OUTPUT ${stamp}
        COMMAND ductus_draw_icons ${svg} ${icon_dir} ${context} ${name}
        COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
        DEPENDS ${svg} ductus_draw_icons VERBATIM)
    set(icon_stamps ${icon_stamps} ${stamp} PARENT_SCOPE)
    install(FILES ${svg} DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/${context} RENAME ${name}.svg
        COMPONENT data)
endfunction()
foreach(app ${ductus_apps})
    string(TOLOWER ${app} program)
    ductus_icon(${resources}/icons/app-${program}.svg apps org.ductus.${app})
endforeach()
ductus_icon(${packaging}/icons/${project_type}.svg mimetypes ${project_type})
add_custom_target(ductus_icons ALL DEPENDS ${icon_stamps})
install(DIRECTORY ${icon_dir} DESTINATION ${CMAKE_INSTALL_DATADIR}/icons COMPONENT data
    FILES_MATCHING PATTERN "*.png")

# ---- what the desktop reads ----------------------------------------------------------------------------------------
foreach(app AnyProject ${ductus_apps})
    install(FILES ${packaging}/desktop/org.ductus.${app}.desktop
        DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT data)
endforeach()
foreach(app ${ductus_apps})
    install(FILES ${packaging}/metainfo/org.ductus.${app}.metainfo.xml
        DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT data)
endforeach()
install(FILES ${packaging}/mime/org.ductus.Project.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages
    COMPONENT data)
install(FILES ${packaging}/thumbnailer/ductus.thumbnailer DESTINATION ${CMAKE_INSTALL_DATADIR}/thumbnailers
    COMPONENT data)

# ---- what people read and open -------------------------------------------------------------------------------------
# The programs carry samples, manual and schemas inside; these are for people, scripts and other programs.
install(DIRECTORY ${resources}/samples ${resources}/manual ${resources}/schemas
    DESTINATION ${CMAKE_INSTALL_DATADIR}/ductus COMPONENT data)
install(FILES ${packaging}/deb/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/ductus COMPONENT data)

find_program(GZIP_PROGRAM gzip REQUIRED)
set(packed_dir ${CMAKE_CURRENT_BINARY_DIR}/packed)
file(MAKE_DIRECTORY ${packed_dir})
# Packed without name and time, so that the same sources give the same package.
function(ductus_packed source destination name)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
    execute_process(COMMAND ${GZIP_PROGRAM} -9nc ${source} OUTPUT_FILE ${packed_dir}/${name}.gz
        COMMAND_ERROR_IS_FATAL ANY)
    install(FILES ${packed_dir}/${name}.gz DESTINATION ${destination} COMPONENT data)
endfunction()
foreach(program ${ductus_programs})
    ductus_packed(${packaging}/man/${program}.1 ${CMAKE_INSTALL_MANDIR}/man1 ${program}.1)
endforeach()
ductus_packed(${CMAKE_CURRENT_SOURCE_DIR}/CHANGELOG.md ${CMAKE_INSTALL_DATADIR}/doc/ductus changelog)

# ---- the package ---------------------------------------------------------------------------------------------------
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON) # cpack would build every test before
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ductus)
set(CPACK_PACKAGE_VENDOR "Ductus")
set(CPACK_PACKAGE_CONTACT "The Ductus maintainers <maintainers@ductus.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "three apps for 3D strokes: surfaces, paintings, doodled films")
set(CPACK_PACKAGE_DESCRIPTION "SketchSurfacer turns 3D sketches into piecewise-smooth surfaces, LayerPainter colours 3D \
paintings with stacks of layers on the desktop and in VR, DoodleStudio pins hand-drawn animation into a filmed scene. \
They share one project file, and each has a batch command.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/package)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Plugins that no program links: SVG icons and sound come through them. Of the others the file triggers are wanted, which
# keep the caches of types, menus and icons, when Ductus comes and when it goes; it needs no scripts of its own.
set(CPACK_DEBIAN_PACKAGE_DEPENDS
    "libqt6svg6, shared-mime-info, desktop-file-utils, hicolor-icon-theme")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1-mesa-dri, fonts-noto-core, qt6-wayland, qt6-translations-l10n")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "colmap")
include(CPack)
