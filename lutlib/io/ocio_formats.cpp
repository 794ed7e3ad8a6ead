#include "lutlib/io/ocio_formats.h"

#include "lutlib/io/text_formats.h"

#include <array>

namespace lutlib::io {
namespace {

template <std::size_t n>
using Extensions = std::array<std::string_view, n>;
constexpr Extensions<1> threedl{"3dl"}, cc{"cc"}, ccc{"ccc"}, cdl{"cdl"}, clf{"clf"}, csp{"csp"},
    ctf{"ctf"}, cub{"cub"}, cube{"cube"}, itx{"itx"}, look{"look"}, lut{"lut"}, m3d{"m3d"},
    mga{"mga"}, spi1d{"spi1d"}, spi3d{"spi3d"}, spimtx{"spimtx"}, vf{"vf"};
constexpr Extensions<3> icc{"icc", "icm", "pf"};

constexpr Holds nothing{};
constexpr Holds everything{.curve = true,
                           .cube = true,
                           .curve_and_cube = true,
                           .curve_domain = true,
                           .cube_domain = true,
                           .per_channel_domain = true,
                           .title = true};
constexpr Holds unit_curve_of_one_range{.curve = true, .curve_domain = true};
constexpr Holds unit_cube{.cube = true};
constexpr Holds unit_cube_6{.cube = true, .decimals = 6};
constexpr Holds unit_cube_12_bits{.cube = true, .integer_bits = 12};

// `magic` is empty where a format has no mark of its own; its extension then decides.
constexpr std::array<OcioFormat, 23> table{{
    {"flame", "Autodesk Flame .3dl: a cube of integer codes", threedl, "", true, "flame", nullptr,
     unit_cube_12_bits},
    {"lustre", "Autodesk Lustre .3dl: a cube of integer codes with a mesh header", threedl,
     "3DMESH", true, "lustre", nullptr, unit_cube_12_bits},
    {"csp", "cineSpace .csp: prelut and table", csp, "CSPLUTV100", true, "", write_csp, everything},
    {"spi1d", "Imageworks .spi1d: a curve", spi1d, "Components", true, "", write_spi1d,
     unit_curve_of_one_range},
    {"spi3d", "Imageworks .spi3d: a cube", spi3d, "SPILUT", true, "", write_spi3d, unit_cube},
    {"clf", "Academy/ASC Common LUT Format: operators, curves and cubes", clf, "compCLFversion",
     true, "Academy/ASC Common LUT Format", nullptr, everything},
    {"ctf", "Autodesk Color Transform Format: operators, curves and cubes", ctf, "<ProcessList",
     true, "Color Transform Format", nullptr, everything},
    {"cc", "ASC ColorCorrection: slope, offset, power, saturation", cc, "<ColorCorrection ", true,
     "", nullptr, nothing},
    {"ccc", "ASC ColorCorrectionCollection: its first correction", ccc,
     "<ColorCorrectionCollection", true, "", nullptr, nothing},
    {"cdl", "ASC ColorDecisionList: its first decision", cdl, "<ColorDecisionList", true, "",
     nullptr, nothing},
    {"look", "Iridas .look: a cube in XML", look, "<look", true, "", nullptr, nothing},
    {"itx", "Iridas .itx: a cube", itx, "", true, "iridas_itx", nullptr, unit_cube_6},
    {"vf", "Nuke .vf: a cube with a matrix", vf, "#Inventor V2.1", true, "", nullptr, nothing},
    {"mga", "Pandora .mga: a cube of integer codes", mga, "", true, "", nullptr, nothing},
    {"m3d", "Pandora .m3d: a cube of integer codes", m3d, "", true, "", nullptr, nothing},
    {"icc", "ICC profile: matrix and curves", icc, "", true, "", nullptr, nothing},
    {"houdini", "Houdini .lut: a cube", lut, "", true, "houdini", nullptr, unit_cube_6},
    {"discreet", "Discreet 1D .lut: a curve of integer codes", lut, "", true, "", nullptr, nothing},
    {"truelight", "Truelight .cub: a cube", cub, "# Truelight Cube", true, "truelight", nullptr,
     unit_cube_6},
    {"spimtx", "Imageworks .spimtx: a matrix", spimtx, "", true, "", nullptr, nothing},
    {"ocio-iridas-cube", "OpenColorIO's own writer of Iridas .cube, for comparison", cube, "",
     false, "iridas_cube", nullptr, unit_cube_6},
    {"ocio-resolve-cube", "OpenColorIO's own writer of Resolve .cube, for comparison", cube, "",
     false, "resolve_cube", nullptr, unit_cube_6},
    {"ocio-csp", "OpenColorIO's own writer of cineSpace .csp, for comparison", csp, "", false,
     "cinespace", nullptr, unit_cube_6},
}};

} // namespace

std::span<const OcioFormat> ocio_formats() {
    return table;
}

} // namespace lutlib::io
