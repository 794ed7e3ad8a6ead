// A verb over many looks, one after the other, each of which uses every core.
#pragma once

#include "converter/command.h"
#include "lutlib/engine/engine.h"
#include "lutlib/io/output_names.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace converter {

/// Whether a folder's file of this name is taken for a look.
bool is_look_file(const std::string& path);

/// A look, where it goes and for whom.
struct LookRoute {
    lutlib::io::Route route;
    const lutlib::Engine* engine = nullptr; ///< null where the verb has none
};

/// The looks that `words` name (LUTs, recipes, folders of them, patterns), each for every engine.
/// `output` is a template that has {engine} too; empty: nothing is written. Says what was left out,
/// and makes the outputs' folders. Throws Error, UsageError, the latter for two outputs of one
/// name.
std::vector<LookRoute> routes_of_looks(std::span<const std::string> words,
                                       const std::string& output,
                                       std::span<const lutlib::Engine* const> engines = {});

/// Runs the verb on each whose output may be replaced (replaceable.h); the answer is the highest
/// ExitCode. Of several, one that fails is said on standard error and the others go on; of one,
/// what it throws passes.
int run_over(std::span<const LookRoute> routes, const std::function<int(const LookRoute&)>& run);

} // namespace converter
