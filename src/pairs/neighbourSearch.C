// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the pairs of a step

#include "neighbourSearch.H"
#include "enginePasses.H"
#include "listLoops.H"

#include <omp.h>

#include <algorithm>
#include <numeric>

namespace lpfPairs
{
namespace
{

//- Rounding of positions relative to a cell, with room to spare
constexpr double rounding = 1 + 1e-5;

cellBox boxAround(const double* const x[3], int begin, int end)
{
    cellBox box;
    for (int d = 0; d < 3; ++d)
    {
        double lower = x[d][begin], upper = x[d][begin];
        for (int i = begin + 1; i < end; ++i)
        {
            lower = std::min(lower, x[d][i]);
            upper = std::max(upper, x[d][i]);
        }
        box.middle[d] = 0.5 * (lower + upper);
        box.half[d] = static_cast<float>(0.5 * (upper - lower) * rounding);
    }
    return box;
}

//- Bits of the cell and its particles, in memory from `at` on
LPF_ONE_BODY void searchCell(
    const searchPass& p,
    const searchedCell& cell,
    candidates& near,
    bitArena& memory,
    bitArena::place& at
)
{
    const double* const x[3] = {p.x, p.y, p.z};
    const double* const X[3] = {p.X, p.Y, p.Z};
    const double reach = 2 * p.h * rounding;
    const auto reachSqr = static_cast<float>(reach * reach);
    const int all = unitsOf(sizeOf(cell.around));
    const int units = near.take(
        cell.around,
        X,
        boxAround(x, cell.begin, cell.end),
        reachSqr,
        memory.room(at, all)
    );
    candidateBits* bits = memory.room(at, units * (cell.end - cell.begin));
    for (int i = cell.begin; i < cell.end; ++i)
    {
        bits = near.near({x[0][i], x[1][i], x[2][i]}, reachSqr, bits);
    }
}

int sizeOf(const cellGrid& g)
{
    return g.start[static_cast<long>(g.n[0]) * g.n[1] * g.n[2]];
}

//- Those with particles
void takeStretches(neighbourTable& table)
{
    const cellGrid& g = table.home;
    const int rows = g.n[1] * g.n[2];
    table.stretches.clear();
    for (int row = 0; row < rows; ++row)
    {
        const int* start = g.start + static_cast<long>(row) * g.n[0];
        for (int x = 0; x < g.n[0]; x += neighbourTable::stretchCells)
        {
            const int end = std::min(x + neighbourTable::stretchCells, g.n[0]);
            if (start[x] < start[end])
            {
                table.stretches.push_back({row, x, 0, {}});
            }
        }
    }
}

//- Has a particle with so many units of bits any of the others near?
bool anyOf(const candidateBits* bits, int units)
{
    return std::any_of(
        bits, bits + units, [](candidateBits b) { return b != 0; }
    );
}

} // namespace

void searchPairs(const searchPass& p, neighbourTable* into)
{
    neighbourTable& table = *into;
    table.home = p.home;
    table.others = p.others;
    table.othersSize = sizeOf(p.others);
    table.cyclic = false;
    for (const double period : p.others.period)
    {
        table.cyclic = table.cyclic || period > 0;
    }
    takeStretches(table);
    const auto threads = static_cast<std::size_t>(omp_get_max_threads());
    if (table.arenas.size() < threads)
    {
        table.arenas.resize(threads);
    }
    std::vector<candidates> near(threads);
    std::vector<bitArena::place> ends(threads);
    forStretches(
        table,
        [&](neighbourTable::stretch& s, std::size_t)
        {
            const int thread = omp_get_thread_num();
            const auto t = static_cast<std::size_t>(thread);
            s.arena = thread;
            s.bits = ends[t];
            forCellsOf(
                s,
                p.home,
                [&](int begin, int end, long x, long y, long z)
                {
                    searchCell(
                        p,
                        {begin, end, runsAround(p.others, x, y, z)},
                        near[t],
                        table.arenas[t],
                        ends[t]
                    );
                }
            );
        }
    );
}

neighbourTable* newTable()
{
    return new neighbourTable;
}

void deleteTable(neighbourTable* table)
{
    delete table;
}

void borrowMemory(neighbourTable* table, const neighbourTable* lender)
{
    table->records = lender->records;
    table->borrows = true;
}

tableSize sizeOfTable(const neighbourTable* table)
{
    tableSize size = {0, 0, table->borrows ? 0 : table->records->bytes()};
    size.neighbours +=
        table->stretches.capacity() * sizeof(neighbourTable::stretch);
    for (const bitArena& arena : table->arenas)
    {
        size.neighbours += arena.bytes();
    }
    for (const neighbourTable::stretch& s : table->stretches)
    {
        forSearched(
            *table,
            s,
            [&](const searchedCell& cell) {
                size.pairs +=
                    countBits(cell.bits, cell.units * (cell.end - cell.begin));
            }
        );
    }
    return size;
}

// Whether, then how many in each stretch, then the numbers
int numberListed(const neighbourTable* table, int* slot)
{
    const auto stretches = table->stretches.size();
    std::vector<int> numbers(stretches + 1, 0);
    forStretches(
        *table,
        [&](const neighbourTable::stretch& s, std::size_t k)
        {
            forSearched(
                *table,
                s,
                [&](const searchedCell& cell)
                {
                    const candidateBits* bits = cell.bits;
                    for (int i = cell.begin; i < cell.end; ++i)
                    {
                        slot[i] = anyOf(bits, cell.units) ? 0 : -1;
                        numbers[k + 1] += slot[i] == 0;
                        bits += cell.units;
                    }
                }
            );
        }
    );
    std::partial_sum(numbers.begin(), numbers.end(), numbers.begin());
    forStretches(
        *table,
        [&](const neighbourTable::stretch& s, std::size_t k)
        {
            int number = numbers[k];
            forCellsOf(
                s,
                table->home,
                [&](int begin, int end, long, long, long)
                {
                    for (int i = begin; i < end; ++i)
                    {
                        slot[i] += slot[i] == 0 ? number++ : 0;
                    }
                }
            );
        }
    );
    return numbers.back();
}

} // namespace lpfPairs
