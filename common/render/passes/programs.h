// The shaders of a frame, compiled when first needed.
#pragma once

#include "painting/blend/blend_mode.h"
#include "render/gl/shader_program.h"

#include <map>
#include <string>

namespace ductus {

/// How far strokes colour: not beyond themselves, or see ToleranceMode.
enum class Reach { Inside, Surface, View };

struct SegmentProgramKind
{
    enum class Pass { Substrate, Appearance, Coverage };
    Pass pass = Pass::Substrate;
    Reach reach = Reach::Inside;
    int onlySection = -1; // the one StrokeSection that occurs
    bool uniformColour = false, uniformOpacity = false;
    bool peeling = false;
};

class Program
{
public:
    Program() = default;
    explicit Program(GlProgram program) : mProgram(std::move(program)) {}

    void use() const { glUseProgram(mProgram.name()); }
    GLint at(const char *uniform) const { return uniformAt(mProgram, uniform); }

private:
    GlProgram mProgram;
};

class Programs
{
public:
    Programs(BlendSpace space, int samples) : mSpace(space), mSamples(samples) {}

    BlendSpace space() const { return mSpace; }
    int samples() const { return mSamples; }

    Result<const Program *> segments(const SegmentProgramKind &kind);
    Result<const Program *> ribbons(bool peeling);
    Result<const Program *> meshSubstrate(bool peeling);
    /// Counts how often meshes wind around the surface point.
    Result<const Program *> meshWinding();
    /// Colours where they do.
    Result<const Program *> meshCover(bool coverageOnly);
    /// Colours what is near a triangle.
    Result<const Program *> meshNear(Reach reach, bool coverageOnly);
    /// \a kind as in mask_fragment.glsl.
    Result<const Program *> mask(int kind);
    Result<const Program *> composite(BlendMode mode, bool readsFrame, bool masked);
    Result<const Program *> accumulate();
    Result<const Program *> present();

private:
    Result<const Program *> get(const std::vector<std::string_view> &vertex,
                                const std::vector<std::string_view> &fragment,
                                std::vector<std::string> defines);

    BlendSpace mSpace;
    int mSamples;
    std::map<std::string, Program> mKnown;
};

} // namespace ductus
