#include "widgets/controls/elided_text.h"

#include <QFontMetrics>
#include <QStringList>
#include <QTextLayout>

namespace ductus {

QString elidedLines(const QString &text, const QFont &font, int width, int lines)
{
    QTextLayout layout(text, font);
    layout.beginLayout();
    QStringList result;
    for (int i = 0; i < lines; ++i) {
        QTextLine line = layout.createLine();
        if (!line.isValid())
            break;
        line.setLineWidth(width);
        const bool isLast = i + 1 == lines;
        result << (isLast ? QFontMetrics(font).elidedText(text.mid(line.textStart()), Qt::ElideRight, width)
                          : text.mid(line.textStart(), line.textLength()).trimmed());
    }
    layout.endLayout();
    return result.join(QLatin1Char('\n'));
}

} // namespace ductus
