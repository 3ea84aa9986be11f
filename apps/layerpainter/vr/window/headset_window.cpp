#include "layerpainter/vr/window/headset_window.h"

#include "widgets/shell/message_bar.h"

#include <QMenu>
#include <QToolButton>

namespace ductus {

namespace {

const Setting<bool> leftHandedSetting{"vr/leftHanded", false};

} // namespace

HeadsetWindow::HeadsetWindow(const ShellServices &services, QWidget *parent)
    : PainterWindow(services, parent), mVr(std::make_unique<VrMode>(*this))
{
    mVr->setLeftHanded(this->settings().value(leftHandedSetting));
    ActionSpec spec{"view.vr",
                    tr("Paint in &VR"),
                    tr("The painting in a headset, with the same layers and tools; again leaves it."),
                    "view-preview",
                    {QKeySequence("Ctrl+Shift+V")},
                    tr("View")};
    spec.isCheckable = true;
    mAction = actions().add(spec, [this] { mVr->isActive() ? mVr->stop() : enterVr(); });
    addToMenu(viewMenu(), {mAction});
    auto *button = new QToolButton;
    button->setDefaultAction(mAction);
    button->setText(tr("VR"));
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setAccessibleName(tr("Paint in VR"));
    addToTopRow(button);
    connect(mVr.get(), &VrMode::ended, this, &HeadsetWindow::onEnded);
}

HeadsetWindow::~HeadsetWindow()
{
    settings().set(leftHandedSetting, mVr->isLeftHanded());
    mVr.reset(); // before the view whose context it shares
}

void HeadsetWindow::enterVr()
{
    if (mVr->isActive())
        return;
    if (painting().isEmpty())
        newPainting();
    else
        showCanvas();
    if (tool() == PainterTool::Orbit)
        setTool(PainterTool::Paint);
    const Result<void> started = mVr->start();
    mAction->setChecked(started.ok());
    if (!started)
        showError(started.error());
    else
        messages()->info(tr("The painting is in the headset. This window shows what the left eye sees."));
}

void HeadsetWindow::onEnded(const QString &error)
{
    mAction->setChecked(false);
    if (!error.isEmpty())
        messages()->warning(error);
}

HeadsetFirstWindow::HeadsetFirstWindow(const ShellServices &services, QWidget *parent)
    : HeadsetWindow(services, parent)
{
    QTimer::singleShot(200, this,
                       &HeadsetWindow::enterVr); // files named on the command line are opened before
}

} // namespace ductus
