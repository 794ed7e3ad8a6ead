#include "preview/cli/options.h"

#include "lutlib/error.h"
#include "lutlib/named.h"
#include "preview/cli/option_rows.h"
#include "preview/cli/options_unused.h"
#include "preview/look/cube_settings.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <type_traits>

namespace preview {

namespace {

/// A number from low to high; unlike CLI::Range it refuses NaN.
CLI::Validator within(double low, double high) {
    return {[=](std::string& text) {
                double value = 0;
                const bool good =
                    CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
                return good ? std::string()
                            : fmt::format("'{}' is not a number from {} to {}", text, low, high);
            },
            fmt::format("in [{} - {}]", low, high)};
}

void declare(CLI::App& app, const OptionRow& row, Options& options) {
    std::visit(
        [&](auto of) {
            auto& member = of(options);
            using T = std::remove_reference_t<decltype(member)>;
            if constexpr (std::is_same_v<T, bool>) {
                app.add_flag(row.flag, member, row.help);
            } else if constexpr (std::is_same_v<T, std::optional<bool>>) {
                app.add_flag_function(
                    row.flag, [&member](std::int64_t count) { member = count > 0; }, row.help);
            } else {
                CLI::Option* const option = app.add_option(row.flag, member, row.help);
                bool stands_for_itself = true;
                if (row.min < row.max) {
                    option->check(within(row.min, row.max));
                    if constexpr (std::is_arithmetic_v<T>) {
                        // The help of one that does not says what it stands for.
                        stands_for_itself = static_cast<double>(member) >= row.min;
                    }
                }
                if (stands_for_itself) {
                    option->capture_default_str();
                }
                if (row.type != nullptr) {
                    option->type_name(row.type);
                }
                if (row.one_of[0] != nullptr) {
                    option->check(CLI::IsMember({row.one_of[0], row.one_of[1]}));
                }
            }
        },
        row.of);
}

template <class S>
void declare(CLI::App& app, const ChoiceRow<S>& row, S& settings) {
    CLI::Option* const option =
        app.add_option_function<std::string>(
               fmt::format("--{}", row.flag),
               [&row, &settings](const std::string& name) {
                   const std::vector<Option> options = row.options();
                   const Option& found =
                       lutlib::require_named(options, row.kind, name, lutlib::Letters::any_case);
                   row.choose(settings, static_cast<std::size_t>(&found - options.data()));
               },
               fmt::format("{}: {}", row.help, lutlib::names_of(row.options())))
            ->type_name("NAME");
    if (row.chosen != nullptr) {
        option->default_str(std::string(row.options()[row.chosen(settings)].name));
    }
}

template <class S>
void declare(CLI::App& app, std::span<const NumberRow<S>> rows, S& settings) {
    for (const NumberRow<S>& row : rows) {
        CLI::Option* const option =
            app.add_option(fmt::format("--{}", row.flag), row.of(settings), std::string(row.help))
                ->check(within(row.min, row.max));
        // The help of one that stands for something says so.
        if (!row.is_own(settings)) {
            option->default_str(fmt::format("{}", row.value(settings)));
        }
    }
}
void declare_camera(CLI::App& app, Options& options) {
    for (std::size_t i = 0; i < options.camera.size(); ++i) {
        const NumberRow<Orbit>& row = camera_numbers()[i];
        app.add_option(fmt::format("--{}", row.flag), options.camera[i], std::string(row.help))
            ->check(within(-reach_of(row), reach_of(row)));
    }
}

void declare_surroundings(CLI::App& app, Options& options) {
    for (std::size_t i = 0; i < options.surroundings_numbers.size(); ++i) {
        const NumberRow<Surroundings>& row = surroundings_numbers()[i];
        app.add_option(fmt::format("--{}", row.flag), options.surroundings_numbers[i],
                       std::string(row.help))
            ->check(within(row.min, row.max));
    }
}

void declare_cube(CLI::App& app, Options& options) {
    declare(app, cube_numbers(), options.cube);
    for (const SwitchRow<CubeView>& row : cube_switches()) {
        app.add_flag(fmt::format("--{}", row.flag), row.of(options.cube), std::string(row.help));
    }
}

void declare(CLI::App& app, const ListRow& row, Options& options) {
    CLI::Option* const option = app.add_option_function<std::vector<std::string>>(
        row.flag,
        [&row, &options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
                row.take(options, text);
            }
        },
        row.help);
    option->allow_extra_args(false)->type_name(row.type);
    if (row.between != '\0') {
        option->delimiter(row.between);
    }
}
/// The first word may name a study; its subject follows.
void take_study(Options& options) {
    options.study = lutlib::find_named(studies(), options.input);
    if (options.study != nullptr) {
        options.input = options.subject.empty() ? Options().input : options.subject;
    } else if (!options.subject.empty()) {
        throw lutlib::UsageError(fmt::format("'{}' is one word too many: looks are named by --a "
                                             "and --b",
                                             options.subject));
    }
}
} // namespace

void declare(CLI::App& app, Options& options) {
    const auto under = [&](const char* heading) { app.option_defaults()->group(heading); };
    for (const OptionRow& row : option_rows()) {
        declare(app, row, options);
    }
    under("Picture");
    for (const ChoiceRow<PictureSettings>& row : picture_choices()) {
        declare<PictureSettings>(app, row, options.frame);
    }
    app.get_option("--compare")->default_str("")->each([&options](const std::string&) {
        options.is_compare_given = true;
    });
    for (const auto& [flag, is_given] : {std::pair{"--tonemap", &Options::is_tonemap_given},
                                         std::pair{"--bloom", &Options::is_bloom_given}}) {
        app.get_option(flag)->each(
            [&options, member = is_given](const std::string&) { options.*member = true; });
    }
    declare<PictureSettings>(app, picture_numbers(), options.frame);
    for (const OptionRow& row : picture_option_rows()) {
        declare(app, row, options);
    }
    for (const ListRow& row : option_lists()) {
        declare(app, row, options);
    }
    for (const ChoiceRow<Options>& row : option_choices()) {
        declare(app, row, options);
    }
    under("Camera");
    declare_camera(app, options);
    under("Surroundings");
    declare_surroundings(app, options);
    under("Cube view");
    declare_cube(app, options);
    app.parse_complete_callback([&] {
        take_study(options);
        for (const CLI::Option* const option : app.get_options()) {
            for (const std::string& name : option->get_lnames()) {
                if (option->count() > 0) {
                    options.given.push_back("--" + name);
                }
            }
        }
        options.unused = unused_options(options);
    });
}
} // namespace preview
