#include "doodlestudio/document/doodle_document.h"

#include "document/project_picture.h"

#include <QDir>
#include <QFileInfo>

namespace ductus {

namespace {

// A plain lens, as wide as a phone's, as reconstructShot takes it where it knows nothing better.
constexpr double focalShareOfWidth = 0.9;
constexpr int workingLines = 480;

QString seenFrom(const QString &folder, const QString &path)
{
    return folder.isEmpty() ? path : QDir(folder).relativeFilePath(path);
}

} // namespace

Shot plainShot(const ClipReference &clip)
{
    Shot shot;
    shot.clipWidth = clip.width;
    shot.clipHeight = clip.height;
    std::tie(shot.width, shot.height) = scaledSize(clip.width, clip.height, workingLines);
    ShotCamera camera;
    camera.focal = focalShareOfWidth * shot.width;
    camera.centre = Vec2(0.5 * shot.width, 0.5 * shot.height);
    shot.cameras.assign(std::size_t(clip.frameCount), camera);
    return shot;
}

DoodleDocument::DoodleDocument(QObject *parent) : Document(parent), mDocumentId(Uuid::create()) {}

QString DoodleDocument::clipPath() const
{
    const QString path = QString::fromStdString(mClip.path);
    if (path.isEmpty() || QDir::isAbsolutePath(path) || filePath().isEmpty())
        return path;
    return QDir::cleanPath(QFileInfo(filePath()).absoluteDir().absoluteFilePath(path));
}

void DoodleDocument::start(const QString &path, ClipReference clip)
{
    reset();
    clip.path = QFileInfo(path).absoluteFilePath().toStdString();
    mClip = std::move(clip);
    emit changed(DocumentReset());
    setUntitledName(QFileInfo(path).completeBaseName());
}

void DoodleDocument::relocateClip(const QString &path)
{
    mClip.path = QFileInfo(path).absoluteFilePath().toStdString();
    touch();
    emit changed(ClipChanged());
}

void DoodleDocument::setShot(std::shared_ptr<const Shot> shot)
{
    mShot = std::move(shot);
    touch();
    emit changed(ShotChanged());
}

std::shared_ptr<const Shot> DoodleDocument::sceneShot() const
{
    if (mShot)
        return mShot;
    if (!mPlainShot || mPlainShot->frameCount() != mClip.frameCount || mPlainShot->clipWidth != mClip.width)
        mPlainShot = std::make_shared<const Shot>(plainShot(mClip));
    return mPlainShot;
}

Result<void> DoodleDocument::readFrom(const Project &project)
{
    Result<std::shared_ptr<const DoodleContent>> content = doodleOf(project);
    if (!content)
        return content.error();
    mContent = *content;
    for (const ProjectDocument &document : project.documents)
        if (document.content == mContent)
            mDocumentId = document.id;
    mClip = mContent->clip();
    mShot = mContent->shot();
    mPlainShot = nullptr;
    mPicture = {};
    undoStack()->clear();
    return {};
}

void DoodleDocument::writeTo(Project &project) const
{
    ClipReference clip = mClip;
    clip.path = seenFrom(mSnapshotFolder, clipPath()).toStdString();
    auto content = std::make_shared<const DoodleContent>(std::move(clip), mShot ? mShot : sceneShot());
    if (ProjectDocument *document = project.find(mDocumentId)) {
        document->content = std::move(content);
        document->name = displayName().toStdString();
    } else {
        project.documents.push_back(
            newDocument(mDocumentId, displayName().toStdString(), std::move(content)));
    }
    project.generator = "DoodleStudio";
    if (!mPicture.isNull())
        setProjectThumbnail(project, mPicture);
}

void DoodleDocument::clear()
{
    mClip = {};
    mShot = nullptr;
    mPlainShot = nullptr;
    mContent = nullptr;
    mDocumentId = Uuid::create();
    mPicture = {};
}

} // namespace ductus
