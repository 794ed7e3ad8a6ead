// For targets of 8 bits on devices with half-float arithmetic.
#version 460
#extension GL_GOOGLE_include_directive : require
#define FINISH_HALF
#include "common/finish_shared.glsl"
