#include "preview/editor/reload.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/look_text.h"
#include "lutlib/io/recipe_file.h"
#include "preview/editor/commands.h"

#include <filesystem>
#include <optional>
#include <system_error>
#include <tuple>
#include <utility>

namespace preview::editor {

namespace {

namespace io = lutlib::io;
using lutlib::Lut;

auto contents_of(const Lut& lut) {
    return std::tie(lut.shaper, lut.cube, lut.interpolation, lut.title, lut.encodings,
                    lut.keywords);
}

bool hold_the_same(const std::shared_ptr<const Lut>& a, const std::shared_ptr<const Lut>& b) {
    return a == b || (a && b && contents_of(*a) == contents_of(*b));
}

/// Whatever the base is called.
bool hold_the_same(const lutlib::Recipe& a, const lutlib::Recipe& b) {
    const auto values = [](const lutlib::Recipe& r) {
        return std::tie(r.title, r.input, r.adaptation, r.bake, r.operations, r.opacity);
    };
    return values(a) == values(b) && a.output_encoding() == b.output_encoding() &&
           hold_the_same(a.base_lut, b.base_lut);
}

bool is_file(const std::string& path) {
    return !path.empty() && path != io::standard_stream && !io::is_special(path);
}

/// Whether the base is read by way of the recipe's file, as at its opening. One that a person has
/// opened may lie where no recipe's file may lead.
bool leads_to_its_base(const State& state) {
    return !state.recipe_path.empty() && !state.base_path.empty() &&
           io::base_path(state.saved, state.recipe_path) == state.base_path &&
           !io::has_base_outside(state.recipe_path, state.base_path);
}

/// The recipe's file as it is now.
struct RecipeFile {
    std::string bytes;
    std::shared_ptr<const io::Look> look; ///< null: it could not be read
    std::optional<lutlib::Error> failure{};
};

RecipeFile read_recipe_file(const std::string& path) {
    RecipeFile out{io::read_file(path), nullptr};
    try {
        out.look = std::make_shared<const io::Look>(io::Look::of_bytes(out.bytes, path));
        if (out.look->recipe() == nullptr) {
            throw lutlib::Error("it is a LUT now and no recipe; open it anew", {path, 0, {}});
        }
    } catch (const lutlib::Error& error) {
        out.look = nullptr;
        out.failure = error;
    }
    return out;
}

void take_base_of(History& history, const io::Look& recipe) {
    if (recipe.recipe()->base_lut) {
        take_base(history, io::base_path(*recipe.recipe(), recipe.path()),
                  recipe.recipe()->base_lut, told_of(recipe));
    }
}

/// Whether the window itself has written the bytes: a base may lie outside the folder, so that they
/// need not be readable.
bool is_own(const State& state, const std::string& bytes) {
    return bytes == io::recipe_text(state.saved, state.recipe_path, state.base_path);
}

std::shared_ptr<const io::Look> put_recipe(History& history, const RecipeFile& file,
                                           const std::string& path) {
    const State& state = history.draft();
    const bool is_ours = state.recipe_path == path && is_own(state, file.bytes);
    if (file.look && is_ours) {
        take_base_of(history, *file.look);
    } else if (file.look) {
        return take_recipe(history, *file.look) ? nullptr : file.look;
    } else if (!is_ours) {
        throw lutlib::Error(*file.failure);
    }
    return nullptr;
}

FollowedFile followed_recipe(const State& state) {
    const std::string path = state.recipe_path;
    std::vector<std::string> files{path};
    if (leads_to_its_base(state)) {
        files.push_back(state.base_path);
    }
    return {"recipe " + path, files, [path]() -> PutInPlace {
                return [path, file = read_recipe_file(path)](History& history) {
                    return put_recipe(history, file, path);
                };
            }};
}

FollowedFile followed_base(const State& state) {
    return {
        "base " + state.base_path,
        {state.base_path},
        [path = state.base_path, said = state.said]() -> PutInPlace {
            const io::Look look = io::Look::open(path, {.encodings = said});
            if (look.recipe() != nullptr) {
                throw lutlib::Error("it is a recipe now and no LUT; open it anew", {path, 0, {}});
            }
            return [path, lut = look.as_recipe().base_lut, told = told_of(look)](History& history) {
                take_base(history, path, lut, told);
                return nullptr;
            };
        }};
}

FollowedFile followed_side(const Side& side) {
    const lutlib::EncodingNames said = names_of(side.said);
    return {"side " + said.input + " " + said.output + " " + side.path, side.files,
            [path = side.path, said = side.said]() -> PutInPlace {
                Side fresh;
                open_side(fresh, io::Look::open(path, {.encodings = said}), said);
                return [fresh](History& history) {
                    take_side(history, fresh);
                    return nullptr;
                };
            }};
}

} // namespace

std::vector<FollowedFile> followed_looks(const State& state) {
    std::vector<FollowedFile> out;
    if (is_file(state.recipe_path)) {
        out.push_back(followed_recipe(state));
    }
    if (is_file(state.base_path) && state.recipe.base_lut && !leads_to_its_base(state)) {
        out.push_back(followed_base(state));
    }
    for (const Side& side : state.sides) {
        if (side.lut && is_file(side.path)) {
            out.push_back(followed_side(side));
        }
    }
    return out;
}

void take_base(History& history, const std::string& path, const std::shared_ptr<const Lut>& lut,
               const std::vector<std::string>& told) {
    const auto replace = [&](lutlib::Recipe& recipe, bool is_titled_by_base) {
        if (is_titled_by_base && recipe.title == recipe.base_lut->title) {
            recipe.title = lut->title;
        }
        recipe.base_lut = lut;
    };
    history.change_all([&](State& state) {
        const lutlib::Recipe& recipe = state.recipe;
        if (state.base_path != path || !recipe.base_lut || hold_the_same(recipe.base_lut, lut)) {
            return;
        }
        const bool has_no_file = state.recipe_path.empty();
        if (state.saved.base_lut && state.saved.base == recipe.base) {
            replace(state.saved, has_no_file);
        }
        replace(state.recipe, has_no_file);
        state.told = told;
    });
}

bool take_recipe(History& history, const io::Look& look) {
    take_base_of(history, look);
    const State& state = history.draft();
    State next = state;
    open_look(next, look);
    if (hold_the_same(next.recipe.base_lut, state.recipe.base_lut)) {
        next.recipe.base_lut = next.saved.base_lut = state.recipe.base_lut;
    }
    if (state.recipe_path != look.path() || hold_the_same(next.recipe, state.saved)) {
        return true;
    }
    const bool is_there = hold_the_same(next.recipe, state.recipe);
    const bool is_kept = !is_there && is_unsaved(state);
    const lutlib::Recipe saved = is_there ? state.recipe : next.recipe;
    history.change_all([&](State& each) {
        if (each.recipe_path == look.path()) {
            each.saved = saved;
        }
    });
    if (!is_there && !is_kept) {
        history.insert(std::move(next));
    }
    return !is_kept;
}

void take_side(History& history, const Side& fresh) {
    history.change_all([&](State& state) {
        for (Side& side : state.sides) {
            if (side.path == fresh.path && side.said == fresh.said && side.lut &&
                !hold_the_same(side.lut, fresh.lut)) {
                side.lut = fresh.lut;
                side.files = fresh.files;
                side.told = fresh.told;
            }
        }
    });
}

bool is_file_as_saved(const State& state) {
    std::error_code unknown;
    if (!std::filesystem::exists(state.recipe_path, unknown)) {
        return true;
    }
    try {
        const RecipeFile file = read_recipe_file(state.recipe_path);
        if (is_own(state, file.bytes)) {
            return true;
        }
        if (!file.look) {
            return false;
        }
        State opened;
        open_look(opened, *file.look);
        return hold_the_same(opened.saved, state.saved);
    } catch (const lutlib::Error&) {
        return false;
    }
}

bool is_offered(const State& state, const io::Look& offered) {
    return state.recipe_path == offered.path() && is_unsaved(state);
}

void take_offered(History& history, const io::Look& offered) {
    State next = history.draft();
    open_look(next, offered);
    history.insert(std::move(next));
}

} // namespace preview::editor
