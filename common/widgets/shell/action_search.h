// ActionSearch: type a few letters of what you want to do, Enter does it. All actions of the catalogue that
// can be used now; recently chosen ones first while nothing is typed.
#pragma once

#include <QFrame>
#include <QStringList>

class QLineEdit;
class QListWidget;

namespace ductus {

class ActionCatalogue;

class ActionSearch : public QFrame
{
    Q_OBJECT
public:
    explicit ActionSearch(ActionCatalogue &actions, QWidget *parent);

    /// Opens in the upper middle of \a window.
    void openOver(const QWidget &window);
    /// Actions to show after all others while nothing is typed.
    void setLast(const QStringList &ids) { mLast = ids; }
    /// Ids in the order shown, for tests.
    QStringList shownIds() const;
    QLineEdit *field() const { return mField; }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void refresh();
    void runCurrent();

    ActionCatalogue &mActions;
    QLineEdit *mField;
    QListWidget *mList;
    QStringList mRecent; // newest first
    QStringList mLast;
};

} // namespace ductus
