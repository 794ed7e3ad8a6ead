// The window's life from its first frame to its end.
#include "preview/window/app_parts.h"

#include "lutlib/error.h"
#include "lutlib/io/reason.h"
#include "lutlib/io/terminal.h"

#include <GLFW/glfw3.h>

#include <utility>

namespace preview {

/// Whatever ends the window, the look outlives it.
void App::run() {
    try {
        loop();
    } catch (const std::exception& error) {
        keep_look();
        throw lutlib::Error(lutlib::io::reason_of(error) + where_kept());
    }
    autosave_.forget();
    keep_memory();
    print_validation(screen_->device);
}

void App::loop() {
    while (!ends()) {
        if (frames_due_ > 0) {
            glfwPollEvents();
        } else {
            glfwWaitEvents();
            frames_due_ = frames_after_event;
        }
        const Size size = window_.framebuffer_size();
        if (size.width < 2 || size.height == 0) { // minimised, or as small
            frames_due_ = 0;
            continue;
        }
        const std::vector<editor::InputEvent> events = events_.input.next_frame();
        if (!events.empty() || !events_.dropped.paths.empty() || events_.resized ||
            std::exchange(events_.moved, false)) {
            wake();
        }
        if (ui_.pick && ui_.pick->place) { // waits for frames that measure it
            wake();
        }
        --frames_due_;
        try {
            if (std::exchange(ui_.wants_new_screen, false)) {
                make_screen();
            }
            frame(events);
            recovery_.drew();
        } catch (const vk::SystemError& error) {
            if (!is_lost(error)) {
                glfwPollEvents(); // which ends the program when the display server is gone
                throw;
            }
            recover(error);
        }
    }
}

/// Everything on the GPU anew; the look is safe before that is tried.
void App::recover(const vk::SystemError& error) {
    keep_look();
    ui_.errors.add(recovery_.lost(error));
    wake();
    try {
        make_screen();
    } catch (const vk::SystemError& again) {
        recovery_.lost(again); // throws: the newest screen has proved nothing
    }
}

/// Who closes the window is asked as by the key, in a window that can be seen.
bool App::ends() {
    if (glfwWindowShouldClose(window_.handle()) == GLFW_TRUE) {
        glfwSetWindowShouldClose(window_.handle(), GLFW_FALSE);
        panels::ask_to_quit(ui_);
        if (ui_.asks_to_quit) {
            glfwRestoreWindow(window_.handle());
            wake();
        }
    }
    return ui_.quits;
}

std::string App::where_kept() const {
    return autosave_.kept()
               ? "; the unsaved look is in " + lutlib::io::shown_text(autosave_.kept()->string())
               : std::string();
}

void print_validation(const gpu::Device& device) {
    for (const std::string& message : device.validation_messages()) {
        lutlib::io::print_err("lutpreview: " + lutlib::io::shown_text(message) + "\n");
    }
}

} // namespace preview
