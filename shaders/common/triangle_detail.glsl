// What the vertices of a triangle say of a pixel in it. After vertex_details, indices, clusters.
struct DetailAt {
    Footprint footprint;
    vec4 color;
    vec4 tangent; // and its side
};

DetailAt detail_at(Object object, Cluster cluster, uint first, vec4 corners[3], vec2 screen,
                   vec2 size, vec3 weights) {
    vec3 right = shares_of(areas_at(screen + vec2(2.0 / size.x, 0.0), corners[0], corners[1],
                                    corners[2]));
    vec3 below = shares_of(areas_at(screen + vec2(0.0, 2.0 / size.y), corners[0], corners[1],
                                    corners[2]));
    vec3 here = shares_of(areas_at(screen, corners[0], corners[1], corners[2]));
    DetailAt point;
    point.footprint = Footprint(vec4(0.0), vec4(0.0), vec4(0.0));
    point.color = vec4(0.0);
    point.tangent = vec4(0.0);
    for (int i = 0; i < 3; ++i) {
        VertexDetail vertex =
            vertex_details[uint(int(indices[first + i]) + cluster.vertex_offset)];
        vec4 uv = vec4(vertex.uv[0], vertex.uv[1]);
        point.footprint.uv += weights[i] * uv;
        point.footprint.dx += (right[i] - here[i]) * uv;
        point.footprint.dy += (below[i] - here[i]) * uv;
        point.color += weights[i] * vertex_color(vertex);
        point.tangent += weights[i] * tangent_of(object, vertex.tangent, vertex.side);
    }
    return point;
}
