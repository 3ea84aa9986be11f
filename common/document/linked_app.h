// Opening a project in another app of the suite.
#pragma once

#include "base/result.h"

#include <QString>

namespace ductus {

enum class LinkedApp { SketchSurfacer, LayerPainter, DoodleStudio };

/// The program's name: "layerpainter".
QString programOf(LinkedApp app);

/// Where \a app is: beside this program, as when both are installed or come out of one build; else in PATH.
/// Empty if it is nowhere.
QString findProgram(LinkedApp app);

/// Starts \a app with \a file and does not wait for it. Errors: FileNotFound when the app or the file is not
/// there, ReadFailed when the program does not start.
Result<void> openInApp(LinkedApp app, const QString &file);

} // namespace ductus
