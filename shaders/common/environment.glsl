// The surroundings of preview/scene/environment.h, formula for formula; its comment has the
// sources.
struct SoftBox {
    vec4 axis_sharpness;
    vec4 radiance;
};

struct Environment {
    vec4 zenith, horizon, ground; // ground.w: how many soft boxes
    SoftBox soft_boxes[4];
};

vec3 environment_radiance(Environment e, vec3 direction, float roughness) {
    float y = direction.y;
    float width = 0.25 + 0.75 * roughness;
    float share = abs(y) * inversesqrt(y * y + width * width);
    vec3 sum = mix(e.horizon.rgb, y > 0.0 ? e.zenith.rgb : e.ground.rgb, share);
    float alpha = max(roughness * roughness, 0.002);
    float blur = 1.0 / (2.0 * alpha * alpha);
    for (int i = 0; i < int(e.ground.w); ++i) {
        float own = e.soft_boxes[i].axis_sharpness.w;
        float sharpness = own * blur / (own + blur);
        float lobe = exp(sharpness * (dot(direction, e.soft_boxes[i].axis_sharpness.xyz) - 1.0));
        sum += e.soft_boxes[i].radiance.rgb * (sharpness / own * lobe);
    }
    return sum;
}

float environment_zenith_share(float y) {
    float h = clamp(0.5 + 0.5 * y, 0.0, 1.0);
    return 0.9 * h * (0.6 + 0.4 * h);
}

vec3 environment_irradiance(Environment e, vec3 normal) {
    const float pi = 3.14159265;
    const float cosine_sharpness = 2.133, cosine_amplitude = 1.170;
    float up = environment_zenith_share(normal.y), down = environment_zenith_share(-normal.y);
    vec3 sum = pi * (up * e.zenith.rgb + down * e.ground.rgb + (1.0 - up - down) * e.horizon.rgb);
    for (int i = 0; i < int(e.ground.w); ++i) {
        vec4 box = e.soft_boxes[i].axis_sharpness;
        float total = box.w + cosine_sharpness;
        float reach = length(box.w * box.xyz + cosine_sharpness * normal);
        float integral = (exp(reach - total) - exp(-reach - total)) / reach;
        sum += e.soft_boxes[i].radiance.rgb * (2.0 * pi * cosine_amplitude * integral);
    }
    return sum;
}
