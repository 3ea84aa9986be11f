// CanvasList: the canvases of the scene by name, lowest last: choose, rename, show, take away.
#pragma once

#include "doodlestudio/ui/canvases/studio_state.h"

#include <QWidget>

class QListWidget;
class QToolButton;

namespace ductus {

class CanvasList : public QWidget
{
    Q_OBJECT
public:
    explicit CanvasList(StudioState &state, QWidget *parent = nullptr);

    void removeChosen();
    void duplicateChosen();

private:
    QToolButton *button(const QString &iconName, const QString &name, const QString &teaches);
    void refresh();

    StudioState &mState;
    QListWidget *mList;
    bool mIsRefreshing = false;
};

} // namespace ductus
