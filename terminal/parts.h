// What the kinds of papers share.
#pragma once

#include "terminal/papers.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace terminal {

/// The first line of a text.
std::string first_line(const std::string& text);
/// Options that have a flag, without hidden ones.
std::vector<const CLI::Option*> flags_of(const CLI::App& app);
/// "--size", "-o": with their dashes, long ones first.
std::vector<std::string> names_of(const CLI::Option& option);
/// Verbs, without hidden ones.
std::vector<const CLI::App*> verbs_of(const CLI::App& app);
/// Null: files.
const std::vector<std::string>* values_of(const Papers& papers, const CLI::Option& option);

std::string man_page(const Papers& papers, const CLI::App& app, const std::string& name);
std::string bash_completion(const Papers& papers);
std::string zsh_completion(const Papers& papers);
std::string fish_completion(const Papers& papers);

} // namespace terminal
