// A canvas that shows a few curves, in place of a viewport.
#pragma once

#include <QWidget>

namespace ductus {

class GalleryCanvas : public QWidget
{
public:
    explicit GalleryCanvas(QWidget *parent = nullptr);

protected:
    void paintEvent(QPaintEvent *event) override;
};

} // namespace ductus
