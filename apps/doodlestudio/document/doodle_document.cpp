#include "doodlestudio/document/doodle_document.h"

#include "document/project_picture.h"
#include "doodling/canvas/edit_scene.h"

#include <QDir>
#include <QFileInfo>
#include <QUndoCommand>

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

/// The one undo command of DoodleStudio: this scene becomes that scene. Marks are shared between scenes, so a
/// step costs little.
class EditScene : public QUndoCommand
{
public:
    EditScene(DoodleDocument &document, const QString &text, std::shared_ptr<const DoodleScene> after,
              quint64 drag)
        : QUndoCommand(text), mDocument(document), mBefore(document.sharedScene()), mAfter(std::move(after)),
          mDrag(drag)
    {
    }

    void redo() override { mDocument.show(mAfter); }
    void undo() override { mDocument.show(mBefore); }
    int id() const override { return mDrag > 0 ? 1 : -1; }

    bool mergeWith(const QUndoCommand *other) override
    {
        const auto *next = dynamic_cast<const EditScene *>(other);
        if (!next || next->mDrag != mDrag || next->text() != text())
            return false;
        mAfter = next->mAfter;
        return true;
    }

private:
    DoodleDocument &mDocument;
    std::shared_ptr<const DoodleScene> mBefore, mAfter;
    quint64 mDrag;
};

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

DoodleDocument::DoodleDocument(QObject *parent)
    : Document(parent), mScene(std::make_shared<const DoodleScene>()), mDocumentId(Uuid::create())
{
}

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

Result<void> DoodleDocument::startSample(Project project, const QString &path, const QString &name)
{
    if (Result<void> loaded = load(std::move(project), {}); !loaded)
        return loaded;
    mClip.path = QFileInfo(path).absoluteFilePath().toStdString();
    setUntitledName(name);
    return {};
}

void DoodleDocument::relocateClip(const QString &path)
{
    mClip.path = QFileInfo(path).absoluteFilePath().toStdString();
    touch();
    emit changed(ClipChanged());
}

bool DoodleDocument::edit(const QString &text, Result<DoodleScene> scene, quint64 drag)
{
    if (!scene) {
        emit refused(scene.error());
        return false;
    }
    undoStack()->push(
        new EditScene(*this, text, std::make_shared<const DoodleScene>(std::move(*scene)), drag));
    return true;
}

bool DoodleDocument::editCanvas(const QString &text, Result<Canvas> canvas, quint64 drag)
{
    if (!canvas) {
        emit refused(canvas.error());
        return false;
    }
    return edit(text, withChangedCanvas(*mScene, std::move(*canvas)), drag);
}

bool DoodleDocument::editDoodle(const QString &text, CanvasId id, Result<Doodle> doodle, quint64 drag)
{
    const Canvas *old = canvas(id);
    if (!old)
        return false;
    if (!doodle) {
        emit refused(doodle.error());
        return false;
    }
    Canvas changed = *old;
    changed.doodle = std::move(*doodle);
    return edit(text, withChangedCanvas(*mScene, std::move(changed)), drag);
}

void DoodleDocument::show(std::shared_ptr<const DoodleScene> scene)
{
    mScene = std::move(scene);
    emit changed(SceneChanged());
}

void DoodleDocument::setShot(std::shared_ptr<const Shot> shot, std::string digest)
{
    const bool isAsSaved = leftShot() != nullptr && mClip.digest == digest;
    mShot = std::move(shot);
    mClip.digest = std::move(digest);
    if (!isAsSaved)
        touch();
    emit changed(ShotChanged());
}

std::shared_ptr<const Shot> DoodleDocument::leftShot() const
{
    return !mShot && mContent && mContent->shot()->isLeftInCache ? mContent->shot() : nullptr;
}

void DoodleDocument::setPacksAnalysis(bool packs)
{
    if (packs == mPacksAnalysis)
        return;
    mPacksAnalysis = packs;
    touch();
}

std::shared_ptr<const Shot> DoodleDocument::sceneShot() const
{
    if (mShot)
        return mShot;
    if (std::shared_ptr<const Shot> left = leftShot())
        return left;
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
    // Saved before the analysis was done: cameras and nothing else.
    mShot = mContent->shot()->isAnalysed() ? mContent->shot() : nullptr;
    mPacksAnalysis = mContent->packsAnalysis();
    mPlainShot = nullptr;
    mScene = mContent->scene();
    mPicture = {};
    undoStack()->clear();
    return {};
}

void DoodleDocument::writeTo(Project &project) const
{
    ClipReference clip = mClip;
    clip.path = seenFrom(mSnapshotFolder, clipPath()).toStdString();
    auto content = std::make_shared<const DoodleContent>(std::move(clip), sceneShot(),
                                                         mContent ? mContent->unknown() : UnknownMembers(),
                                                         mScene, mPacksAnalysis);
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
    mScene = std::make_shared<const DoodleScene>();
    mClip = {};
    mShot = nullptr;
    mPacksAnalysis = false;
    mPlainShot = nullptr;
    mContent = nullptr;
    mDocumentId = Uuid::create();
    mPicture = {};
}

} // namespace ductus
