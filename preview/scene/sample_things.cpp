// What stands on the sample's table.
#include "preview/scene/angles.h"
#include "preview/scene/pictures.h"
#include "preview/scene/sample_parts.h"
#include "preview/scene/shapes.h"
#include "preview/scene/swatches.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace preview {

namespace {

Mesh turned_shape(std::span<const glm::vec2> points, int steps, int sectors) {
    return lathe(smoothed(points, steps), sectors);
}

Mesh ball(int rings) {
    std::vector<glm::vec2> profile;
    for (int i = 0; i <= rings; ++i) {
        const float angle = pi * static_cast<float>(i) / static_cast<float>(rings);
        profile.push_back({std::sin(angle), -std::cos(angle)});
    }
    Mesh mesh = lathe(profile, 2 * rings);
    repeat(mesh, {2, 1});
    return mesh;
}

/// Red where the sun was, yellow elsewhere, in streaks from pole to pole.
glm::vec3 apple_color(const Vertex& vertex) {
    const float turn = std::atan2(vertex.position.z, vertex.position.x) / (2 * pi) + 0.5F;
    const float streaks = layered_noise({48 * turn, 2 * vertex.position.y + 4}, {48, 8}, 2, 3);
    const float sunny = 0.5F + 0.5F * std::cos(2 * pi * turn - 1);
    const float red = glm::smoothstep(0.25F, 0.62F, 0.65F * sunny + 0.45F * streaks);
    return glm::mix(glm::vec3(0.66F, 0.42F, 0.07F), glm::vec3(0.42F, 0.018F, 0.02F), red);
}

constexpr glm::vec2 apple_profile[]{{0, -0.74F},     {0.22F, -0.86F}, {0.55F, -0.76F},
                                    {0.88F, -0.25F}, {0.98F, 0.2F},   {0.82F, 0.66F},
                                    {0.46F, 0.84F},  {0.16F, 0.76F},  {0, 0.56F}};
constexpr glm::vec2 lemon_profile[]{{0, -1.3F},      {0.1F, -1.26F}, {0.24F, -1.08F},
                                    {0.66F, -0.76F}, {0.9F, -0.2F},  {0.9F, 0.25F},
                                    {0.62F, 0.8F},   {0.22F, 1.1F},  {0, 1.2F}};
constexpr glm::vec2 pear_profile[]{{0, -0.86F},    {0.3F, -0.93F}, {0.8F, -0.66F},
                                   {0.98F, -0.1F}, {0.8F, 0.5F},   {0.5F, 1.0F},
                                   {0.36F, 1.4F},  {0.2F, 1.6F},   {0, 1.62F}};
constexpr glm::vec2 bowl_profile[]{{0, 0},          {0.17F, 0},      {0.17F, 0},
                                   {0.16F, 0.035F}, {0.28F, 0.09F},  {0.4F, 0.2F},
                                   {0.445F, 0.25F}, {0.44F, 0.262F}, {0.425F, 0.25F},
                                   {0.37F, 0.19F},  {0.25F, 0.1F},   {0, 0.06F}};
constexpr glm::vec2 jug_profile[]{{0, 0},         {0.19F, 0},     {0.19F, 0},       {0.2F, 0.012F},
                                  {0.25F, 0.14F}, {0.26F, 0.26F}, {0.2F, 0.46F},    {0.145F, 0.6F},
                                  {0.15F, 0.7F},  {0.18F, 0.78F}, {0.172F, 0.782F}, {0.14F, 0.7F},
                                  {0.13F, 0.6F},  {0, 0.5F}};
constexpr glm::vec2 bottle_profile[]{
    {0, 0},          {0.15F, 0},     {0.15F, 0},     {0.165F, 0.02F}, {0.168F, 0.3F},
    {0.168F, 0.56F}, {0.15F, 0.66F}, {0.07F, 0.78F}, {0.056F, 0.88F}, {0.056F, 0.99F},
    {0.056F, 0.99F}, {0.07F, 0.99F}, {0.07F, 0.99F}, {0.07F, 1.04F},  {0.07F, 1.04F},
    {0.055F, 1.05F}, {0, 1.05F}};
constexpr glm::vec2 pan_profile[]{{0, 0},         {0.26F, 0},     {0.28F, 0.02F},   {0.29F, 0.06F},
                                  {0.3F, 0.3F},   {0.3F, 0.3F},   {0.315F, 0.305F}, {0.31F, 0.315F},
                                  {0.29F, 0.31F}, {0.29F, 0.31F}, {0.28F, 0.06F},   {0.25F, 0.03F},
                                  {0, 0.03F}};
constexpr glm::vec2 pot_profile[]{
    {0, 0},          {0.17F, 0},      {0.17F, 0},      {0.22F, 0.3F},  {0.22F, 0.3F},
    {0.245F, 0.3F},  {0.245F, 0.3F},  {0.25F, 0.38F},  {0.25F, 0.38F}, {0.225F, 0.38F},
    {0.225F, 0.38F}, {0.215F, 0.34F}, {0.215F, 0.34F}, {0, 0.35F}};
constexpr glm::vec2 vase_profile[]{{0, 0},         {0.11F, 0},      {0.11F, 0},      {0.17F, 0.12F},
                                   {0.19F, 0.26F}, {0.13F, 0.4F},   {0.065F, 0.47F}, {0.06F, 0.52F},
                                   {0.09F, 0.57F}, {0.082F, 0.57F}, {0.05F, 0.5F},   {0, 0.4F}};
constexpr glm::vec2 stick_profile[]{
    {0, 0},         {0.13F, 0},       {0.13F, 0},       {0.135F, 0.012F}, {0.09F, 0.03F},
    {0.04F, 0.05F}, {0.022F, 0.09F},  {0.036F, 0.13F},  {0.022F, 0.17F},  {0.018F, 0.25F},
    {0.026F, 0.3F}, {0.055F, 0.335F}, {0.055F, 0.345F}, {0.03F, 0.35F},   {0.03F, 0.35F},
    {0.034F, 0.4F}, {0.034F, 0.4F},   {0, 0.4F}};
constexpr glm::vec2 candle_profile[]{{0, 0},          {0.026F, 0},     {0.026F, 0},
                                     {0.027F, 0.24F}, {0.024F, 0.26F}, {0, 0.25F}};
constexpr glm::vec2 flame_profile[]{{0, 0},        {0.5F, 0.3F},  {0.62F, 0.7F},
                                    {0.42F, 1.4F}, {0.16F, 2.2F}, {0, 2.7F}};

/// A leaf from its stalk at the origin along +x: pointed, folded along its middle, bent down.
Mesh leaf(float bend) {
    return two_sided(surface(8, 4, [bend](glm::vec2 at) {
        const float t = std::max(at.x, 0.001F);
        const float half = 0.34F * std::pow(std::sin(pi * std::pow(t, 0.75F)), 0.8F) + 0.004F;
        const float across = 2 * at.y - 1;
        const float droop = bend * t * t;
        return glm::vec3(t * (1 - 0.25F * bend * t),
                         0.10F * std::abs(across) * half / 0.34F - droop, half * across);
    }));
}

} // namespace

