#include "render/gl/shader_program.h"

#include "base/assert.h"

namespace ductus {

namespace {

std::string assembled(const std::vector<std::string_view> &names, const std::vector<std::string> &defines)
{
    std::string text = "#version 430 core\n";
    for (const std::string &define : defines)
        text += "#define " + define + "\n";
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string_view part = shaderText(names[i]);
        DUCTUS_ASSERT(!part.empty());
        // The number before a line in the compiler's message is the place of the text in this list.
        text += "#line 1 " + std::to_string(i) + "\n";
        text += part;
    }
    return text;
}

Error failure(const std::string &what, const std::vector<std::string_view> &names, std::string log)
{
    std::string parts;
    for (std::size_t i = 0; i < names.size(); ++i)
        parts += (i ? ", " : "") + std::to_string(i) + " = " + std::string(names[i]) + ".glsl";
    while (!log.empty() && (log.back() == '\n' || log.back() == '\0'))
        log.pop_back();
    return {ErrorCode::Unsupported,
            "Preparing the graphics card",
            what + " (" + parts + "): " + log,
            "Update the graphics driver, or start with LIBGL_ALWAYS_SOFTWARE=1",
            {}};
}

/// Owns a shader until it is linked.
struct Shader
{
    explicit Shader(GLenum kind) : name(glCreateShader(kind)) {}
    ~Shader() { glDeleteShader(name); }
    Shader(const Shader &) = delete;
    Shader &operator=(const Shader &) = delete;
    GLuint name;
};

Result<void> compile(const Shader &shader, const std::vector<std::string_view> &names,
                     const std::vector<std::string> &defines)
{
    const std::string text = assembled(names, defines);
    const char *pointer = text.c_str();
    glShaderSource(shader.name, 1, &pointer, nullptr);
    glCompileShader(shader.name);
    GLint compiled = 0, length = 0;
    glGetShaderiv(shader.name, GL_COMPILE_STATUS, &compiled);
    if (compiled)
        return {};
    glGetShaderiv(shader.name, GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(std::max(length, 1)), '\0');
    glGetShaderInfoLog(shader.name, length, nullptr, log.data());
    return failure("a shader does not compile", names, std::move(log));
}

} // namespace

Result<GlProgram> compileProgram(const ShaderSource &source)
{
    const Shader vertex(GL_VERTEX_SHADER), fragment(GL_FRAGMENT_SHADER);
    if (Result<void> done = compile(vertex, source.vertex, source.defines); !done)
        return done.error();
    if (Result<void> done = compile(fragment, source.fragment, source.defines); !done)
        return done.error();
    GlProgram program = GlProgram::create();
    glAttachShader(program.name(), vertex.name);
    glAttachShader(program.name(), fragment.name);
    glLinkProgram(program.name());
    GLint linked = 0, length = 0;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked)
        return program;
    glGetProgramiv(program.name(), GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(std::max(length, 1)), '\0');
    glGetProgramInfoLog(program.name(), length, nullptr, log.data());
    return failure("the shaders do not fit together", source.fragment, std::move(log));
}

} // namespace ductus
