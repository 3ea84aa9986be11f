// draw_icons NAME.svg OUTDIR CONTEXT NAME: the PNGs of the hicolor theme, OUTDIR/48x48/CONTEXT/NAME.png and
// so on, for desktops that draw no SVG.
#include <QDir>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>

#include <cstdio>

int main(int argc, char **argv)
{
    if (argc != 5) {
        std::fputs("Usage: draw_icons PICTURE.svg OUTDIR CONTEXT NAME\n", stderr);
        return 2;
    }
    QSvgRenderer picture(QString::fromLocal8Bit(argv[1]));
    if (!picture.isValid()) {
        std::fprintf(stderr, "draw_icons: %s is no SVG\n", argv[1]);
        return 1;
    }
    for (const int size : {16, 22, 24, 32, 48, 64, 128, 256}) {
        const QString folder = QStringLiteral("%1/%2x%2/%3")
                                   .arg(QString::fromLocal8Bit(argv[2]))
                                   .arg(size)
                                   .arg(QString::fromLocal8Bit(argv[3]));
        QImage image(size, size, QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        picture.render(&painter, QRectF(0, 0, size, size));
        painter.end();
        const QString file =
            folder + QLatin1Char('/') + QString::fromLocal8Bit(argv[4]) + QStringLiteral(".png");
        if (!QDir().mkpath(folder) || !image.save(file)) {
            std::fprintf(stderr, "draw_icons: cannot write %s\n", qPrintable(file));
            return 1;
        }
    }
    return 0;
}
