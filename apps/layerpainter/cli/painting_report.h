// What is in a painting, counted: for reports and `layerpainter info`.
#pragma once

#include "layerpainter/document/import_file.h"

#include <nlohmann/json.hpp>

namespace ductus {

/// Counts, stacks with their layers, looks, motion.
nlohmann::ordered_json paintingSummary(const Painting &painting);

/// The same for people, a line each.
std::string paintingLines(const Painting &painting);

/// The report of an import: schema "import-report", version 1.
nlohmann::ordered_json importReport(const std::string &input, const ImportedFile &imported);

} // namespace ductus
