#include "sketchsurfacer/ui/viewport/vtk_widget.h"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QSurfaceFormat>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

namespace ductus {

VtkWidget::VtkWidget(QWidget *parent)
    : QOpenGLWidget(parent), mWindow(vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New()),
      mObserver(vtkSmartPointer<vtkCallbackCommand>::New())
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2); // the least VTK needs; drivers give more
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    setFormat(format);

    mWindow->SetReadyForRendering(false);
    mWindow->SetOwnContext(0);
    mWindow->SetMultiSamples(0);
    mWindow->SetFrameBlitModeToBlitToCurrent();
    mObserver->SetClientData(this);
    mObserver->SetCallback(&VtkWidget::onWindowEvent);
    for (unsigned long event : {vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent,
                                vtkCommand::WindowSupportsOpenGLEvent, vtkCommand::WindowIsDirectEvent})
        mWindow->AddObserver(event, mObserver);
}

VtkWidget::~VtkWidget()
{
    releaseGraphics(); // the observer still answers whether the context is current
    mWindow->RemoveObserver(mObserver);
}

vtkGenericOpenGLRenderWindow *VtkWidget::renderWindow() const
{
    return mWindow;
}

void VtkWidget::addRenderer(vtkRenderer *renderer)
{
    mWindow->AddRenderer(renderer);
}

void VtkWidget::onWindowEvent(vtkObject *, unsigned long event, void *clientData, void *callData)
{
    auto *widget = static_cast<VtkWidget *>(clientData);
    switch (event) {
    case vtkCommand::WindowMakeCurrentEvent:
        // makeCurrent() re-binds the widget's framebuffer behind VTK's back: only when it is really needed.
        if (widget->context() && QOpenGLContext::currentContext() != widget->context())
            widget->makeCurrent();
        break;
    case vtkCommand::WindowIsCurrentEvent:
        *static_cast<bool *>(callData) =
            widget->context() && QOpenGLContext::currentContext() == widget->context();
        break;
    case vtkCommand::WindowSupportsOpenGLEvent:
    case vtkCommand::WindowIsDirectEvent:
        *static_cast<int *>(callData) = 1;
        break;
    default:
        break;
    }
}

void VtkWidget::initializeGL()
{
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &VtkWidget::releaseGraphics,
            Qt::UniqueConnection);
    mWindow->SetForceMaximumHardwareLineWidth(1);
    mWindow->SetReadyForRendering(true);
    mWindow->OpenGLInitContext();
    mHasGraphics = context()->isValid() && context()->format().version() >= qMakePair(3, 2);
    if (!mHasGraphics) {
        mWindow->SetReadyForRendering(false);
        emit graphicsFailed(tr("This computer's graphics driver offers no OpenGL 3.2."));
    }
}

void VtkWidget::resizeGL(int, int)
{
    mWindow->SetSize(qRound(width() * devicePixelRatioF()), qRound(height() * devicePixelRatioF()));
}

void VtkWidget::paintGL()
{
    if (!mHasGraphics)
        return;
    QElapsedTimer clock;
    clock.start();
    resizeGL(width(), height()); // the pixel ratio changes without a resize when the window changes screens
    prepareFrame();
    vtkOpenGLState *state = mWindow->GetState();
    state->Reset();
    state->Push();
    state->vtkglBindFramebuffer(0x8D40 /* GL_FRAMEBUFFER */, defaultFramebufferObject());
    mWindow->Render();
    state->Pop();
    mLastFrameMilliseconds = double(clock.nsecsElapsed()) * 1e-6;
    ++mFrameCount;
}

void VtkWidget::releaseGraphics()
{
    if (!mHasGraphics)
        return;
    mHasGraphics = false;
    makeCurrent();
    mWindow->Finalize();
    mWindow->SetReadyForRendering(false);
    doneCurrent();
}

} // namespace ductus
