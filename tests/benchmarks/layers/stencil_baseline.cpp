#include "benchmarks/layers/stencil_baseline.h"

#include "painting/blend/blend.h"
#include "render/gl/gl_error.h"

#include <cmath>
#include <numbers>

namespace ductus {

namespace {

constexpr int sides = 8;

const char *tubeVertex = R"(#version 430 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 colour;
uniform mat4 clipFromScene;
flat out vec3 vColour;
void main() { gl_Position = clipFromScene * vec4(position, 1.0); vColour = colour; }
)";
const char *tubeFragment = R"(#version 430 core
flat in vec3 vColour;
out vec4 outColour;
void main() { outColour = vec4(vColour, 1.0); }
)";
const char *copyVertex = R"(#version 430 core
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }
)";
// Normal, multiply, screen, overlay, in the formulas of the prototype, of what the frame was before.
const char *blendFragment = R"(#version 430 core
layout(binding = 0) uniform sampler2D layer;
layout(binding = 1) uniform sampler2D before;
uniform int mode;
uniform float opacity;
out vec4 outColour;
void main()
{
    vec4 s = texelFetch(layer, ivec2(gl_FragCoord.xy), 0);
    vec3 b = texelFetch(before, ivec2(gl_FragCoord.xy), 0).rgb, c = s.rgb / max(s.a, 1e-4);
    if (mode == 1)
        c = b * c;
    else if (mode == 2)
        c = b + c - b * c;
    else if (mode == 3)
        c = mix(1.0 - 2.0 * (1.0 - b) * (1.0 - c), 2.0 * b * c, lessThanEqual(b, vec3(0.5)));
    outColour = vec4(c, 1.0) * s.a * opacity;
}
)";

GlProgram program(const char *vertexText, const char *fragmentText)
{
    GlProgram made = GlProgram::create();
    for (const auto &[kind, text] :
         {std::pair(GL_VERTEX_SHADER, vertexText), std::pair(GL_FRAGMENT_SHADER, fragmentText)}) {
        const GLuint shader = glCreateShader(GLenum(kind));
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        glAttachShader(made.name(), shader);
        glDeleteShader(shader);
    }
    glLinkProgram(made.name());
    return made;
}

struct TubeMesh
{
    std::vector<float> vertices; // position, colour
    std::vector<GLuint> indices;

    void add(const StrokeShape &stroke)
    {
        const auto start = GLuint(vertices.size() / 6);
        const std::size_t count = stroke.points.size();
        for (std::size_t i = 0; i < count; ++i) {
            const PaintedPoint &point = stroke.points[i];
            const Vec3 colour = toBlendSpace(BlendSpace::Encoded, point.colour.cast<double>());
            const Vec3 tangent = (stroke.points[std::min(i + 1, count - 1)].position -
                                  stroke.points[i > 0 ? i - 1 : 0].position)
                                     .cast<double>()
                                     .normalized();
            const Vec3 u = point.normal.cast<double>().cross(tangent).normalized(), v = tangent.cross(u);
            for (int k = 0; k < sides; ++k) {
                const double angle = 2 * std::numbers::pi * k / sides;
                const Vec3 at = point.position.cast<double>() +
                                double(point.halfWidth) * (std::cos(angle) * u + std::sin(angle) * v);
                for (const float value : {float(at[0]), float(at[1]), float(at[2]), float(colour[0]),
                                          float(colour[1]), float(colour[2])})
                    vertices.push_back(value);
            }
        }
        const auto at = [&](std::size_t ring, int k) {
            return start + GLuint(ring) * sides + GLuint(k % sides);
        };
        for (std::size_t i = 0; i + 1 < count; ++i)
            for (int k = 0; k < sides; ++k)
                for (const GLuint index :
                     {at(i, k), at(i, k + 1), at(i + 1, k), at(i, k + 1), at(i + 1, k + 1), at(i + 1, k)})
                    indices.push_back(index);
        for (int k = 1; k + 1 < sides; ++k) {
            for (const GLuint index : {at(0, 0), at(0, k + 1), at(0, k)})
                indices.push_back(index);
            for (const GLuint index : {at(count - 1, 0), at(count - 1, k), at(count - 1, k + 1)})
                indices.push_back(index);
        }
    }
};

void storeTexture(const GlTexture &texture, GLenum format, int width, int height)
{
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
}

} // namespace

