// SPDX-License-Identifier: GPL-3.0-or-later
// The runs of particles around a cell hold every neighbour exactly once, also
// through cyclic planes, and down to one cell in a period.

#include <catch2/catch.hpp>

#include "cellLattice.H"
#include "cellRuns.H"
#include "sampleGrains.H"

#include <map>
#include <tuple>

using namespace Foam;
using namespace Foam::lpf;

namespace
{

constexpr double h = 0.5; // a cell is at least 1 wide

//- A neighbour: its number and which image of it
using image = std::tuple<int, int, int>;

struct scene
{
    cyclicBox box;
    realArrays<3> x;
    int n = 0;
    sortedCells cells;

    scene(randomNumbers& random, int count, const vector& size)
    {
        n = count;
        for (direction d = 0; d < 3; ++d)
        {
            x[d].resize(n);
            for (int i = 0; i < n; ++i)
            {
                x[d][i] = random(0, size[d]);
            }
        }
    }

    void makeCyclic(direction d, double period)
    {
        box.lower[d] = 0;
        box.period[d] = period;
    }

    void sort()
    {
        const cellLattice lattice(h, box);
        indexArray order;
        order.resize(n);
        lattice.sort(x, n, order, cells);
        if (cells.moved)
        {
            for (auto& component : x)
            {
                const auto old = component;
                for (int i = 0; i < n; ++i)
                {
                    component[i] = old[order[i]];
                }
            }
        }
    }

    //- How often each neighbour is met from i, by the runs
    std::map<image, int> byRuns(int i, long cx, long cy, long cz) const
    {
        std::map<image, int> met;
        const lpfPairs::runs around =
            lpfPairs::runsAround(cells.grid, cx, cy, cz);
        for (int k = 0; k < around.count; ++k)
        {
            const lpfPairs::run& r = around.list[k];
            const vector shift(r.shift[0], r.shift[1], r.shift[2]);
            for (int j = r.begin; j < r.end; ++j)
            {
                if (magSqr(at(x, i) - shift - at(x, j)) < 4 * h * h)
                {
                    ++met[{j, sign(shift.x()), sign(shift.y())}];
                }
            }
        }
        return met;
    }

    //- The same by looking at all particles and their images
    std::map<image, int> byForce(int i) const
    {
        std::map<image, int> met;
        const int reachX = box.period.x() > 0, reachY = box.period.y() > 0;
        for (int ix = -reachX; ix <= reachX; ++ix)
        {
            for (int iy = -reachY; iy <= reachY; ++iy)
            {
                const vector shift(ix * box.period.x(), iy * box.period.y(), 0);
                for (int j = 0; j < n; ++j)
                {
                    if (magSqr(at(x, i) - shift - at(x, j)) < 4 * h * h)
                    {
                        ++met[{j, ix, iy}];
                    }
                }
            }
        }
        return met;
    }

    static int sign(double s) { return s > 0 ? 1 : s < 0 ? -1 : 0; }
};


//- All particles of a scene; returns how many neighbours they have
int compare(scene& s)
{
    s.sort();
    int visited = 0, neighbours = 0, wrong = 0;
    lpfPairs::forCells(
        s.cells.grid,
        [&](int begin, int end, long cx, long cy, long cz)
        {
            for (int i = begin; i < end; ++i)
            {
                const auto expected = s.byForce(i);
                const bool same = s.byRuns(i, cx, cy, cz) == expected;
#pragma omp critical
                {
                    ++visited;
                    neighbours += static_cast<int>(expected.size());
                    wrong += !same;
                }
            }
        }
    );
    CHECK(visited == s.n);
    CHECK(wrong == 0);
    return neighbours;
}

} // namespace


TEST_CASE("cell runs: exactly the neighbours of each particle")
{
    randomNumbers random(11);
    scene s(random, 500, vector(7, 6, 5));
    CHECK(compare(s) > 1500);
}


TEST_CASE("cell runs: a cloud across the origin and one far away")
{
    randomNumbers random(12);
    for (const double away : {-3.3, -1e6, 1e6})
    {
        scene s(random, 300, vector(6, 5, 4));
        for (auto& component : s.x)
        {
            for (int i = 0; i < s.n; ++i)
            {
                component[i] += away;
            }
        }
        CHECK(compare(s) > 900);
    }
}


TEST_CASE("cell runs: cyclic in x and y, from one cell in a period upwards")
{
    randomNumbers random(13);
    // floor of the period, over an edge of 1: cells
    for (const double period : {1.0, 1.7, 2.0, 2.9, 3.0, 3.4, 6.0})
    {
        for (const bool alsoY : {false, true})
        {
            scene s(random, 250, vector(period, alsoY ? 2.6 : 4, 3));
            s.makeCyclic(0, period);
            if (alsoY)
            {
                s.makeCyclic(1, 2.6);
            }
            INFO("period " << period << " cyclic in y " << alsoY);
            CHECK(compare(s) > 2000);
            CHECK(s.cells.grid.n[0] == static_cast<int>(period));
        }
        scene s(random, 250, vector(3, period, 3));
        s.makeCyclic(1, period);
        compare(s);
    }
}


TEST_CASE("cell runs: all in one place, and none at all")
{
    randomNumbers random(14);
    scene s(random, 20, vector(0.01, 0.01, 0.01));
    CHECK(compare(s) == 400);
    scene none(random, 0, vector(1, 1, 1));
    CHECK(compare(none) == 0);
}


TEST_CASE("cellLattice: sorted by cell, stable, and still when nothing moves")
{
    randomNumbers random(15);
    scene s(random, 400, vector(5, 5, 5));
    const cellLattice lattice(h, s.box);
    indexArray order;
    order.resize(s.n);
    lattice.sort(s.x, s.n, order, s.cells);
    REQUIRE(s.cells.moved);
    const std::vector<int>& start = s.cells.start;
    CHECK(start.front() == 0);
    CHECK(start.back() == s.n);
    for (std::size_t c = 0; c + 1 < start.size(); ++c)
    {
        for (int k = start[c] + 1; k < start[c + 1]; ++k)
        {
            CHECK(order[k - 1] < order[k]);
        }
    }
    s.sort();
    lattice.sort(s.x, s.n, order, s.cells);
    CHECK_FALSE(s.cells.moved);
}
