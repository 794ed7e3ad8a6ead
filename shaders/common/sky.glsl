// The sky of preview/scene/sky.h, formula for formula; its comment has the sources.
#ifndef SKY_GLSL
#define SKY_GLSL

struct Sky {
    vec4 distribution[5]; // rows A..E of Y, x and y
    vec4 zenith;
    vec4 towards_sun;
    vec4 ground;
};

vec3 sky_radiance(Sky sky, vec3 direction) {
    float cos_sun = clamp(dot(direction, sky.towards_sun.xyz), -1.0, 1.0);
    float angle = acos(cos_sun);
    vec3 gradient =
        1.0 + sky.distribution[0].xyz * exp(sky.distribution[1].xyz / max(direction.y, 0.01));
    vec3 glow = 1.0 + sky.distribution[2].xyz * exp(sky.distribution[3].xyz * angle) +
                sky.distribution[4].xyz * (cos_sun * cos_sun);
    vec3 value = sky.zenith.xyz * gradient * glow;
    float luminance = max(value.x, 0.0);
    float y = max(value.z, 0.01);
    vec3 xyz = vec3(luminance * value.y / y, luminance, luminance * (1.0 - value.y - value.z) / y);
    // IEC 61966-2-1, columns.
    const mat3 to_srgb = mat3(3.2406, -0.9689, 0.0557, -1.5372, 1.8758, -0.2040, -0.4986, 0.0415,
                              1.0570);
    return mix(sky.ground.rgb, max(to_srgb * xyz, vec3(0.0)),
               smoothstep(-0.002, 0.002, direction.y));
}

#endif
