#include "lutlib/io/formats/opencolorio.h"

#include "lutlib/error.h"
#include "lutlib/formats/integer_codes.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats/all.h"
#include "lutlib/io/ocio.h"
#include "lutlib/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

namespace lutlib::formats {
namespace {

constexpr Holds operators_and_tables{.curve = true,
                                     .cube = true,
                                     .curve_and_cube = true,
                                     .curve_domain = true,
                                     .cube_domain = true,
                                     .per_channel_domain = true,
                                     .title = true,
                                     .encodings = true,
                                     .interpolation = true};
constexpr Holds unit_cube_of_6_decimals{.cube = true, .decimals = 6};

// OpenColorIO tries all its readers on a file that the one for its name refuses, and that of .csp
// looks for the end of the metadata without end.
void refuse_endless_metadata(std::string_view bytes, const std::string& file) {
    LineScanner lines(bytes);
    bool is_csp = false;
    std::size_t begun = 0;
    for (std::string_view line; lines.next(line);) {
        const std::string words = upper(trimmed(line));
        if (!is_csp && !words.empty()) {
            is_csp = words.starts_with("CSPLUTV100");
            if (!is_csp) {
                return;
            }
        } else if (words == "BEGIN METADATA" && begun == 0) {
            begun = lines.line_number();
        } else if (words == "END METADATA") {
            return;
        }
    }
    if (begun > 0) {
        throw Error(
            "BEGIN METADATA without END METADATA: the file is cut short or damaged; fetch or "
            "export it again",
            {file, begun, {}});
    }
}

// The first line that is neither blank nor a comment: "LUT:", the number of tables, their length.
std::string_view discreet_head(std::string_view bytes) {
    LineScanner lines(bytes);
    std::string_view line;
    while (lines.next(line) && (trimmed(line).empty() || trimmed(line).front() == '#')) {
    }
    return trimmed(line);
}

int recognise_discreet(std::string_view bytes) {
    const Words words = words_of(discreet_head(bytes.substr(0, 4096)));
    return upper(words.items[0]) == "LUT:" && words.count >= 3 ? 80 : 0;
}

// The depth of its codes stands behind the table's sizes ("LUT: 1 1024 256"), else behind "to" in
// the file's name (12to10log.lut); else OpenColorIO takes them for as many bits as the table has
// entries.
struct Declaration {
    bool known;
    std::string note; ///< where the depth is known from, unless it stands in the file
};
Declaration depth_declared(std::string_view bytes, const std::string& file) {
    if (words_of(discreet_head(bytes)).count > 3) {
        return {true, {}};
    }
    const std::string name = upper(std::filesystem::path(file).stem().string());
    const std::size_t to = name.find("TO");
    const std::string digits = to == std::string::npos ? "" : name.substr(to + 2, 2);
    const bool known = digits.starts_with('8') || digits == "10" || digits == "12" ||
                       digits == "16" || digits == "32";
    return {known, known ? "the codes' depth is read from the file's name, which says to " +
                               (digits.front() == '8' ? "8" : digits) + " bits"
                         : "no depth of the codes is declared: guessed to be that of the input, "
                           "by the number of entries"};
}

// Codes beyond the depth of the input, of which nothing else is declared, have a depth of their
// own. Answers what is to be said of that; nothing where all fit.
std::string scale_codes_beyond(Lut1D& table) {
    const double top = static_cast<double>(table.entries.size()) - 1;
    double largest = 0;
    for (const Rgb& entry : table.entries) {
        largest = std::max({largest, entry.r * top, entry.g * top, entry.b * top});
    }
    const std::optional<int> bits = depth_of_codes(std::round(largest));
    if (!(std::round(largest) > top) || !bits) {
        return {};
    }
    const auto scale = static_cast<float>(top / largest_code(*bits));
    for (Rgb& entry : table.entries) {
        entry = entry * scale;
    }
    return "no depth of the codes is declared: guessed to be " + std::to_string(*bits) +
           " bits by the largest, " + std::to_string(std::lround(largest)) +
           ", as the input's has none so large";
}

Reading read_discreet(const FileFormat& format, std::string_view bytes, const std::string& file,
                      const ReadOptions& options) {
    Reading out = read_with_opencolorio(format, bytes, file, options);
    const Declaration declared = depth_declared(bytes, file);
    std::string note = declared.note;
    if (!declared.known && out.lut.shaper && !out.lut.cube) {
        if (const std::string beyond = scale_codes_beyond(*out.lut.shaper); !beyond.empty()) {
            note = beyond;
            out.table_losses.clear(); // rounding of values far above 1
        }
    }
    if (!note.empty()) {
        out.lut.notes.push_back(std::move(note));
    }
    return out;
}

// The text of an element in the head of an XML file, before its first table.
std::string element_text(std::string_view bytes, std::string_view name) {
    const std::string_view head = bytes.substr(0, std::min<std::size_t>(bytes.size(), 1U << 16));
    const std::string open = '<' + std::string(name) + '>', close = "</" + std::string(name) + '>';
    const std::size_t from = head.find(open);
    const std::size_t to = from == std::string_view::npos ? from : head.find(close, from);
    return to == std::string_view::npos
               ? std::string()
               : std::string(trimmed(head.substr(from + open.size(), to - from - open.size())));
}

// XML without its comments; line ends stay.
std::string without_comments(std::string_view bytes) {
    std::string out;
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t begin = bytes.find("<!--", at);
        out += bytes.substr(at, begin - at);
        const std::size_t end = begin == bytes.npos ? begin : bytes.find("-->", begin);
        at = end == bytes.npos ? bytes.size() : end + 3;
        const std::string_view comment =
            begin == bytes.npos ? std::string_view{} : bytes.substr(begin, at - begin);
        out.append(static_cast<std::size_t>(std::count(comment.begin(), comment.end(), '\n')),
                   '\n');
    }
    return out;
}

// OpenColorIO takes a table without values for the identity.
void require_arrays(std::string_view bytes, const std::string& file) {
    const std::string text = without_comments(bytes);
    for (const std::string table : {"LUT1D", "LUT3D"}) {
        for (std::size_t at = text.find('<' + table); at != text.npos;
             at = text.find('<' + table, at + 1)) {
            const std::size_t end = std::min(text.find("</" + table, at), text.size());
            if (text.substr(at, end - at).find("<Array") == text.npos) {
                const auto line =
                    std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
                throw Error("the table " + table +
                                " has no Array of values: the file is cut short or damaged; fetch "
                                "or export it again",
                            {file, static_cast<std::size_t>(line) + 1, {}});
            }
        }
    }
}

// Descriptors are free text: whoever uses them says which he knows.
Reading read_process_list(const FileFormat& format, std::string_view bytes, const std::string& file,
                          const ReadOptions& options) {
    require_arrays(bytes, file);
    Reading out = read_with_opencolorio(format, bytes, file, options);
    out.lut.encodings = {element_text(bytes, "InputDescriptor"),
                         element_text(bytes, "OutputDescriptor")};
    return out;
}

constexpr FileFormat read_by(decltype(FileFormat::read) read, FileFormat row) {
    row.read = read;
    return row;
}

// Without a magic text the extension decides.
constexpr auto rows = std::to_array<FileFormat>({
    read_by(read_process_list,
            read_by_opencolorio({
                .name = "clf",
                .label = "Academy/ASC Common LUT Format: operators, curves and cubes",
                .extensions = {"clf"},
                .holds = operators_and_tables,
                .magic = "compCLFversion",
                .opencolorio_writer = "Academy/ASC Common LUT Format",
            })),
    read_by(read_process_list,
            read_by_opencolorio({
                .name = "ctf",
                .label = "Autodesk Color Transform Format: operators, curves and cubes",
                .extensions = {"ctf"},
                .holds = operators_and_tables,
                .magic = "<ProcessList",
                .opencolorio_writer = "Color Transform Format",
            })),
    read_by_opencolorio({
        .name = "cc",
        .label = "ASC ColorCorrection: slope, offset, power, saturation",
        .extensions = {"cc"},
        .holds = {},
        .magic = "<ColorCorrection ",
    }),
    read_by_opencolorio({
        .name = "ccc",
        .label = "ASC ColorCorrectionCollection: its first correction",
        .extensions = {"ccc"},
        .holds = {},
        .magic = "<ColorCorrectionCollection",
    }),
    read_by_opencolorio({
        .name = "cdl",
        .label = "ASC ColorDecisionList: its first decision",
        .extensions = {"cdl"},
        .holds = {},
        .magic = "<ColorDecisionList",
    }),
    read_by_opencolorio({
        .name = "look",
        .label = "Iridas .look: a cube in XML",
        .extensions = {"look"},
        .holds = {},
        .magic = "<look",
    }),
    read_by_opencolorio({
        .name = "itx",
        .label = "Iridas .itx: a cube",
        .extensions = {"itx"},
        .holds = unit_cube_of_6_decimals,
        .opencolorio_writer = "iridas_itx",
    }),
    read_by_opencolorio({
        .name = "vf",
        .label = "Nuke .vf: a cube with a matrix",
        .extensions = {"vf"},
        .holds = {},
        .magic = "#Inventor V2.1",
    }),
    read_by_opencolorio({
        .name = "mga",
        .label = "Pandora .mga: a cube of integer codes",
        .extensions = {"mga"},
        .holds = {},
    }),
    read_by_opencolorio({
        .name = "m3d",
        .label = "Pandora .m3d: a cube of integer codes",
        .extensions = {"m3d"},
        .holds = {},
    }),
    read_by_opencolorio({
        .name = "icc",
        .label = "ICC profile: matrix and curves",
        .extensions = {"icc", "icm", "pf"},
        .holds = {},
    }),
    read_by_opencolorio({
        .name = "houdini",
        .label = "Houdini .lut: a cube",
        .extensions = {"lut"},
        .holds = unit_cube_of_6_decimals,
        .opencolorio_writer = "houdini",
    }),
    read_by(read_discreet, read_by_opencolorio({
                               .name = "discreet",
                               .label = "Discreet 1D .lut: a curve of integer codes",
                               .extensions = {"lut"},
                               .holds = {},
                               .recognise = recognise_discreet,
                           })),
    read_by_opencolorio({
        .name = "truelight",
        .label = "Truelight .cub: a cube",
        .extensions = {"cub"},
        .holds = unit_cube_of_6_decimals,
        .magic = "# Truelight Cube",
        .opencolorio_writer = "truelight",
    }),
    read_by_opencolorio({
        .name = "spimtx",
        .label = "Imageworks .spimtx: a matrix",
        .extensions = {"spimtx"},
        .holds = {},
    }),
    written_by_opencolorio({
        .name = "ocio-iridas-cube",
        .label = "OpenColorIO's own writer of Iridas .cube, for comparison",
        .extensions = {"cube"},
        .holds = unit_cube_of_6_decimals,
        .opencolorio_writer = "iridas_cube",
    }),
    written_by_opencolorio({
        .name = "ocio-resolve-cube",
        .label = "OpenColorIO's own writer of Resolve .cube, for comparison",
        .extensions = {"cube"},
        .holds = unit_cube_of_6_decimals,
        .opencolorio_writer = "resolve_cube",
    }),
    written_by_opencolorio({
        .name = "ocio-csp",
        .label = "OpenColorIO's own writer of cineSpace .csp, for comparison",
        .extensions = {"csp"},
        .holds = unit_cube_of_6_decimals,
        .opencolorio_writer = "cinespace",
    }),
});

} // namespace

std::string opencolorio_extension(const FileFormat& format, const std::string& file) {
    const std::string own = io::extension_of(file);
    return format.extensions.contain(own) ? own : format.extensions.first();
}

Reading read_with_opencolorio(const FileFormat& format, std::string_view bytes,
                              const std::string& file, const ReadOptions& options) {
    refuse_endless_metadata(bytes, file);
    return io::ocio().read(bytes, opencolorio_extension(format, file), file, options);
}

std::string write_with_opencolorio(const FileFormat& format, const Lut& lut,
                                   const WriteOptions& options) {
    return io::ocio().write(lut, std::string(format.opencolorio_writer), options);
}

std::span<const FileFormat> opencolorios() {
    return rows;
}

} // namespace lutlib::formats
