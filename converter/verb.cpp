#include "converter/verb.h"

#include "lutlib/limits.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace converter {
namespace {

namespace limits = lutlib::limits;

// CLI11's own ranges take NaN for a member.
CLI::Validator number_that(bool (*fits)(double), const std::string& words) {
    return CLI::Validator(
        [fits, words](const std::string& text) {
            double value = 0;
            const bool good =
                CLI::detail::lexical_cast(text, value) && std::isfinite(value) && fits(value);
            return good ? std::string() : fmt::format("'{}' is not {}", text, words);
        },
        words);
}

CLI::Validator validator_of(Takes values) {
    switch (values) {
    case Takes::cube_size:
        return CLI::Range(limits::min_cube_size, limits::max_cube_size);
    case Takes::shaper_size:
        return CLI::Range(limits::min_shaper_size, limits::max_shaper_size);
    case Takes::picture_bits:
        return CLI::IsMember({8, 16});
    case Takes::count:
        return CLI::NonNegativeNumber;
    case Takes::above_zero:
        return number_that([](double x) { return x > 0; }, "a number above 0");
    case Takes::share:
        return number_that([](double x) { return x >= 0 && x <= 1; }, "a number of 0 to 1");
    case Takes::zero_or_more:
        break;
    }
    return number_that([](double x) { return x >= 0; }, "a number of 0 or more");
}

} // namespace

VerbOption& VerbOption::required() {
    option_->required();
    return *this;
}

VerbOption& VerbOption::takes(Takes values) {
    option_->check(validator_of(values));
    return *this;
}

VerbOption& VerbOption::expected(int count) {
    option_->expected(count);
    return *this;
}

VerbOption& VerbOption::expected(int least, int most) {
    option_->expected(least, most);
    return *this;
}

VerbOption& VerbOption::excludes(std::initializer_list<const char*> options) {
    for (const char* const option : options) {
        option_->excludes(option);
    }
    return *this;
}

VerbOption& VerbOption::group(const std::string& heading) {
    option_->group(heading);
    return *this;
}

VerbOption& VerbOption::capture_default_str() {
    option_->capture_default_str();
    return *this;
}

VerbOption Verb::add_option(const std::string& names, std::string& value, const std::string& help) {
    return VerbOption(*app_.add_option(names, value, help));
}

VerbOption Verb::add_output(const std::string& names, std::string& value, const std::string& help,
                            OutputName name) {
    CLI::Option* const option = app_.add_option(names, value, help);
    option->check(CLI::Validator(
        [](const std::string& path) {
            return path.empty() ? std::string("name the file to write, or - for standard output")
                                : std::string();
        },
        ""));
    outputs_.push_back({option, &value, name});
    return VerbOption(*option);
}

std::vector<std::string> Verb::outputs() const {
    std::vector<std::string> out;
    for (const Output& output : outputs_) {
        if (output.name == OutputName::is_file && !output.value->empty()) {
            out.push_back(*output.value);
        }
    }
    return out;
}

std::vector<std::string> Verb::other_values() const {
    std::vector<std::string> out = words();
    for (const CLI::Option* const option : app_.get_options()) {
        const bool is_output =
            std::any_of(outputs_.begin(), outputs_.end(),
                        [option](const Output& output) { return output.option == option; });
        if (!is_output) {
            out.insert(out.end(), option->results().begin(), option->results().end());
        }
    }
    return out;
}

VerbOption Verb::add_option(const std::string& names, int& value, const std::string& help) {
    return VerbOption(*app_.add_option(names, value, help));
}

VerbOption Verb::add_option(const std::string& names, double& value, const std::string& help) {
    return VerbOption(*app_.add_option(names, value, help));
}

VerbOption Verb::add_option(const std::string& names, std::vector<int>& value,
                            const std::string& help) {
    return VerbOption(*app_.add_option(names, value, help));
}

VerbOption Verb::add_option(const std::string& names, std::vector<float>& value,
                            const std::string& help) {
    return VerbOption(*app_.add_option(names, value, help));
}

VerbOption Verb::add_option(const std::string& names, std::vector<std::string>& value,
                            const std::string& help) {
    return VerbOption(*app_.add_option(names, value, help));
}

VerbOption Verb::add_action(const std::string& names,
                            const std::function<void(const std::string&)>& take,
                            const std::string& help) {
    return VerbOption(*app_.add_option_function<std::string>(names, take, help));
}

VerbOption Verb::add_flag(const std::string& names, bool& value, const std::string& help) {
    return VerbOption(*app_.add_flag(names, value, help));
}

bool Verb::given(std::string_view option) const {
    return app_.count(std::string(option)) > 0;
}

void Verb::footer(const std::string& text) {
    app_.footer(text);
}

std::size_t Verb::add_in_order(const std::string& name, const std::string& help,
                               const std::string& heading) {
    ordered_.push_back(app_.add_option(name)
                           ->type_name("")
                           ->description(help)
                           ->expected(1)
                           ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
                           ->group(heading));
    return ordered_.size() - 1;
}

std::vector<std::pair<std::size_t, std::string>> Verb::in_order() const {
    std::vector<std::pair<std::size_t, std::string>> out;
    std::map<const CLI::Option*, std::size_t> used;
    for (const CLI::Option* const option : app_.parse_order()) {
        const auto found = std::find(ordered_.begin(), ordered_.end(), option);
        if (found != ordered_.end()) {
            out.emplace_back(static_cast<std::size_t>(found - ordered_.begin()),
                             option->results()[used[option]++]);
        }
    }
    return out;
}

void Verb::allow_words() {
    app_.allow_extras();
    // CLI11 gives what follows a bare -- to the program itself.
    CLI::App& program = *app_.get_parent();
    app_.parse_complete_callback([&program] { program.allow_extras(); });
}

std::vector<std::string> Verb::words() const {
    std::vector<std::string> out = app_.remaining();
    const std::vector<std::string> more = app_.get_parent()->remaining();
    out.insert(out.end(), more.begin(), more.end());
    return out;
}

} // namespace converter
