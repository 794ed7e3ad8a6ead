// The line between sides A and B: two texels wide at 1080 lines, at least one.
bool on_line(int x, ivec2 size, float split) {
    float half_width = max(float(size.y) / 1080.0, 0.5);
    return abs(float(x) + 0.5 - split * float(size.x)) <= half_width;
}
