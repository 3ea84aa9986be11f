// Shaders from the texts in render/shaders, with readable errors.
#pragma once

#include "base/result.h"
#include "render/gl/gl_object.h"

#include <string>
#include <string_view>
#include <vector>

namespace ductus {

/// The text of render/shaders/NAME.glsl; empty if there is none.
std::string_view shaderText(std::string_view name);

struct ShaderSource
{
    std::vector<std::string_view> vertex;   // names of texts, in order
    std::vector<std::string_view> fragment; // likewise
    std::vector<std::string> defines;       // "SAMPLES 4"
};

/// Unsupported with the compiler's message; its lines name the text they stand in.
Result<GlProgram> compileProgram(const ShaderSource &source);

/// Of the current program; -1 if the shader does not use it.
inline GLint uniformAt(const GlProgram &program, const char *name)
{
    return glGetUniformLocation(program.name(), name);
}

} // namespace ductus
