# Sources of a folder compiled some at a time, as one: most of a compiler's time goes to the headers,
# which it then reads once. They may not use one name for two things. The preset dev compiles
# each alone, and shows what a source forgot to include.
option(LUT_TOGETHER "Compile several sources at once" OFF)

# Patterns of sources that stay alone: the rows of a table, which all use the same names, others that
# share a name with a neighbour, and those that take long by themselves.
set(lut_apart
    lutlib/color/
    lutlib/interpolation/apply
    lutlib/interpolation/grade_
    lutlib/io/output_names
    lutlib/io/pending_file
    lutlib/io/references
    lutlib/paint/denoise
    lutlib/plot/scatter
    lutlib/resample/invert.cpp
    lutlib/survey/precision
    python/recipe
    python/work
    preview/cli/options_unused
    preview/reference/occlusion
    preview/scene/studio
    preview/scene/surroundings
    tests/converter/placing
    tests/converter/written_file
    tests/docs/workplace
    tests/lutlib/color/transfer
    tests/lutlib/health/
    tests/lutlib/interpolation/
    tests/lutlib/io/png_test
    tests/lutlib/resample/
    tests/lutlib/verify/moved
    tests/preview/graph/persistent
    tests/preview/passes/geometry
    tests/preview/passes/resolve
    tests/preview/passes/shadow
    tests/preview/passes/texel_gpu
)

# For the targets of a folder and of those in it, once all are known.
function(lut_compile_together folder)
    set(at_a_time 8)
    list(JOIN lut_apart "|" apart)
    get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
    foreach(inner ${folders})
        lut_compile_together(${inner})
    endforeach()
    get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
    foreach(target ${targets})
        get_target_property(sources ${target} SOURCES)
        set(is_joined OFF)
        foreach(source ${sources})
            cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${folder} OUTPUT_VARIABLE path)
            if(NOT path MATCHES "^${PROJECT_SOURCE_DIR}/.*\\.cpp$" OR
                    path MATCHES "^${PROJECT_SOURCE_DIR}/(${apart})" OR
                    path MATCHES "^${PROJECT_BINARY_DIR}/")
                continue()
            endif()
            cmake_path(GET path PARENT_PATH place)
            cmake_path(RELATIVE_PATH place BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
            string(MAKE_C_IDENTIFIER "${target}_${place}" place)
            math(EXPR count_${place} "0${count_${place}} + 1")
            math(EXPR group "${count_${place}} / ${at_a_time}")
            set_source_files_properties(${path} TARGET_DIRECTORY ${target}
                PROPERTIES UNITY_GROUP ${place}_${group})
            set(is_joined ON)
        endforeach()
        if(is_joined)
            set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
        endif()
    endforeach()
endfunction()
