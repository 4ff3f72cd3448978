// SPDX-License-Identifier: GPL-3.0-or-later

#include "seriesTable.H"

#include "error.H"
#include "ListOps.H"
#include "OSspecific.H"

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

namespace
{

using namespace Foam;

[[noreturn]] void
damaged(const fileName& file, const label line, const string& what)
{
    FatalIOError("", "", 0, file, line, -1)
        << what.c_str() << nl
        << "lpfSolver writes this file: is it damaged, or of another "
        << "version? Remove it, and what rests on it is left out."
        << exit(FatalIOError);
    std::exit(1); // not reached; exit() above is not declared noreturn
}

} // namespace


Foam::lpf::seriesTable::seriesTable(
    const fileName& caseDir, const word& program, const word& file
)
{
    const fileName parent = caseDir / "postProcessing" / program;
    std::map<scalar, fileName> starts;
    for (const fileName& name : readDir(parent, fileName::DIRECTORY))
    {
        scalar start;
        if (readScalar(name, start) && isFile(parent / name / file))
        {
            starts[start] = parent / name / file;
        }
    }
    for (const auto& [start, path] : starts)
    {
        join(path, start);
    }
}


void Foam::lpf::seriesTable::join(const fileName& file, const scalar start)
{
    while (!rows_.empty() && rows_.last().first() >= start)
    {
        rows_.remove();
    }
    std::ifstream is(file);
    std::string line;
    for (label number = 1; std::getline(is, line); ++number)
    {
        if (is.eof())
        {
            break;
        }
        if (number == 1)
        {
            readNames(line, file);
        }
        else
        {
            rows_.append(readRow(line, file, number));
        }
    }
}


void Foam::lpf::seriesTable::readNames(
    const std::string& line, const fileName& file
)
{
    std::istringstream words(line);
    std::string name;
    DynamicList<string> names;
    words >> name;
    const bool isHeader = name == "#";
    while (words >> name)
    {
        names.append(name);
    }
    if (!isHeader || names.empty())
    {
        damaged(file, 1, "`#` and the names of the columns should stand here");
    }
    if (!names_.empty() && names_ != names)
    {
        damaged(file, 1, "the columns are not those of the run before");
    }
    names_ = names;
}


Foam::scalarList Foam::lpf::seriesTable::readRow(
    const std::string& line, const fileName& file, const label number
) const
{
    std::istringstream words(line);
    std::string text;
    DynamicList<scalar> row;
    while (words >> text)
    {
        scalar value;
        if (!readScalar(text, value))
        {
            damaged(file, number, "`" + text + "` is no number");
        }
        row.append(value);
    }
    if (row.size() != names_.size())
    {
        damaged(
            file,
            number,
            Foam::name(row.size()) + " numbers for " + Foam::name(names_.size())
                + " columns"
        );
    }
    return scalarList(std::move(row));
}


Foam::scalarField Foam::lpf::seriesTable::column(const string& name) const
{
    const label c = names_.find(name);
    if (c < 0)
    {
        FatalErrorInFunction << "the table has no column " << name.c_str()
                             << abort(FatalError);
    }
    scalarField values(rows_.size());
    forAll (values, k)
    {
        values[k] = rows_[k][c];
    }
    return values;
}
