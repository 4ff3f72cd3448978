// SPDX-License-Identifier: GPL-3.0-or-later
// Tables against time: one of all start folders.

#include <catch2/catch.hpp>

#include "OSspecific.H"
#include "seriesTable.H"

#include <fstream>

using namespace Foam;
using namespace Foam::lpf;

namespace
{

void put(const fileName& caseDir, const char* start, const char* text)
{
    const fileName dir = caseDir / "postProcessing/lpfSolver" / start;
    mkDir(dir);
    std::ofstream(dir / "a.dat") << text;
}

} // namespace


TEST_CASE("seriesTable: a run from an earlier time replaces what was written")
{
    const fileName dir = "seriesTableTest." + Foam::name(pid());
    put(dir, "0", "# time[s] a\n0\t1\t\n0.5\t2\n1\t3\n1.5\t4\n");
    put(dir, "1", "# time[s] a\n1\t30\n1.25\t40\n1.5\t5");
    // Ten is later than nine, whatever the order of the letters
    put(dir, "10", "# time[s] a\n10\t7\n");
    put(dir, "9", "# time[s] a\n9\t6\n");
    const seriesTable table(dir, "lpfSolver", "a.dat");
    // the last line of 1 has no end: it is being written
    CHECK(
        table.time()
        == scalarField(scalarList({0.0, 0.5, 1.0, 1.25, 9.0, 10.0}))
    );
    CHECK(
        table.column("a")
        == scalarField(scalarList({1.0, 2.0, 30.0, 40.0, 6.0, 7.0}))
    );
    CHECK(!table.has("b"));
    CHECK(seriesTable(dir, "lpfSolver", "b.dat").empty());
    CHECK(seriesTable(dir / "none", "lpfSolver", "a.dat").empty());
    rmDir(dir);
}
