#version 460
#extension GL_GOOGLE_include_directive : require
#define HAS_DETAIL
#include "common/forward.glsl"
