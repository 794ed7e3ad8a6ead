/// Brightness of display-encoded colours (Rec. 709's weights on codes).
float luma_of(vec3 codes) {
    return dot(codes, vec3(0.2126, 0.7152, 0.0722));
}
