// DoodleDocument: one filmed shot with what was found out about it and what was drawn into it. The clip stays
// where it is: the document knows its place.
#pragma once

#include "document/document.h"
#include "doodling/canvas/canvas.h"
#include "doodling/storage/doodle_content.h"

#include <QImage>

namespace ductus {

/// The clip was found, or found elsewhere.
struct ClipChanged : ChangeEvent
{
};

/// The analysis of the clip is there.
struct ShotChanged : ChangeEvent
{
};

/// Canvases or what is drawn on them are others.
struct SceneChanged : ChangeEvent
{
};

class DoodleDocument : public Document
{
    Q_OBJECT
public:
    explicit DoodleDocument(QObject *parent = nullptr);

    bool isEmpty() const { return mClip.path.empty(); }
    /// The clip's facts; its path as stored.
    const ClipReference &clip() const { return mClip; }
    /// Absolute path of the clip: file or folder. It may not be there.
    QString clipPath() const;

    /// A new, unsaved document on the clip at \a path.
    void start(const QString &path, ClipReference clip);
    /// A sample: \a project as an unsaved document called \a name, its clip at \a path. Errors: those of
    /// load().
    Result<void> startSample(Project project, const QString &path, const QString &name);
    /// The clip is elsewhere now. No edit: the file is changed at the next save.
    void relocateClip(const QString &path);

    /// What is known of the scene; null until the analysis was done.
    std::shared_ptr<const Shot> shot() const { return mShot; }
    /// \a digest: clipDigest of the clip, empty if it is not known. What a saved project left in the cache
    /// and was found there again is no edit.
    void setShot(std::shared_ptr<const Shot> shot, std::string digest = {});
    /// The project's cameras while motion and depth are still in the cache; null at all other times.
    std::shared_ptr<const Shot> leftShot() const;
    /// Motion and depth are saved in the project as well, so that it can be given away.
    bool packsAnalysis() const { return mPacksAnalysis; }
    void setPacksAnalysis(bool packs);
    /// The analysis if there is one, else a camera that stands still: enough to place and draw.
    std::shared_ptr<const Shot> sceneShot() const;

    const DoodleScene &scene() const { return *mScene; }
    /// For workers and views; never null.
    std::shared_ptr<const DoodleScene> sharedScene() const { return mScene; }
    const Canvas *canvas(CanvasId id) const { return mScene->find(id); }

    /// Makes \a scene the present one as a step of the history called \a text ("Move canvas"). A refused
    /// edit changes nothing and is told by refused(). Steps of one \a drag (> 0) and text become one.
    bool edit(const QString &text, Result<DoodleScene> scene, quint64 drag = 0);
    /// The same for one canvas.
    bool editCanvas(const QString &text, Result<Canvas> canvas, quint64 drag = 0);
    /// The same for what is drawn on the canvas \a id.
    bool editDoodle(const QString &text, CanvasId id, Result<Doodle> doodle, quint64 drag = 0);

    /// The folder the next snapshot will be saved in: the clip's path is stored as seen from there. Empty:
    /// absolute, for copies whose folder means nothing.
    void setSnapshotFolder(const QString &folder) { mSnapshotFolder = folder; }
    /// What goes into the next snapshot as the project's picture; no edit. Null: the one it has stays.
    void setPicture(const QImage &picture) { mPicture = picture; }

signals:
    /// An edit was refused; nothing has changed.
    void refused(const ductus::Error &error);

protected:
    Result<void> readFrom(const Project &project) override;
    void writeTo(Project &project) const override;
    void clear() override;

private:
    friend class EditScene;
    void show(std::shared_ptr<const DoodleScene> scene);

    ClipReference mClip;                       // the path: absolute, or as seen from the project's folder
    std::shared_ptr<const DoodleScene> mScene; // never null
    std::shared_ptr<const Shot> mShot;
    bool mPacksAnalysis = false;
    mutable std::shared_ptr<const Shot> mPlainShot;
    std::shared_ptr<const DoodleContent> mContent; // as read; what is unknown
    Uuid mDocumentId;
    QString mSnapshotFolder;
    QImage mPicture;
};

/// A shot of \a clip in which nothing is known: the camera stands still and all is at one depth.
Shot plainShot(const ClipReference &clip);

} // namespace ductus
