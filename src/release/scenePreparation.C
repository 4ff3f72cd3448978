// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenePreparation.H"
#include "crs.H"
#include "dictionaryText.H"
#include "frictionMapping.H"
#include "inputCheck.H"
#include "OSspecific.H"

#include <cmath>

namespace Foam
{
namespace lpf
{

namespace
{

// Relative deviation that rounding of typed numbers may cause
constexpr scalar typed = 1e-6;

// Columns of a release beyond which a spacing is taken for a slip; a minute of
// work and some 1e9 particles
constexpr scalar mostColumns = 1e8;

// Cells over the spacing below which an elevation model is too fine
constexpr scalar fineCells = 0.25;

} // namespace


scenePreparation::scenePreparation(
    const fileName& caseDir, const fileName& dictFile
)
    : caseDir_(caseDir), dict_(readDictionary(dictFile)),
      dictDigest_(
          dictFile == caseDir / "system" / "terrainToParticlesDict"
              ? digestOf(dictFile)
              : word()
      ),
      g_(readGravity(caseDir)),
      boundaries_(readDictionary(caseDir / "constant" / "boundaryProperties")),
      frame_(readSceneFrame(boundaries_))
{
    allowOnly(
        dict_,
        {"spacing",
         "lattice",
         "origin",
         "maxSpeed",
         "water",
         "ground",
         "release"}
    );
    if (frame_.planeThickness > 0)
    {
        checkGravityInPlane(caseDir_, frame_.planeNormal);
    }
    readPhases();
    readEndTime();
    readReleases();
    makeGround();
    checkCrs();
    fillReleases();
    grains_ = grainsAtRest(bodies_, material_, g_, grid_.spacing);
    water_ = waterAtRest(waters_, sceneOfWater());
    checkBorder();
}


void scenePreparation::readGrains(const dictionary& grains)
{
    material_.rho = readNumber(
        grains,
        "rho",
        dimDensity,
        {0, GREAT, true, false, "density of the grain, e.g. 2600 kg/m3"}
    );
    const word rheology = grains.get<word>("rheology");
    const dictionary& coeffs = neededDictionary(
        grains,
        rheology + "Coeffs",
        "write " + rheology + "Coeffs { ... }; tutorials show its numbers"
    );
    const scalar nu = readNumber(
        coeffs,
        "nu",
        dimless,
        {0,
         0.49,
         false,
         false,
         "Poisson's ratio of a granular skeleton lies between 0 and 0.49;"
         " write 0.2 to 0.4"}
    );
    material_.K0 = readNumber(
        coeffs,
        "K0",
        dimless,
        {0, 10, false, false, "ratio of lateral and vertical stress at rest"},
        nu / (1 - nu)
    );
    material_.geostatic =
        readChoice(coeffs, "initialStress", {"geostatic", "zero"}, "geostatic")
        == "geostatic";
    const autoPtr<frictionMapping> cone = frictionMapping::New(coeffs);
    const scalar muS = cone->slope(coeffs.getOrDefault<scalar>("muS", GREAT));
    const scalar ratio =
        std::sqrt(3.0) * (1 - material_.K0) / (1 + 2 * material_.K0);
    if (material_.geostatic && ratio > muS)
    {
        const scalar k = (std::sqrt(3.0) - muS) / (std::sqrt(3.0) + 2 * muS);
        Info << "The geostatic state, K0 = " << material_.K0
             << ", has sqrt(J2)/p = " << ratio << ", more than the slope "
             << "of muS, " << muS
             << ": it yields at once. Within the yield surface: K0 >= " << k
             << " or nu >= " << k / (1 + k) << nl << nl;
    }
}


void scenePreparation::readEndTime()
{
    const fileName file = caseDir_ / "system" / "controlDict";
    if (isFile(file))
    {
        bounds any;
        any.lower = 0;
        any.reason = "a run needs an end above zero, in s";
        endTime_ = readNumber(readDictionary(file), "endTime", dimTime, any, 0);
    }
}


void scenePreparation::readReleases()
{
    Info << "Reading releases" << nl;
    const dictionary& releases = neededDictionary(
        dict_, "release", "write release { type box; ... grains { ... } }"
    );
    const bool single = releases.found("type");
    const dictionary& where =
        single && releases.found("spacing") ? releases : dict_;
    grid_.spacing = readNumber(
        where,
        "spacing",
        dimLength,
        {0,
         GREAT,
         true,
         false,
         "distance of particles; five in the thickness of the release are"
         " a fair start"}
    );
    // origin is not known yet, only the axes are
    readLattice(dict_, Zero, grid_);
    if (single)
    {
        addRelease(releases, releases.getOrDefault<word>("zone", "release"));
    }
    else
    {
        for (const entry& e : releases)
        {
            if (!e.isDict())
            {
                refuse(
                    releases,
                    e.keyword(),
                    "release is either one body with a type, or several"
                    " sub-dictionaries, each with a type."
                );
            }
            addRelease(
                e.dict(), e.dict().getOrDefault<word>("zone", e.keyword())
            );
        }
    }
    if (regions_.empty())
    {
        FatalIOErrorInFunction(releases)
            << "No release is given: there would be no particle."
            << exit(FatalIOError);
    }
    checkPhasesUsed();
    readSpacingRatio();
    Info << nl;
}


void scenePreparation::addRelease(const dictionary& dict, const word& name)
{
    lattice own(grid_);
    readLattice(dict, Zero, own);
    if (dict.found("spacing")
        && mag(dict.get<scalar>("spacing") - grid_.spacing) > 0)
    {
        refuse(
            dict,
            "spacing",
            "All particles of a case have one spacing: the smoothing length is"
            " one for all. Write it once, at the top of the dictionary."
        );
    }
    regions_.append(releaseRegion::New(dict, {caseDir_, own.axes}));
    checkPhases(dict);
    regionDicts_.append(&dict);
    names_.append(name);
}


point scenePreparation::chooseOrigin() const
{
    // Not a round number near by: the same scene elsewhere, or in another
    // unit, must give the same local coordinates
    if (!dict_.found("origin"))
    {
        return pieces_.bounds().min();
    }
    ITstream& is = dict_.lookup("origin");
    if (is.size() && is[0].isWord())
    {
        readChoice(dict_, "origin", {"auto"});
        return pieces_.bounds().min();
    }
    const point origin = readVector(dict_, "origin", dimLength);
    checkReach(origin);
    return origin;
}


// Local coordinates have 16 digits: so far away the distance of two particles
// would be left with less than seven
void scenePreparation::checkReach(const point& origin) const
{
    constexpr scalar spacings = 1e9;
    const boundBox box = pieces_.bounds();
    const scalar reach =
        max(cmptMax(cmptMag(box.min() - origin)),
            cmptMax(cmptMag(box.max() - origin)));
    if (reach > spacings * grid_.spacing)
    {
        refuse(
            dict_,
            "origin",
            "The ground reaches " + Foam::name(reach) + " m away from it, "
                + "more than 1e9 spacings: particles could not be told apart. "
                + "Write a point near the ground, or leave it out: auto."
        );
    }
}


void scenePreparation::lowerGround()
{
    for (rasterPiece& piece : pieces_.rasters)
    {
        raster& r = piece.heights;
        forAll (r.values, k)
        {
            const label j = k / r.nx, i = k - j * r.nx;
            forAll (regions_, m)
            {
                r.values[k] -=
                    regions_[m].lowering(r.x0 + i * r.dx, r.y0 + j * r.dy);
            }
        }
    }
}


void scenePreparation::checkCells() const
{
    for (const rasterPiece& piece : pieces_.rasters)
    {
        const raster& r = piece.heights;
        if (max(r.dx, r.dy) < fineCells * grid_.spacing)
        {
            WarningInFunction
                << piece.file << " has cells of " << r.dx << " m, particles"
                << " stand " << grid_.spacing << " m apart: the flow does not"
                << " see the detail, but every cell costs time. Average it,"
                << " e.g. gdalwarp -r average -tr " << grid_.spacing / 2 << ' '
                << grid_.spacing / 2 << endl;
        }
    }
}


void scenePreparation::makeGround()
{
    Info << "Reading ground" << nl;
    boundBox plan = boundBox(boundBox::invertedBox);
    forAll (regions_, i)
    {
        plan.add(regions_[i].plan());
    }
    pieces_ = readGround(
        neededDictionary(
            dict_, "ground", "write ground { type raster; file \"...\"; }"
        ),
        {caseDir_, plan}
    );
    lowerGround();
    checkCells();
    ground_ = pieces_.build(chooseOrigin());
    const boundBox box = ground_->bounds();
    const point& o = ground_->origin();
    Info << "    " << ground_->nTriangles() << " triangles, zones";
    for (const word& zone : ground_->zones())
    {
        Info << ' ' << zone;
    }
    // coordinates of maps have seven digits before the point
    const int digits = Info().precision(10);
    Info << nl << "    from " << box.min() + o << " to " << box.max() + o
         << " m" << nl << "    local origin " << o << nl << nl;
    Info().precision(digits);
}


void scenePreparation::checkCrs() const
{
    forAll (regions_, i)
    {
        const string crs = regions_[i].crs();
        if (!crs.empty() && !ground_->crs().empty()
            && !sameCrs(crs, ground_->crs()))
        {
            FatalIOErrorInFunction(*regionDicts_[i])
                << "Release " << names_[i] << " is in " << crsName(crs).c_str()
                << ", the ground in " << crsName(ground_->crs()).c_str() << '.'
                << nl << "Reproject one of them (ogr2ogr or gdalwarp -t_srs)."
                << exit(FatalIOError);
        }
        if (crs.empty() != ground_->crs().empty())
        {
            Info << "Release " << names_[i]
                 << " and ground: only one of them states its CRS; taken as the"
                 << " same." << nl << nl;
        }
    }
}


void scenePreparation::checkPeriod(const cyclicPair& pair, const scalar spacing)
    const
{
    const bool isGrains = mag(spacing - grid_.spacing) <= 0;
    const scalar period = pair.to - pair.from;
    const word axis = pair.axis == 0 ? "x" : "y";
    const scalar support = 2 * smoothingRatio * spacing;
    if (period < support)
    {
        refuse(
            boundaries_.subDict("cyclic"),
            axis,
            "The period of " + Foam::name(period)
                + " m is shorter than the support of the kernel, "
                + Foam::name(support)
                + " m: a grain would be its own neighbour. Write a longer "
                  "period or take a smaller spacing"
        );
    }
    const scalar n = period / spacing;
    if (mag(n - std::round(n)) > typed * n)
    {
        refuse(
            boundaries_.subDict("cyclic"),
            axis,
            "The period is " + Foam::name(n) + " spacings of "
                + Foam::name(spacing)
                + (isGrains ? " m. " : " m, that of the water. ")
                + "It must be a whole number of them: the lattice goes"
                  " on through the pair, else particles start too near to"
                  " each other or with a gap there. "
                + (isGrains ? "Take a spacing of " : "Take a water spacing of ")
                + Foam::name(period / std::round(n))
                + (isGrains ? " m or change the period."
                            : " m (spacingRatio) or change the period.")
        );
    }
}


void scenePreparation::checkCyclic() const
{
    for (const cyclicPair& pair : frame_.cyclic)
    {
        checkPeriod(pair, grid_.spacing);
        checkPeriod(pair, waterSpacing_);
        checkGroundBeyond(pair);
    }
}


// Particles at one plane see the ground on both sides of it
void scenePreparation::checkGroundBeyond(const cyclicPair& pair) const
{
    const scalar reach = 2 * smoothingRatio * max(grid_.spacing, waterSpacing_);
    const scalar little = typed * grid_.spacing;
    const scalar origin = ground_->origin()[pair.axis];
    const scalar from = ground_->bounds().min()[pair.axis] + origin;
    const scalar to = ground_->bounds().max()[pair.axis] + origin;
    if (from > pair.from - reach + little || to < pair.to + reach - little)
    {
        refuse(
            boundaries_.subDict("cyclic"),
            pair.name(),
            "The ground goes from " + pair.name() + " = " + Foam::name(from)
                + " to " + Foam::name(to)
                + " m. It must reach beyond the cyclic planes by twice the"
                  " smoothing length, "
                + Foam::name(reach)
                + " m, or particles there would see its end. Enlarge the"
                  " ground"
        );
    }
}


void scenePreparation::keepInCyclicBox(DynamicList<seed>& seeds) const
{
    // Half open, so that of two planes a period apart one is kept
    const scalar little = typed * grid_.spacing;
    label used = 0;
    forAll (seeds, i)
    {
        const point x = seeds[i].x + ground_->origin();
        bool inside = true;
        for (const cyclicPair& pair : frame_.cyclic)
        {
            const scalar s = x[pair.axis];
            inside = inside && s >= pair.from - little && s < pair.to - little;
        }
        if (inside)
        {
            seeds[used++] = seeds[i];
        }
    }
    seeds.resize(used);
}


void scenePreparation::checkSize(const label i) const
{
    const vector span = regions_[i].plan().span();
    const scalar columns =
        (frame_.planeThickness > 0 ? max(span.x(), span.y()) * grid_.spacing
                                   : span.x() * span.y())
        / sqr(min(grid_.spacing, waterSpacing_));
    if (columns > mostColumns)
    {
        FatalIOErrorInFunction(*regionDicts_[i])
            << "Release " << names_[i] << " is " << span.x() << " x "
            << span.y() << " m in plan; with a spacing of " << grid_.spacing
            << " m that is " << columns << " columns of particles." << nl
            << "Up to " << mostColumns << " can be made: is the spacing in"
            << " metres?" << exit(FatalIOError);
    }
}


void scenePreparation::warnBeyond(const boundBox& box) const
{
    label beyond = 0;
    const pointField all = positions();
    for (const point& x : all)
    {
        beyond += x.x() < box.min().x() || x.x() > box.max().x()
               || (frame_.planeThickness <= 0
                   && (x.y() < box.min().y() || x.y() > box.max().y()));
    }
    if (beyond > 0)
    {
        WarningInFunction
            << beyond << " particles of the release stand beyond the ground,"
            << " which ends at x " << box.min().x() + ground_->origin().x()
            << " to " << box.max().x() + ground_->origin().x() << ", y "
            << box.min().y() + ground_->origin().y() << " to "
            << box.max().y() + ground_->origin().y() << " m. They will fall"
            << " and be booked as left. Enlarge the ground if that is not meant"
            << endl;
    }
}


void scenePreparation::checkBorder() const
{
    const boundBox box = ground_->bounds();
    if (pieces_.rasters.empty())
    {
        warnBeyond(box);
        return;
    }
    const scalar margin = 2 * smoothingRatio * grid_.spacing;
    const pointField all = positions();
    for (const point& x : all)
    {
        if (x.x() < box.min().x() + margin || x.x() > box.max().x() - margin
            || x.y() < box.min().y() + margin || x.y() > box.max().y() - margin)
        {
            const point at = x + ground_->origin();
            FatalIOErrorInFunction(dict_)
                << "The release touches the border of the ground: a particle"
                << " at (" << at.x() << ' ' << at.y() << ") is nearer than "
                << margin << " m to it." << nl
                << "It would fall off at the start. Enlarge the window of the"
                << " ground, or cut the release." << exit(FatalIOError);
        }
    }
}

} // namespace lpf
} // namespace Foam
