#include "converter/grade_text.h"

#include "converter/placing.h"
#include "lutlib/io/file.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace converter {
namespace {

namespace io = lutlib::io;

std::string picture_text(const Grading& grading, const lutlib::LookPlace& place) {
    if (grading.picture_encoding) {
        return {};
    }
    if (place.given) {
        const bool is_known = place.look.input || place.look.output;
        return "the picture holds " + place.given->name() +
               " by its file type, profile or tag (--picture-encoding names another)" +
               (is_known ? ""
                         : "; the look does not say what it takes, and gets that as it is: name "
                           "it with --look-input and --look-output");
    }
    return place.look.input
               ? "the picture's encoding is not known and taken for the look's input, " +
                     place.look.input->name() +
                     ": if it is another, name it with "
                     "--picture-encoding"
               : "neither the picture's nor the look's encoding is known; the codes are looked up "
                 "as they are";
}

std::string result_text(const std::string& output, const lutlib::LookPlace& place) {
    const std::optional<lutlib::Encoding> holds = place.shown().output;
    const std::string type = io::extension_of(output);
    const bool is_light = type == "exr" || type == "hdr";
    if (!holds) {
        return is_light && place.given ? "what the result holds is not known, and readers expect "
                                         "linear light in ." +
                                             type + " files: name it with --look-output"
                                       : "";
    }
    const bool misread = is_light && holds->curve->name != "linear";
    return "the result holds " + holds->name() +
           (misread ? ", but readers expect linear light in ." + type +
                          " files: write that with --output-encoding linear"
                    : "");
}

// A line each.
std::vector<std::string> encodings_text(const Grading& grading, const lutlib::LookPlace& place,
                                        const std::string& output) {
    std::vector<std::string> out{picture_text(grading, place)};
    if (place.given && (place.look.input || place.look.output)) {
        out.push_back(sentence_of(place, "the picture"));
    } else if (place.applied().converts()) {
        out.push_back(place.applied().text());
    }
    out.push_back(result_text(output, place));
    std::erase(out, "");
    return out;
}

std::string share(const PixelCounts& all, std::size_t count, const char* what) {
    return count == 0
               ? ""
               : fmt::format("{} pixels ({:.3g} %) {}", count,
                             100 * static_cast<double>(count) / static_cast<double>(all.pixels),
                             what);
}

} // namespace

std::string size_text(const Graded& graded) {
    return fmt::format("{}x{} pixels, {}", graded.width, graded.height, graded.depth->name);
}

std::vector<std::string> lines_of(const PixelCounts& counts) {
    std::vector<std::string> out{
        share(counts, counts.outside_domain, "lay outside the LUT's input and were clamped to it"),
        share(counts, counts.not_a_number, "hold NaN, which was read as 0"),
        share(counts, counts.clamped,
              "came out outside 0..1 and were clamped, as the file stores integers")};
    std::erase(out, "");
    return out;
}

std::vector<std::string> lines_of(const Graded& graded, const Grading& grading,
                                  const std::string& output) {
    std::vector<std::string> out;
    for (const std::string& line : encodings_text(grading, graded.place, output)) {
        out.push_back("encodings: " + line);
    }
    out.insert(out.end(), graded.remarks.begin(), graded.remarks.end());
    for (const std::string& what :
         grading.explains ? graded.left_out : std::vector<std::string>{}) {
        out.push_back("left out: " + what);
    }
    if (grading.explains && graded.left_out.empty()) {
        out.emplace_back("everything is needed");
    }
    for (const std::string& lost : graded.lost) {
        out.push_back("not kept, as the new file does not hold it: " + lost);
    }
    return out;
}

nlohmann::ordered_json to_json(const Graded& graded, const std::string& picture,
                               const std::string& output) {
    return {{"picture", io::input_name(picture)},
            {"output", io::output_name(output)},
            {"width", graded.width},
            {"height", graded.height},
            {"depth", graded.depth->name},
            {"share_of_picture", graded.share},
            {"pixels_outside_domain", graded.counts.outside_domain},
            {"pixels_not_a_number", graded.counts.not_a_number},
            {"pixels_clamped", graded.counts.clamped},
            {"encodings", to_json(graded.place)},
            {"left_out", graded.left_out},
            {"remarks", graded.remarks},
            {"not_kept", graded.lost}};
}

} // namespace converter
