#include "lutlib/io/text_formats.h"

#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"

#include <array>
#include <charconv>

namespace lutlib::io {
namespace {

void append(std::string& out, float value) {
    std::array<char, 32> text;
    out.append(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr);
}

void append_row(std::string& out, const Rgb& row) {
    append(out, row.r);
    out += ' ';
    append(out, row.g);
    out += ' ';
    append(out, row.b);
    out += '\n';
}

void append_rows(std::string& out, const std::vector<Rgb>& rows) {
    for (const Rgb& row : rows) {
        append_row(out, row);
    }
}

std::string triple(int n) {
    const std::string text = std::to_string(n);
    return text + ' ' + text + ' ' + text + '\n';
}

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
            append(out, static_cast<float>(point.*side));
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

} // namespace

std::string write_spi1d(const Lut& lut, const WriteOptions& /*options*/) {
    validate(lut);
    if (!lut.shaper || lut.cube) {
        throw Error("an .spi1d file holds one curve and nothing else");
    }
    const Domain& domain = lut.shaper->domain;
    if (domain.min != Rgb{domain.min.r, domain.min.r, domain.min.r} ||
        domain.max != Rgb{domain.max.r, domain.max.r, domain.max.r}) {
        throw Error("an .spi1d file has one input range for all channels; this look's differ");
    }
    std::string out = "Version 1\nFrom ";
    append(out, domain.min.r);
    out += ' ';
    append(out, domain.max.r);
    out += "\nLength " + std::to_string(lut.shaper->size()) + "\nComponents 3\n{\n";
    append_rows(out, lut.shaper->entries);
    return out + "}\n";
}

std::string write_spi3d(const Lut& lut, const WriteOptions& /*options*/) {
    validate(lut);
    if (!lut.cube || lut.shaper || !lut.cube->domain.is_unit()) {
        throw Error("an .spi3d file holds one cube of input 0..1 and nothing else");
    }
    std::string out = "SPILUT 1.0\n3 3\n" + triple(lut.cube->size);
    // Blue fastest, as the format's own files are; the indices say it anyway.
    for (int r = 0; r < lut.cube->size; ++r) {
        for (int g = 0; g < lut.cube->size; ++g) {
            for (int b = 0; b < lut.cube->size; ++b) {
                out += std::to_string(r) + ' ' + std::to_string(g) + ' ' + std::to_string(b) + ' ';
                append_row(out, lut.cube->at(r, g, b));
            }
        }
    }
    return out;
}

std::string write_csp(const Lut& lut, const WriteOptions& options) {
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
        out += triple(lut.cube->size);
        append_rows(out, lut.cube->nodes);
    } else {
        out += std::to_string(lut.shaper->size()) + '\n';
        append_rows(out, lut.shaper->entries);
    }
    return out;
}

} // namespace lutlib::io
