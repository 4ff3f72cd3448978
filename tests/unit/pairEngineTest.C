// SPDX-License-Identifier: GPL-3.0-or-later
// Every build of the pair loops against a plain double loop over all pairs, in
// one number type, without cells: 1e-13.

#include <catch2/catch.hpp>

#include "cellLattice.H"
#include "engineLoader.H"
#include "pairTable.H"
#include "pairTerms.H"
#include "sampleCase.H"
#include "sampleGrains.H"
#include "waterTerms.H"
#include "wendlandC2.H"

#include <cstring>

using namespace Foam;
using namespace Foam::lpf;
using lpfPairs::loadPairEngine;
using lpfPairs::pairEngine;
using lpfPairs::wendlandC2;

namespace
{

constexpr double dx = 0.1, h = 1.3 * dx;

//- The builds that this processor runs
std::vector<const pairEngine*> engines()
{
    std::vector<const pairEngine*> all;
    for (const std::string isa : {"x86-64-v2", "x86-64-v3", "x86-64-v4"})
    {
        const bool runs = isa == "x86-64-v4" ? __builtin_cpu_supports("avx512f")
                        : isa == "x86-64-v3" ? __builtin_cpu_supports("avx2")
                                             : __builtin_cpu_supports("sse4.2");
        if (runs)
        {
            all.push_back(&loadPairEngine(isa));
            CHECK(isa == all.back()->instructionSet);
        }
        else
        {
            WARN("this processor has no " << isa << ": not tested");
        }
    }
    return all;
}


//- Copy of an array in the order of a sort
void arrange(realArray& values, const indexArray& order, int n)
{
    const realArray old = values;
    for (int i = 0; i < n; ++i)
    {
        values[i] = old[order[i]];
    }
}


//- Grains and surface elements at random, sorted into cells
struct cloud
{
    int n = 0, dimensions;
    cyclicBox box;
    realArrays<3> x, u;
    realArray V, m, rho;
    realArrays<9> A, L;
    sortedCells cells;

    int nElements = 0;
    realArrays<3> ex, en;
    realArray area, mu;
    sortedCells elements;
    indexArray slot;
    realArrays<3> sheet;
    realArray sheetHeight;
    bool screened = false; //!< every other element by a sheet

    cloud(unsigned seed, int dims, bool cyclic) : dimensions(dims)
    {
        randomNumbers random(seed);
        const auto points =
            jitteredLattice(random, Zero, {10, dims == 2 ? 1 : 8, 7}, dx, 0.3);
        n = static_cast<int>(points.size());
        resize();
        for (int i = 0; i < n; ++i)
        {
            vector p = points[static_cast<std::size_t>(i)];
            if (dims == 2)
            {
                p.y() = 0;
            }
            set(x, i, p);
            set(u, i, random.inCube(2));
            V[i] = random(0.5, 1.5) * dx * dx * (dims == 2 ? 1 : dx);
            m[i] = V[i] * random(1000, 2000);
            rho[i] = m[i] / V[i];
            for (std::size_t c = 0; c < 9; ++c)
            {
                A[c][i] = random(-1e4, 1e4);
                L[c][i] = random(-20, 20);
            }
        }
        if (cyclic)
        {
            box.period = vector(10 * dx, dims == 2 ? 0 : 8 * dx, 0);
            wrap();
        }
        const cellLattice lattice(h, box);
        sort(lattice);
        makeElements(random, lattice);
        // what lies beyond the end must not matter, as long as it is finite
        for (auto* f : {&x[0], &x[1], &x[2], &u[0], &u[1], &u[2], &V, &m})
        {
            f->pad(n, 0.3);
        }
        rho.pad(n, 1);
        for (std::size_t c = 0; c < 9; ++c)
        {
            A[c].pad(n, 1e9);
            L[c].pad(n, 1e9);
        }
    }

