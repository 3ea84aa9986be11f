#include "layerpainter/vr/draw/overlay.h"

#include "base/assert.h"

#include <cstddef>
#include <string>

namespace ductus {

namespace {

constexpr const char *vertexText = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 place;
layout(location = 2) in vec4 colour;
uniform mat4 clipFromRoom;
uniform vec4 depthOfRoom; // along the view, metres
out vec2 at;
out vec4 tint;
out float depth;
void main()
{
    gl_Position = clipFromRoom * vec4(position, 1.0);
    depth = dot(depthOfRoom, vec4(position, 1.0));
    at = place;
    tint = colour;
}
)";

constexpr const char *fragmentText = R"(
layout(location = 0) out vec4 outColour;
in vec2 at;
in vec4 tint;
in float depth;
#if SAMPLES > 1
layout(binding = 0) uniform usampler2DMS surface;
#elif SAMPLES == 1
layout(binding = 0) uniform usampler2D surface;
#endif
layout(binding = 1) uniform sampler2D picture;
uniform bool isPicture;
uniform float metresPerUnit;
void main()
{
    outColour = isPicture ? texture(picture, at) : tint;
#if SAMPLES > 0
    uvec2 seen = texelFetch(surface, ivec2(gl_FragCoord.xy), 0).xy;
    if (!isPicture && seen.x != 0u && uintBitsToFloat(seen.y) * metresPerUnit < depth - 0.002)
        outColour.a *= 0.25;
#endif
}
)";

constexpr const char *wholeText = R"(
void main()
{
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
)";

constexpr const char *convertText = R"(
layout(location = 0) out vec4 outColour;
layout(binding = 1) uniform sampler2D picture;
void main()
{
    vec4 c = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
    vec3 high = pow((c.rgb + 0.055) / 1.055, vec3(2.4));
    outColour = vec4(mix(high, c.rgb / 12.92, lessThanEqual(c.rgb, vec3(0.04045))), c.a);
}
)";

GlProgram compile(const char *vertex, const char *fragment, int samples)
{
    GlProgram program = GlProgram::create();
    const std::string head = "#version 430 core\n#define SAMPLES " + std::to_string(samples) + "\n";
    for (const auto &[kind, text] :
         {std::pair(GL_VERTEX_SHADER, vertex), std::pair(GL_FRAGMENT_SHADER, fragment)}) {
        const GLuint shader = glCreateShader(GLenum(kind));
        const char *parts[] = {head.c_str(), text};
        glShaderSource(shader, 2, parts, nullptr);
        glCompileShader(shader);
        glAttachShader(program.name(), shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program.name());
    GLint linked = 0;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    DUCTUS_ASSERT(linked); // the text is ours and always the same
    return program;
}

} // namespace

OverlayRenderer::OverlayRenderer()
    : mConvert(compile(wholeText, convertText, 0)), mArray(GlVertexArray::create()),
      mBuffer(GlBuffer::create())
{
    glBindVertexArray(mArray.name());
    glBindBuffer(GL_ARRAY_BUFFER, mBuffer.name());
    const auto attribute = [](GLuint index, int size, std::size_t offset) {
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(OverlayShapes::Vertex),
                              reinterpret_cast<const void *>(offset));
    };
    attribute(0, 3, offsetof(OverlayShapes::Vertex, position));
    attribute(1, 2, offsetof(OverlayShapes::Vertex, place));
    attribute(2, 4, offsetof(OverlayShapes::Vertex, colour));
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

GLuint OverlayRenderer::program(int samples)
{
    GlProgram &found = mPrograms[samples];
    if (!found)
        found = compile(vertexText, fragmentText, samples);
    return found.name();
}

void OverlayRenderer::upload(const OverlayShapes &shapes)
{
    mParts = shapes.mParts;
    glBindBuffer(GL_ARRAY_BUFFER, mBuffer.name());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(shapes.mVertices.size() * sizeof(OverlayShapes::Vertex)),
                 shapes.mVertices.data(), GL_STREAM_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void OverlayRenderer::draw(const FrameCamera &camera, const std::optional<SeenSurface> &surface,
                           double metresPerUnit)
{
    if (mParts.empty())
        return;
    constexpr double nearest = 0.02, farthest = 200; // metres
    const double l = camera.left, r = camera.right, d = camera.down, u = camera.up;
    Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
    clip(0, 0) = 2 / (r - l);
    clip(0, 2) = (r + l) / (r - l);
    clip(1, 1) = 2 / (u - d);
    clip(1, 2) = (u + d) / (u - d);
    clip(2, 2) = -(farthest + nearest) / (farthest - nearest);
    clip(2, 3) = -2 * farthest * nearest / (farthest - nearest);
    clip(3, 2) = -1;
    Eigen::Isometry3d room = Eigen::Isometry3d::Identity();
    room.linear() = camera.rotation.toRotationMatrix();
    room.translation() = camera.eye;
    const Eigen::Matrix4d cameraFromRoom = room.inverse().matrix();
    const Eigen::Matrix4f clipFromRoom = (clip * cameraFromRoom).cast<float>();
    const Eigen::Vector4f depth = -cameraFromRoom.row(2).cast<float>().transpose();

    const int samples = surface ? surface->samples : 0;
    const GLuint used = program(samples);
    glUseProgram(used);
    glUniformMatrix4fv(glGetUniformLocation(used, "clipFromRoom"), 1, GL_FALSE, clipFromRoom.data());
    glUniform4fv(glGetUniformLocation(used, "depthOfRoom"), 1, depth.data());
    glUniform1f(glGetUniformLocation(used, "metresPerUnit"), float(metresPerUnit));
    const GLint isPicture = glGetUniformLocation(used, "isPicture");
    const GLenum surfaceTarget = samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    if (surface) {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(surfaceTarget, surface->texture);
    }
    glActiveTexture(GL_TEXTURE1);
    glBindVertexArray(mArray.name());
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (const OverlayShapes::Part &part : mParts) {
        glUniform1i(isPicture, part.texture != 0);
        glBindTexture(GL_TEXTURE_2D, part.texture);
        glDrawArrays(GL_TRIANGLES, part.first, part.count);
    }
    glDisable(GL_BLEND);
    glBindTexture(GL_TEXTURE_2D, 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(surfaceTarget, 0);
    glBindVertexArray(0);
    glUseProgram(0);
}

void OverlayRenderer::convert(std::uint32_t from)
{
    glUseProgram(mConvert.name());
    glBindVertexArray(mArray.name());
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, from);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindTexture(GL_TEXTURE_2D, 0);
    glActiveTexture(GL_TEXTURE0);
    glBindVertexArray(0);
    glUseProgram(0);
}

} // namespace ductus
