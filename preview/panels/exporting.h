// The look on its way into a file: made ready on a thread of its own, shown with what it loses,
// then written.
#pragma once

#include "preview/editor/look_export.h"

#include <functional>
#include <future>
#include <optional>

namespace preview::panels {

struct Ui;

struct Exporting {
    editor::ExportChoice lut, strip;
    std::future<editor::PreparedExport> waiting; ///< being made ready
    std::optional<editor::PreparedExport> ready; ///< waits to be written or not
    bool is_busy() const { return waiting.valid() || ready.has_value(); }
};

/// Begins with `prepare`, which runs on a thread; the dialog then shows what it gave.
void begin_export(Ui& ui, std::function<editor::PreparedExport()> prepare);
/// What a LUT file, and a strip, is to be.
void lut_controls(Ui& ui);
void strip_controls(Ui& ui, const lutlib::Engine& engine);
/// Draws the question before it is written.
void export_dialog(Ui& ui);

} // namespace preview::panels
