// Finding out how the scene moves, in DoodleStudio's window: from the cache where it was kept, else from the
// clip.
#include "document/document_files.h"
#include "document/words/engine_words.h"
#include "doodlestudio/ui/window/studio_window.h"
#include "doodling/reconstruction/analysed_shot.h"
#include "widgets/shell/message_bar.h"

#include <QFileInfo>

namespace ductus {

namespace {

struct FoundScene
{
    AnalysedShot analysed;
    bool wasLost = false; // the project's analysis was not in the cache any more
};

// \a known: the project's cameras, if its motion and depth are to be looked for in the cache; else null.
Result<FoundScene> findScene(const std::filesystem::path &clip, const std::shared_ptr<const Shot> &known,
                             const std::string &digest, const JobControl &control)
{
    FoundScene found;
    if (known) {
        ShotOptions options;
        options.cache = userAnalysisCache();
        options.clipDigest = digest;
        options.known = known.get();
        if (std::optional<Shot> cached = shotFromCache(options, control.part(0.0, 0.1))) {
            found.analysed = {std::make_shared<const Shot>(std::move(*cached)), digest, {}, {}};
            return found;
        }
        found.wasLost = true;
    }
    // A clip of its own: the player's is in use.
    Result<AnalysedShot> analysed =
        analysedShot(clip, userAnalysisCache(), known.get(), control.part(0.1, 1.0));
    if (!analysed)
        return analysed.error();
    found.analysed = std::move(*analysed);
    return found;
}

} // namespace

void StudioWindow::analyse()
{
    jobs().start<FoundScene>(
        {QStringLiteral("analyse"), tr("Looking at the scene")}, this,
        [path = enginePath(mDoodle.clipPath()), known = mDoodle.leftShot(), digest = mDoodle.clip().digest](
            const JobControl &control) { return findScene(path, known, digest, control); },
        [this, revision = mDoodle.project().id](Result<FoundScene> found) {
            if (revision != mDoodle.project().id)
                return; // another clip was opened meanwhile
            if (found) {
                const AnalysedShot &analysed = found->analysed;
                if (found->wasLost)
                    messages()->info(
                        tr("How the scene moves was not in the cache any more and was found again."));
                if (analysed.cacheProblem)
                    messages()->warning(
                        tr("What was found out is kept in the project, as the cache cannot be used: %1")
                            .arg(engineWords(analysed.cacheProblem->problem)));
                mDoodle.setShot(analysed.shot, analysed.digest);
                return;
            }
            if (!found.error().isCancelled()) {
                showError(found.error(), tr("Try again"), [this] { analyse(); });
                return;
            }
            Message message{MessageKind::Info, tr("The scene was not looked at to the end.")};
            message.remedy = tr("Canvases cannot follow what moves until it is; it goes on where it was.");
            message.action = tr("Look at the scene");
            message.run = [this] { analyse(); };
            message.key = QStringLiteral("analyse");
            messages()->show(message);
        });
}

void StudioWindow::packAnalysis(bool packs)
{
    if (packs && mDoodle.shot() && packedAnalysisBytes(*mDoodle.shot()) > mostPackedBytes) {
        messages()->warning(tr("The clip is too long for that: its analysis has %1 megabytes.")
                                .arg(packedAnalysisBytes(*mDoodle.shot()) >> 20));
        packs = false;
    }
    mDoodle.setPacksAnalysis(packs);
    actions().action(QStringLiteral("file.pack"))->setChecked(mDoodle.packsAnalysis());
}

} // namespace ductus
