// The end of the X server under a window.
#pragma once

#include <functional>

namespace preview {

/// Xlib ends a program whose server is gone: then `last` is called before, once, and the exit code
/// is `code`. Does nothing where windows are not Xlib's.
void at_end_of_display(std::function<void()> last, int code);

} // namespace preview
