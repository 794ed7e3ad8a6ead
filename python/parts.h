// The parts of the Python module, each declared by its own file.
#pragma once

#include "lutlib/interpolation/grade.h"
#include "lutlib/io/look.h"

#include <nlohmann/json_fwd.hpp>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace lutlib_python {

namespace py = pybind11;

/// What Python calls a Look: a look, and what apply() has laid out of it. Shared between threads.
class PyLook {
  public:
    explicit PyLook(lutlib::io::Look look) : look_(std::move(look)) {}

    const lutlib::io::Look& operator*() const { return look_; }
    const lutlib::io::Look* operator->() const { return &look_; }
    /// Its own table, baked and measured once where it is a recipe.
    const lutlib::io::LookTable& table() const;
    /// The same laid out for apply(), kept for the interpolation that was used last.
    lutlib::Grading grading(lutlib::Interpolation how) const;

  private:
    const lutlib::io::LookTable& table_unlocked() const;

    lutlib::io::Look look_;
    mutable std::mutex mutex_;
    mutable std::optional<lutlib::io::LookTable> table_;
    mutable std::optional<std::pair<lutlib::Interpolation, lutlib::Grading>> grading_;
};

/// Python's dicts, lists, numbers and texts of a document; what JSON has no number for is None.
py::object as_python(const nlohmann::ordered_json& json);
py::list as_python(const std::vector<lutlib::Loss>& losses);

/// Throws UsageError for a name that is none.
std::optional<lutlib::Interpolation> interpolation_of(const std::optional<std::string>& name);
const lutlib::Engine& engine_of(const std::string& name);
lutlib::LookEncodings encodings_of(const std::optional<std::string>& input,
                                   const std::optional<std::string>& output);

void declare_apply(py::module_& module);
void declare_errors(py::module_& module);
void declare_look(py::module_& module);
void declare_recipe(py::module_& module);
void declare_tables(py::module_& module);
void declare_work(py::module_& module);

} // namespace lutlib_python
