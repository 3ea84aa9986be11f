#include "doodlestudio/document/clip_opening.h"

#include "document/document_files.h"
#include "doodling/clip/clip_digest.h"

#include <QDir>
#include <QFileInfo>

namespace ductus {

namespace {

const QStringList videoSuffixes{QStringLiteral("mp4"), QStringLiteral("mov"),  QStringLiteral("m4v"),
                                QStringLiteral("mkv"), QStringLiteral("avi"),  QStringLiteral("webm"),
                                QStringLiteral("mpg"), QStringLiteral("mpeg"), QStringLiteral("mts"),
                                QStringLiteral("wmv"), QStringLiteral("flv"),  QStringLiteral("ogv"),
                                QStringLiteral("3gp"), QStringLiteral("gif")};

} // namespace

Result<OpenedClip> openClipFile(const QString &path, const JobControl &control)
{
    control.progress(0.0, "Opening the clip");
    Result<std::unique_ptr<Clip>> clip = openClip(enginePath(path), control);
    if (!clip)
        return clip.error();
    OpenedClip opened;
    opened.clip = std::move(*clip);
    const ClipInfo &info = opened.clip->info();
    opened.reference = {QFileInfo(path).absoluteFilePath().toStdString(), info.frameCount, info.width,
                        info.height, info.framesPerSecond};
    return opened;
}

Result<OpenedClip> openMovedClip(const QString &path, const ClipReference &known, const JobControl &control)
{
    Result<OpenedClip> opened = openClipFile(path, control.part(0.0, 0.5));
    if (!opened || likenessOf(known, opened->reference) == ClipLikeness::Other)
        return opened;
    Result<std::string> digest = clipDigest(enginePath(path), control.part(0.5, 1.0));
    if (!digest)
        return digest.error();
    opened->reference.digest = std::move(*digest);
    return opened;
}

bool looksLikeClip(const QString &path)
{
    const QFileInfo info(path);
    if (info.isDir())
        return !QDir(path)
                    .entryList({QStringLiteral("*.jpg"), QStringLiteral("*.jpeg"), QStringLiteral("*.png"),
                                QStringLiteral("*.JPG"), QStringLiteral("*.PNG")},
                               QDir::Files)
                    .isEmpty();
    return videoSuffixes.contains(info.suffix().toLower());
}

QString clipPatterns()
{
    QStringList patterns;
    for (const QString &suffix : videoSuffixes)
        patterns << QStringLiteral("*.") + suffix;
    return patterns.join(QLatin1Char(' '));
}

ClipLikeness likenessOf(const ClipReference &known, const ClipReference &found)
{
    if (known.frameCount != found.frameCount || known.width != found.width || known.height != found.height)
        return ClipLikeness::Other;
    if (known.digest.empty() || found.digest.empty())
        return ClipLikeness::Alike;
    return known.digest == found.digest ? ClipLikeness::Same : ClipLikeness::OtherBytes;
}

} // namespace ductus