    void resize()
    {
        for (std::size_t d = 0; d < 3; ++d)
        {
            x[d].resize(n);
            u[d].resize(n);
        }
        for (auto* f : {&V, &m, &rho})
        {
            f->resize(n);
        }
        for (std::size_t c = 0; c < 9; ++c)
        {
            A[c].resize(n);
            L[c].resize(n);
        }
    }

    void wrap()
    {
        for (direction d = 0; d < 3; ++d)
        {
            const double p = box.period[d];
            for (int i = 0; p > 0 && i < n; ++i)
            {
                x[d][i] -= p * std::floor(x[d][i] / p);
            }
        }
    }

    void sort(const cellLattice& lattice)
    {
        indexArray order;
        order.resize(n);
        lattice.sort(x, n, order, cells);
        REQUIRE(cells.moved);
        for (std::size_t d = 0; d < 3; ++d)
        {
            arrange(x[d], order, n);
            arrange(u[d], order, n);
        }
        for (auto* f : {&V, &m, &rho})
        {
            arrange(*f, order, n);
        }
        for (std::size_t c = 0; c < 9; ++c)
        {
            arrange(A[c], order, n);
            arrange(L[c], order, n);
        }
    }

    void makeElements(randomNumbers& random, const cellLattice& lattice)
    {
        // on a wavy floor, looking upwards in all directions
        nElements = 400;
        for (auto* f :
             {&ex[0], &ex[1], &ex[2], &en[0], &en[1], &en[2], &area, &mu})
        {
            f->resize(nElements);
        }
        for (int q = 0; q < nElements; ++q)
        {
            const vector p(
                random(-2 * dx, 12 * dx),
                dimensions == 2 ? 0 : random(-2 * dx, 10 * dx),
                random(-dx, dx)
            );
            vector normal = vector(0, 0, 1) + random.inCube(0.9);
            normal.y() *= dimensions == 3;
            set(ex, q, p);
            set(en, q, normal / mag(normal));
            area[q] = random(0.2, 1) * dx * (dimensions == 2 ? 1 : dx);
            mu[q] = random(0, 1);
        }
        indexArray order;
        order.resize(nElements);
        lattice.sort(ex, nElements, order, elements);
        for (auto* f :
             {&ex[0], &ex[1], &ex[2], &en[0], &en[1], &en[2], &area, &mu})
        {
            arrange(*f, order, nElements);
        }
        slot.resize(n);
        makeSheets(random);
    }

    void makeSheets(randomNumbers& random)
    {
        lpf::resize(sheet, nElements);
        sheetHeight.resize(nElements);
        for (int q = 0; q < nElements; q += 2)
        {
            const vector normal = random.inCube(1);
            set(sheet, q, normal / mag(normal));
            sheetHeight[q] = random(-2 * dx, 0);
        }
    }

    //- term(j, x_ij) for all images within the support
    template<class Term>
    void overPairs(int i, const Term& term) const
    {
        const double Px = box.period.x(), Py = box.period.y();
        for (int ix = Px > 0 ? -1 : 0; ix <= (Px > 0 ? 1 : 0); ++ix)
        {
            for (int iy = Py > 0 ? -1 : 0; iy <= (Py > 0 ? 1 : 0); ++iy)
            {
                const vector from = at(x, i) - vector(ix * Px, iy * Py, 0);
                for (int j = 0; j < n; ++j)
                {
                    const vector x_ij = from - at(x, j);
                    if (magSqr(x_ij) < 4 * h * h)
                    {
                        term(j, vec(x_ij));
                    }
                }
            }
        }
    }

    bool single = false; //!< ask for single precision

    template<class Pass>
    void fill(Pass& p) const
    {
        p = {};
        p.single = single;
        p.cells = cells.grid;
        p.h = h;
        p.dimensions = dimensions;
        p.x = x[0].data();
        p.y = x[1].data();
        p.z = x[2].data();
    }
};


//- Columns of results, and how far two of them are apart
class results
{
    std::vector<std::vector<double>> columns_;

public:
    results(std::size_t columns, int n)
        : columns_(columns, std::vector<double>(static_cast<std::size_t>(n)))
    {
    }

