# The Debian packages: `vidno`, the program with its page and its lessons, and `libvidno-dev`, the headers. ./dev package builds them.
include(GNUInstallDirs)
install(FILES LICENSE RENAME copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/vidno COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/NOTICES.txt DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/vidno COMPONENT program OPTIONAL)
install(FILES trace/LICENCES.md CHANGELOG.md COMPATIBILITY.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/vidno COMPONENT program)
install(FILES LICENSE RENAME copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libvidno-dev COMPONENT library)

set(CPACK_GENERATOR DEB)
file(STRINGS LICENSE holder REGEX "^Copyright")
string(REGEX REPLACE "^Copyright \\(c\\) [0-9]+ " "" holder "${holder}")
set(CPACK_PACKAGE_VENDOR "${holder}")
set(CPACK_PACKAGE_CONTACT "${holder}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program library)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SECTION education)

set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "vidno runs the textbook procedures one small step at a time, says why each
step was taken, and proves each decision right or wrong in exact arithmetic.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME vidno)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# Charts, questions for Moodle, the sandbox for a student's program. vidno says which of these is missing.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "nodejs (>= 18), bubblewrap, fonts-liberation")

set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "The procedures as C++20 headers, which find_package(vidno) finds.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libvidno-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libglm-dev, libcgal-dev")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
include(CPack)
