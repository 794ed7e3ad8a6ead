// cineSpace .csp: a prelut and a table.
//
//   "CSPLUTV100" / "1D" or "3D" / "BEGIN METADATA" .. "END METADATA" / three preluts, each: n / n
//   inputs / n outputs / then either n and n rows r g b, or N N N and N^3 rows, red fastest. A
//   prelut is piecewise and takes the look's domain, or its shaper, to 0..1.
//
// OpenColorIO reads it; we write the shortest decimals that read back bit-identically. Source:
// Rising Sun Research, "cineSpace LUT file format" (2008).

#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/io/formats/all.h"
#include "lutlib/io/formats/opencolorio.h"
#include "lutlib/number_text.h"
#include "lutlib/text.h"

namespace lutlib::formats {
namespace {

// Comments and titles are single lines of the metadata block.
std::string one_line(std::string text) {
    for (char& c : text) {
        c = c == '\n' || c == '\r' ? ' ' : c;
    }
    return text;
}

constexpr int least_prelut_points = 8192;

struct PrelutPoint {
    double in, out;
};

void append_prelut(std::string& out, const std::vector<PrelutPoint>& points) {
    out += std::to_string(points.size()) + '\n';
    for (const auto side : {&PrelutPoint::in, &PrelutPoint::out}) {
        for (const PrelutPoint& point : points) {
            append_number(out, static_cast<float>(point.*side), Exponents::allowed);
            out += ' ';
        }
        out.back() = '\n';
    }
}

// What stands before the table in one channel: its domain alone, or the shaper onto its domain.
std::vector<PrelutPoint> prelut(const Lut& lut, std::size_t channel) {
    const Domain& domain = lut.domain();
    if (!lut.shaper || !lut.cube) {
        return {{domain.min[channel], 0}, {domain.max[channel], 1}};
    }
    const double min = lut.cube->domain.min[channel];
    const double width = static_cast<double>(lut.cube->domain.max[channel]) - min;
    // Readers lay a smooth curve through the points; many on each straight piece keep it straight.
    const int pieces = lut.shaper->size() - 1;
    const int points_a_piece = (least_prelut_points + pieces - 1) / pieces;
    std::vector<PrelutPoint> points;
    for (int i = 0; i <= pieces * points_a_piece; ++i) {
        const double t = static_cast<double>(i) / (pieces * points_a_piece);
        const double low = lut.shaper->domain.min[channel];
        const double in = low + t * (static_cast<double>(lut.shaper->domain.max[channel]) - low);
        const double entry = evaluate_exact(*lut.shaper, {in, in, in})[channel];
        points.push_back({in, (entry - min) / width});
    }
    return points;
}

std::string write_csp(const FileFormat& /*format*/, const Lut& lut, const WriteOptions& options) {
    validate(lut);
    if (!lut.shaper && !lut.cube) {
        throw Error("a .csp file needs a table; bake the identity to a size first");
    }
    std::string out = "CSPLUTV100\n";
    out += lut.cube ? "3D\n\n" : "1D\n\n";
    const std::string& title = options.title.empty() ? lut.title : options.title;
    out += "BEGIN METADATA\n";
    out += title.empty() ? "" : one_line(title) + '\n';
    for (const std::string& comment : lut.comments) {
        out += one_line(comment) + '\n';
    }
    out += "END METADATA\n\n";
    for (std::size_t channel = 0; channel < 3; ++channel) {
        append_prelut(out, prelut(lut, channel));
    }
    out += '\n';
    if (lut.cube) {
        const std::string n = std::to_string(lut.cube->size);
        out += n + ' ' + n + ' ' + n + '\n';
        append_rows(out, lut.cube->nodes, Exponents::allowed);
    } else {
        out += std::to_string(lut.shaper->size()) + '\n';
        append_rows(out, lut.shaper->entries, Exponents::allowed);
    }
    return out;
}

} // namespace

constinit const FileFormat csp = read_by_opencolorio({
    .name = "csp",
    .label = "cineSpace .csp: prelut and table",
    .extensions = {"csp"},
    .holds = {.curve = true,
              .cube = true,
              .curve_and_cube = true,
              .curve_domain = true,
              .cube_domain = true,
              .per_channel_domain = true,
              .title = true},
    .magic = "CSPLUTV100",
    .write = write_csp,
});

} // namespace lutlib::formats
