// Files as strangers damage them, by rows: each makes another of the same bytes, by a seed.
#pragma once

#include <cstddef>
#include <random>
#include <span>
#include <string>

namespace support {

struct Mutation {
    const char* name;
    bool (*fits)(const std::string& bytes); ///< null: every file
    std::string (*of)(std::string bytes, std::mt19937& random);
};
std::span<const Mutation> mutations();

/// A file that one or two of the rows have been through; the same for the same number.
struct Mutated {
    std::string names, bytes;
};
Mutated mutated(const std::string& bytes, std::size_t number);

/// How many of each file a test tries: LUT_MUTATIONS, else 200, under sanitizers 15.
std::size_t mutations_to_try();

/// What is wrong with a text that goes to a terminal; empty: nothing.
std::string problem_of(const std::string& message);

} // namespace support
