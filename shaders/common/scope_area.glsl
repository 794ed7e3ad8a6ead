// Which texels a scope counts: preview/finish/scope_area.h, whose is_counted() is the twin.
layout(constant_id = 0) const uint part = 0u; // ScopePart

layout(push_constant) uniform Push {
    uint x, y, width, height; // the rectangle
    uint total;               // columns of all pictures side by side that have it
    uint stride;              // columns from one of them to the next
    uint columns;             // of counts
    uint unused;
    vec4 border; // common/wipe.glsl
    float reach;
} push;

/// The texel of a column of all these pictures' rectangles.
ivec2 texel_of(uint column, uint row) {
    uint x = column < push.width ? column : column - push.width + push.stride;
    return ivec2(push.x + x, push.y + row);
}

/// In float, one operation after the other, as the twin does it.
bool is_counted(ivec2 at) {
    if (part == 0u) {
        return true;
    }
    precise vec2 centre = vec2(at) + 0.5;
    precise float beyond;
    if (part == 3u || part == 4u) {
        precise vec2 outside = max(push.border.xy - centre, centre - push.border.zw);
        beyond = max(outside.x, outside.y);
    } else {
        precise float across = centre.x * push.border.x;
        precise float down = centre.y * push.border.y;
        precise float along = across + down;
        beyond = along - push.border.z;
    }
    return part == 1u || part == 3u ? beyond < -push.reach : beyond > push.reach;
}