void add_fruit(SceneBuilder& build) {
    const glm::vec3 middle(0.3F, 0.03F, -0.08F);
    Mesh bowl = turned_shape(bowl_profile, 4, 64);
    paint(bowl, [](const Vertex& v) {
        const bool is_band = v.normal.x * v.position.x + v.normal.z * v.position.z > 0 &&
                             ((v.position.y > 0.205F && v.position.y < 0.235F) ||
                              (v.position.y > 0.15F && v.position.y < 0.165F));
        return is_band ? glm::vec3(0.035F, 0.07F, 0.27F) : glm::vec3(0.76F, 0.77F, 0.76F);
    });
    build.place(build.mesh(std::move(bowl)),
                build.material({.albedo = glm::vec3(1), .roughness = 0.12F}), at(middle));

    Mesh painted_apple = turned_shape(apple_profile, 3, 32);
    paint(painted_apple, apple_color);
    const auto apple = build.mesh(std::move(painted_apple));
    const auto round = build.mesh(ball(16));
    const auto lemon = build.mesh(turned_shape(lemon_profile, 3, 28));
    const auto pear = build.mesh(turned_shape(pear_profile, 3, 28));
    const auto stalk = build.mesh(cylinder(6));
    const TextureUse dents{.texture = build.texture(dented_normals(), false)};
    const auto skin = build.material({.albedo = glm::vec3(1), .roughness = 0.28F});
    const auto rind = build.material(
        {.albedo = {0.80F, 0.26F, 0.018F}, .roughness = 0.42F, .detail = {.normal = dents}});
    const auto zest = build.material(
        {.albedo = {0.80F, 0.58F, 0.035F}, .roughness = 0.4F, .detail = {.normal = dents}});
    const auto green = build.material({.albedo = {0.36F, 0.44F, 0.07F}, .roughness = 0.4F});
    const auto plum = build.material({.albedo = {0.075F, 0.014F, 0.06F}, .roughness = 0.34F});
    const auto twig = build.material({.albedo = {0.10F, 0.055F, 0.025F}, .roughness = 0.8F});
    const auto put = [&](std::uint32_t mesh, std::uint32_t material, glm::vec3 place, float size,
                         glm::vec3 axis, float degrees) {
        build.place(mesh, material,
                    turned(at(place), degrees, axis) * at({0, 0, 0}, glm::vec3(size)));
        if (mesh == apple || mesh == pear) {
            const float top = mesh == apple ? 0.8F : 1.7F;
            build.place(stalk, twig,
                        turned(at(place), degrees, axis) *
                            turned(at({0.0F, size * top, 0}, size * glm::vec3(0.03F, 0.22F, 0.03F)),
                                   14, {0, 0, 1}));
        }
    };
    put(apple, skin, middle + glm::vec3(-0.17F, 0.2F, 0.1F), 0.15F, {1, 0, 0.3F}, 24);
    put(apple, skin, middle + glm::vec3(0.03F, 0.2F, -0.19F), 0.15F, {0, 0, 1}, -20);
    put(round, rind, middle + glm::vec3(0.14F, 0.2F, 0.12F), 0.145F, {1, 1, 0}, 40);
    put(round, rind, middle + glm::vec3(-0.2F, 0.2F, -0.13F), 0.14F, {0, 1, 1}, 80);
    put(lemon, zest, middle + glm::vec3(0.0F, 0.33F, 0.0F), 0.105F, {0.2F, 0.3F, 1}, 74);
    put(pear, green, middle + glm::vec3(0.22F, 0.26F, -0.08F), 0.13F, {0.4F, 0, -1}, 28);
    put(round, plum, middle + glm::vec3(0.0F, 0.22F, 0.24F), 0.09F, {1, 0, 0}, 0);
    // And some beside the bowl.
    put(lemon, zest, {-0.38F, 0.115F, 0.62F}, 0.115F, {0.15F, 0.5F, 1}, 84);
    put(apple, skin, {-0.72F, 0.14F, 0.38F}, 0.165F, {0.3F, 1, 0.2F}, 150);
    put(round, plum, {0.84F, 0.095F, 0.10F}, 0.095F, {1, 0, 0}, 0);
    put(round, plum, {0.98F, 0.09F, -0.06F}, 0.09F, {1, 0, 0}, 60);
}

