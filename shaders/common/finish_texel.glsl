// For passes that finish texels and keep no picture of them: what common/finish.glsl needs beside
// itself. They bind their own resources from binding 14 on, in place of finish.glsl's, which they
// must not touch.
vec3 graded_a(vec3 c);
vec3 graded_b(vec3 c);
#include "common/bloom.glsl"
#include "common/finish.glsl"

// The rows that read shared memory elsewhere compute the same from the picture itself.
vec3 graded_by(int row, sampler2D source, sampler3D volume, sampler2D shaper, Look look, vec3 c) {
    if (row == lookup_shared_tetrahedral)
        return tetrahedral_picture(source, layout_strip, look.size,
                                   saturate(c) * float(look.size - 1));
    return apply_lookup(row == lookup_shared_trilinear ? lookup_strip_texels : row, source, volume,
                        shaper, look, c);
}

vec3 graded_a(vec3 c) {
    return graded_by(lookup_a, picture_a, volume_a, shaper_a, look_a, c);
}

vec3 graded_b(vec3 c) {
    return graded_by(lookup_b, picture_b, volume_b, shaper_b, look_b, c);
}
