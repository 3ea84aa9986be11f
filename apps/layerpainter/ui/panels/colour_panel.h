// ColourPanel: the colour to paint with: a square of saturation and brightness, a bar of hues, recent ones.
#pragma once

#include <QColor>
#include <QList>
#include <QWidget>

class QHBoxLayout;

namespace ductus {

class ColourField;

class ColourPanel : public QWidget
{
    Q_OBJECT
public:
    explicit ColourPanel(QWidget *parent = nullptr);

    QColor colour() const { return mColour; }
    void setColour(const QColor &colour);
    /// The present colour was used: it goes to the recent ones.
    void remember();

signals:
    void colourChanged(const QColor &colour);

private:
    void fillRecent();

    QColor mColour = QColor(0x8e, 0x5b, 0xd6);
    QList<QColor> mRecent;
    ColourField *mField;
    QHBoxLayout *mRecentRow;
};

/// Square and bar. Arrow keys move in the square, Page keys along the hues.
class ColourField : public QWidget
{
    Q_OBJECT
public:
    explicit ColourField(QWidget *parent = nullptr);
    void setColour(const QColor &colour);
    QSize sizeHint() const override { return {240, 150}; }

signals:
    void picked(const QColor &colour);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    QRectF square() const;
    QRectF bar() const;
    void take(const QPointF &position);
    void change();

    double mHue = 0.75, mSaturation = 0.57, mValue = 0.84;
    bool mIsOnBar = false;
};

} // namespace ductus
