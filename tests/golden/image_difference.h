// How far a picture of a window is from the one that is kept, as an eye would say: at a quarter of the size,
// where a pixel more or less of a letter does not count, and a missing panel does.
#pragma once

#include <QImage>

namespace ductus {

struct DifferenceOptions
{
    int channelTolerance = 20;  // of 255, at a quarter of the size
    double mostFailing = 0.015; // share of pixels
};

struct ImageDifference
{
    double failingShare = 1.0; // of pixels with a channel beyond the tolerance; 1 where the sizes differ
    QImage picture;            // dimmed, failing pixels red; at a quarter of the size

    bool isMatch(const DifferenceOptions &options = {}) const { return failingShare <= options.mostFailing; }
};

ImageDifference differenceOf(const QImage &made, const QImage &kept, const DifferenceOptions &options = {});

/// Coarser colours than an eye tells apart, so that it stays small in a repository.
QImage toBeKept(const QImage &image);

} // namespace ductus
