# What is installed where, and what a package says of itself. ./package.sh makes the packages.
include(GNUInstallDirs)
set(package_files ${PROJECT_SOURCE_DIR}/cmake/package)
install(TARGETS glint)
# What is compiled in stays here.
install(DIRECTORY assets DESTINATION ${CMAKE_INSTALL_DATADIR}/glint
        PATTERN programs EXCLUDE PATTERN materials.json EXCLUDE)
install(FILES ${package_files}/glint.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${package_files}/glint.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES ${package_files}/glint-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME glint.xml)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
# Man pages and completion are made from the built program.
set(package_texts ${PROJECT_BINARY_DIR}/package/share)
set(CPACK_PACKAGE_CONTACT "The Glint founders <glint@users.noreply.github.com>")
add_custom_target(package_texts
  COMMAND ${package_files}/texts.sh $<TARGET_FILE:glint> ${package_texts} ${CPACK_PACKAGE_CONTACT} DEPENDS glint VERBATIM)
install(DIRECTORY ${package_texts}/ DESTINATION ${CMAKE_INSTALL_DATADIR} OPTIONAL)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME glint)
set(CPACK_PACKAGE_VENDOR "The Glint founders")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "lighting explorer that shows every number behind a pixel")
set(CPACK_PACKAGE_DESCRIPTION "A scene goes in, a picture comes out, in a window or on the
command line, and the lighting equation is shown with its numbers for every
pixel. A picture that another program drew wrong is compared with 52 mistakes
that people make, and its mistake is named.")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The window loads OpenGL when it opens; sheets are lettered with DejaVu.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libgl1, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1-mesa-dri")
include(CPack)
