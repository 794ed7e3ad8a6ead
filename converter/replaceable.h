// Which files a run may write over without being told to.
#pragma once

#include "converter/verb.h"

#include <string>
#include <vector>

namespace converter {

/// --force, for verbs that call require_replaceable().
void declare_force(Verb& verb, bool& force);

/// Whether the bytes of a file are lutconv's own: it says so in them (a picture in its text, a
/// page, drawing or shader near its head), or they are a LUT exactly as lutconv writes it. An empty
/// file is anybody's.
bool is_of_own_making(const std::string& bytes, const std::string& path);

/// Throws Error where there is a file of that path which lutconv did not make or which is one of
/// `inputs`, unless `force`. Pipes and devices have nothing to lose.
void require_replaceable(const std::string& path, const std::vector<std::string>& inputs,
                         bool force);

} // namespace converter
