#include "widgets/pages/recovery_notice.h"

#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace ductus {

namespace {

constexpr int pictureSide = 40;

QLabel *pictureOf(const RecoveredFile &file, qreal scale)
{
    auto *picture = new QLabel;
    picture->setFixedSize(pictureSide, pictureSide);
    QImage image = file.thumbnail;
    if (!image.isNull()) {
        image = image.scaled(QSize(pictureSide, pictureSide) * scale, Qt::KeepAspectRatio,
                             Qt::SmoothTransformation);
        image.setDevicePixelRatio(scale);
        picture->setPixmap(QPixmap::fromImage(image));
    }
    picture->setVisible(!image.isNull());
    return picture;
}

// Short enough to stand beside the buttons.
QString timeOf(const QDateTime &saved)
{
    return saved.date() == QDate::currentDate()
               ? RecoveryNotice::tr("Today %1").arg(QLocale().toString(saved.time(), QLocale::ShortFormat))
               : QLocale().toString(saved.date(), QLocale::ShortFormat);
}

} // namespace

RecoveryNotice::RecoveryNotice(const QList<RecoveredFile> &files, QWidget *parent) : QFrame(parent)
{
    setObjectName(QStringLiteral("recoveryNotice"));
    setAccessibleName(tr("Unsaved work"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 8, 8, 12);
    layout->setSpacing(8);
    auto *heading = new QLabel(tr("Unsaved work from last time"));
    heading->setProperty("heading", true);
    layout->addWidget(heading);
    for (const RecoveredFile &file : files) {
        auto *row = new QWidget;
        auto *grid = new QGridLayout(row);
        grid->setContentsMargins(0, 0, 0, 0);
        grid->setHorizontalSpacing(8);
        grid->setVerticalSpacing(4);
        auto *name = new QLabel(file.displayName);
        name->setTextFormat(Qt::PlainText);
        name->setToolTip(file.originalPath);
        name->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        auto *when = new QLabel(timeOf(file.savedAt));
        when->setToolTip(QLocale().toString(file.savedAt, QLocale::LongFormat));
        when->setProperty("dim", true);
        auto *open = new QPushButton(tr("Open"));
        auto *discard = new QPushButton(tr("Discard"));
        open->setAccessibleName(tr("Open the unsaved %1").arg(file.displayName));
        discard->setAccessibleName(tr("Discard the unsaved %1").arg(file.displayName));
        grid->addWidget(pictureOf(file, devicePixelRatioF()), 0, 0, 2, 1);
        grid->addWidget(name, 0, 1, 1, 3);
        grid->addWidget(when, 1, 1);
        grid->addWidget(open, 1, 2);
        grid->addWidget(discard, 1, 3);
        grid->setColumnStretch(1, 1);
        layout->addWidget(row);
        connect(open, &QPushButton::clicked, this, [this, file] { emit openRequested(file); });
        connect(discard, &QPushButton::clicked, this, [this, row, file] {
            row->hide();
            bool isLast = true;
            for (QWidget *other : findChildren<QWidget *>(Qt::FindDirectChildrenOnly))
                isLast = isLast && (other->isHidden() || !other->findChild<QPushButton *>());
            setVisible(!isLast);
            emit discardRequested(file);
        });
    }
    setVisible(!files.isEmpty());
}

} // namespace ductus
