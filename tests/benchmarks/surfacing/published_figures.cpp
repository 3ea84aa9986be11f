#include "benchmarks/surfacing/published_figures.h"

#include <algorithm>

namespace ductus {

namespace {

template <typename Row, typename Name>
const Row *rowNamed(const std::vector<Row> &rows, Name Row::*member, const std::string &name)
{
    const auto at =
        std::find_if(rows.begin(), rows.end(), [&](const Row &row) { return row.*member == name; });
    return at == rows.end() ? nullptr : &*at;
}

} // namespace

const std::vector<ThesisTiming> &thesisTimings()
{
    static const std::vector<ThesisTiming> rows{
        {"robbins_car1", 46.3, 11.4, 68.3, 8},     {"author1_car", 16.7, 1.9, 41.4, 5},
        {"flowrep_boat", 17.1, 1.6, 45.7, 3},      {"flowrep_bottle", 17.6, 2.2, 20.0, 3},
        {"onshape_bishop", 9.2, 1.2, 14.8, 4},     {"onshape_iron", 20.6, 5.6, 25.8, 6},
        {"flowsurf_beetle", 14.6, 0.8, 31.2, 2},   {"ils_roadster", 9.3, 1.5, 35.3, 4},
        {"t2f_car_97", 18.2, 1.6, 18.7, 3},        {"author2_guitar", 16.2, 1.6, 26.8, 3},
        {"robbins_car2", 62.3, 9.5, 64.5, 6},      {"author1_building", 32.9, 4.8, 41.9, 4},
        {"ils_speaker", 16.9, 1.2, 23.5, 3},       {"swh_vr_controller", 146.4, 79.1, 35.0, 8},
        {"author1_bulbasaur", 11.1, 3.7, 23.2, 5}, {"cassie_hat", 17.7, 1.2, 60.3, 3},
        {"tolentino_shoe", 57.0, 8.2, 38.8, 5},
    };
    return rows;
}

const ThesisTiming *thesisTiming(const std::string &sketch)
{
    return rowNamed(thesisTimings(), &ThesisTiming::sketch, sketch);
}

const std::vector<VipssCost> &vipssCosts()
{
    static const std::vector<VipssCost> rows{
        {"planck", 500, 29.5, 199},   {"trebol", 498, 33.3, 205},    {"hand", 500, 25.2, 199},
        {"vertebra", 500, 30.0, 199}, {"doghead", 1001, 112.8, 777}, {"planck", 1000, 114.7, 776},
    };
    return rows;
}

const VipssDistances *vipssDistances(const std::string &input)
{
    static const std::vector<VipssDistances> rows{
        {"planck", .0282, .0149, 3.712, .1657, .5302, 4.639},
        {"hand", .0054, .0178, .041, .0734, .2480, .989},
    };
    return rowNamed(rows, &VipssDistances::input, input);
}

} // namespace ductus