    double* column(std::size_t c) { return columns_[c].data(); }

    //- Largest difference over the largest value of a group of columns
    double apart(const results& other, std::size_t from, std::size_t to) const
    {
        double difference = 0, largest = 0;
        for (std::size_t c = from; c < to; ++c)
        {
            for (std::size_t i = 0; i < columns_[c].size(); ++i)
            {
                difference = std::max(
                    difference, std::abs(columns_[c][i] - other.columns_[c][i])
                );
                largest = std::max(largest, std::abs(columns_[c][i]));
            }
        }
        REQUIRE(largest > 0);
        return difference / largest;
    }
};


results kinematicsOf(const cloud& c, const pairEngine* engine)
{
    results all(15, c.n);
    if (engine)
    {
        lpfPairs::kinematicsPass p = {};
        c.fill(p);
        p.u = c.u[0].data();
        p.v = c.u[1].data();
        p.w = c.u[2].data();
        p.V = c.V.data();
        for (std::size_t k = 0; k < 9; ++k)
        {
            p.R[k] = all.column(k);
        }
        for (std::size_t k = 0; k < 6; ++k)
        {
            p.M[k] = all.column(9 + k);
        }
        engine->kinematics(p);
        return all;
    }
    const wendlandC2 W(h, c.dimensions);
    for (int i = 0; i < c.n; ++i)
    {
        lpfPairs::Kinematics<double> sum = {};
        c.overPairs(
            i,
            [&](int j, const Vec3& x_ij)
            {
                addKinematics(
                    sum,
                    c.V[j] * W.gradByDistance(magSqr(x_ij)),
                    x_ij,
                    vec(at(c.u, i) - at(c.u, j))
                );
            }
        );
        double values[15];
        static_assert(sizeof(values) == sizeof(sum), "all of the sums");
        std::memcpy(values, &sum, sizeof(sum));
        for (std::size_t k = 0; k < 15; ++k)
        {
            all.column(k)[i] = values[k];
        }
    }
    return all;
}


constexpr double soundSpeed = 40, thickness = 0.7;

//- Artificial viscosity and damping of noise
struct damping
{
    const char* name;
    double alpha, beta;
};

//- Acceleration and viscous power by an engine
results forcesBy(const pairEngine& engine, const cloud& c, const damping& by)
{
    results all(4, c.n);
    lpfPairs::forcePass p;
    c.fill(p);
    p.thickness = thickness;
    p.V = c.V.data();
    p.m = c.m.data();
    p.ax = all.column(0);
    p.ay = all.column(1);
    p.az = all.column(2);
    p.alpha = by.alpha;
    p.beta = by.beta;
    p.soundSpeed = soundSpeed;
    p.u = c.u[0].data();
    p.v = c.u[1].data();
    p.w = c.u[2].data();
    p.rho = c.rho.data();
    p.viscousPower = all.column(3);
    for (std::size_t k = 0; k < 9; ++k)
    {
        p.A[k] = c.A[k].data();
        p.L[k] = c.L[k].data();
    }
    engine.force(p);
    return all;
}


tensor tensorAt(const realArrays<9>& from, int i)
{
    tensor t;
    for (direction k = 0; k < 9; ++k)
    {
        t[k] = from[k][i];
    }
    return t;
}


//- Acceleration of i by the damping of one pair
vector dampingOfPair(
    const cloud& c, const damping& by, int i, int j, const Vec3& x_ij, double F
)
{
    const vector v_ij = at(c.u, i) - at(c.u, j), r = toFoam(x_ij);
    const vector w_ij =
        v_ij - (0.5 * (tensorAt(c.L, i) + tensorAt(c.L, j)) & r);
    const double rSqr = magSqr(x_ij), hc = h * soundSpeed,
                 rhoMean = 0.5 * (c.rho[i] + c.rho[j]);
    const double Pi = lpfPairs::artificialViscosity(
                          x_ij, vec(v_ij), rSqr, by.alpha * hc, h * h, rhoMean
                      )
                    + lpfPairs::noiseDamping(
                          x_ij, vec(w_ij), rSqr, by.beta * hc, h * h, rhoMean
                    );
    return (-c.m[j] * Pi * F / thickness) * r;
}


//- The same by looking at all pairs
results forcesByPairs(const cloud& c, const damping& by)
{
    results all(4, c.n);
    const wendlandC2 W(h, c.dimensions);
    for (int i = 0; i < c.n; ++i)
    {
        lpfPairs::Force<double> sum = {};
        vector a = Zero;
        double power = 0;
        c.overPairs(
            i,
            [&](int j, const Vec3& x_ij)
            {
                const double F = W.gradByDistance(magSqr(x_ij));
                addForce(sum, c.V[j] * F, x_ij, tens(tensorAt(c.A, j)));
                const vector a_ij = dampingOfPair(c, by, i, j, x_ij, F);
                a += a_ij;
                // each of the two bears half of what the pair loses
                power -= 0.5 * c.m[i] * (a_ij & (at(c.u, i) - at(c.u, j)));
            }
        );
        a += (thickness * c.V[i] / c.m[i])
           * toFoam((tens(tensorAt(c.A, i)) & sum.gradV) + sum.other);
        for (direction d = 0; d < 3; ++d)
        {
            all.column(d)[i] = a[d];
        }
        all.column(3)[i] = power;
    }
    return all;
}


lpfPairs::wallPass wallPassOf(cloud& c)
{
    lpfPairs::wallPass p = {};
    c.fill(p);
    // the ground has no images, as groundContact::present says
    p.elements = c.elements.grid;
    for (double& period : p.elements.period)
    {
        period = 0;
    }
    p.layerDepth = dx;
    p.behind = 0.1 * dx;
    p.outOfSight = dx;
    p.ex = c.ex[0].data();
    p.ey = c.ex[1].data();
    p.ez = c.ex[2].data();
    p.nx = c.en[0].data();
    p.ny = c.en[1].data();
    p.nz = c.en[2].data();
    p.area = c.area.data();
    p.mu = c.mu.data();
    p.slot = c.slot.data();
    if (c.screened)
    {
        for (direction d = 0; d < 3; ++d)
        {
            p.screens.n[d] = c.sheet[d].data();
        }
        p.screens.height = c.sheetHeight.data();
    }
    return p;
}


//- N3 (10), D2 (6), area, friction, share, then the nearest element: its
//  squared distance, plane distance, normal, and whether there is one
results wallsBy(const pairEngine& engine, cloud& c)
{
    results all(25, c.n);
    lpfPairs::wallPass p = wallPassOf(c);
    p.withShare = true;
    lpfPairs::pairTable around(engine);
    around.search({p.cells, p.elements, p.h, p.x, p.y, p.z, p.ex, p.ey, p.ez});
    std::vector<lpfPairs::wallRecord> records(
        static_cast<std::size_t>(around.number(c.slot.data()))
    );
    p.pairs = around.get();
    p.sums = records.data();
    engine.wall(p);
    for (int i = 0; i < c.n; ++i)
    {
        if (c.slot[i] < 0)
        {
            continue;
        }
        const auto& r = records[static_cast<std::size_t>(c.slot[i])];
        double values[24];
        static_assert(sizeof(values) == sizeof(r), "all of the record");
        std::memcpy(values, &r, sizeof(r));
        const bool found = values[19] < 4 * h * h;
        for (std::size_t k = 0; k < 24; ++k)
        {
            all.column(k)[i] = k < 19 || found ? values[k] : 0;
        }
        all.column(24)[i] = found;
    }
    return all;
}


//- The same by looking at all elements
results wallsByElements(cloud& c)
{
    results all(25, c.n);
    const lpfPairs::wallPass p = wallPassOf(c);
    const wendlandC2 W(h, c.dimensions);
    for (int i = 0; i < c.n; ++i)
    {
        lpfPairs::WallSums<double> sum = {};
        double values[25] = {};
        double nearest = 4 * h * h;
        for (int q = 0; q < c.nElements; ++q)
        {
            const vector x = at(c.x, i) - at(c.ex, q), n = at(c.en, q);
            const double rSqr = magSqr(x), d = x & n;
            if (c.screened && (x & at(c.sheet, q)) > -c.sheetHeight[q])
            {
                continue;
            }
            if (rSqr < nearest && d > -p.outOfSight)
            {
                nearest = rSqr;
                const double seen[6] = {rSqr, d, n.x(), n.y(), n.z(), 1};
                std::memcpy(values + 19, seen, sizeof(seen));
            }
            if (d > -p.behind && rSqr < 4 * h * h)
            {
                // the third layer is out of sight at h = 1.3 dx
                const auto s = lpfPairs::layerSums<2>(W, rSqr, d, dx);
                addWall(
                    sum,
                    lpfPairs::LayerSums<double>{
                        c.area[q] * s.E, c.area[q] * s.D},
                    vec(n),
                    c.mu[q]
                );
                sum.share +=
                    (c.dimensions == 3
                         ? lpfPairs::solidShare<3>(W, rSqr, d, c.area[q])
                         : lpfPairs::solidShare<2>(W, rSqr, d, c.area[q]));
            }
        }
        static_assert(sizeof(sum) == 19 * sizeof(double), "all of the sums");
        std::memcpy(values, &sum, sizeof(sum));
        for (std::size_t k = 0; k < 25; ++k)
        {
            all.column(k)[i] = values[k];
        }
    }
    return all;
}


constexpr double rho0 = 1500;
const Vec3 hydrostatic = {0.2, 0, -3};

//- div, |curl|, diffusion, fill, grad fill of the cloud taken as water
results waterContinuityOf(const cloud& c, const pairEngine* engine)
{
    results all(7, c.n);
    if (engine)
    {
        lpfPairs::waterContinuityPass p;
        c.fill(p);
        p.u = c.u[0].data();
        p.v = c.u[1].data();
        p.w = c.u[2].data();
        p.V = c.V.data();
        p.rho = c.rho.data();
        p.scale = 0.98;
        p.rho0 = rho0;
        p.hydrostatic[0] = hydrostatic.x;
        p.hydrostatic[2] = hydrostatic.z;
        p.divergence = all.column(0);
        p.curl = all.column(1);
        p.diffusion = all.column(2);
        p.fill = all.column(3);
        for (std::size_t k = 0; k < 3; ++k)
        {
            p.gradFill[k] = all.column(4 + k);
        }
        engine->waterContinuity(p);
        return all;
    }
    const wendlandC2 W(h, c.dimensions);
    for (int i = 0; i < c.n; ++i)
    {
        lpfPairs::Continuity<double> sum = {};
        lpfPairs::Filling<double> filling = {};
        c.overPairs(
            i,
            [&](int j, const Vec3& x_ij)
            {
                const double rSqr = magSqr(x_ij);
                const double VF = 0.98 * c.V[j] * W.gradByDistance(rSqr);
                addVelocityGradient(
                    sum, VF, x_ij, vec(at(c.u, i) - at(c.u, j))
                );
                addFilling(filling, c.V[j] * W.value(rSqr), VF, x_ij);
                sum.diffusion += lpfPairs::densityDiffusion(
                    VF, x_ij, c.rho[i], c.rho[j], rho0, hydrostatic
                );
            }
        );
        const double values[7] = {
            sum.divergence,
            std::sqrt(magSqr(sum.curl)),
            sum.diffusion,
            filling.fill,
            filling.gradient.x,
            filling.gradient.y,
            filling.gradient.z};
        for (std::size_t k = 0; k < 7; ++k)
        {
            all.column(k)[i] = values[k];
        }
    }
    return all;
}


//- Pressure P = 10 rho, switch 0.1 m, eta from L
struct waterValues
{
    realArray P, balsara, eta;

