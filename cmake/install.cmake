# What `cmake --install` puts beside programs and libraries: what find_package and pkg-config read,
# the sample looks, the papers.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/lutlib)
configure_package_config_file(cmake/lutlib-config.cmake.in lutlib-config.cmake
    INSTALL_DESTINATION ${package_folder}
    PATH_VARS lutlib_module_folder)
write_basic_package_version_file(lutlib-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES
    ${PROJECT_BINARY_DIR}/lutlib-config.cmake ${PROJECT_BINARY_DIR}/lutlib-config-version.cmake
    DESTINATION ${package_folder} COMPONENT dev)
install(EXPORT lutlib FILE lutlib-targets.cmake NAMESPACE lutlib::
    DESTINATION ${package_folder} COMPONENT dev)

# Relative to where the file lies, so that a folder can be moved.
file(RELATIVE_PATH prefix_from_pkgconfig
    ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
if(BUILD_SHARED_LIBS)
    set(required_here)
    set(required_when_static "Requires.private: ")
else()
    set(required_here "Requires: ")
    set(required_when_static)
endif()
configure_file(cmake/lutlib.pc.in lutlib.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/lutlib.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)

file(GLOB looks CONFIGURE_DEPENDS luts/*.cube luts/*.json)
install(FILES ${looks} DESTINATION ${CMAKE_INSTALL_DATADIR}/lutlib/luts COMPONENT lutconv)
install(FILES README.md CHANGELOG.md THIRD-PARTY.md LICENSE
    DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT lutconv)

include(cmake/packages.cmake)
