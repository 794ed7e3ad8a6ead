# Compiles GLSL to SPIR-V, checks it and embeds it in a target as arrays (preview/gpu/shaders.h).
# min, max and clamp of NaN are defined as the number (--nan-clamp). Beside shaders/, what they include
# may stand in the folder INCLUDE, where the build writes the files DEPENDS. A source that ends in .hlsl
# is HLSL, for which the OPTIONS name its entry point.
find_program(GLSLANG glslangValidator REQUIRED)
find_program(SPIRV_VAL spirv-val REQUIRED)

function(embed_shaders target)
    cmake_parse_arguments(shaders "" "INCLUDE" "DEPENDS;OPTIONS;SOURCES" ${ARGN})
    set(modules)
    foreach(source IN LISTS shaders_SOURCES)
        get_filename_component(name ${source} NAME)
        set(module ${CMAKE_CURRENT_BINARY_DIR}/shaders/${name}.spv)
        add_custom_command(OUTPUT ${module}
            COMMAND ${GLSLANG} -V --quiet --nan-clamp --target-env vulkan1.3
                -I${PROJECT_SOURCE_DIR}/shaders -I${shaders_INCLUDE} ${shaders_OPTIONS}
                --depfile ${module}.d -o ${module} ${source}
            COMMAND ${SPIRV_VAL} --target-env vulkan1.3 ${module}
            DEPENDS ${source} ${shaders_DEPENDS}
            DEPFILE ${module}.d
            COMMENT "Shader ${name}"
            VERBATIM)
        list(APPEND modules ${module})
    endforeach()
    set(embedded ${CMAKE_CURRENT_BINARY_DIR}/shaders/${target}_shaders.cpp)
    add_custom_command(OUTPUT ${embedded}
        COMMAND ${CMAKE_COMMAND} -DOUTPUT=${embedded} "-DMODULES=${modules}"
            -P ${PROJECT_SOURCE_DIR}/preview/cmake/embed.cmake
        DEPENDS ${modules} ${PROJECT_SOURCE_DIR}/preview/cmake/embed.cmake
        COMMENT "Embedding the shaders"
        VERBATIM)
    target_sources(${target} PRIVATE ${embedded})
endfunction()
