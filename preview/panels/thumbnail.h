// Small pictures of what is shown under looks, in panels and popups. The program renders those that
// are seen, and puts them on the screen where their window stands among the others.
#pragma once

#include "preview/gpu/size.h"

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

struct ImDrawCmd;
struct ImDrawList;

namespace preview::panels {

struct Ui;
struct Rect;

/// What a picture is of: what is shown, under a look in a file or a version, or a built-in scene.
enum class ThumbnailKind : std::uint8_t { file, version, scene };
struct ThumbnailKey {
    ThumbnailKind kind = ThumbnailKind::file;
    std::string name; ///< the file's path, the version's place, or the scene's name
    friend auto operator<=>(const ThumbnailKey&, const ThumbnailKey&) = default;
};

/// What there is of one.
struct ThumbnailFact {
    std::optional<std::size_t> cell; ///< where the program has it; empty: nowhere yet
    Size size;                       ///< of what is there, in pixels
    std::string reason{};            ///< why there is none; empty: it will come
    bool is_no_look = false;         ///< the file is none
};

/// A picture in this frame; places are in the window's coordinates.
struct PlacedThumbnail {
    float x = 0, y = 0, width = 0, height = 0;
    float clip_left = 0, clip_top = 0, clip_right = 0, clip_bottom = 0;
    std::size_t cell = 0;
};

/// Of one window: what a callback of its draw list puts on the screen at once.
using ThumbnailGroup = std::vector<PlacedThumbnail>;

struct Thumbnails {
    std::vector<ThumbnailKey> wanted; ///< in this frame, the first first
    std::map<ThumbnailKey, ThumbnailFact> facts;
    ThumbnailGroup placed;             ///< of the window that is being drawn
    std::deque<ThumbnailGroup> groups; ///< of this frame; callbacks point to them
    /// Puts the group at `UserCallbackData` on the screen; null: there is no screen.
    void (*draw)(const ImDrawList* list, const ImDrawCmd* command) = nullptr;
    std::size_t drawn = 0; ///< how many were rendered since the window was opened
};

/// How large they are, in heights of the text.
inline constexpr float thumbnail_width = 11, thumbnail_height = 6.2F;

/// One in a box with that upper left corner, of that share of the full size, in its middle; or what
/// there is to say in its place. Asks for it where it is seen.
void place_thumbnail(Ui& ui, const ThumbnailKey& key, float x, float y, float share = 1);
/// Behind all that this window has placed, and ahead of what it draws over them.
void show_thumbnails(Ui& ui);

} // namespace preview::panels
