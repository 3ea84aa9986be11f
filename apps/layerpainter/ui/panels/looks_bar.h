// LooksBar: the looks of the painting as chips; a click switches, + keeps the present one.
#pragma once

#include "layerpainter/document/painting_document.h"

#include <QWidget>

class QHBoxLayout;

namespace ductus {

class LooksBar : public QWidget
{
    Q_OBJECT
public:
    explicit LooksBar(PaintingDocument &document, QWidget *parent = nullptr);

    void addLook();

private:
    void refresh();
    void showMenu(LookId look, const QPoint &at);

    PaintingDocument &mDocument;
    QHBoxLayout *mChips;
    std::optional<LookId> mCurrent; // shown now
    bool mIsSwitching = false;
};

} // namespace ductus
