#include "widgets/theme/icons.h"

#include "widgets/theme/tinted_icon_engine.h"

#include <QDir>
#include <QFile>
#include <set>

namespace ductus {

namespace {

const QString ownFolder = QStringLiteral(":/ductus/own/");
const QString breezeFolder = QStringLiteral(":/ductus/breeze/");

QString existing(const QString &path)
{
    return QFile::exists(path) ? path : QString();
}

} // namespace

QIcon icon(const QString &name)
{
    return icon(name, IconTint::Text);
}

QIcon icon(const QString &name, IconTint tint)
{
    if (name.isEmpty())
        return {};
    IconDrawings drawings;
    if (const QString own = existing(ownFolder + name + QStringLiteral(".svg")); !own.isEmpty()) {
        if (name.startsWith(QLatin1String("app-")))
            return QIcon(own); // has colours of its own
        drawings = {own, 24, {}};
    } else {
        const QString large = existing(breezeFolder + QStringLiteral("22/") + name + QStringLiteral(".svg"));
        const QString small = existing(breezeFolder + QStringLiteral("16/") + name + QStringLiteral(".svg"));
        if (large.isEmpty() && small.isEmpty())
            return {};
        drawings = large.isEmpty() ? IconDrawings{small, 16, {}} : IconDrawings{large, 22, small};
    }
    return QIcon(new TintedIconEngine(drawings, tint));
}

bool hasIcon(const QString &name)
{
    return !icon(name).isNull();
}

QStringList iconNames()
{
    std::set<QString> names;
    for (const QString &folder : {ownFolder, breezeFolder + "16", breezeFolder + "22"}) {
        for (const QString &file : QDir(folder).entryList({QStringLiteral("*.svg")}, QDir::Files))
            names.insert(file.chopped(4));
    }
    return QStringList(names.begin(), names.end());
}

} // namespace ductus
