// A look of two operators, one of them a curve over hues, as a recipe and as a LUT of any format:
// recipe LOOK.json LOOK.cube
#include <lutlib/io/file.h>
#include <lutlib/io/formats.h>
#include <lutlib/recipe/bake_recipe.h>

#include <cstdio>

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("recipe LOOK.json LOOK.cube\n", stderr);
        return 3;
    }
    lutlib::Recipe recipe;
    recipe.title = "Warm, with calm greens";

    lutlib::Operation white_balance = lutlib::default_operation(*lutlib::op_named("white-balance"));
    white_balance.values[0] = 5600.0; // kelvin
    // Hue in degrees, red at 0, and the factor on saturation there.
    lutlib::Operation calm = lutlib::default_operation(*lutlib::op_named("hue-vs-sat"));
    calm.values[0] = lutlib::Knots{{0, 1.1}, {120, 0.6}, {240, 1}};
    recipe.operations = {white_balance, calm};

    lutlib::io::write_file(argv[1], lutlib::to_json(recipe));
    const auto written = lutlib::io::write_lut(argv[2], lutlib::bake_recipe(recipe));
    for (const lutlib::Loss& loss : written.losses) {
        std::printf("lost: %s (%g %s)\n", loss.what.c_str(), loss.figure, loss.unit.c_str());
    }
}