void add_vessels(SceneBuilder& build) {
    Mesh jug = turned_shape(jug_profile, 5, 64);
    repeat(jug, {3, 3});
    Material steel{.albedo = {0.58F, 0.575F, 0.56F}, .roughness = 0.24F, .metalness = 1};
    steel.detail.normal.texture = build.texture(brushed_normals(), false);
    const auto steel_paint = build.material(steel);
    const glm::vec3 jug_place(-0.42F, 0, -0.62F);
    build.place(build.mesh(std::move(jug)), steel_paint, at(jug_place));
    build.place(build.mesh(torus(0.1F, 40, 12)), steel_paint,
                turned(at(jug_place + glm::vec3(-0.2F, 0.46F, 0.04F)), 90, {1, 0, 0}) *
                    at({0, 0, 0}, {0.13F, 0.2F, 0.22F}));

    const auto glass = build.material({.albedo = {0.004F, 0.012F, 0.006F}, .roughness = 0.07F});
    const glm::vec3 bottle_place(0.92F, 0, -0.72F);
    build.place(build.mesh(turned_shape(bottle_profile, 4, 48)), glass, at(bottle_place));
    constexpr glm::vec2 label_profile[]{{0.17F, 0.2F}, {0.17F, 0.46F}};
    build.place(build.mesh(lathe(label_profile, 48)),
                build.material({.albedo = {0.70F, 0.64F, 0.50F}, .roughness = 0.85F}),
                at(bottle_place));
    constexpr glm::vec2 band_profile[]{{0.1708F, 0.4F}, {0.1708F, 0.43F}};
    build.place(build.mesh(lathe(band_profile, 48)),
                build.material({.albedo = linear_of(color_checker[14]), .roughness = 0.8F}),
                at(bottle_place), false);

    const auto copper =
        build.material({.albedo = {0.955F, 0.50F, 0.36F}, .roughness = 0.2F, .metalness = 1});
    const auto brass =
        build.material({.albedo = {0.91F, 0.72F, 0.36F}, .roughness = 0.26F, .metalness = 1});
    const glm::vec3 pan_place(1.36F, 0, -0.38F);
    build.place(build.mesh(turned_shape(pan_profile, 4, 64)), copper, at(pan_place));
    build.place(build.mesh(box({0.22F, 0.014F, 0.022F}, 0.012F, 3)), brass,
                turned(turned(at(pan_place + glm::vec3(0.27F, 0.30F, 0.42F)), -58, {0, 1, 0}), 8,
                       {0, 0, 1}));
    build.place(build.mesh(turned_shape(vase_profile, 4, 48)),
                build.material({.albedo = glm::vec3(0.012F), .roughness = 0.3F}),
                at({0.47F, 0, -1.08F}));
}

