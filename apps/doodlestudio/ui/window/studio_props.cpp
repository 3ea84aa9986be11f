// Paintings of LayerPainter in the filmed scene: placed, and updated when they changed there.
#include "document/document_files.h"
#include "doodlestudio/document/placing.h"
#include "doodlestudio/ui/window/studio_window.h"
#include "doodling/canvas/edit_scene.h"
#include "doodling/prop/prop_link.h"
#include "project/project_reader.h"
#include "widgets/shell/message_bar.h"

#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>

namespace ductus {

namespace {

const QString linkKey = QStringLiteral("links");

ProjectReadOptions paintings()
{
    ProjectReadOptions options;
    options.kinds = {paintingKind()};
    return options;
}

QString nameOf(const DocumentLink &link)
{
    const QString name = QString::fromStdString(link.name);
    return name.isEmpty() ? StudioWindow::tr("The painting") : name;
}

QString offerOf(const std::vector<PropLink> &links)
{
    QString offer;
    for (const PropLink &link : links)
        if (link.update)
            offer += QString::fromStdString(link.update->link.digest);
    return offer;
}

} // namespace

void StudioWindow::choosePainting()
{
    if (mDoodle.isEmpty()) {
        messages()->info(tr("Open a clip first; a painting can stand in it then."));
        return;
    }
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Place a painting"), QFileInfo(mDoodle.filePath()).path(),
                                     tr("Paintings of LayerPainter (*.ductus)"));
    if (!path.isEmpty())
        placePainting(path);
}

void StudioWindow::takePainting(const QString &path)
{
    if (!mDoodle.isEmpty()) {
        placePainting(path);
        return;
    }
    mPaintingToPlace = path;
    Message message;
    message.what = tr("Open a clip: %1 will stand in it.").arg(QFileInfo(path).completeBaseName());
    message.action = tr("Open...");
    message.key = linkKey;
    message.run = [this] { chooseAndOpen(); };
    messages()->show(message);
}

void StudioWindow::placePainting(const QString &path)
{
    const bool isOwn = QFileInfo(path) == QFileInfo(mDoodle.filePath());
    const QString folder = mDoodle.filePath().isEmpty() ? QString() : QFileInfo(mDoodle.filePath()).path();
    jobs().start<Prop>(
        {QStringLiteral("place"), tr("Reading %1").arg(QFileInfo(path).fileName())}, this,
        [path, isOwn, folder](const JobControl &) -> Result<Prop> {
            const Result<Project> project = ductus::openProject(enginePath(path), paintings());
            if (!project)
                return project.error();
            return propFromProject(*project,
                                   isOwn ? "" : linkedFileName(enginePath(path), enginePath(folder)));
        },
        [this](Result<Prop> prop) {
            if (!prop)
                showError(prop.error());
            else
                standProp(std::move(*prop));
        });
}

// In the lower middle of what is seen, half as high as the picture; from there it is moved by its handles.
void StudioWindow::standProp(Prop prop)
{
    const std::shared_ptr<const Shot> shot = mDoodle.sceneShot();
    const std::vector<Look> &looks = prop.painting->painting().looks;
    if (!looks.empty())
        prop.look = looks.front().name;
    if (hasMotion(prop.painting->painting()))
        prop.framesPerSecond = mDoodle.clip().framesPerSecond;
    const Vec2 size(shot->width, shot->height);
    Canvas canvas = propInBox(*shot, mState.frame(), size.cwiseProduct(Vec2(0.3, 0.3)),
                              size.cwiseProduct(Vec2(0.7, 0.8)), std::move(prop), {});
    const QString name = nameOf(canvas.prop->link);
    if (!mDoodle.edit(tr("Place painting"), withCanvas(mDoodle.scene(), std::move(canvas))))
        return;
    mState.choose(mDoodle.scene().canvases.back().id);
    setStep(StudioStep::Place);
    messages()->success(tr("%1 stands in the scene. Move it by its handles.").arg(name));
}

void StudioWindow::watchPaintings()
{
    const LinkSources sources(mDoodle.project(), enginePath(mDoodle.filePath()), {});
    QStringList files;
    for (const Canvas &canvas : mDoodle.scene().canvases)
        if (canvas.prop && !canvas.prop->link.file.empty()) {
            const QString file =
                QFile::decodeName(QByteArray::fromStdString(sources.fileOf(canvas.prop->link).string()));
            if (!files.contains(file))
                files << file;
        }
    mLinkWatcher.setFiles(files);
}

void StudioWindow::lookForNewerPaintings(bool isAsked)
{
    struct Question
    {
        std::shared_ptr<const DoodleScene> scene;
        Project project;
        std::filesystem::path file;
    };
    jobs().start<std::vector<PropLink>>(
        {QStringLiteral("links"), tr("Looking for changes of the paintings")}, this,
        [question = Question{mDoodle.sharedScene(), mDoodle.project(), enginePath(mDoodle.filePath())}](
            const JobControl &) -> Result<std::vector<PropLink>> {
            LinkSources sources(question.project, question.file, paintings());
            return propLinks(*question.scene, sources);
        },
        [this, isAsked](Result<std::vector<PropLink>> links) {
            if (!links)
                messages()->show(links.error());
            else
                offerNewerPaintings(*links, isAsked);
        });
}

void StudioWindow::offerNewerPaintings(const std::vector<PropLink> &links, bool isAsked)
{
    const auto isNewer = [](const PropLink &link) { return link.update != nullptr; };
    const auto newer = std::ranges::find_if(links, isNewer);
    if (newer == links.end()) {
        messages()->withdraw(linkKey);
        mOffered.clear();
        const auto problem = std::ranges::find_if(links, [](const PropLink &l) { return !!l.problem; });
        if (isAsked && links.empty())
            messages()->info(tr("No painting stands in this scene."));
        else if (isAsked && problem != links.end())
            messages()->show(*problem->problem);
        else if (isAsked)
            messages()->success(tr("All paintings are as they are in LayerPainter."));
        return;
    }
    const QString offer = offerOf(links);
    if (offer == mOffered && !isAsked)
        return;
    mOffered = offer;
    const auto count = std::ranges::count_if(links, isNewer);
    Message message;
    message.kind = MessageKind::Info;
    message.what = count == 1 ? tr("The painting \"%1\" changed in LayerPainter.").arg(nameOf(newer->link))
                              : tr("%n paintings changed in LayerPainter.", nullptr, int(count));
    message.remedy = tr("Update? Where they stand and what you drew stays.");
    message.action = tr("Update");
    message.decline = tr("Not now");
    message.key = linkKey;
    message.run = [this, links] {
        mDoodle.edit(tr("Update painting"), withUpdatedProps(mDoodle.scene(), links));
    };
    messages()->show(message);
}

} // namespace ductus
