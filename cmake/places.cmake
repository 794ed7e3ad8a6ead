# Where things lie when they are installed, and how those that belong together find each other.
include(GNUInstallDirs)

# What the library loads on demand, by itself: nobody else's business.
set(lutlib_module_folder ${CMAKE_INSTALL_LIBDIR}/lutlib)

file(RELATIVE_PATH from_programs_to_libraries
    ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})

# For lutlib/io/module.cpp. A program that another project builds lies anywhere, so there the folder
# of the build is named.
if(PROJECT_IS_TOP_LEVEL)
    set(folder_of_last_resort ${CMAKE_INSTALL_FULL_LIBDIR}/lutlib)
else()
    set(folder_of_last_resort ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
endif()
set(lutlib_module_places
    LUT_MODULES_FROM_PROGRAM="${from_programs_to_libraries}/lutlib"
    LUT_MODULES_LAST="${folder_of_last_resort}")

# Of a library that others link: `export` is its name behind lutlib::, further arguments its public
# headers, relative to the project's root.
function(lut_public_library target export)
    add_library(lutlib::${export} ALIAS ${target})
    follow_house_rules(${target})
    target_compile_features(${target} PUBLIC cxx_std_20)
    list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/)
    target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${ARGN})
    # While the major version is 0, a minor one may change anything.
    set_target_properties(${target} PROPERTIES
        EXPORT_NAME ${export}
        VERSION ${PROJECT_VERSION}
        SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
        DEFINE_SYMBOL ""
        INSTALL_RPATH "$ORIGIN")
    if(LUT_INSTALL)
        install(TARGETS ${target} EXPORT lutlib
            LIBRARY COMPONENT lutconv NAMELINK_COMPONENT dev
            ARCHIVE COMPONENT dev
            FILE_SET HEADERS COMPONENT dev)
    endif()
endfunction()

# `component` is the package that it goes into.
function(lut_install_beside_library target component)
    set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN/..")
    if(LUT_INSTALL)
        install(TARGETS ${target}
            RUNTIME DESTINATION ${lutlib_module_folder} COMPONENT ${component}
            LIBRARY DESTINATION ${lutlib_module_folder} COMPONENT ${component})
    endif()
endfunction()

function(lut_install_program target component)
    set_target_properties(${target} PROPERTIES
        INSTALL_RPATH "$ORIGIN/${from_programs_to_libraries}")
    if(LUT_INSTALL)
        install(TARGETS ${target} RUNTIME COMPONENT ${component})
    endif()
endfunction()

# Man pages and completions of a program, which it writes itself from what its help says.
function(lut_papers target component)
    set(papers ${PROJECT_BINARY_DIR}/papers/${target})
    add_custom_command(OUTPUT ${papers}/man/man1/${target}.1
        COMMAND ${target} --write-papers ${papers} DEPENDS ${target} VERBATIM)
    add_custom_target(${target}_papers ALL DEPENDS ${papers}/man/man1/${target}.1)
    if(LUT_INSTALL)
        install(DIRECTORY ${papers}/ DESTINATION ${CMAKE_INSTALL_DATADIR} COMPONENT ${component})
    endif()
endfunction()
