// Which files a run may write over without being told to: the same for every verb.
#pragma once

#include "converter/verb.h"
#include "lutlib/io/output_names.h"

#include <span>
#include <string>
#include <vector>

namespace converter {

/// --force, for verbs that write.
void declare_force(Verb& verb, bool& force);
/// Whether this run was told to write over whatever is there.
void set_force(bool force);

/// Whether the bytes of a file are lutconv's own: it says so in them (a picture in its text, a
/// page, drawing or shader near its head), or they are a LUT or a recipe exactly as lutconv writes
/// it. An empty file is anybody's.
bool is_of_own_making(const std::string& bytes, const std::string& path);

/// Throws Error where there is a file of that path which lutconv did not make or which is one of
/// `inputs`, but under --force. Pipes and devices have nothing to lose.
void require_replaceable(const std::string& path, const std::vector<std::string>& inputs);
/// All outputs that a verb declared, before it runs, against what else its command line names.
void require_replaceable(const Verb& verb);
/// The same of every route, for outputs that a template names.
void require_replaceable(std::span<const lutlib::io::Route> routes);

} // namespace converter
