/// Of light that blooms above a threshold, with a soft step of half width `knee` about it; `parabola` is
/// 1 / (4 knee), 0 without a knee. preview/passes/bloom.cpp fills it.
struct BloomOnset {
    float threshold, knee, parabola;
};

/// Which share of its light a colour gives to bloom: none below threshold - knee, the excess over
/// the threshold above threshold + knee, between them a parabola, which is nowhere less than the excess.
/// preview/finish/blooms.cpp has the same.
float bloom_share(float brightness, BloomOnset onset) {
    float over = brightness - onset.threshold;
    if (!(over > -onset.knee)) {
        return 0.0;
    }
    float soft = min(over + onset.knee, 2.0 * onset.knee);
    return max(soft * soft * onset.parabola, over) / brightness;
}

/// Light of which `own` has gone into a glow.
vec3 with_bloom(vec3 light, vec3 own, vec3 glow, float strength) {
    return light + strength * (glow - own);
}
