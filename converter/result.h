// What a verb that makes a LUT says of it: its tables, and its error against what it stands for.
#pragma once

#include "lutlib/format.h"
#include "lutlib/io/file.h"
#include "lutlib/lut.h"
#include "lutlib/metrics/compare.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace converter {

struct Result {
    const lutlib::Lut& lut;
    std::string output;
    std::string
        shown; ///< the output that print() must not mix with: this one or another of the run
    std::string made_of; ///< "a.cube, then b.cube"
    /// What the LUT stands for, over its domain.
    lutlib::Transform exact;
    lutlib::Encoding encoding;                        ///< of the result's code values
    std::vector<std::string> notes;                   ///< lines of text, what was lost
    lutlib::Breaks breaks = lutlib::no_breaks();      ///< of `exact`
    std::vector<lutlib::io::FileToWrite> others = {}; ///< written with the LUT or not at all
};

/// Writes the LUT, measures what the file then holds over the LUT's domain, and prints text or
/// JSON; "size" is 0 there for a 1D table alone.
void write_and_report(const Result& result, bool json, nlohmann::ordered_json extra);

nlohmann::ordered_json to_json(const lutlib::Difference& difference);
std::string to_text(const lutlib::Difference& difference, const std::string& indent);
std::string color_text(lutlib::RgbD color);

nlohmann::ordered_json to_json(const std::vector<lutlib::Loss>& losses);
/// A line for each.
std::string to_text(const std::vector<lutlib::Loss>& losses);
/// The error of a file with these losses against what it stands for.
std::string figures_of_file(const std::vector<lutlib::Loss>& losses,
                            const lutlib::Difference& error);

} // namespace converter
