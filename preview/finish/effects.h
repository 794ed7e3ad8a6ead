// The parts that every frame has and that can be switched off, as a table: the command line, the
// panel of passes and the frame's explanation follow it. What may be laid over a frame beside them
// is in preview/effects/.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace preview {

enum class Effect : std::uint8_t {
    lights,
    shadows,
    environment,
    occlusion,
    specular_aa,
    floor,
    bloom,
    tonemap,
    looks,
    names,
};

struct EffectInfo {
    Effect effect;
    std::string_view name;
    std::string_view label;
    std::string_view help; ///< what the frame does without it
};

/// In the order of the enumeration, which is that of the frame.
inline constexpr std::array<EffectInfo, 10> effects{{
    {Effect::lights, "lights", "Lights", "no light of the scene shines, and none casts a shadow"},
    {Effect::shadows, "shadows", "Shadows", "lights shine through everything"},
    {Effect::environment, "environment", "Surroundings", "the surroundings are black"},
    {Effect::occlusion, "occlusion", "Ambient occlusion",
     "light of the surroundings reaches every corner"},
    {Effect::specular_aa, "specular-aa", "Specular antialiasing",
     "highlights of what is curved within a pixel glitter"},
    {Effect::floor, "floor", "Floor", "a model that has no floor of its own gets none"},
    {Effect::bloom, "bloom", "Bloom", "bright light does not spread"},
    {Effect::tonemap, "tonemap", "Tone map", "light above 1 is clipped"},
    {Effect::looks, "looks", "Looks", "both sides show the picture without a LUT"},
    {Effect::names, "names", "Names", "a comparison does not name its looks"},
}};

/// Some of the effects.
class EffectSet {
  public:
    constexpr bool has(Effect effect) const { return (bits_ >> index(effect) & 1U) != 0; }
    constexpr void set(Effect effect, bool is_in) {
        bits_ = (bits_ & ~(1U << index(effect))) | (is_in ? 1U << index(effect) : 0U);
    }
    friend constexpr bool operator==(EffectSet, EffectSet) = default;

  private:
    static constexpr unsigned index(Effect effect) { return static_cast<unsigned>(effect); }
    std::uint32_t bits_ = 0;
};

} // namespace preview
