#include "tests/support/mutations.h"

#include "tests/support/thorough.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

namespace support {
namespace {

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t end) {
    return end == 0 ? 0 : random() % end;
}

template <class Choices>
auto one_of(Random& random, const Choices& choices) {
    return choices[below(random, std::size(choices))];
}

bool is_text(const std::string& bytes) {
    return std::none_of(bytes.begin(), bytes.end(), [](char c) { return c == '\0'; });
}

bool is_markup(const std::string& bytes) {
    return is_text(bytes) && bytes.find('<') != std::string::npos;
}

bool is_json(const std::string& bytes) {
    return bytes.starts_with('{') && nlohmann::json::accept(bytes);
}

std::string cut(std::string bytes, Random& random) {
    return bytes.substr(0, below(random, bytes.size()));
}

std::string with_flips(std::string bytes, Random& random) {
    for (std::size_t left = 1 + below(random, 8); left > 0 && !bytes.empty(); --left) {
        bytes[below(random, bytes.size())] = static_cast<char>(random());
    }
    return bytes;
}

std::string with_a_run(std::string bytes, Random& random) {
    const std::size_t at = below(random, bytes.size());
    const std::size_t length = std::min(1 + below(random, 64), bytes.size() - at);
    std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), length,
                one_of(random, std::string_view("\0\xff\x7f\x80 ", 5)));
    return bytes;
}

std::string without_a_piece(std::string bytes, Random& random) {
    return bytes.erase(below(random, bytes.size()), 1 + below(random, 256));
}

std::string with_a_piece_twice(std::string bytes, Random& random) {
    const std::size_t at = below(random, bytes.size());
    return bytes.insert(at, bytes.substr(at, 1 + below(random, 4096)));
}

/// Headers of binary files are full of them.
std::string with_a_size(std::string bytes, Random& random) {
    constexpr std::array<std::uint32_t, 8> sizes{0,           1,        0xffffffffU, 0x7fffffffU,
                                                 0x80000000U, 0x10000U, 0xffff0000U, 0x00ffffffU};
    const std::uint32_t size = one_of(random, sizes);
    const std::size_t width = one_of(random, std::array<std::size_t, 2>{2, 4});
    if (bytes.size() > width) {
        const std::size_t head = std::min<std::size_t>(bytes.size() - width, 256);
        std::memcpy(bytes.data() + below(random, head), &size, width);
    }
    return bytes;
}

std::string with_a_number(std::string bytes, Random& random) {
    constexpr std::array<const char*, 12> numbers{
        "-1",         "0",    "1e999", "nan", "inf", "99999999999",
        "2147483648", "0x10", "1.5.2", "",    "257", "-0"};
    constexpr const char* digits = "0123456789.";
    const std::size_t first = bytes.find_first_of(digits, below(random, bytes.size()));
    if (first == std::string::npos) {
        return bytes;
    }
    const std::size_t end = std::min(bytes.find_first_not_of(digits, first), bytes.size());
    return bytes.replace(first, end - first, one_of(random, numbers));
}

std::string with_depth(std::string bytes, Random& random) {
    const std::size_t at = bytes.find_first_of("[{<(", below(random, bytes.size()));
    if (at == std::string::npos) {
        return bytes;
    }
    const std::string opening = bytes[at] == '<' ? "<a>" : std::string(1, bytes[at]);
    std::string nest;
    for (int depth = 0; depth < 20'000; ++depth) {
        nest += opening;
    }
    return bytes.insert(at, nest);
}

/// Ten times ten times ten ... of an entity (the "billion laughs").
std::string with_entities(std::string bytes, Random& random) {
    std::string type = "<!DOCTYPE a [<!ENTITY e0 \"aaaaaaaaaa\">";
    const int levels = 3 + static_cast<int>(below(random, 8));
    for (int level = 1; level <= levels; ++level) {
        type += "<!ENTITY e" + std::to_string(level) + " \"";
        for (int i = 0; i < 10; ++i) {
            type += "&e" + std::to_string(level - 1) + ";";
        }
        type += "\">";
    }
    const std::size_t head = bytes.starts_with("<?") ? bytes.find('>') + 1 : 0;
    bytes.insert(head, type + "]>");
    const std::size_t text = bytes.find('>', head + type.size() + 2);
    return text == std::string::npos ? bytes
                                     : bytes.insert(text + 1, "&e" + std::to_string(levels) + ";");
}

