// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the pairs of a step

#include "neighbourSearch.H"
#include "enginePasses.H"
#include "cellRuns.H"
#include "listLoops.H"

#include <omp.h>

#include <algorithm>

namespace lpfPairs
{
namespace
{

//- Rounding of positions relative to a cell, with room to spare
constexpr double rounding = 1 + 1e-5;

struct box
{
    double lower[3], upper[3], middle[3];
};

box boxOf(const double* const x[3], int begin, int end)
{
    box b;
    for (int d = 0; d < 3; ++d)
    {
        b.lower[d] = b.upper[d] = x[d][begin];
        for (int i = begin + 1; i < end; ++i)
        {
            b.lower[d] = std::min(b.lower[d], x[d][i]);
            b.upper[d] = std::max(b.upper[d], x[d][i]);
        }
        b.middle[d] = 0.5 * (b.lower[d] + b.upper[d]);
    }
    return b;
}

//- Lists of the particles [begin, end) of a cell
LPF_ONE_BODY void searchCell(
    const searchPass& p,
    const runs& around,
    int begin,
    int end,
    candidates& near,
    neighbourTable& table
)
{
    if (around.count == 0)
    {
        std::fill(
            table.of.begin() + begin,
            table.of.begin() + end,
            neighbourTable::entry{nullptr, 0}
        );
        return;
    }
    const double* const x[3] = {p.x, p.y, p.z};
    const double* const X[3] = {p.X, p.Y, p.Z};
    const double reach = 2 * p.h * rounding;
    const auto reachSqr = static_cast<float>(reach * reach);
    const box b = boxOf(x, begin, end);
    near.take(around, X, b.middle);
    near.cut(b.lower, b.upper, reachSqr);

    listArena& arena =
        table.arenas[static_cast<std::size_t>(omp_get_thread_num())];
    const auto most = static_cast<std::size_t>(near.size()) + 2 * padding;
    for (int i = begin; i < end; ++i)
    {
        std::int32_t* list = arena.room(most);
        const int count =
            near.near({x[0][i], x[1][i], x[2][i]}, reachSqr, list);
        const int whole = (count + padding - 1) / padding * padding;
        std::fill(list + count, list + whole, table.others);
        table.of[static_cast<std::size_t>(i)] = {list, count};
        arena.take(static_cast<std::size_t>(whole));
    }
}

int sizeOf(const cellGrid& g)
{
    return g.start[static_cast<long>(g.n[0]) * g.n[1] * g.n[2]];
}

} // namespace

void searchPairs(const searchPass& p, neighbourTable* into)
{
    neighbourTable& table = *into;
    table.of.resize(static_cast<std::size_t>(sizeOf(p.home)));
    table.others = sizeOf(p.others);
    table.cyclic = false;
    for (int d = 0; d < 3; ++d)
    {
        table.period[d] = p.others.period[d];
        table.cyclic = table.cyclic || table.period[d] > 0;
    }
    const auto threads = static_cast<std::size_t>(omp_get_max_threads());
    if (table.arenas.size() < threads)
    {
        table.arenas.resize(threads);
    }
    for (listArena& arena : table.arenas)
    {
        arena.clear();
    }
    std::vector<candidates> near(threads);
    forCells(
        p.home,
        [&](int begin, int end, long x, long y, long z)
        {
            searchCell(
                p,
                runsAround(p.others, x, y, z),
                begin,
                end,
                near[static_cast<std::size_t>(omp_get_thread_num())],
                table
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

tableSize sizeOfTable(const neighbourTable* table)
{
    tableSize size = {0, 0, table->records.bytes()};
    size.lists += table->of.capacity() * sizeof(neighbourTable::entry);
    for (const listArena& arena : table->arenas)
    {
        size.lists += arena.bytes();
    }
    for (const neighbourTable::entry& e : table->of)
    {
        size.pairs += e.count;
    }
    return size;
}

int numberListed(const neighbourTable* table, int* slot)
{
    int count = 0;
    for (const neighbourTable::entry& e : table->of)
    {
        *slot++ = e.count > 0 ? count++ : -1;
    }
    return count;
}

} // namespace lpfPairs
