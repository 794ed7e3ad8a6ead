// The block of preview/scene/environment.h; common/environment_light.glsl reads it.
struct SoftBox {
    vec4 axis_sharpness;
    vec4 radiance;
};

struct Environment {
    vec4 zenith, horizon, ground;
    SoftBox soft_boxes[4];
};