void add_plant(SceneBuilder& build) {
    const glm::vec3 place(-1.12F, 0, -0.92F);
    build.place(build.mesh(turned_shape(pot_profile, 3, 48)),
                build.material({.albedo = {0.44F, 0.17F, 0.085F}, .roughness = 0.85F}), at(place));
    std::array<std::uint32_t, 3> leaves{};
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        Mesh mesh = leaf(0.25F + 0.3F * static_cast<float>(i));
        paint(mesh, [](const Vertex& v) {
            const float rib = glm::smoothstep(0.0F, 0.03F, std::abs(v.position.z));
            return glm::mix(glm::vec3(0.30F, 0.36F, 0.10F), glm::vec3(0.055F, 0.17F, 0.03F), rib);
        });
        leaves[i] = build.mesh(std::move(mesh));
    }
    const auto green = build.material({.albedo = glm::vec3(1), .roughness = 0.36F});
    const auto stem = build.material({.albedo = {0.12F, 0.17F, 0.05F}, .roughness = 0.6F});
    const auto rod = build.mesh(cylinder(8));
    constexpr int count = 26;
    for (int i = 0; i < count; ++i) {
        const float share = static_cast<float>(i) / (count - 1);
        // The golden angle, as leaves stand in nature.
        const float around = 137.508F * static_cast<float>(i);
        const float size = 0.40F - 0.17F * share;
        const float height = 0.36F + 0.52F * share;
        const float lift = 12 + 52 * share + 12 * std::sin(static_cast<float>(i) * 2.3F);
        const glm::mat4 direction =
            turned(turned(at(place + glm::vec3(0, height, 0)), around, {0, 1, 0}), lift, {0, 0, 1});
        build.place(leaves[static_cast<std::size_t>(i) % leaves.size()], green,
                    direction * at({0.05F, 0, 0}, glm::vec3(size)));
    }
    build.place(rod, stem, at(place + glm::vec3(0, 0.6F, 0), {0.012F, 0.3F, 0.012F}));
}

