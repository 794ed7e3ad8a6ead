// The surroundings of preview/scene/environment.h, formula for formula; its comment has the
// sources. Who includes this has the block `environment` and common/lighting_constants.glsl. The
// block is not passed on as a value: with its array that would be a copy in every texel's memory.
#ifndef ENVIRONMENT_LIGHT_GLSL
#define ENVIRONMENT_LIGHT_GLSL

vec3 environment_radiance(vec3 direction, float roughness) {
    float y = direction.y;
    float width = 0.25 + 0.75 * roughness;
    float share = abs(y) * inversesqrt(y * y + width * width);
    vec3 far = y > 0.0 ? environment.zenith.rgb : environment.ground.rgb;
    vec3 sum = mix(environment.horizon.rgb, far, share);
    float alpha = max(roughness * roughness, 0.002);
    float blur = 1.0 / (2.0 * alpha * alpha);
    for (int i = 0; i < soft_boxes; ++i) {
        vec4 box = environment.soft_boxes[i].axis_sharpness;
        float kept = blur / (box.w + blur); // of the sharpness
        float lobe = exp(box.w * kept * (dot(direction, box.xyz) - 1.0));
        sum += environment.soft_boxes[i].radiance.rgb * (kept * lobe);
    }
    return sum;
}

float environment_zenith_share(float y) {
    float h = clamp(0.5 + 0.5 * y, 0.0, 1.0);
    return 0.9 * h * (0.6 + 0.4 * h);
}

vec3 environment_irradiance(vec3 normal) {
    const float pi = 3.14159265;
    const float cosine_sharpness = 2.133, cosine_amplitude = 1.170;
    float up = environment_zenith_share(normal.y), down = environment_zenith_share(-normal.y);
    vec3 sum = pi * (up * environment.zenith.rgb + down * environment.ground.rgb +
                     (1.0 - up - down) * environment.horizon.rgb);
    for (int i = 0; i < soft_boxes; ++i) {
        vec4 box = environment.soft_boxes[i].axis_sharpness;
        float total = box.w + cosine_sharpness;
        // Of the sum of both lobes' axes.
        float cosine = dot(box.xyz, normal);
        float squared = total * total + 2.0 * cosine_sharpness * box.w * (cosine - 1.0);
        float inverse = inversesqrt(max(squared, 1e-6)), reach = squared * inverse;
        float integral = (exp(reach - total) - exp(-reach - total)) * inverse;
        sum += environment.soft_boxes[i].radiance.rgb * (2.0 * pi * cosine_amplitude * integral);
    }
    return sum;
}

#endif
