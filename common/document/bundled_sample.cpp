#include "document/bundled_sample.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace ductus {

QString bundledSampleId(const QString &path, const QString &listName)
{
    const QFileInfo file(path);
    QFile list(file.absoluteDir().filePath(listName));
    if (!file.isFile() || !list.open(QIODevice::ReadOnly))
        return {};
    const QJsonObject content = QJsonDocument::fromJson(list.readAll()).object();
    for (const QJsonValue &sample : content[QLatin1String("samples")].toArray())
        if (sample[QLatin1String("file")].toString() == file.fileName())
            return sample[QLatin1String("id")].toString();
    return {};
}

} // namespace ductus
