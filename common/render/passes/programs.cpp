#include "render/passes/programs.h"

namespace ductus {

Result<const Program *> Programs::get(const std::vector<std::string_view> &vertex,
                                      const std::vector<std::string_view> &fragment,
                                      std::vector<std::string> defines)
{
    if (mSpace == BlendSpace::Linear)
        defines.push_back("LINEAR_BLENDING");
    if (mSamples > 1)
        defines.push_back("SAMPLES " + std::to_string(mSamples));
    std::string key;
    for (const std::string_view name : vertex)
        key += std::string(name) + ' ';
    for (const std::string_view name : fragment)
        key += std::string(name) + ' ';
    for (const std::string &define : defines)
        key += define + '\n';
    const auto found = mKnown.find(key);
    if (found != mKnown.end())
        return &found->second;
    Result<GlProgram> made = compileProgram({vertex, fragment, defines});
    if (!made)
        return made.error();
    return &mKnown.emplace(key, Program(std::move(*made))).first->second;
}

Result<const Program *> Programs::segments(const SegmentProgramKind &kind)
{
    std::vector<std::string> defines;
    if (kind.onlySection >= 0)
        defines.push_back("ONLY_SECTION " + std::to_string(kind.onlySection));
    if (kind.uniformColour)
        defines.push_back("UNIFORM_COLOUR");
    if (kind.uniformOpacity)
        defines.push_back("UNIFORM_OPACITY");
    if (kind.reach == Reach::Surface)
        defines.push_back("SURFACE_TOLERANCE");
    if (kind.reach == Reach::View)
        defines.push_back("VIEW_TOLERANCE");
    if (kind.pass == SegmentProgramKind::Pass::Coverage)
        defines.push_back("COVERAGE_ONLY");
    const std::vector<std::string_view> vertex{"view", "elements", "segment_vertex"};
    if (kind.pass != SegmentProgramKind::Pass::Substrate)
        return get(vertex, {"view", "surface_lookup", "order", "segment", "appearance_fragment"}, defines);
    defines.push_back("SKIN_ONLY");
    if (!kind.peeling)
        return get(vertex, {"view", "segment", "substrate_fragment"}, defines);
    defines.push_back("PEELING");
    return get(vertex, {"view", "peeling", "segment", "substrate_fragment"}, defines);
}

Result<const Program *> Programs::ribbons(bool peeling)
{
    const std::vector<std::string_view> vertex{"view", "elements", "ribbon_vertex"};
    if (!peeling)
        return get(vertex, {"view", "ribbon_fragment"}, {});
    return get(vertex, {"view", "peeling", "ribbon_fragment"}, {"PEELING"});
}

Result<const Program *> Programs::meshSubstrate(bool peeling)
{
    if (!peeling)
        return get({"view", "elements", "mesh_vertex"}, {"view", "mesh_substrate_fragment"}, {});
    return get({"view", "elements", "mesh_vertex"}, {"view", "peeling", "mesh_substrate_fragment"},
               {"PEELING"});
}

Result<const Program *> Programs::meshWinding()
{
    return get({"view", "elements", "mesh_vertex"}, {"view", "surface_lookup", "mesh_winding_fragment"}, {});
}

Result<const Program *> Programs::meshCover(bool coverageOnly)
{
    return get({"whole_frame_vertex"}, {"view", "surface_lookup", "order", "mesh_cover_fragment"},
               coverageOnly ? std::vector<std::string>{"COVERAGE_ONLY"} : std::vector<std::string>{});
}

Result<const Program *> Programs::meshNear(Reach reach, bool coverageOnly)
{
    std::vector<std::string> defines;
    if (reach == Reach::View)
        defines.push_back("VIEW_TOLERANCE");
    if (coverageOnly)
        defines.push_back("COVERAGE_ONLY");
    return get({"view", "elements", "mesh_near_vertex"},
               {"view", "surface_lookup", "order", "mesh_near_fragment"}, defines);
}

Result<const Program *> Programs::mask(int kind)
{
    return get({"whole_frame_vertex"}, {"view", "surface_lookup", "mask_fragment"},
               {"MASK_KIND " + std::to_string(kind)});
}

Result<const Program *> Programs::composite(BlendMode mode, bool readsFrame, bool masked)
{
    std::vector<std::string> defines;
    if (masked)
        defines.push_back("MASK_TEXTURE");
    if (!readsFrame)
        return get({"whole_frame_vertex"}, {"view", "surface_lookup", "composite_fragment"}, defines);
    defines.push_back("READS_FRAME");
    defines.push_back("BLEND_MODE " + std::to_string(int(mode)));
    return get({"whole_frame_vertex"}, {"view", "surface_lookup", "blend", "composite_fragment"}, defines);
}

Result<const Program *> Programs::accumulate()
{
    return get({"whole_frame_vertex"}, {"view", "surface_lookup", "accumulate_fragment"}, {});
}

Result<const Program *> Programs::present()
{
    return get({"whole_frame_vertex"}, {"view", "present_fragment"}, {});
}

} // namespace ductus
