#include "layerpainter/ui/panels/colour_panel.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace ductus {

namespace {

constexpr double barWidth = 18, gap = 8;
constexpr int mostRecent = 8;

} // namespace

ColourField::ColourField(QWidget *parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Colour"));
    setToolTip(tr("Left and right: how colourful; up and down: how bright. The bar at the right: the hue."));
    setMinimumHeight(130);
    setCursor(Qt::CrossCursor);
}

QRectF ColourField::square() const
{
    return QRectF(1, 1, width() - barWidth - gap - 2, height() - 2);
}

QRectF ColourField::bar() const
{
    return QRectF(width() - barWidth - 1, 1, barWidth, height() - 2);
}

void ColourField::setColour(const QColor &colour)
{
    const QColor hsv = colour.toHsv();
    if (hsv.hsvHueF() >= 0) // grey has none: the last one stays
        mHue = hsv.hsvHueF();
    mSaturation = hsv.hsvSaturationF();
    mValue = hsv.valueF();
    update();
}

void ColourField::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF field = square(), hues = bar();
    QLinearGradient across(field.topLeft(), field.topRight());
    across.setColorAt(0, Qt::white);
    across.setColorAt(1, QColor::fromHsvF(float(mHue), 1, 1));
    QLinearGradient down(field.topLeft(), field.bottomLeft());
    down.setColorAt(0, Qt::transparent);
    down.setColorAt(1, Qt::black);
    painter.setPen(Qt::NoPen);
    for (const QLinearGradient &gradient : {across, down}) {
        painter.setBrush(gradient);
        painter.drawRoundedRect(field, 4, 4);
    }
    QLinearGradient around(hues.topLeft(), hues.bottomLeft());
    for (int i = 0; i <= 6; ++i)
        around.setColorAt(i / 6.0, QColor::fromHsvF(float(i % 6) / 6, 0.9f, 0.95f));
    painter.setBrush(around);
    painter.drawRoundedRect(hues, 4, 4);
    const QPointF at(field.left() + mSaturation * field.width(), field.bottom() - mValue * field.height());
    const double y = hues.top() + mHue * hues.height();
    painter.setBrush(Qt::NoBrush);
    for (const auto &[colour, w] :
         {std::pair(QColor(0, 0, 0, 170), 3.6), std::pair(QColor(Qt::white), 1.8)}) {
        painter.setPen(QPen(colour, w));
        painter.drawEllipse(at, 6, 6);
        painter.drawRoundedRect(QRectF(hues.left() - 1, y - 3, hues.width() + 2, 6), 3, 3);
    }
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
        painter.drawRoundedRect(field, 4, 4);
    }
}

void ColourField::take(const QPointF &position)
{
    const auto share = [](double value, double from, double length) {
        return std::clamp((value - from) / length, 0.0, 1.0);
    };
    if (mIsOnBar) {
        mHue = std::min(0.9999, share(position.y(), bar().top(), bar().height()));
    } else {
        mSaturation = share(position.x(), square().left(), square().width());
        mValue = 1 - share(position.y(), square().top(), square().height());
    }
    change();
}

void ColourField::change()
{
    update();
    emit picked(QColor::fromHsvF(float(mHue), float(mSaturation), float(mValue)));
}

void ColourField::mousePressEvent(QMouseEvent *event)
{
    mIsOnBar = event->position().x() > square().right() + 0.5 * gap;
    take(event->position());
}

void ColourField::mouseMoveEvent(QMouseEvent *event)
{
    if (event->buttons() & Qt::LeftButton)
        take(event->position());
}

void ColourField::keyPressEvent(QKeyEvent *event)
{
    const auto step = [&](double &value, double by) {
        value = std::clamp(value + by, 0.0, 1.0);
        change();
    };
    switch (event->key()) {
    case Qt::Key_Left:
        return step(mSaturation, -0.02);
    case Qt::Key_Right:
        return step(mSaturation, 0.02);
    case Qt::Key_Up:
        return step(mValue, 0.02);
    case Qt::Key_Down:
        return step(mValue, -0.02);
    case Qt::Key_PageUp:
        return step(mHue, -0.01);
    case Qt::Key_PageDown:
        return step(mHue, 0.01);
    default:
        QWidget::keyPressEvent(event);
    }
}

ColourPanel::ColourPanel(QWidget *parent) : QWidget(parent), mField(new ColourField)
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(mField);
    mRecentRow = new QHBoxLayout;
    mRecentRow->setSpacing(4);
    layout->addLayout(mRecentRow);
    for (const unsigned rgb :
         {0x2d2a32u, 0xf6f1e7u, 0xffe2a8u, 0xe0664fu, 0x5f8fb4u, 0x4f8f55u, 0x5f6f96u, 0x8e5bd6u})
        mRecent << QColor::fromRgb(rgb);
    mField->setColour(mColour);
    connect(mField, &ColourField::picked, this, [this](const QColor &picked) {
        mColour = picked;
        emit colourChanged(mColour);
    });
    fillRecent();
}

void ColourPanel::setColour(const QColor &colour)
{
    if (colour == mColour)
        return;
    mColour = colour;
    mField->setColour(colour);
    emit colourChanged(mColour);
}

void ColourPanel::remember()
{
    mRecent.removeAll(mColour);
    mRecent.prepend(mColour);
    while (mRecent.size() > mostRecent)
        mRecent.removeLast();
    fillRecent();
}

void ColourPanel::fillRecent()
{
    while (QLayoutItem *item = mRecentRow->takeAt(0)) {
        if (item->widget())
            item->widget()->deleteLater();
        delete item;
    }
    for (const QColor &colour : mRecent) {
        auto *chip = new QToolButton;
        QPixmap pixmap(40, 40);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setBrush(colour);
        painter.setPen(QPen(QColor(128, 128, 128, 120), 2));
        painter.drawRoundedRect(QRectF(2, 2, 36, 36), 8, 8);
        painter.end();
        chip->setIcon(QIcon(pixmap));
        chip->setIconSize({20, 20});
        chip->setAutoRaise(true);
        chip->setAccessibleName(tr("Colour %1").arg(colour.name()));
        chip->setToolTip(colour.name());
        connect(chip, &QToolButton::clicked, this, [this, colour] { setColour(colour); });
        mRecentRow->addWidget(chip);
    }
    mRecentRow->addStretch();
}

} // namespace ductus
