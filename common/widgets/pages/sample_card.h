// SampleCardButton: a sample as a card: a picture of 240x150, the title, one line of what can be learned.
#pragma once

#include "widgets/pages/start_page.h"

#include <QAbstractButton>

namespace ductus {

class SampleCardButton : public QAbstractButton
{
    Q_OBJECT
public:
    explicit SampleCardButton(const SampleCard &card, QWidget *parent = nullptr);
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void enterEvent(QEnterEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    SampleCard mCard;
    QImage mPicture;
    bool mIsHovered = false;
};

/// \a image cut to the shape of \a size and scaled to it, in device pixels.
QImage coveringImage(const QImage &image, const QSize &size);

} // namespace ductus
