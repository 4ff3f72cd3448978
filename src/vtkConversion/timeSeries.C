// SPDX-License-Identifier: GPL-3.0-or-later

#include "timeSeries.H"
#include "error.H"
#include "OSspecific.H"

#include <charconv>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace
{

using namespace Foam;

//- The shortest text that reads back to the same number
std::string exact(const scalar x)
{
    char digits[40];
    return std::string(digits, std::to_chars(digits, digits + 40, x).ptr);
}


void replaceFile(const fileName& file, const std::string& text)
{
    const fileName part(file + ".part");
    std::ofstream os(part);
    os << text;
    os.close();
    if (!os || !mv(part, file))
    {
        FatalErrorInFunction << "Cannot write " << file << nl
                             << "Check permissions and free space"
                             << exit(FatalError);
    }
}

} // namespace


Foam::lpf::timeSeries::timeSeries(const fileName& dir, const word& name)
    : dir_(dir), name_(name)
{
    std::ifstream is(seriesFile());
    const std::string text{
        std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>()};

    // as write() and OpenFOAM's foamToVTK write them
    static const std::regex entry(
        "\"name\"\\s*:\\s*\"([^\"]*)\"\\s*,\\s*\"time\"\\s*:\\s*([-+.0-9eE]+)"
    );
    for (std::sregex_iterator i(text.begin(), text.end(), entry), end; i != end;
         ++i)
    {
        scalar time;
        if (readScalar((*i)[2].str().c_str(), time))
        {
            files_[time] = fileName((*i)[1].str(), false);
        }
    }
}


void Foam::lpf::timeSeries::prune(const std::map<scalar, fileName>& data)
{
    // 0 stays when other times are purged
    const auto first = data.upper_bound(0);
    for (auto i = files_.begin(); i != files_.end();)
    {
        const fileName file(dir_ / i->second);
        const auto found = data.find(i->first);
        const bool ours = found != data.end()
                            ? highResLastModified(file)
                                  >= highResLastModified(found->second)
                            : (first == data.end() || i->first < first->first);
        i = ours && isFile(file) ? std::next(i) : files_.erase(i);
    }
}


void Foam::lpf::timeSeries::set(const scalar time, const fileName& file)
{
    for (auto i = files_.begin(); i != files_.end();)
    {
        i = i->second == file ? files_.erase(i) : std::next(i);
    }
    files_[time] = file;
}


void Foam::lpf::timeSeries::write() const
{
    std::ostringstream pvd, series;
    pvd << "<?xml version=\"1.0\"?>\n"
        << "<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n";
    series << "{\n  \"file-series-version\" : \"1.0\",\n  \"files\" : [";
    const char* separator = "\n";
    for (const auto& [time, file] : files_)
    {
        pvd << "    <DataSet timestep=\"" << exact(time)
            << "\" part=\"0\" file=\"" << file.c_str() << "\"/>\n";
        series << separator << "    { \"name\" : \"" << file.c_str()
               << "\", \"time\" : " << exact(time) << " }";
        separator = ",\n";
    }
    pvd << "  </Collection>\n</VTKFile>\n";
    series << "\n  ]\n}\n";
    mkDir(dir_);
    replaceFile(dir_ / name_ + ".pvd", pvd.str());
    replaceFile(seriesFile(), series.str());
}
