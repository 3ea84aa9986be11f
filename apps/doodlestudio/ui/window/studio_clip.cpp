// Clips in DoodleStudio's window: opened, found again where they were moved to, shown.
#include "document/document_files.h"
#include "doodlestudio/document/moved_clip.h"
#include "doodlestudio/ui/player/player_view.h"
#include "doodlestudio/ui/timeline/timeline_view.h"
#include "doodlestudio/ui/window/studio_window.h"
#include "doodling/clip/clip_sound.h"
#include "widgets/shell/message_bar.h"

#include <QFileDialog>
#include <QFileInfo>

namespace ductus {

void StudioWindow::openClipAt(const QString &path)
{
    jobs().start<OpenedClip>(
        {QStringLiteral("open"), tr("Opening %1").arg(QFileInfo(path).fileName())}, this,
        [path](const JobControl &control) { return openClipFile(path, control); },
        [this, path](Result<OpenedClip> clip) {
            if (!clip) {
                showError(clip.error());
                return;
            }
            messages()->closeAll();
            mDoodle.start(path, clip->reference);
            mRecent.add(path);
            adoptClip(std::move(*clip));
            analyse();
        });
}

void StudioWindow::findClip()
{
    const QString path = mDoodle.clipPath();
    showOpened();
    if (QFileInfo::exists(path)) {
        openKnownClip(path);
        return;
    }
    jobs().start<QString>(
        {QStringLiteral("open"), tr("Looking where %1 is now").arg(QFileInfo(path).fileName())}, this,
        [known = mDoodle.clip(), path, project = mDoodle.filePath()](const JobControl &control) {
            return movedClip(known, path, placesOfClips(path, project), control);
        },
        [this](Result<QString> found) {
            if (!found || found->isEmpty())
                lookForClip(); // what could not be read is not the clip
            else
                openKnownClip(*found);
        });
}

void StudioWindow::openKnownClip(const QString &path)
{
    jobs().start<OpenedClip>(
        {QStringLiteral("open"), tr("Opening %1").arg(QFileInfo(path).fileName())}, this,
        [path, known = mDoodle.clip(), isMoved = path != mDoodle.clipPath()](const JobControl &control) {
            return isMoved ? openMovedClip(path, known, control) : openClipFile(path, control);
        },
        [this, path](Result<OpenedClip> clip) {
            if (!clip) {
                showError(clip.error(), tr("Find the clip..."), [this] { lookForClip(); });
                return;
            }
            const ClipLikeness likeness = likenessOf(mDoodle.clip(), clip->reference);
            if (likeness == ClipLikeness::Other) {
                offerOtherClip(tr("The clip is another one than this was drawn on."),
                               tr("Its number of frames or its size differ."));
                return;
            }
            if (path != mDoodle.clipPath()) {
                mDoodle.relocateClip(path);
                if (likeness == ClipLikeness::Same)
                    messages()->info(tr("The clip was moved and is found again: %1").arg(path));
                else if (likeness == ClipLikeness::OtherBytes)
                    offerOtherClip(
                        tr("The clip has the frames and the size of the one this was drawn on, but "
                           "it is another file."),
                        tr("If it does not show the same scene, find the right one."));
            }
            adoptClip(std::move(*clip));
            if (!mDoodle.shot())
                analyse();
        });
}

void StudioWindow::offerOtherClip(const QString &what, const QString &remedy)
{
    Message message{MessageKind::Warning, what};
    message.remedy = remedy;
    message.key = QStringLiteral("clip");
    message.action = tr("Find the clip...");
    message.run = [this] { askForClip(); };
    messages()->show(message);
}

void StudioWindow::lookForClip()
{
    offerOtherClip(tr("The clip %1 is not where it was.").arg(QFileInfo(mDoodle.clipPath()).fileName()),
                   tr("Show where it is now: everything drawn is kept."));
}

void StudioWindow::askForClip()
{
    const QString found =
        QFileDialog::getOpenFileName(this, tr("Where is %1?").arg(QFileInfo(mDoodle.clipPath()).fileName()),
                                     {}, tr("Clips (%1);;All files (*)").arg(clipPatterns()));
    if (!found.isEmpty())
        openKnownClip(found);
    else if (!QFileInfo::exists(mDoodle.clipPath()))
        lookForClip();
}

void StudioWindow::adoptClip(OpenedClip clip)
{
    const std::shared_ptr<const Shot> shot = mDoodle.sceneShot();
    mPlayer->setWorkingSize({shot->width, shot->height});
    mTimeline->setFrameTimes(clip.clip->info().frameTimes);
    mTimeline->setSound(nullptr);
    mPlayback.setSound(nullptr);
    for (const std::string &warning : clip.clip->info().warnings)
        messages()->warning(QString::fromStdString(warning));
    mFrames.setClip(clip.clip);
    mPreview.forget();
    mPlayback.setFrameTimes(clip.clip->info().frameTimes);
    showOpened();
    updatePictureSize();
    if (!mPaintingToPlace.isEmpty())
        placePainting(std::exchange(mPaintingToPlace, {}));
    if (!clip.clip->info().hasAudio)
        return;
    jobs().start<ClipSound>(
        {QStringLiteral("sound"), tr("Reading the sound"), true}, this,
        [path = enginePath(mDoodle.clipPath())](const JobControl &control) {
            return readSound(path, {}, control);
        },
        [this](Result<ClipSound> sound) {
            if (!sound) {
                showError(sound.error());
                return;
            }
            auto shared = std::make_shared<const ClipSound>(std::move(*sound));
            mPlayback.setSound(shared);
            mTimeline->setSound(shared);
        });
}

} // namespace ductus
