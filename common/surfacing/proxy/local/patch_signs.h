// Which side of each patch is outside: fits without normals know their surface, not its sides. Neighbouring
// patches agree about the normals of the points they share up to a sign; the signs are chosen so that as much
// as possible agrees, with each other and, where that leaves a choice, with a rough idea of the whole shape.
//
//     max  sum_ab s_a s_b A_ab + sum_a s_a u_a,   s = +-1,   A_ab = sum over shared points of n^a . n^b
//
// Signs carried along the most reliable tree, and those of the rough idea, are two proposals; each connected
// piece in which they differ takes the better one, and then each patch for itself.
#pragma once

#include <vector>

namespace ductus {

struct PatchAgreement
{
    int a = 0, b = 0;         // patches, a < b
    double agreement = 0.0;   // A_ab
    double reliability = 0.0; // 0..1: |A_ab| over the number of points shared
};

/// One sign a patch, +1 or -1. \a rough: u_a, one a patch.
std::vector<int> consistentSigns(const std::vector<PatchAgreement> &agreements,
                                 const std::vector<double> &rough);

} // namespace ductus
