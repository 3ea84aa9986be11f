#include "layerpainter/ui/view/smooth_still.h"

#include <QMatrix4x4>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <array>

namespace ductus {

namespace {

constexpr GLenum sixteenBits = 0x805B; // GL_RGBA16

/// Sixteenths of a pixel: no two in the same row or column, none of them nearer to another than it must.
constexpr std::array<std::array<int, 2>, SmoothStill::samples> shifts{
    {{0, 0}, {1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}}};

void copy(unsigned from, unsigned to, const QSize &size)
{
    QOpenGLExtraFunctions *gl = QOpenGLContext::currentContext()->extraFunctions();
    gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    gl->glDisable(GL_SCISSOR_TEST);
    gl->glBlitFramebuffer(0, 0, size.width(), size.height(), 0, 0, size.width(), size.height(),
                          GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

} // namespace

bool StillScene::operator==(const StillScene &other) const
{
    const FrameCamera &a = camera, &b = other.camera;
    return painting == other.painting && seconds == other.seconds && size == other.size && a.eye == b.eye &&
           a.rotation.coeffs() == b.rotation.coeffs() && a.left == b.left && a.right == b.right &&
           a.down == b.down && a.up == b.up && a.nearDepth == b.nearDepth;
}

SmoothStill::~SmoothStill()
{
    if (mBlitter.isCreated())
        mBlitter.destroy();
}

void SmoothStill::begin(const StillScene &scene, unsigned framebuffer)
{
    if (!mBlitter.isCreated())
        mBlitter.create();
    if (!mMean || mMean->size() != scene.size) {
        mNext = std::make_unique<QOpenGLFramebufferObject>(scene.size);
        mMean = std::make_unique<QOpenGLFramebufferObject>(scene.size, QOpenGLFramebufferObject::NoAttachment,
                                                           GL_TEXTURE_2D, sixteenBits);
    }
    copy(framebuffer, mMean->handle(), scene.size);
    QOpenGLContext::currentContext()->functions()->glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    mScene = scene;
    mTaken = 1;
}

FrameCamera SmoothStill::nextCamera() const
{
    FrameCamera camera = mScene->camera;
    const auto &[x, y] = shifts[std::size_t(mTaken)];
    const double right = x / 16.0 * (camera.right - camera.left) / mScene->size.width();
    const double up = y / 16.0 * (camera.up - camera.down) / mScene->size.height();
    camera.left += right;
    camera.right += right;
    camera.down += up;
    camera.up += up;
    return camera;
}

void SmoothStill::add()
{
    QOpenGLFunctions *gl = QOpenGLContext::currentContext()->functions();
    ++mTaken;
    gl->glBindFramebuffer(GL_FRAMEBUFFER, mMean->handle());
    gl->glViewport(0, 0, mScene->size.width(), mScene->size.height());
    gl->glDisable(GL_DEPTH_TEST);
    gl->glDisable(GL_SCISSOR_TEST);
    gl->glEnable(GL_BLEND);
    gl->glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    mBlitter.bind();
    mBlitter.setOpacity(1.f / float(mTaken));
    mBlitter.blit(mNext->texture(), QMatrix4x4(), QOpenGLTextureBlitter::OriginBottomLeft);
    mBlitter.release();
    gl->glDisable(GL_BLEND);
    gl->glBlendFunc(GL_ONE, GL_ZERO);
}

void SmoothStill::show(unsigned framebuffer) const
{
    copy(mMean->handle(), framebuffer, mScene->size);
    QOpenGLContext::currentContext()->functions()->glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

} // namespace ductus
