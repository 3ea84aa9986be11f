// StrokePanel: what the chosen strokes are for, and what the role brush paints.
#pragma once

#include "sketchsurfacer/ui/window/tool_box.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;

namespace ductus {

QString roleName(StrokeRole role);

class StrokePanel : public QWidget
{
    Q_OBJECT
public:
    StrokePanel(SketchDocument &document, SketchPresenter &presenter, ToolBox &tools,
                QWidget *parent = nullptr);

private:
    void refresh();

    SketchDocument &mDocument;
    SketchPresenter &mPresenter;
    ToolBox &mTools;
    QLabel *mChosen;
    QComboBox *mRole;
    QPushButton *mDelete;
};

} // namespace ductus