std::string with_a_reference(std::string bytes, Random& random) {
    static const std::array<std::string, 8> references{"/dev/zero",
                                                       "../../../../etc/passwd",
                                                       "/proc/self/mem",
                                                       "x\x1b]0;owned\x07",
                                                       std::string(70'000, 'a'),
                                                       "file:///etc/passwd",
                                                       "data:application/octet-stream;base64,AA",
                                                       "%2e%2e/%2e%2e/x"};
    const std::size_t first = bytes.find('"', below(random, bytes.size()));
    const std::size_t end = first == std::string::npos ? first : bytes.find('"', first + 1);
    if (end == std::string::npos) {
        return bytes;
    }
    return bytes.replace(first + 1, end - first - 1, one_of(random, references));
}

std::string with_an_escape(std::string bytes, Random& random) {
    constexpr std::array<const char*, 6> escapes{"\x1b]0;owned\x07",
                                                 "\xc2\x9b"
                                                 "31m",
                                                 "\xe2\x80\xae",
                                                 "\xff\xfe",
                                                 "\r",
                                                 "\xed\xa0\x80"};
    return bytes.insert(below(random, bytes.size()), one_of(random, escapes));
}

/// A random value of the document, into another one, away, or twice.
std::string with_surgery(std::string bytes, Random& random) {
    using json = nlohmann::json;
    json document = json::parse(bytes);
    json* at = &document;
    while (at->is_structured() && !at->empty() && below(random, 4) != 0) {
        auto inner = at->begin();
        std::advance(inner, static_cast<std::ptrdiff_t>(below(random, at->size())));
        at = &*inner;
    }
    static const std::array<json, 11> others{json(),
                                             json(true),
                                             json(-1),
                                             json(1e300),
                                             json(4294967296),
                                             json("x"),
                                             json(""),
                                             json::array(),
                                             json::object(),
                                             json::array({1, 2}),
                                             json(std::string(5000, 'x'))};
    if (at->is_array() && !at->empty() && below(random, 2) == 0) {
        at->push_back(at->front());
    } else {
        *at = one_of(random, others);
    }
    return document.dump();
}

constexpr std::array<Mutation, 13> table{{
    {"cut", nullptr, cut},
    {"flips", nullptr, with_flips},
    {"run", nullptr, with_a_run},
    {"piece left out", nullptr, without_a_piece},
    {"piece twice", nullptr, with_a_piece_twice},
    {"declared size", nullptr, with_a_size},
    {"number", is_text, with_a_number},
    {"depth", is_text, with_depth},
    {"entities", is_markup, with_entities},
    {"reference", is_text, with_a_reference},
    {"escape", nullptr, with_an_escape},
    {"surgery", is_json, with_surgery},
    {"more surgery", is_json, with_surgery},
}};

} // namespace

std::span<const Mutation> mutations() {
    return table;
}

Mutated mutated(const std::string& bytes, std::size_t number) {
    Random random(static_cast<Random::result_type>(number));
    Mutated out{"", bytes};
    for (std::size_t left = 1 + below(random, 2); left > 0 && !out.bytes.empty();) {
        const Mutation& row = one_of(random, table);
        if (!row.fits || row.fits(out.bytes)) {
            out.bytes = row.of(std::move(out.bytes), random);
            out.names += (out.names.empty() ? "" : ", ") + std::string(row.name);
            --left;
        }
    }
    return out;
}

std::size_t mutations_to_try() {
    const char* const asked = std::getenv("LUT_MUTATIONS");
    const std::size_t usual = is_sanitized ? 15 : is_thorough() ? 200 : 60;
    return asked ? static_cast<std::size_t>(std::strtoull(asked, nullptr, 10)) : usual;
}

std::string problem_of(const std::string& message) {
    for (const char* const inside : {"vector::", "std::", "bad_alloc", "basic_string",
                                     "json.exception", "no reason given", "0x7f"}) {
        if (message.find(inside) != std::string::npos) {
            return std::string("it says ") + inside;
        }
    }
    for (std::size_t at = 0; at < message.size(); ++at) {
        const auto c = static_cast<unsigned char>(message[at]);
        const auto before = static_cast<unsigned char>(at > 0 ? message[at - 1] : 0);
        if ((c < 0x20 && c != '\n') || c == 0x7f || (before == 0xc2 && c >= 0x80 && c < 0xa0)) {
            return "it holds a control character";
        }
    }
    const bool turns = message.find("\xe2\x80\xae") != std::string::npos;
    return turns ? "it turns the direction of writing" : message.size() > 4000 ? "it is long" : "";
}

} // namespace support
