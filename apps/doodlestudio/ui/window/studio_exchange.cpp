// Lines to and from the other apps by the clipboard.
#include "doodlestudio/document/stroke_exchange.h"
#include "doodlestudio/ui/window/studio_window.h"
#include "widgets/shell/message_bar.h"

#include <QClipboard>
#include <QGuiApplication>

namespace ductus {

void StudioWindow::copyStrokes()
{
    const Canvas *canvas = mState.chosenCanvas();
    const CopiedStrokes copied =
        canvas ? copiedLines(canvas->doodle.frames[std::size_t(mState.drawingOf(*canvas))]) : CopiedStrokes();
    if (copied.strokes.empty()) {
        messages()->info(tr("Choose a canvas with drawn lines: they are copied then."));
        return;
    }
    QGuiApplication::clipboard()->setMimeData(mimeDataOf(copied).release());
    messages()->success(tr("%n lines copied.", nullptr, int(copied.strokes.size())));
}

void StudioWindow::pasteStrokes()
{
    const Canvas *canvas = mState.chosenCanvas();
    if (!canvas) {
        messages()->info(tr("Choose a canvas, or place one: the strokes are drawn on it."));
        return;
    }
    const Result<CopiedStrokes> copied = strokesFrom(QGuiApplication::clipboard()->mimeData());
    if (!copied) {
        messages()->show(copied.error());
        return;
    }
    const Brush &brush = mState.brush();
    const QColor colour = brush.colour;
    const std::vector<InkStroke> lines =
        inkStrokes(*copied, canvas->size, brush.width * canvas->size.maxCoeff(),
                   {std::uint8_t(colour.red()), std::uint8_t(colour.green()), std::uint8_t(colour.blue()),
                    std::uint8_t(colour.alpha())});
    if (mDoodle.editDoodle(tr("Paste lines"), canvas->id,
                           withLines(canvas->doodle, mState.drawingOf(*canvas), lines)))
        messages()->success(tr("%n lines pasted.", nullptr, int(lines.size())));
}

} // namespace ductus
