// O3DE's .azasset of a LUT: a cube of 12-bit codes as JSON, in the order of a .3dl.
//
//   { "Type": "JsonSerialization", "Version": 1, "ClassName": "LookupTableAsset",
//     "ClassData": { "Name": "LookupTable",
//                    "Intervals": [ n numbers of 0..1023, which the engine takes for even ],
//                    "Values": [ 3 n^3 codes of 0..4095, blue fastest ] } }
//
// Sources: O3DE's from_3dl_to_azasset.py and AcesDisplayMapperFeatureProcessor, which reads it.
#include "lutlib/error.h"
#include "lutlib/formats/all.h"
#include "lutlib/formats/integer_codes.h"
#include "lutlib/json_text.h"

#include <cmath>

namespace lutlib {
namespace {

constexpr int bits = 12, interval_bits = 10;
constexpr std::string_view class_name = "LookupTableAsset";

int rounded(double value) {
    return static_cast<int>(std::lround(value));
}

int interval(int node, int size) {
    return rounded(node * largest_code(interval_bits) / (size - 1));
}

[[noreturn]] void refuse(const std::string& why, const std::string& file) {
    throw Error("this is no LUT of O3DE's: " + why, {file, 0, {}});
}

const nlohmann::json& list_in(const nlohmann::json& data, const char* name,
                              const std::string& file) {
    if (!data.is_object() || !data.contains(name) || !data[name].is_array()) {
        refuse(std::string("its \"ClassData\" lacks the list \"") + name + '"', file);
    }
    return data[name];
}

float value_of(const nlohmann::json& code, const std::string& file) {
    const double top = largest_code(bits);
    if (!code.is_number() || code.get<double>() < 0 || code.get<double>() > top) {
        refuse("the value " + code.dump().substr(0, 40) + " is no code of 0 to 4095", file);
    }
    return static_cast<float>(code.get<double>() / top);
}

void note_uneven(const nlohmann::json& intervals, Lut& lut) {
    for (int i = 0; i < lut.cube->size; ++i) {
        const nlohmann::json& at = intervals[static_cast<std::size_t>(i)];
        if (!at.is_number() || std::abs(at.get<double>() - interval(i, lut.cube->size)) > 1) {
            lut.notes.emplace_back("its intervals are not even; the nodes are read as evenly "
                                   "spaced, as O3DE does");
            return;
        }
    }
}

Lut read_azasset(std::string_view bytes, const std::string& file) {
    const nlohmann::json document = parse_json(bytes, file);
    if (!document.is_object() || document.value("ClassName", nlohmann::json()) != class_name ||
        !document.contains("ClassData")) {
        refuse("its \"ClassName\" is not \"" + std::string(class_name) + '"', file);
    }
    const nlohmann::json& data = document["ClassData"];
    const nlohmann::json& intervals = list_in(data, "Intervals", file);
    const nlohmann::json& values = list_in(data, "Values", file);
    check_cube_size(static_cast<long long>(intervals.size()));
    const std::size_t n = intervals.size();
    if (values.size() != 3 * n * n * n) {
        refuse(std::to_string(n) + " intervals need " + std::to_string(3 * n * n * n) +
                   " values, it has " + std::to_string(values.size()),
               file);
    }
    Lut out;
    Lut3D& cube = out.cube.emplace();
    cube.size = static_cast<int>(n);
    cube.nodes.resize(n * n * n);
    std::size_t next = 0;
    for (int r = 0; r < cube.size; ++r) {
        for (int g = 0; g < cube.size; ++g) {
            for (int b = 0; b < cube.size; ++b) {
                for (std::size_t c = 0; c < 3; ++c) {
                    cube.at(r, g, b)[c] = value_of(values[next++], file);
                }
            }
        }
    }
    note_uneven(intervals, out);
    out.provenance = file;
    return out;
}

std::string write_azasset(const Lut& lut) {
    validate(lut);
    if (!lut.cube || lut.shaper || !lut.cube->domain.is_unit()) {
        throw Error("an .azasset holds one cube over 0..1 and nothing else");
    }
    const Lut3D& cube = *lut.cube;
    std::string intervals, values;
    for (int i = 0; i < cube.size; ++i) {
        intervals += (i == 0 ? "" : ", ") + std::to_string(interval(i, cube.size));
    }
    for (int r = 0; r < cube.size; ++r) {
        for (int g = 0; g < cube.size; ++g) {
            for (int b = 0; b < cube.size; ++b) {
                values += values.empty() ? "" : ",\n";
                for (std::size_t c = 0; c < 3; ++c) {
                    const double value = saturate(static_cast<double>(cube.at(r, g, b)[c]));
                    values +=
                        (c == 0 ? "" : ", ") + std::to_string(rounded(value * largest_code(bits)));
                }
            }
        }
    }
    return "{\n    \"Type\": \"JsonSerialization\",\n    \"Version\": 1,\n    \"ClassName\": \"" +
           std::string(class_name) +
           "\",\n    \"ClassData\": {\n        \"Name\": \"LookupTable\",\n        \"Intervals\": "
           "[" +
           intervals + "],\n        \"Values\": [" + values + "]\n    }\n}\n";
}

} // namespace

constinit const FileFormat formats::azasset{
    .name = "azasset",
    .label = "O3DE .azasset: a cube of 12-bit codes",
    .extensions = {"azasset"},
    .holds = {.cube = true, .integer_bits = bits},
    .magic = "\"LookupTableAsset\"",
    .read = [](const FileFormat& /*format*/, std::string_view bytes, const std::string& file,
               const ReadOptions& /*options*/) -> Reading {
        return {read_azasset(bytes, file), {}};
    },
    .write = [](const FileFormat& /*format*/, const Lut& lut,
                const WriteOptions& /*options*/) { return write_azasset(lut); },
};

} // namespace lutlib
