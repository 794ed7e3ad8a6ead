#include "preview/passes/surroundings.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace preview {

namespace {

/// shaders/common/surroundings.glsl
struct SurroundingsBlock {
    glm::vec4 turn_scale{1, 0, 1, static_cast<float>(surroundings_levels)};
    glm::vec4 disc{0};
    glm::vec4 noise{0};
    SkyBlock sky;
};

SurroundingsBlock block_of(const Surroundings& surroundings, const SkyBlock& sky, float exposure) {
    SurroundingsBlock block;
    if (surroundings.kind == SurroundingsKind::noise) {
        block.noise = glm::vec4(noise_now(surroundings));
        return block;
    }
    block.turn_scale.z = std::exp2(surroundings.exposure);
    if (surroundings.kind == SurroundingsKind::picture) {
        const float turn = glm::radians(surroundings.rotation);
        block.turn_scale.x = std::cos(turn);
        block.turn_scale.y = std::sin(turn);
        return block;
    }
    // Half floats hold 65504, before the exposure and after it.
    constexpr double most = 60000;
    const double scale = static_cast<double>(block.turn_scale.z);
    const double most_of_disc = most / std::max(std::exp2(static_cast<double>(exposure)), 1.0);
    block.disc = glm::vec4(glm::vec3(sun_disc(surroundings.sky, most_of_disc / scale) * scale),
                           static_cast<float>(glm::radians(sun_radius)));
    block.sky = sky;
    return block;
}

} // namespace

SurroundingsHandles add_surroundings(Graph& graph, const Surroundings& surroundings,
                                     const SurroundingsInputs& inputs) {
    if (!has_map(surroundings.kind)) {
        SurroundingsHandles out;
        out.kind = surroundings.kind;
        out.block = graph.data_of("surroundings", block_of(surroundings, {}, inputs.exposure));
        return out;
    }
    const bool is_picture = surroundings.kind == SurroundingsKind::picture;
    const std::string_view still_right =
        is_picture ? "the picture is the same" : "the sun has not moved";
    const auto image = [&](std::string_view name, const ImageDesc& desc) {
        return image_kept_if(graph, inputs.are_kept, name, desc, still_right);
    };
    const SkyBlock sky = is_picture ? SkyBlock{} : sky_block(surroundings.sky);
    SurroundingsHandles out;
    out.kind = surroundings.kind;
    out.block = graph.data_of("surroundings", block_of(surroundings, sky, inputs.exposure));
    out.picture = is_picture ? inputs.picture : ImageHandle{};
    const BufferHandle sky_data = is_picture ? BufferHandle{} : graph.data_of("sky", sky);
    const auto add_base = [&](const char* name, Size size) {
        Pass pass = graph.compute(name, "surroundings_base.comp");
        pass.constants({is_picture ? 1U : 0U});
        pass.uniform(sky_data);
        pass.read(out.picture);
        const ImageHandle base =
            pass.write(image(name, {Format::rgba16f, size.width, size.height}));
        pass.dispatch_over(size.width, size.height);
        return base;
    };
    if (is_picture) {
        out.mirror = add_base("surroundings mirror", surroundings_mirror_size);
    }
    const Size size = inputs.base;
    out.base = add_base("surroundings base", size);

    Pass levels = graph.compute("surroundings levels", "surroundings_levels.comp");
    levels.read(out.base);
    const ImageDesc stack{Format::rgba16f, size.width, size.height * surroundings_levels};
    out.levels = levels.write(image("surroundings levels", stack));
    levels.dispatch_over(stack.width, stack.height);

    Pass harmonics = graph.compute("surroundings irradiance", "surroundings_harmonics.comp");
    harmonics.read(out.base);
    constexpr std::uint32_t count = 9;
    constexpr std::uint64_t bytes = count * sizeof(glm::vec4);
    out.harmonics = harmonics.write(
        buffer_kept_if(graph, inputs.are_kept, "surroundings irradiance", bytes, still_right));
    harmonics.dispatch(count);

    Pass reflectance = graph.compute("reflectance", "surroundings_reflectance.comp");
    const ImageDesc table{Format::rgba16f, 32, 32};
    out.reflectance = reflectance.write(
        image_kept_if(graph, inputs.are_kept, "reflectance", table, "it is always the same"));
    reflectance.dispatch_over(table.width, table.height);
    return out;
}

} // namespace preview
