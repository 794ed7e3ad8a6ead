#include "lutlib/error.h"
#include "lutlib/formats/all.h"
#include "lutlib/formats/cube.h"
#include "lutlib/formats/encoding_comment.h"
#include "lutlib/limits.h"
#include "lutlib/number_text.h"
#include "lutlib/text.h"

#include <algorithm>

namespace lutlib {
namespace {

// Some readers know no exponents.
constexpr Exponents exponents = Exponents::rare;

bool equal_channels(const Rgb& c) {
    return c.r == c.g && c.g == c.b;
}

bool scalar(const Domain& d) {
    return equal_channels(d.min) && equal_channels(d.max);
}

void append_domain(std::string& out, const Domain& domain) {
    if (domain.is_unit()) {
        return;
    }
    out += "DOMAIN_MIN ";
    append_row(out, domain.min, exponents);
    out += "DOMAIN_MAX ";
    append_row(out, domain.max, exponents);
}

void append_range(std::string& out, std::string_view keyword, const Domain& domain) {
    if (!scalar(domain)) {
        throw Error("the Resolve dialect has one input range for all channels; this look's differ");
    }
    out += keyword;
    out += ' ';
    append_number(out, domain.min.r, exponents);
    out += ' ';
    append_number(out, domain.max.r, exponents);
    out += '\n';
}

// Resolve's dialect knows no TITLE, and OpenColorIO refuses a file of it that has one; there the
// title is a comment, which our reader knows again. It stands first, so that no other comment is
// taken for it.
void append_head(std::string& out, const Lut& lut, CubeDialect dialect,
                 const WriteOptions& options) {
    const auto one_line = [](std::string text) {
        for (char& c : text) {
            c = (c == '\n' || c == '\r' || c == '\0') ? ' ' : c;
        }
        return text;
    };
    std::string title = one_line(options.title.empty() ? lut.title : options.title);
    for (char& c : title) {
        c = c == '"' ? '\'' : c;
    }
    if (title.size() > limits::max_title_bytes) {
        throw Error("the title has " + std::to_string(title.size()) + " bytes; a .cube takes " +
                    std::to_string(limits::max_title_bytes));
    }
    if (!title.empty()) {
        out += dialect == CubeDialect::resolve ? "# " : "";
        out += "TITLE \"" + title + "\"\n";
    }
    for (const std::string& comment : encoding_comments(lut.encodings)) {
        out += "# " + one_line(comment) + '\n';
    }
    for (const std::string& comment : lut.comments) {
        out += is_superseded(comment, lut.encodings) ? "" : "# " + one_line(comment) + '\n';
    }
    for (const std::string& keyword : lut.keywords) {
        out += one_line(keyword) + '\n';
    }
}

bool head_has(std::string_view bytes, std::string_view keyword) {
    const std::string_view head = bytes.substr(0, FileFormat::head_bytes);
    const auto same = [](char a, char b) { return upper(a) == b; };
    return std::search(head.begin(), head.end(), keyword.begin(), keyword.end(), same) !=
           head.end();
}

int recognise(std::string_view bytes) {
    return head_has(bytes, "LUT_3D_SIZE") || head_has(bytes, "LUT_1D_SIZE") ? 90 : 0;
}

int recognise_resolve(std::string_view bytes) {
    return recognise(bytes) == 0 ? 0 : head_has(bytes, "D_INPUT_RANGE") ? 95 : 80;
}

Reading read_cube_row(const FileFormat& /*format*/, std::string_view bytes, const std::string& file,
                      const ReadOptions& /*options*/) {
    return {.lut = read_cube(bytes, file)};
}

} // namespace

std::string write_cube(const Lut& lut, CubeDialect dialect, const WriteOptions& options) {
    validate(lut);
    if (!lut.shaper && !lut.cube) {
        throw Error("a .cube needs a table; bake the identity to a size first");
    }
    if (dialect == CubeDialect::adobe && lut.shaper && lut.cube) {
        throw Error("the Adobe dialect holds a shaper or a cube, not both; use " +
                    std::string(formats::cube_resolve.name));
    }
    std::string out;
    const std::size_t rows =
        (lut.cube ? lut.cube->nodes.size() : 0) + (lut.shaper ? lut.shaper->entries.size() : 0);
    out.reserve(1024 + rows * 34);
    append_head(out, lut, dialect, options);
    const bool resolve = dialect == CubeDialect::resolve;
    if (lut.shaper) {
        out += "LUT_1D_SIZE " + std::to_string(lut.shaper->size()) + '\n';
        resolve ? append_range(out, "LUT_1D_INPUT_RANGE", lut.shaper->domain)
                : append_domain(out, lut.shaper->domain);
    }
    if (lut.cube) {
        out += "LUT_3D_SIZE " + std::to_string(lut.cube->size) + '\n';
        resolve ? append_range(out, "LUT_3D_INPUT_RANGE", lut.cube->domain)
                : append_domain(out, lut.cube->domain);
    }
    if (lut.shaper) {
        append_rows(out, lut.shaper->entries, exponents);
    }
    if (lut.cube) {
        append_rows(out, lut.cube->nodes, exponents);
    }
    return out;
}

CubeDialect best_dialect(const Lut& lut) {
    return lut.shaper && lut.cube ? CubeDialect::resolve : CubeDialect::adobe;
}

constinit const FileFormat formats::cube{
    .name = "cube",
    .label = "Adobe/Iridas .cube: a 1D or a 3D table with its domain",
    .extensions = {"cube"},
    .holds = {.curve = true,
              .cube = true,
              .curve_domain = true,
              .cube_domain = true,
              .per_channel_domain = true,
              .title = true,
              .keywords = true,
              .encodings = true},
    .recognise = recognise,
    .read = read_cube_row,
    .read_in_pieces = read_cube_in_pieces,
    .read_broken = read_broken_cube,
    .write =
        [](const FileFormat& /*format*/, const Lut& lut, const WriteOptions& options) {
            return write_cube(lut, CubeDialect::adobe, options);
        },
};

constinit const FileFormat formats::cube_resolve{
    .name = "cube-resolve",
    .label = "Resolve .cube: a 1D shaper, a 3D table or both, with their input ranges",
    .extensions = {"cube"},
    .holds = {.curve = true,
              .cube = true,
              .curve_and_cube = true,
              .curve_domain = true,
              .cube_domain = true,
              .title = true,
              .keywords = true,
              .encodings = true},
    .recognise = recognise_resolve,
    .read = read_cube_row,
    .read_in_pieces = read_cube_in_pieces,
    .read_broken = read_broken_cube,
    .write =
        [](const FileFormat& /*format*/, const Lut& lut, const WriteOptions& options) {
            return write_cube(lut, CubeDialect::resolve, options);
        },
};

} // namespace lutlib