    explicit waterValues(const cloud& c)
    {
        for (auto* f : {&P, &balsara, &eta})
        {
            f->resize(c.n);
        }
        for (int i = 0; i < c.n; ++i)
        {
            P[i] = 10 * c.rho[i];
            balsara[i] = 0.5 + c.L[0][i] / 40;
            eta[i] = 1 + std::abs(c.L[1][i]);
        }
    }
};

//- Which friction
struct waterFriction
{
    const char* name;
    double alpha;
    bool viscous;
};

//- Pressure, friction, artificial and viscous power
results
waterForcesBy(const pairEngine& engine, const cloud& c, const waterFriction& by)
{
    results all(8, c.n);
    const waterValues values(c);
    lpfPairs::waterForcePass p;
    c.fill(p);
    p.thickness = thickness;
    p.scale = 0.98;
    p.V = c.V.data();
    p.m = c.m.data();
    p.P = values.P.data();
    p.ax = all.column(0);
    p.ay = all.column(1);
    p.az = all.column(2);
    p.alpha = by.alpha;
    p.soundSpeed = soundSpeed;
    p.u = c.u[0].data();
    p.v = c.u[1].data();
    p.w = c.u[2].data();
    p.rho = c.rho.data();
    p.balsara = values.balsara.data();
    p.eta = by.viscous ? values.eta.data() : nullptr;
    p.bx = all.column(3);
    p.by = all.column(4);
    p.bz = all.column(5);
    p.artificial = all.column(6);
    p.viscous = all.column(7);
    engine.waterForce(p);
    return all;
}

//- What one pair adds to the friction on i and to the powers lost there
struct frictionOfPair
{
    Vec3 acceleration;
    double artificial, viscous;
};

frictionOfPair frictionBy(
    const cloud& c,
    const waterValues& w,
    const waterFriction& by,
    int i,
    int j,
    const Vec3& x
)
{
    const double rSqr = magSqr(x);
    const double F = wendlandC2(h, c.dimensions).gradByDistance(rSqr);
    const Vec3 v = vec(at(c.u, i) - at(c.u, j));
    const double Pi = lpfPairs::artificialViscosity(
        x,
        v,
        rSqr,
        0.5 * (w.balsara[i] + w.balsara[j]) * by.alpha * h * soundSpeed,
        h * h,
        0.5 * (c.rho[i] + c.rho[j])
    );
    const double mPiF = c.m[j] * Pi * F / thickness;
    frictionOfPair all = {(-mPiF) * x, 0.5 * c.m[i] * mPiF * (v & x), 0};
    if (by.viscous)
    {
        const double volume = thickness * c.V[i];
        const double factor = lpfPairs::viscousFactor(
            c.V[j] * F,
            w.eta[i] + w.eta[j],
            c.dimensions + 2.0,
            x,
            v,
            rSqr,
            h * h
        );
        all.acceleration += (volume / c.m[i] * factor) * x;
        all.viscous = -0.5 * volume * factor * (v & x);
    }
    return all;
}

results waterForcesByPairs(const cloud& c, const waterFriction& by)
{
    results all(8, c.n);
    const waterValues w(c);
    const wendlandC2 W(h, c.dimensions);
    for (int i = 0; i < c.n; ++i)
    {
        Vec3 pressure = {};
        frictionOfPair total = {};
        c.overPairs(
            i,
            [&](int j, const Vec3& x)
            {
                const double VF = 0.98 * c.V[j] * W.gradByDistance(magSqr(x));
                lpfPairs::addPressureForce(pressure, VF, w.P[i], w.P[j], x);
                const frictionOfPair ij = frictionBy(c, w, by, i, j, x);
                total.acceleration += ij.acceleration;
                total.artificial += ij.artificial;
                total.viscous += ij.viscous;
            }
        );
        pressure = (thickness * c.V[i] / c.m[i]) * pressure;
        const double values[8] = {
            pressure.x,
            pressure.y,
            pressure.z,
            total.acceleration.x,
            total.acceleration.y,
            total.acceleration.z,
            total.artificial,
            total.viscous};
        for (std::size_t k = 0; k < 8; ++k)
        {
            all.column(k)[i] = values[k];
        }
    }
    return all;
}


//- The first count components of A, smoothed
results smoothedBy(const pairEngine* engine, const cloud& c, int count)
{
    results all(static_cast<std::size_t>(count), c.n);
    const wendlandC2 W(h, c.dimensions);
    lpfPairs::smoothPass p = {};
    p.single = c.single;
    p.home = p.others = c.cells.grid;
    p.h = h;
    p.dimensions = c.dimensions;
    p.x = p.X = c.x[0].data();
    p.y = p.Y = c.x[1].data();
    p.z = p.Z = c.x[2].data();
    p.count = count;
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
    {
        p.q[k] = c.A[k].data();
        p.out[k] = all.column(k);
        for (int i = 0; !engine && i < c.n; ++i)
        {
            c.overPairs(
                i,
                [&](int j, const Vec3& x)
                { p.out[k][i] += c.A[k][j] * W.value(magSqr(x)); }
            );
        }
    }
    if (engine)
    {
        engine->smooth(p);
    }
    return all;
}


template<class Test>
void forScenes(const Test& test)
{
    for (const int dimensions : {3, 2})
    {
        for (const bool cyclic : {false, true})
        {
            cloud c(20 + static_cast<unsigned>(dimensions), dimensions, cyclic);
            INFO(dimensions << " dimensions, cyclic " << cyclic);
            test(c);
        }
    }
}

} // namespace


