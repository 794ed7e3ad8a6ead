// Any bytes as a recipe: read or refused with an Error; what was read is written and read back the
// same, and answers colours of every kind.
#include "lutlib/error.h"
#include "lutlib/recipe/recipe.h"
#include "lutlib/transform.h"

#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <utility>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        lutlib::Recipe recipe = lutlib::parse_recipe(bytes, "fuzz.json");
        const std::string text = to_json(recipe);
        if (to_json(lutlib::parse_recipe(text, "again.json")) != text) {
            std::abort();
        }
        if (!recipe.base.empty()) {
            lutlib::Lut base;
            base.cube = lutlib::identity_cube(2);
            recipe.base_lut = std::make_shared<const lutlib::Lut>(std::move(base));
        }
        const lutlib::Transform edit = lutlib::Transform::of(recipe);
        constexpr double inf = std::numeric_limits<double>::infinity();
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        for (const double x : {0.0, 0.18, 1.0, -0.5, 1e-40, 1e30, -inf, nan}) {
            edit(lutlib::RgbD{x, 0.3, 0.7});
            edit(lutlib::RgbD{0.5, x, x});
        }
    } catch (const lutlib::Error&) {
    }
    return 0;
}
