// ReadingList: what else the strokes could mean, as pictures to choose from.
#pragma once

#include "sketchsurfacer/ui/presentation/ambiguity_presenter.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace ductus {

class ReadingList : public QWidget
{
    Q_OBJECT
public:
    /// \a ambiguity must outlive this.
    explicit ReadingList(AmbiguityPresenter &ambiguity, QWidget *parent = nullptr);

signals:
    void lookRequested();
    void chosen(int reading);

private:
    void refresh();

    AmbiguityPresenter &mAmbiguity;
    std::shared_ptr<const AmbiguityView> mListed;
    QLabel *mState;
    QPushButton *mLook;
    QVBoxLayout *mChoices;
};

} // namespace ductus
