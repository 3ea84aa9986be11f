// ThinBar: a progress bar of four pixels, without words.
#pragma once

#include <QWidget>

namespace ductus {

class ThinBar : public QWidget
{
    Q_OBJECT
public:
    explicit ThinBar(QWidget *parent = nullptr);
    /// 0..1
    void setFraction(double fraction);
    double fraction() const { return mFraction; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    double mFraction = 0.0;
};

} // namespace ductus
