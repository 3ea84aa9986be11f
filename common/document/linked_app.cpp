#include "document/linked_app.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>

namespace ductus {

QString programOf(LinkedApp app)
{
    switch (app) {
    case LinkedApp::SketchSurfacer:
        return QStringLiteral("sketchsurfacer");
    case LinkedApp::LayerPainter:
        return QStringLiteral("layerpainter");
    case LinkedApp::DoodleStudio:
        return QStringLiteral("doodlestudio");
    }
    return {};
}

QString findProgram(LinkedApp app)
{
    const QString name = programOf(app);
    const QString here = QCoreApplication::applicationDirPath();
    const QString beside = QStandardPaths::findExecutable(
        name, {here, here + QStringLiteral("/../") + name}); // installed; in the tree of a build
    return beside.isEmpty() ? QStandardPaths::findExecutable(name) : beside;
}

Result<void> openInApp(LinkedApp app, const QString &file)
{
    const std::string name = programOf(app).toStdString(), attempted = "Opening " + name;
    if (!QFileInfo::exists(file))
        return Error{ErrorCode::FileNotFound, attempted, "the project is not where it was saved",
                     "Save it again", file.toStdString()};
    const QString program = findProgram(app);
    if (program.isEmpty())
        return Error{ErrorCode::FileNotFound, attempted, "the program is not installed",
                     "Install it beside this one, or put its folder into PATH", ""};
    if (!QProcess::startDetached(program, {file}))
        return Error{ErrorCode::ReadFailed, attempted, "the program does not start", "",
                     program.toStdString()};
    return {};
}

} // namespace ductus
