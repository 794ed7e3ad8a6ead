#include "converter/examples.h"

#include "lutlib/named.h"

namespace converter {
namespace {

struct Examples {
    std::string_view name, lines;
};

constexpr Examples table[] = {
    {"bake", "lutconv bake look.cube -o strip.png\n"
             "lutconv bake look.cube -o strip.png --engine unreal --measure\n"
             "lutconv bake looks --engine unity,unreal -o out/{name}.{engine}.png\n"
             "lutconv bake look.json -o strip.png --watch\n"
             "lutconv bake day.cube night.cube --stack -o multi.png\n"},
    {"verify", "lutconv verify strip.png --against look.cube --engine unreal\n"
               "lutconv verify strip.png --against look.json --json\n"},
    {"check", "lutconv check look.cube --strict\n"
              "lutconv check broken.cube --repair --clamp -o repaired.cube\n"},
    {"convert", "lutconv convert look.3dl -o look.cube\n"
                "lutconv convert strip.png -o look.cube\n"
                "lutconv convert wide.cube -o look.spi3d --strict\n"
                "lutconv convert their.3dl -o look.cube --watch\n"},
    {"edit", "lutconv edit identity -o look.cube --saturation 1.3 --save-recipe look.json\n"
             "lutconv edit their.cube -o warmer.cube --temperature 7200\n"
             "lutconv edit identity -o look.cube --cdl-file shots.ccc --cdl-id sh010\n"
             "lutconv edit look.json --save-cdl shots.ccc --save-cdl-id sh020\n"},
    {"resample", "lutconv resample look.cube -o small.cube --size 17\n"},
    {"compose", "lutconv compose first.cube second.cube -o both.cube\n"},
    {"invert", "lutconv invert look.cube -o undo.cube\n"},
    {"blend", "lutconv blend a.cube b.cube --amount 0.3 -o mixed.cube\n"},
    {"compare", "lutconv compare a.cube b.cube\n"
                "lutconv compare look.cube identity --max-delta-e 2\n"},
    {"extract", "lutconv extract graded.png -o look.cube\n"
                "lutconv extract graded.png --original shot.png --denoise -o look.cube\n"
                "lutconv extract graded.png --engine unity -o strip.png\n"},
    {"match", "lutconv match before.png after.png -o look.cube\n"
              "lutconv match plate.####.exr graded.####.png -o look.cube\n"
              "lutconv match photo.png --chart-before 40,30,240,160 -o look.cube\n"},
    {"apply", "lutconv apply look.cube picture.exr -o graded.exr --picture-encoding linear\n"
              "lutconv apply look.cube shot.####.exr -o graded/{name}.{ext}\n"},
    {"sheet", "lutconv sheet picture.exr looks -o sheet.png\n"
              "lutconv sheet picture.png a.cube b.cube --engine unity -o sheet.png\n"},
    {"show", "lutconv show look.cube -o look.png\n"
             "lutconv show a.cube b.cube -o both.html\n"
             "lutconv show look.json --panels curves,slopes -o curves.svg\n"},
    {"report", "lutconv report look.cube -o report.html\n"
               "lutconv report --suite stiff -o stiff.html\n"},
    {"engines", "lutconv engines\n"
                "lutconv engines --page unreal\n"},
    {"shader", "lutconv shader --engine unreal --language hlsl -o lut.hlsl\n"
               "lutconv shader --inline look.cube --max-delta-e 2 --language glsl -o look.glsl\n"},
    {"info", "lutconv info look.cube\n"},
    {"encodings", "lutconv encodings\n"
                  "lutconv encodings --json\n"},
    {"operators", "lutconv operators\n"
                  "lutconv operators --json\n"},
    {"formats", "lutconv formats\n"},
    {"eval", "lutconv eval look.cube 0.18 0.18 0.18\n"},
    {"identity", "lutconv identity --size 33 -o identity.cube\n"
                 "lutconv identity --engine unreal --into shot.png -o for_grading.png\n"},
};

} // namespace

std::string_view examples_of(std::string_view verb) {
    const Examples* const row = lutlib::find_named(table, verb);
    return row ? row->lines : std::string_view();
}

} // namespace converter