TEST_CASE("pair engines: kinematics of every instruction set")
{
    const auto all = engines();
    forScenes(
        [&](cloud& c)
        {
            const results expected = kinematicsOf(c, nullptr);
            for (const pairEngine* engine : all)
            {
                INFO(engine->instructionSet);
                const results got = kinematicsOf(c, engine);
                CHECK(expected.apart(got, 0, 9) < 1e-13);
                CHECK(expected.apart(got, 9, 15) < 1e-13);
            }
        }
    );
}


TEST_CASE("pair engines: force of every instruction set")
{
    const auto all = engines();
    forScenes(
        [&](cloud& c)
        {
            for (const damping& by :
                 {damping{"none", 0, 0},
                  damping{"viscosity", 0.03, 0},
                  damping{"viscosity and noise", 0.03, 0.2}})
            {
                const results expected = forcesByPairs(c, by);
                for (const pairEngine* engine : all)
                {
                    INFO(engine->instructionSet << ", damping: " << by.name);
                    const results got = forcesBy(*engine, c, by);
                    CHECK(expected.apart(got, 0, 3) < 1e-13);
                    if (by.alpha > 0)
                    {
                        CHECK(expected.apart(got, 3, 4) < 1e-13);
                    }
                }
            }
        }
    );
}


TEST_CASE("pair engines: ground of every instruction set")
{
    const auto all = engines();
    const bool screened = GENERATE(false, true);
    forScenes(
        [&](cloud& c)
        {
            c.screened = screened;
            const results expected = wallsByElements(c);
            for (const pairEngine* engine : all)
            {
                INFO(engine->instructionSet);
                const results got = wallsBy(*engine, c);
                CHECK(expected.apart(got, 0, 10) < 1e-13);
                CHECK(expected.apart(got, 10, 16) < 1e-13);
                CHECK(expected.apart(got, 16, 18) < 1e-13);
                CHECK(expected.apart(got, 18, 19) < 1e-13);
                // found or not, and which: the same element
                CHECK(expected.apart(got, 19, 20) < 1e-13);
                CHECK(expected.apart(got, 20, 21) < 1e-13);
                CHECK(expected.apart(got, 21, 25) == 0);
            }
        }
    );
}


