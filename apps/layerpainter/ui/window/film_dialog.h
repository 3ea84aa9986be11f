// FilmDialog: what a film shows, how large and of which kind.
#pragma once

#include "layerpainter/film/painting_film.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;

namespace ductus {

class NumberSlider;

struct FilmChoice
{
    PaintingFilm film;
    bool everyLook = false;
    QString extension; // ".mp4"; empty: a folder of pictures
};

class FilmDialog : public QDialog
{
    Q_OBJECT
public:
    /// \a present: from where the canvas shows the painting now.
    FilmDialog(std::shared_ptr<const Painting> painting, const CameraKey &present, QWidget *parent = nullptr);

    FilmChoice choice() const;

private:
    void refresh();

    std::shared_ptr<const Painting> mPainting;
    CameraKey mPresent;
    double mMotionSeconds;
    QComboBox *mView, *mLook, *mKind, *mSize, *mRate;
    NumberSlider *mSeconds;
    QCheckBox *mTransparent;
    QLabel *mSummary = nullptr;
};

} // namespace ductus
