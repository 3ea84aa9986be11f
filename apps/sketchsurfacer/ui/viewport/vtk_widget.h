// VtkWidget: a VTK render window inside a Qt OpenGL widget. Debian's VTK speaks Qt 5 in its own widget, so
// this hosts a vtkGenericOpenGLRenderWindow; nothing here knows what is shown.
#pragma once

#include <QOpenGLWidget>
#include <vtkSmartPointer.h>

class vtkCallbackCommand;
class vtkGenericOpenGLRenderWindow;
class vtkObject;
class vtkRenderer;

namespace ductus {

class VtkWidget : public QOpenGLWidget
{
    Q_OBJECT
public:
    explicit VtkWidget(QWidget *parent = nullptr);
    ~VtkWidget() override;

    void addRenderer(vtkRenderer *renderer);
    vtkGenericOpenGLRenderWindow *renderWindow() const;

    /// Wall milliseconds the last frame took to draw; 0 before the first.
    double lastFrameMilliseconds() const { return mLastFrameMilliseconds; }
    /// Frames drawn since the start.
    int frameCount() const { return mFrameCount; }

signals:
    /// OpenGL is missing or refused; \a reason in words.
    void graphicsFailed(const QString &reason);

protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;

    /// Called with the context current, before VTK draws a frame.
    virtual void prepareFrame() {}

private:
    void releaseGraphics();
    static void onWindowEvent(vtkObject *caller, unsigned long event, void *clientData, void *callData);

    vtkSmartPointer<vtkGenericOpenGLRenderWindow> mWindow;
    vtkSmartPointer<vtkCallbackCommand> mObserver;
    bool mHasGraphics = false;
    double mLastFrameMilliseconds = 0.0;
    int mFrameCount = 0;
};

} // namespace ductus