TEST_CASE("pair engines: water of every instruction set")
{
    const auto all = engines();
    forScenes(
        [&](cloud& c)
        {
            const results expected = waterContinuityOf(c, nullptr);
            for (const pairEngine* engine : all)
            {
                INFO(engine->instructionSet);
                const results got = waterContinuityOf(c, engine);
                for (std::size_t k = 0; k < 4; ++k)
                {
                    CHECK(expected.apart(got, k, k + 1) < 1e-13);
                }
                CHECK(expected.apart(got, 4, 7) < 1e-13);
            }
            for (const waterFriction& by :
                 {waterFriction{"none", 0, false},
                  waterFriction{"artificial", 0.03, false},
                  waterFriction{"viscous", 0, true},
                  waterFriction{"both", 0.03, true}})
            {
                const results forces = waterForcesByPairs(c, by);
                for (const pairEngine* engine : all)
                {
                    INFO(engine->instructionSet << ", friction " << by.name);
                    const results got = waterForcesBy(*engine, c, by);
                    CHECK(forces.apart(got, 0, 3) < 1e-13);
                    if (by.alpha > 0 || by.viscous)
                    {
                        CHECK(forces.apart(got, 3, 6) < 1e-13);
                    }
                    if (by.alpha > 0)
                    {
                        CHECK(forces.apart(got, 6, 7) < 1e-13);
                    }
                    if (by.viscous)
                    {
                        CHECK(forces.apart(got, 7, 8) < 1e-13);
                    }
                }
            }
        }
    );
}


