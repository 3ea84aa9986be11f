#include "layerpainter/ui/window/picture_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <algorithm>

namespace ductus {

namespace {

constexpr int largestSide = 8192; // pixels

int heightFor(const QSize &view, int width)
{
    return std::clamp(qRound(double(width) * view.height() / std::max(1, view.width())), 1, largestSide);
}

} // namespace

PictureDialog::PictureDialog(const QSize &view, QWidget *parent) : QDialog(parent), mView(view)
{
    setWindowTitle(tr("Export picture"));
    auto *form = new QFormLayout(this);
    form->setHorizontalSpacing(16);
    mWidth = new QSpinBox;
    mWidth->setRange(16, largestSide);
    mWidth->setValue(std::min(2 * view.width(), largestSide));
    mWidth->setSuffix(tr(" pixels"));
    mWidth->setAccessibleName(tr("Width"));
    auto *height = new QLabel;
    const auto tellHeight = [this, height] {
        height->setText(tr("%1 pixels").arg(heightFor(mView, mWidth->value())));
    };
    connect(mWidth, &QSpinBox::valueChanged, this, tellHeight);
    tellHeight();
    mTransparent = new QCheckBox(tr("Without background"));
    mTransparent->setToolTip(
        tr("<b>Without background</b><br>Where nothing is painted the picture is transparent, to be put "
           "on something else."));
    form->addRow(tr("&Width"), mWidth);
    form->addRow(tr("Height"), height);
    form->addRow(QString(), mTransparent);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton *go = buttons->addButton(tr("Export..."), QDialogButtonBox::AcceptRole);
    go->setDefault(true);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

FrameOptions PictureDialog::choice() const
{
    FrameOptions options;
    options.width = mWidth->value();
    options.height = heightFor(mView, options.width);
    options.transparentBackground = mTransparent->isChecked();
    return options;
}

} // namespace ductus
