// SPDX-License-Identifier: GPL-3.0-or-later

#include "sampleGrains.H"

Foam::tensor Foam::lpf::randomNumbers::turn()
{
    const vector a = inCube(1);
    const vector e1 = a / mag(a);
    const vector b = inCube(1);
    const vector c = b - (b & e1) * e1;
    const vector e2 = c / mag(c);
    return tensor(e1, e2, e1 ^ e2);
}


std::vector<Foam::vector> Foam::lpf::jitteredLattice(
    randomNumbers& random,
    const vector& lower,
    const FixedList<label, 3>& n,
    const double spacing,
    const double jitter
)
{
    std::vector<vector> x;
    for (label k = 0; k < n[2]; ++k)
    {
        for (label j = 0; j < n[1]; ++j)
        {
            for (label i = 0; i < n[0]; ++i)
            {
                x.push_back(
                    lower + spacing * vector(i + 0.5, j + 0.5, k + 0.5)
                    + random.inCube(jitter * spacing)
                );
            }
        }
    }
    return x;
}
