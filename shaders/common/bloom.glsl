// Which share of its light a colour gives to bloom: none below threshold - knee, the excess over
// the threshold above threshold + knee, a parabola between. preview/finish/blooms.cpp has the same.
float bloom_share(float brightness, float threshold, float knee) {
    float over = brightness - threshold;
    if (!(over > -knee)) {
        return 0.0;
    }
    float soft = min(over + knee, 2.0 * knee);
    float light = over < knee ? soft * soft / (4.0 * knee) : over;
    return light / brightness;
}

/// Light of which `own` has gone into a glow.
vec3 with_bloom(vec3 light, vec3 own, vec3 glow, float strength) {
    return light + strength * (glow - own);
}
