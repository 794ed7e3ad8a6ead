// All that a pass which finishes texels is given: preview/passes/finish.h, bind_finish(), binds it,
// and the passes' own bindings follow from 13 on. Only the functions here, those of
// common/graded.glsl and the shaders themselves read it; every other function takes what it uses.
#ifndef FINISH_GLSL
#define FINISH_GLSL
#include "common/bloom.glsl"
#include "common/sanitise.glsl"
#include "rows/lookups.glsl"
#include "rows/tonemaps.glsl"
#include "common/look_conversion.glsl"

layout(constant_id = 0) const int tonemap_row = 0; // -1: the picture is display-encoded already
layout(constant_id = 1) const int bloom_taps = 0; // of the bloom's last filter; 0: no bloom
layout(constant_id = 2) const bool bloom_threshold = false;
layout(constant_id = 3) const int lookup_a = 0;
layout(constant_id = 4) const int lookup_b = 0;
layout(constant_id = 5) const int compare = 0;
layout(constant_id = 6) const bool unit_picture = false; // its format holds 0..1 only
layout(constant_id = 7) const bool has_marks = true; // split line, scale; else a later pass draws them
layout(constant_id = 8) const int place_a = 0;           // bits of common/look_conversion.glsl
layout(constant_id = 9) const int place_b = 0;

layout(binding = 0) uniform sampler2D picture;
layout(binding = 1) uniform sampler2D glow;
layout(binding = 2) uniform Filter {
    float scale;
    vec4 taps[9]; // offset, weight
} final_filter;
layout(binding = 3) uniform sampler2D picture_a;
layout(binding = 4) uniform sampler3D volume_a;
layout(binding = 5) uniform sampler2D shaper_a;
layout(binding = 6) uniform LookA { Look look_a; };
layout(binding = 7) uniform sampler2D picture_b;
layout(binding = 8) uniform sampler3D volume_b;
layout(binding = 9) uniform sampler2D shaper_b;
layout(binding = 10) uniform LookB { Look look_b; };
layout(push_constant) uniform Push {
    vec4 wipe;      // common/wipe.glsl
    float exposure; // factor
    float strength, heat_scale;
    BloomOnset onset;
} push;

vec3 picture_at(ivec2 at) {
    return texelFetch(picture, at, 0).rgb;
}

/// What the bloom's last filter adds up about a texel.
vec3 glow_at(ivec2 at) {
    vec2 texel = 1.0 / vec2(textureSize(glow, 0));
    vec2 centre = (vec2(at) + 0.5) * final_filter.scale;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < bloom_taps; ++i) {
        vec4 tap = final_filter.taps[i];
        sum += textureLod(glow, (centre + tap.xy) * texel, 0.0).rgb * tap.z;
    }
    return sum;
}

/// The light of a texel, which is `light` in the picture, with its bloom.
vec3 bloomed(ivec2 at, vec3 light) {
    if (bloom_taps == 0) {
        return light;
    }
    vec3 own = light;
    if (bloom_threshold) {
        own *= bloom_share(max(light.r, max(light.g, light.b)), push.onset);
    }
    return with_bloom(light, own, glow_at(at), push.strength);
}

/// A texel where looks may stand: before the tone map and after it.
struct Stages {
    vec3 light, codes;
};

/// A picture that is display-encoded already has no light.
Stages stages_of(ivec2 at, vec3 texel) {
    if (tonemap_row < 0) {
        return Stages(vec3(0.0), texel);
    }
    vec3 light = sanitise(bloomed(at, texel) * push.exposure);
    return Stages(light, tonemap(tonemap_row, light));
}

#endif
