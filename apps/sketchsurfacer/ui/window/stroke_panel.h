// StrokePanel: what the chosen strokes are for, what the role brush paints, and which borders were found.
#pragma once

#include "sketchsurfacer/ui/window/tool_box.h"

#include <QPointer>
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

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *newFoundRow();
    void refresh();

    SketchDocument &mDocument;
    SketchPresenter &mPresenter;
    QPointer<SketchPresenter> mLivePresenter; // gone before the last events of a closing window
    ToolBox &mTools;
    QLabel *mChosen;
    QComboBox *mRole;
    QPushButton *mDelete;
    QWidget *mFoundRow; // borders nobody marked
    QLabel *mFound;
    QPushButton *mConfirm;
};

} // namespace ductus