Result<StencilBaseline> StencilBaseline::create(const Painting &painting, int width, int height)
{
    StencilBaseline made;
    made.mWidth = width;
    made.mHeight = height;
    TubeMesh mesh;
    const auto addLayer = [&](const Layer &layer) {
        std::vector<Range> ranges;
        for (const Element &element : layer.drawings[0].elements) {
            const auto first = GLint(mesh.indices.size());
            mesh.add(std::get<StrokeShape>(*element.shape));
            ranges.push_back({first, GLsizei(mesh.indices.size()) - first});
        }
        return ranges;
    };
    made.mSubstrate = addLayer(*painting.stacks[0].substrate);
    for (const Layer &layer : painting.stacks[0].appearance)
        made.mLayers.push_back({addLayer(layer),
                                layer.properties.blendMode == BlendMode::Multiply  ? 1
                                : layer.properties.blendMode == BlendMode::Screen  ? 2
                                : layer.properties.blendMode == BlendMode::Overlay ? 3
                                                                                   : 0,
                                float(layer.properties.opacity)});

    made.mVertices = GlBuffer::create();
    made.mIndices = GlBuffer::create();
    made.mArray = GlVertexArray::create();
    made.mNothing = GlVertexArray::create();
    glBindVertexArray(made.mArray.name());
    glBindBuffer(GL_ARRAY_BUFFER, made.mVertices.name());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh.vertices.size() * 4), mesh.vertices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, made.mIndices.name());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.indices.size() * 4), mesh.indices.data(),
                 GL_STATIC_DRAW);
    for (GLuint i = 0; i < 2; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 24,
                              reinterpret_cast<const void *>(std::size_t(12) * i));
    }
    glBindVertexArray(0);
    made.mTubes = program(tubeVertex, tubeFragment);
    made.mBlend = program(copyVertex, blendFragment);

    made.mColour = GlTexture::create();
    made.mCopy = GlTexture::create();
    made.mLayer = GlTexture::create();
    made.mDepth = GlTexture::create();
    storeTexture(made.mColour, GL_RGBA8, width, height);
    storeTexture(made.mCopy, GL_RGBA8, width, height);
    storeTexture(made.mLayer, GL_RGBA8, width, height);
    storeTexture(made.mDepth, GL_DEPTH24_STENCIL8, width, height);
    for (const auto &[target, colour] :
         {std::pair(&made.mTarget, &made.mColour), std::pair(&made.mLayerTarget, &made.mLayer)}) {
        *target = GlFramebuffer::create();
        glBindFramebuffer(GL_FRAMEBUFFER, target->name());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour->name(), 0);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, made.mDepth.name(),
                               0);
    }
    if (Result<void> fine = checkGl("Preparing the stencil method"); !fine)
        return fine.error();
    return made;
}

void StencilBaseline::draw(const FrameCamera &camera, bool withLayers)
{
    Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
    const double near = 0.05, far = 100;
    clip(0, 0) = 2 / (camera.right - camera.left);
    clip(1, 1) = 2 / (camera.up - camera.down);
    clip(2, 2) = -(far + near) / (far - near);
    clip(2, 3) = -2 * far * near / (far - near);
    clip(3, 2) = -1;
    Eigen::Affine3d cameraFromScene =
        Eigen::Affine3d(camera.rotation.conjugate()) * Eigen::Translation3d(-camera.eye);
    const Eigen::Matrix4f matrix = (clip * cameraFromScene.matrix()).cast<float>();
    const auto drawRange = [](const Range &range) {
        glDrawElements(GL_TRIANGLES, range.count, GL_UNSIGNED_INT,
                       reinterpret_cast<const void *>(std::size_t(range.first) * 4));
    };

    glViewport(0, 0, mWidth, mHeight);
    glBindFramebuffer(GL_FRAMEBUFFER, mTarget.name());
    glClearColor(0, 0, 0, 0);
    glStencilMask(0xff);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_STENCIL_TEST);
    glBindVertexArray(mArray.name());
    glUseProgram(mTubes.name());
    glUniformMatrix4fv(glGetUniformLocation(mTubes.name(), "clipFromScene"), 1, GL_FALSE, matrix.data());
    glDepthFunc(GL_LEQUAL);
    glStencilFunc(GL_ALWAYS, 1, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    for (const Range &range : mSubstrate)
        drawRange(range);
    glDepthMask(GL_FALSE);

    for (const LayerRanges &layer : mLayers) {
        if (!withLayers)
            break;
        glBindFramebuffer(GL_FRAMEBUFFER, mLayerTarget.name());
        glClear(GL_COLOR_BUFFER_BIT);
        glBindVertexArray(mArray.name());
        glUseProgram(mTubes.name());
        glEnable(GL_STENCIL_TEST);
        for (const Range &range : layer.strokes) {
            glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); // 1: nothing is marked here
            glStencilMask(0xc0);
            glDepthFunc(GL_ALWAYS);
            glStencilFunc(GL_ALWAYS, 0x40, 0xff);
            glStencilOp(GL_KEEP, GL_REPLACE, GL_REPLACE);
            drawRange(range);
            glDepthFunc(GL_GEQUAL); // 2: a back face lies behind the surface
            glEnable(GL_CULL_FACE);
            glCullFace(GL_FRONT);
            glStencilFunc(GL_ALWAYS, 0xc0, 0xff);
            glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
            drawRange(range);
            glDisable(GL_CULL_FACE);
            glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE); // 3: and any face before it
            glDepthFunc(GL_LEQUAL);
            glStencilMask(0x40);
            glStencilFunc(GL_EQUAL, 0xc1, 0xff);
            glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
            glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
            drawRange(range);
            glDisable(GL_BLEND);
        }
        glDisable(GL_STENCIL_TEST);
        glDisable(GL_DEPTH_TEST);
        composite(layer);
        glEnable(GL_DEPTH_TEST);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_STENCIL_TEST);
    glStencilMask(0xff);
    glDepthFunc(GL_LESS);
}

// Two whole-frame passes a layer, as the prototype does it: the frame is copied, the layer blended onto it.
void StencilBaseline::composite(const LayerRanges &layer)
{
    glCopyImageSubData(mColour.name(), GL_TEXTURE_2D, 0, 0, 0, 0, mCopy.name(), GL_TEXTURE_2D, 0, 0, 0, 0,
                       mWidth, mHeight, 1);
    glBindFramebuffer(GL_FRAMEBUFFER, mTarget.name());
    glUseProgram(mBlend.name());
    glUniform1i(glGetUniformLocation(mBlend.name(), "mode"), layer.mode);
    glUniform1f(glGetUniformLocation(mBlend.name(), "opacity"), layer.opacity);
    glBindVertexArray(mNothing.name());
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, mCopy.name());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, mLayer.name());
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
}

} // namespace ductus