TEST_CASE("pair engines: smoothing of every instruction set")
{
    const auto all = engines();
    forScenes(
        [&](cloud& c)
        {
            for (const int count : {1, 3, 5, 7})
            {
                const results expected = smoothedBy(nullptr, c, count);
                for (const pairEngine* engine : all)
                {
                    INFO(engine->instructionSet << ", " << count);
                    const results got = smoothedBy(engine, c, count);
                    CHECK(
                        expected.apart(got, 0, static_cast<std::size_t>(count))
                        < 1e-13
                    );
                }
            }
        }
    );
}


//- Single precision has rounded, and by no more than it must. Groups of
//  columns: [ends[0], ends[1]), ...
void checkSingle(
    const results& exact,
    const results& got,
    const std::vector<std::size_t>& ends
)
{
    for (std::size_t k = 1; k < ends.size(); ++k)
    {
        const double apart = exact.apart(got, ends[k - 1], ends[k]);
        CHECK(apart < 3e-5);
        CHECK(apart > 1e-10);
    }
}


TEST_CASE("pair engines: single precision beside double")
{
    const auto all = engines();
    forScenes(
        [&](cloud& c)
        {
            for (const pairEngine* engine : all)
            {
                INFO(engine->instructionSet);
                const damping by = {"viscosity and noise", 0.03, 0.2};
                const waterFriction friction = {"both", 0.03, true};
                c.single = false;
                const results kinematics = kinematicsOf(c, engine);
                const results forces = forcesBy(*engine, c, by);
                const results continuity = waterContinuityOf(c, engine);
                const results water = waterForcesBy(*engine, c, friction);
                const results smooth = smoothedBy(engine, c, 5);
                const results walls = wallsBy(*engine, c);
                c.single = true;
                checkSingle(walls, wallsBy(*engine, c), {0, 10, 16, 18, 19});
                checkSingle(kinematics, kinematicsOf(c, engine), {0, 9, 15});
                checkSingle(forces, forcesBy(*engine, c, by), {0, 3, 4});
                checkSingle(
                    continuity, waterContinuityOf(c, engine), {0, 1, 2, 3, 4, 7}
                );
                checkSingle(
                    water, waterForcesBy(*engine, c, friction), {0, 3, 6, 7, 8}
                );
                checkSingle(smooth, smoothedBy(engine, c, 5), {0, 5});
                c.single = false;
            }
        }
    );
}


TEST_CASE("pair engines: an instruction set that is not known is refused")
{
    CHECK_THROWS_WITH(
        loadPairEngine("x86-64-v9"), Catch::Matchers::Contains("x86-64-v9")
    );
}
