// One layer object of Quill.json as plain data. quill-and-tilt.md section 3.
#pragma once

#include "formats/paintings/quill_scene.h"

#include <nlohmann/json.hpp>

namespace ductus {

struct QuillLayerRecord
{
    QuillLayer layer;
    std::vector<std::uint64_t> children; // numbers of layers taken out before this one
};

/// True for objects that look like a layer.
bool isQuillLayer(const nlohmann::json &object);

/// \a object is a layer whose child layers have been taken out (object_stream.h). \a place stands in the
/// error, \a notes grow by what was put right.
Result<QuillLayerRecord> quillLayer(const nlohmann::json &object, const std::string &place,
                                    std::vector<std::string> &notes);

} // namespace ductus
