// The options of a verb on the command line. CLI11, which keeps them, is included by verb.cpp and
// program.cpp alone: every other file would pay seconds for it.
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace converter {

/// What an option's value may be.
enum class Takes { cube_size, shaper_size, picture_bits, count, above_zero, zero_or_more, share };

/// What the value of an option for a file to write is.
enum class OutputName { is_file, is_template };

/// An option that has been declared; the functions return it, to be chained.
class VerbOption {
  public:
    explicit VerbOption(CLI::Option& option) : option_(&option) {}

    VerbOption& required();
    VerbOption& takes(Takes values);
    /// Values at once, or at least and, unless -1, at most.
    VerbOption& expected(int count);
    VerbOption& expected(int least, int most);
    VerbOption& excludes(std::initializer_list<const char*> options);
    /// The heading that it stands under in the help.
    VerbOption& group(const std::string& heading);
    /// Shows the variable's value as the default in the help.
    VerbOption& capture_default_str();

  private:
    CLI::Option* option_;
};

/// A verb being declared. It and the variables outlive the run.
class Verb {
  public:
    explicit Verb(CLI::App& app) : app_(app) {}
    Verb(const Verb&) = delete;
    Verb& operator=(const Verb&) = delete;

    VerbOption add_option(const std::string& names, std::string& value, const std::string& help);
    VerbOption add_option(const std::string& names, int& value, const std::string& help);
    VerbOption add_option(const std::string& names, double& value, const std::string& help);
    VerbOption add_option(const std::string& names, std::vector<int>& value,
                          const std::string& help);
    VerbOption add_option(const std::string& names, std::vector<float>& value,
                          const std::string& help);
    VerbOption add_option(const std::string& names, std::vector<std::string>& value,
                          const std::string& help);
    /// `take` gets the value while the command line is read.
    VerbOption add_action(const std::string& names,
                          const std::function<void(const std::string&)>& take,
                          const std::string& help);
    VerbOption add_flag(const std::string& names, bool& value, const std::string& help);
    /// A file to write. `OutputName::is_template` where the value can stand for several: the verb
    /// then calls require_replaceable() (replaceable.h) for each of them.
    VerbOption add_output(const std::string& names, std::string& value, const std::string& help,
                          OutputName name = OutputName::is_file);
    bool writes() const { return !outputs_.empty(); }
    /// The files to write, by their one name.
    std::vector<std::string> outputs() const;
    /// What else stands on the command line that was read: options' values and words.
    std::vector<std::string> other_values() const;
    /// Whether this option stands on the command line that was read.
    bool given(std::string_view option) const;
    /// Words under the options in the help.
    void footer(const std::string& text);

    /// An option of one value whose place among its like counts. Returns its number.
    std::size_t add_in_order(const std::string& name, const std::string& help,
                             const std::string& heading);
    /// Those that were given, by number, with their values.
    std::vector<std::pair<std::size_t, std::string>> in_order() const;

    /// Words that are no option's, among them numbers below zero, which a positional option would
    /// take for flags.
    void allow_words();
    std::vector<std::string> words() const;

  private:
    CLI::App& app_;
    struct Output {
        const CLI::Option* option;
        const std::string* value;
        OutputName name;
    };

    std::vector<const CLI::Option*> ordered_;
    std::vector<Output> outputs_;
};

} // namespace converter
