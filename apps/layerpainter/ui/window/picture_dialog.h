// PictureDialog: how large a picture is exported, and with or without its background.
#pragma once

#include "layerpainter/film/frame_maker.h"

#include <QDialog>

class QCheckBox;
class QSpinBox;

namespace ductus {

class PictureDialog : public QDialog
{
    Q_OBJECT
public:
    /// \a view: pixels of the canvas; the picture keeps its shape and is twice as large unless told
    /// otherwise.
    explicit PictureDialog(const QSize &view, QWidget *parent = nullptr);
    FrameOptions choice() const;

private:
    QSize mView;
    QSpinBox *mWidth;
    QCheckBox *mTransparent;
};

} // namespace ductus
