#include "render/passes/mask_pass.h"

#include "render/passes/element_pass.h"

#include <cmath>

namespace ductus {

namespace {

void setVector(const Program &program, const char *name, const Vec3 &v)
{
    glUniform3f(program.at(name), float(v[0]), float(v[1]), float(v[2]));
}

void setGradient(const Program &program, const GradientMask &mask, const Vec3 &eye)
{
    setVector(program, "start", mask.start - eye);
    setVector(program, "axis", mask.end - mask.start);
    glUniform2f(program.at("opacities"), float(mask.opacityAtStart), float(mask.opacityAtEnd));
    glUniform1i(program.at("smoothEasing"), mask.easing == MaskEasing::Smooth);
}

void setNoise(const Program &program, const NoiseMask &mask, const Vec3 &eye)
{
    const Vec3 inCells = (eye / mask.cellSize).cwiseMax(-2e9).cwiseMin(2e9);
    const Vec3 cell = inCells.array().floor();
    glUniform1f(program.at("cellsPerUnit"), float(1 / mask.cellSize));
    glUniform3i(program.at("eyeCell"), GLint(cell[0]), GLint(cell[1]), GLint(cell[2]));
    setVector(program, "eyeInCell", inCells - cell);
    glUniform1ui(program.at("seedStart"),
                 std::uint32_t(mask.seed) ^ (std::uint32_t(mask.seed >> 32) * 0x9e3779b9u)); // mask_value.h
    glUniform4f(program.at("ramp"), float(mask.threshold), float(mask.softness), float(mask.low),
                float(mask.high));
}

void setBlock(const Program &program, const TextureMask &mask, const Vec3 &eye, MaskBlocks &blocks)
{
    glActiveTexture(GL_TEXTURE3);
    glBindTexture(GL_TEXTURE_3D, blocks.textureOf(mask));
    const Eigen::Affine3d cubeFromRelative = mask.placement.matrix().inverse() * Eigen::Translation3d(eye);
    const Eigen::Matrix4f matrix = cubeFromRelative.matrix().cast<float>();
    glUniformMatrix4fv(program.at("cubeFromRelative"), 1, GL_FALSE, matrix.data());
}

int kindOf(const Mask &mask)
{
    if (const auto *gradient = std::get_if<GradientMask>(&mask.shape))
        return gradient->shape == GradientMask::Shape::Linear ? 0 : 1;
    return int(mask.shape.index()) + 1;
}

Result<void> drawStrokesOf(FrameContext &frame, const StrokeMask &mask, const PixelRect &rect,
                           StackId onlyStack)
{
    frame.bindTarget(frame.buffers.coverageTarget);
    frame.setScissor(rect);
    constexpr std::array<float, 4> none{};
    glClearBufferfv(GL_COLOR, 0, none.data());
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    const DrawnLayer *layer = frame.painting.maskLayer(mask.layer);
    if (!layer)
        return {};
    return drawCoverage(frame, *layer, lookAtAppearance(frame, *layer), onlyStack);
}

} // namespace

GLuint MaskBlocks::textureOf(const TextureMask &mask)
{
    Block &block = mBlocks[mask.values.get()];
    block.isUsed = true;
    if (block.texture)
        return block.texture.name();
    block.values = mask.values;
    block.texture = GlTexture::create();
    glBindTexture(GL_TEXTURE_3D, block.texture.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexStorage3D(GL_TEXTURE_3D, 1, GL_R8, mask.width, mask.height, mask.depth);
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, mask.width, mask.height, mask.depth, GL_RED, GL_UNSIGNED_BYTE,
                    mask.values->data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return block.texture.name();
}

void MaskBlocks::dropUnused()
{
    std::erase_if(mBlocks, [](const auto &block) { return !block.second.isUsed; });
    for (auto &[values, block] : mBlocks)
        block.isUsed = false;
}

bool hasMasks(const DrawnLayer &layer)
{
    return std::any_of(layer.properties.masks.begin(), layer.properties.masks.end(),
                       [](const Mask &mask) { return mask.enabled; });
}

Result<void> drawMasks(FrameContext &frame, MaskBlocks &blocks, const DrawnLayer &layer,
                       const PixelRect &rect, StackId onlyStack)
{
    bool isFirst = true;
    for (const Mask &mask : layer.properties.masks) {
        if (!mask.enabled)
            continue;
        const auto *strokes = std::get_if<StrokeMask>(&mask.shape);
        if (strokes)
            if (Result<void> done = drawStrokesOf(frame, *strokes, rect, onlyStack); !done)
                return done;
        const Result<const Program *> found = frame.programs.mask(kindOf(mask));
        if (!found)
            return found.error();
        const Program &program = **found;
        frame.bindTarget(frame.buffers.maskTarget);
        frame.setScissor(rect);
        glDisable(GL_DEPTH_TEST);
        if (isFirst) {
            glDisable(GL_BLEND);
        } else {
            glEnable(GL_BLEND);
            glBlendFunc(GL_DST_COLOR, GL_ZERO);
        }
        isFirst = false;
        program.use();
        frame.buffers.bind(1, frame.buffers.layer);
        glUniform1i(program.at("inverted"), mask.inverted);
        if (const auto *gradient = std::get_if<GradientMask>(&mask.shape)) {
            setGradient(program, *gradient, frame.camera.eye);
        } else if (const auto *noise = std::get_if<NoiseMask>(&mask.shape)) {
            setNoise(program, *noise, frame.camera.eye);
        } else if (const auto *block = std::get_if<TextureMask>(&mask.shape)) {
            setBlock(program, *block, frame.camera.eye, blocks);
        } else {
            frame.buffers.bind(3, frame.buffers.coverage);
            glUniform1i(program.at("inside"), strokes->inside);
        }
        frame.drawWholeFrame();
    }
    return {};
}

} // namespace ductus
