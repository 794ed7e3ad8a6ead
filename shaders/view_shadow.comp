// Shows the layers of a depth array side by side; near is bright.
#version 460
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2DArray source;
layout(binding = 1) writeonly uniform image2D target;
layout(constant_id = 0) const bool as_numbers = false; // depth as it is
layout(push_constant) uniform Push { float near_plane; } view_push; // as of every view

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(target);
    if (any(greaterThanEqual(at, size))) {
        return;
    }
    ivec3 maps = textureSize(source, 0);
    int edge = max(min(size.x / maps.z, size.y), 1);
    ivec2 cell = ivec2(at.x / edge, at.y / edge);
    float shown = 0.0;
    if (cell.x < maps.z && cell.y == 0) {
        ivec2 texel = (at - cell * edge) * maps.xy / edge;
        float depth = texelFetch(source, ivec3(texel, cell.x), 0).r;
        shown = as_numbers ? depth : depth < 1.0 ? 1.0 + log2(1.0 - depth * 0.999) / 10.0 : 0.0;
    }
    imageStore(target, at, vec4(vec3(shown), 1.0));
}
