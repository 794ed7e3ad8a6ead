# Debian 12 packages, by `cpack -G DEB` in a finished build: lutconv, lutpreview, liblutlib-dev and
# python3-lutlib.
set(CPACK_PACKAGE_NAME lutlib)
set(CPACK_PACKAGE_VENDOR "the lutlib authors")
set(CPACK_PACKAGE_CONTACT "the lutlib authors <lutlib@localhost>")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL lutconv dev)
if(TARGET lutpreview)
    list(APPEND CPACK_COMPONENTS_ALL lutpreview)
endif()
if(TARGET lutlib_python)
    list(APPEND CPACK_COMPONENTS_ALL python)
endif()

# Written out instead of found by dpkg-shlibdeps: what the modules load on demand is recommended.
set(needs_of_library "libc6 (>= 2.36), libgcc-s1, libstdc++6 (>= 12), libtbb12, libhwy1, libfmt9, \
libspng0, libisal2, libseccomp2")
set(formats_of_others "libopencolorio2.1, libopenimageio2.4")

set(CPACK_DEBIAN_LUTCONV_PACKAGE_NAME lutconv)
set(CPACK_DEBIAN_LUTCONV_PACKAGE_DEPENDS "${needs_of_library}")
set(CPACK_DEBIAN_LUTCONV_PACKAGE_RECOMMENDS "${formats_of_others}")
set(CPACK_COMPONENT_LUTCONV_DESCRIPTION
    "colour LUTs for game engines: bake, verify, convert, edit, apply
 The command line and what lutlib loads on demand.")

set(CPACK_DEBIAN_LUTPREVIEW_PACKAGE_NAME lutpreview)
set(CPACK_DEBIAN_LUTPREVIEW_PACKAGE_DEPENDS "lutconv (= ${PROJECT_VERSION}), ${needs_of_library}, \
libvulkan1, libglfw3, libstb0, libfftw3-double3, fonts-dejavu-core")
set(CPACK_DEBIAN_LUTPREVIEW_PACKAGE_RECOMMENDS "mesa-vulkan-drivers, libassimp5")
set(CPACK_COMPONENT_LUTPREVIEW_DESCRIPTION
    "previews colour LUTs on rendered scenes, as game engines show them
 A renderer on Vulkan, in a window or without one.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME liblutlib-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "lutconv (= ${PROJECT_VERSION}), libtbb-dev, libhwy-dev, \
libfmt-dev, libspng-dev, libisal-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION
    "colour LUTs in programs of your own
 Headers and libraries of lutlib, for CMake and pkg-config.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-lutlib)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "lutconv (= ${PROJECT_VERSION}), ${needs_of_library}, \
python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
    "colour LUTs in Python, on numpy arrays
 Reads, writes, bakes, verifies, and applies looks to arrays where they lie.")
include(CPack)
