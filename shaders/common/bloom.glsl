// Which share of its light a colour gives to bloom: none below threshold - knee, the excess over the
// threshold above threshold + knee, a parabola between. preview/blooms.cpp has the same.
float bloom_share(float brightness, float threshold, float knee) {
    float over = brightness - threshold;
    if (!(over > -knee))
        return 0.0;
    float soft = min(over + knee, 2.0 * knee);
    float light = over < knee ? soft * soft / (4.0 * knee) : over;
    return light / brightness;
}

/// Light of which `share` has gone into a glow.
vec3 with_bloom(vec3 light, float share, vec3 glow, float strength) {
    return light + strength * (glow - light * share);
}

/// A layer of the bloom at a place in its own texels.
vec3 layer_at(sampler2D layer, vec2 at) {
    return textureLod(layer, at / vec2(textureSize(layer, 0)), 0.0).rgb;
}
