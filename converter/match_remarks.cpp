#include "converter/match_remarks.h"

#include "lutlib/lut.h"

#include <fmt/core.h>

#include <algorithm>

namespace converter {
namespace {

using lutlib::Rgb;

std::string range_remark(const Matched& matched) {
    float least = 0, most = 1;
    for (const Rgb& node : matched.match.cube.nodes) {
        least = std::min({least, node.r, node.g, node.b});
        most = std::max({most, node.r, node.g, node.b});
    }
    return matched.bits == 0 || (least == 0 && most == 1)
               ? ""
               : fmt::format(
                     "the look goes from {:.3f} to {:.3f}, beyond AFTER's codes, which tells "
                     "best where they end; what shows it must cut that to 0..1, as AFTER "
                     "was and the figures are",
                     least, most);
}

std::string nothing_graded_remark(const Matched& matched) {
    constexpr double code = 1 / 255.0;
    const lutlib::Lut3D same = lutlib::identity_cube(matched.match.cube.size);
    for (std::size_t i = 0; i < same.nodes.size(); ++i) {
        if (largest_magnitude(to_double(matched.match.cube.nodes[i]) - to_double(same.nodes[i])) >=
            code) {
            return "";
        }
    }
    return "nothing was graded: AFTER has BEFORE's colours";
}

std::string few_pixels_remark(const Matched& matched) {
    constexpr std::size_t few = 1000;
    return matched.pixels >= few
               ? ""
               : fmt::format("{} pixels tell little: give larger pictures, or more of them",
                             matched.pixels);
}

} // namespace

std::vector<std::string> remarks_of(const Matched& matched) {
    std::vector<std::string> out;
    for (std::string remark :
         {range_remark(matched), nothing_graded_remark(matched), few_pixels_remark(matched)}) {
        if (!remark.empty()) {
            out.push_back(std::move(remark));
        }
    }
    return out;
}

} // namespace converter
