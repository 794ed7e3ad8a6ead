// The engines' arithmetic, in float as theirs, which rows of engine.cpp name: what each shader
// makes of a picture of codes/maximum with `n` nodes a side and a colour in codes of 0..1.
#pragma once

#include "lutlib/engine/layout.h"

namespace lutlib::lookup {

Rgb piccolo(const Picture& picture, int n, Rgb in);
Rgb unreal(const Picture& picture, int n, Rgb in);
Rgb unity(const Picture& picture, int n, Rgb in);
Rgb reshade(const Picture& picture, int n, Rgb in);
Rgb playcanvas(const Picture& picture, int n, Rgb in);
Rgb obs(const Picture& picture, int n, Rgb in);
Rgb threejs(const Picture& picture, int n, Rgb in);
Rgb o3de(const Picture& picture, int n, Rgb in);
Rgb godot(const Picture& picture, int n, Rgb in);
Rgb hald(const Picture& picture, int n, Rgb in);
Rgb ocio(const Picture& picture, int n, Rgb in);

} // namespace lutlib::lookup
