#include "preview/check/lighting_twin.h"

#include "preview/check/read_by.h"
#include "preview/check/seen_surfaces.h"
#include "preview/reference/gradient.h"
#include "preview/reference/noise.h"
#include "preview/reference/surroundings.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace preview {

namespace {

using lutlib::RgbD;
using reference::Filtered;
using reference::Lit;

RgbD rgb_of(glm::dvec3 v) {
    return {v.x, v.y, v.z};
}

/// What surrounds the scene in this frame, for surfaces and for the eye.
struct Around {
    Surroundings asked;
    bool is_on = true;
    SkyBlock sky;
    reference::SurroundingsMaps maps;
    reference::Image picture;
    double largest_disc = 0; ///< of its radiance
    double pixel = 0;        ///< its angle

    bool has_maps() const { return is_on && has_map(asked.kind); }
    Filtered behind(const Environment& environment, glm::dvec3 direction) const;
};

/// The sky with the disc of its sun, whose edge is a pixel wide.
RgbD sky_behind(const Around& around, glm::dvec3 direction) {
    const glm::dvec3 disc = sun_disc(around.asked.sky, around.largest_disc);
    const double away = glm::length(direction - glm::dvec3(around.sky.towards_sun));
    const double covered =
        std::clamp((glm::radians(sun_radius) - away) / around.pixel + 0.5, 0.0, 1.0);
    const double risen = glm::smoothstep(-0.002, 0.002, direction.y);
    return rgb_of(sky_radiance(around.sky, direction) + disc * (covered * risen)) *
           around.maps.factor;
}

Filtered Around::behind(const Environment& environment, glm::dvec3 direction) const {
    if (!is_on) {
        return {};
    }
    switch (asked.kind) {
    case SurroundingsKind::gradient:
        return {reference::radiance(environment, direction, 0), {}};
    case SurroundingsKind::noise:
        return {reference::noise_background(glm::dvec4(glm::vec4(noise_now(asked))), direction),
                {}};
    case SurroundingsKind::sky:
        return {sky_behind(*this, direction), {}};
    case SurroundingsKind::picture:
        break;
    }
    const Filtered found =
        reference::sphere_sample(picture, turned(maps, direction), 0, picture.height);
    return {found.light * maps.factor, found.doubt * maps.factor};
}

/// Where in the pass the six bindings of shaders/common/surroundings.glsl begin.
Around around_of(const TwinInput& in, const ReadBy& read, std::size_t first) {
    const Situation& s = in.situation;
    Around out;
    out.asked = s.surroundings;
    out.is_on = !s.settings.without.has(Effect::environment);
    if (out.asked.kind == SurroundingsKind::picture && !s.shown->surroundings) {
        out.asked.kind = SurroundingsKind::gradient;
    }
    out.pixel = 2 * glm::length(glm::dvec3(read.block<ViewBlock>(0).up)) / in.size.height;
    if (!out.has_maps()) {
        return out;
    }
    out.maps.factor = std::exp2(static_cast<double>(out.asked.exposure));
    const std::vector<float>& harmonics = read.values(first + 1);
    for (std::size_t i = 0; i < out.maps.harmonics.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            out.maps.harmonics[i][c] = static_cast<double>(harmonics[4 * i + c]);
        }
    }
    out.maps.levels = read.colors(first + 2);
    out.maps.level_count = static_cast<int>(surroundings_levels);
    out.maps.reflectance = read.colors(first + 5);
    if (out.asked.kind == SurroundingsKind::picture) {
        out.maps.turn = glm::radians(static_cast<double>(out.asked.rotation));
        out.maps.mirror = [mirror = read.colors(first + 3)](glm::dvec3 direction) {
            return reference::sphere_sample(mirror, direction, 0, mirror.height);
        };
        out.picture = image_of(*s.shown->surroundings);
        return out;
    }
    out.sky = sky_block(out.asked.sky);
    out.maps.mirror = [sky = out.sky](glm::dvec3 direction) {
        return Filtered{rgb_of(sky_radiance(sky, direction)), {}};
    };
    // Half floats hold it before the exposure and after it.
    const double stops = static_cast<double>(s.settings.exposure + s.shown->scene->exposure);
    out.largest_disc = 60000 / std::max(std::exp2(stops), 1.0) / out.maps.factor;
    return out;
}

} // namespace

Twin lighting_twin(const TwinInput& in) {
    const ReadBy read(in);
    const bool has_detail = in.situation.shown->scene->has_detail();
    const GBufferRead surfaces(in, read, has_detail);
    const Environment& environment = in.situation.shown->scene->environment;
    const Around around = around_of(in, read, has_detail ? 11 : 10);
    reference::Illumination by;
    const std::vector<LightBlock> lights = read.blocks<LightBlock>(2);
    by.lights = lights;
    if (const Observed* const maps = read.image(7)) {
        by.shadow_maps = {static_cast<int>(maps->desc.width), maps->values};
    }
    by.shadow_filter = in.situation.settings.shadow_filter;
    by.has_occlusion = read.image(8) != nullptr;
    by.maps = around.has_maps() ? &around.maps : nullptr;
    by.environment = around.is_on ? &environment : nullptr;

    const auto width = static_cast<int>(in.size.width), height = static_cast<int>(in.size.height);
    Twin out(reference::Image(width, height));
    out.brightness = out.doubt = out.wanted;
    tbb::parallel_for(0, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            Lit found;
            if (surfaces.shows(x, y)) {
                found = lit(surfaces.at(x, y), by, surfaces.rounding(x, y));
            } else {
                const Filtered seen = around.behind(environment, surfaces.direction(x, y));
                found = {seen.light, seen.light, seen.doubt};
            }
            out.wanted.at(x, y) = found.light;
            out.brightness.at(x, y) = found.magnitude;
            out.doubt.at(x, y) = found.doubt;
        }
    });
    return out;
}

} // namespace preview