void add_skins(SceneBuilder& build) {
    const auto round = build.mesh(ball(16));
    // From light to dark: measured means, one more than a deviation above and below, and darker
    // skin from the charts.
    const std::array<glm::vec3, 6> tones{
        linear_of_lab({70.0F, 9.5F, 14.5F}), linear_of(measured_skins[6]),
        linear_of(measured_skins[2]),        linear_of_lab({48.0F, 13.0F, 18.5F}),
        linear_of(color_checker[0]),         linear_of(skin_tones[8])};
    for (std::size_t i = 0; i < tones.size(); ++i) {
        const float t = static_cast<float>(i) / 5;
        const float size = 0.098F;
        build.place(round, build.material({.albedo = tones[i], .roughness = 0.46F}),
                    at({0.4F + 0.98F * t, size, 0.66F - 0.3F * t + 0.1F * std::sin(5 * t)},
                       glm::vec3(size)));
    }
}

void add_jewels(SceneBuilder& build) {
    const glm::mat4 pad = turned(at({-0.93F, 0.03F, 0.72F}), 24, {0, 1, 0});
    // The pile of velvet swallows what other surfaces mirror: as dark as things get.
    const auto velvet =
        build.material({.albedo = glm::vec3(0.003F), .roughness = 0.85F, .metalness = 1});
    build.place(build.mesh(box({0.25F, 0.03F, 0.18F}, 0.03F, 4)), velvet, pad);
    const auto pearl = build.material({.albedo = {0.74F, 0.69F, 0.62F}, .roughness = 0.16F});
    const auto gold =
        build.material({.albedo = {1.0F, 0.75F, 0.32F}, .roughness = 0.14F, .metalness = 1});
    const auto round = build.mesh(ball(8));
    constexpr int count = 22;
    for (int i = 0; i < count; ++i) {
        const float turn = 2 * pi * static_cast<float>(i) / count;
        const float away = 1 + 0.16F * std::sin(3 * turn + 1);
        build.place(round, pearl,
                    pad *
                        at({0.155F * away * std::cos(turn), 0.05F, 0.105F * away * std::sin(turn)},
                           glm::vec3(0.021F)));
    }
    build.place(build.mesh(torus(0.2F, 40, 12)), gold,
                pad * turned(at({0.01F, 0.042F, 0.0F}, glm::vec3(0.045F)), 12, {1, 0, 0}));
}

std::uint32_t add_candle(SceneBuilder& build, glm::vec3 tip) {
    const glm::vec3 foot(tip.x, 0, tip.z);
    const auto brass =
        build.material({.albedo = {0.91F, 0.72F, 0.36F}, .roughness = 0.22F, .metalness = 1});
    build.place(build.mesh(turned_shape(stick_profile, 4, 40)), brass, at(foot));
    build.place(build.mesh(turned_shape(candle_profile, 3, 24)),
                build.material({.albedo = {0.80F, 0.75F, 0.62F}, .roughness = 0.5F}),
                at(foot + glm::vec3(0, 0.38F, 0)), false);
    const auto glow =
        build.material({.albedo = glm::vec3(0), .roughness = 1, .emission = {60, 27, 6.5F}});
    return build.place(build.mesh(turned_shape(flame_profile, 4, 12)), glow,
                       at(tip, glm::vec3(0.022F)), false);
}

} // namespace preview
