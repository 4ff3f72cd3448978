// SPDX-License-Identifier: GPL-3.0-or-later
// Each pair term on its own: kernel, antisymmetry, Galilean invariance,
// covariance under turns.

#include <catch2/catch.hpp>

#include "momentInverse.H"
#include "pairTerms.H"
#include "sampleGrains.H"
#include "latticeSums.H"
#include "surfaceShare.H"
#include "wendlandC2.H"

#include <cmath>

using namespace Foam;
using namespace Foam::lpf;
using lpfPairs::wendlandC2;

namespace
{

constexpr double pi = 3.14159265358979323846;

//- Simpson's rule, exact enough for a polynomial of degree 8
template<class F>
double integral(const F& f, const double from, const double to)
{
    constexpr int n = 4000;
    const double step = (to - from) / n;
    double sum = f(from) + f(to);
    for (int k = 1; k < n; ++k)
    {
        sum += (k % 2 ? 4 : 2) * f(from + k * step);
    }
    return sum * step / 3;
}


double largest(const tensor& t)
{
    return cmptMax(cmptMag(t));
}


//- Two grains within their support
struct pairOfGrains
{
    vector x[2], v[2];
    tensor A[2];
    double V[2], m[2], rho[2];
    double h = 0.13;

    explicit pairOfGrains(randomNumbers& random)
    {
        for (int k = 0; k < 2; ++k)
        {
            x[k] = random.inCube(0.06);
            v[k] = random.inCube(3);
            A[k] = random.anyTensor(500);
            V[k] = random(0.5, 1.5);
            m[k] = random(1, 4);
            rho[k] = m[k] / V[k];
        }
    }

    void turn(const tensor& Q)
    {
        for (int k = 0; k < 2; ++k)
        {
            x[k] = Q & x[k];
            v[k] = Q & v[k];
            A[k] = Q & A[k] & Q.T();
        }
    }

    Vec3 separation(int i) const { return vec(x[i] - x[1 - i]); }
    double rSqr() const { return magSqr(x[0] - x[1]); }

    double F() const { return wendlandC2(h, 3).gradByDistance(rSqr()); }

    lpfPairs::Kinematics<double> kinematics(int i) const
    {
        lpfPairs::Kinematics<double> k = {};
        addKinematics(k, V[1 - i] * F(), separation(i), vec(v[i] - v[1 - i]));
        return k;
    }

    //- Force on i from the other, as the engine puts it together
    vector force(int i) const
    {
        lpfPairs::Force<double> f = {};
        addForce(f, V[1 - i] * F(), separation(i), tens(A[1 - i]));
        return V[i] * toFoam((tens(A[i]) & f.gradV) + f.other);
    }

    //- The same of the damping of noise; A serves as the velocity gradient
    vector noiseForce(int i) const
    {
        const vector x_ij = x[i] - x[1 - i];
        const vector w_ij = v[i] - v[1 - i] - (0.5 * (A[0] + A[1]) & x_ij);
        const double Pi = lpfPairs::noiseDamping(
            vec(x_ij),
            vec(w_ij),
            rSqr(),
            0.05 * h * 40.0,
            h * h,
            0.5 * (rho[0] + rho[1])
        );
        return -m[0] * m[1] * Pi * F() * x_ij;
    }

    //- The same of artificial viscosity
    vector viscousForce(int i) const
    {
        const double Pi = lpfPairs::artificialViscosity(
            separation(i),
            vec(v[i] - v[1 - i]),
            rSqr(),
            0.05 * h * 40.0,
            h * h,
            0.5 * (rho[0] + rho[1])
        );
        return -m[0] * m[1] * Pi * F() * toFoam(separation(i));
    }
};


Symm turned(const tensor& Q, const Symm& s)
{
    return symm(tens(Q & toFoam(s) & Q.T()));
}

} // namespace


TEST_CASE("wendlandC2: W integrates to one, in two and three dimensions")
{
    for (const double h : {0.013, 1.0, 26.0})
    {
        const wendlandC2 W3(h, 3), W2(h, 2);
        CHECK(
            integral(
                [&](double r) { return 4 * pi * r * r * W3.value(r * r); },
                0,
                2 * h
            )
            == Approx(1).epsilon(1e-12)
        );
        CHECK(
            integral(
                [&](double r) { return 2 * pi * r * W2.value(r * r); }, 0, 2 * h
            )
            == Approx(1).epsilon(1e-12)
        );
    }
}


TEST_CASE("wendlandC2: F x is the gradient of W, zero beyond the support")
{
    const double h = 0.7;
    for (const int dimensions : {2, 3})
    {
        const wendlandC2 W(h, dimensions);
        for (const double r : {0.001, 0.1, 0.5, 0.9, 1.2, 1.39})
        {
            // five points, error of order step^4
            const double s = 1e-3 * h;
            const auto value = [&](double d)
            { return W.value((r + d) * (r + d)); };
            const double slope = r < 2 * s ? (value(s) - value(0)) / s
                                           : (8 * (value(s) - value(-s))
                                              - value(2 * s) + value(-2 * s))
                                                 / (12 * s);
            const double scale = W.value(0.0) / h;
            CHECK(
                W.gradByDistance(r * r) * r
                == Approx(slope).margin((r < 2 * s ? 5e-3 : 1e-9) * scale)
            );
        }
        CHECK(W.gradByDistance(0.0) < 0);
        CHECK(W.gradByDistance(4 * h * h) == 0);
        CHECK(W.gradByDistance(5 * h * h) == 0);
        CHECK(W.value(4.001 * h * h) == 0);
    }
}


TEST_CASE("pair terms: f_ij = -f_ji")
{
    randomNumbers random(1);
    int viscous = 0;
    for (int k = 0; k < 200; ++k)
    {
        const pairOfGrains p(random);
        const vector f = p.force(0);
        REQUIRE(mag(f) > 0);
        CHECK(
            mag(f + p.force(1)) < 1e-15 * (mag(p.A[0]) + mag(p.A[1])) * p.V[0]
                                      * p.V[1] * mag(p.F())
                                      * Foam::sqrt(p.rSqr())
        );

        const vector a = p.viscousForce(0);
        CHECK(mag(a + p.viscousForce(1)) <= 1e-15 * mag(a));
        // along the line between them: no torque; only against approach
        CHECK(mag(a ^ (p.x[0] - p.x[1])) <= 1e-15 * mag(a));
        const double approach = -(p.v[0] - p.v[1]) & (p.x[0] - p.x[1]);
        CHECK((mag(a) > 0) == (approach > 0));
        CHECK((a & (p.v[0] - p.v[1])) <= 0);
        viscous += mag(a) > 0;

        const vector b = p.noiseForce(0);
        CHECK(mag(b) > 0);
        CHECK(mag(b + p.noiseForce(1)) <= 1e-15 * mag(b));
        CHECK(mag(b ^ (p.x[0] - p.x[1])) <= 1e-15 * mag(b));
    }
    CHECK(viscous > 50);
}


TEST_CASE("pair terms: a common velocity changes nothing")
{
    randomNumbers random(2);
    for (int k = 0; k < 50; ++k)
    {
        pairOfGrains p(random);
        const tensor R = toFoam(p.kinematics(0).R);
        const vector a = p.viscousForce(0);
        const vector common = random.inCube(100);
        p.v[0] += common;
        p.v[1] += common;
        CHECK(
            largest(toFoam(p.kinematics(0).R) - R) < 1e-12 * (largest(R) + 1)
        );
        // the digits that 100 m/s leave of a relative velocity
        const double lost = 1e-13 * p.m[0] * p.m[1] * mag(p.F()) * mag(common)
                          * 0.26 / min(p.rho[0], p.rho[1]);
        CHECK(mag(p.viscousForce(0) - a) < lost);
        // nothing to damp in a flow that is linear in x
        p.A[1] = p.A[0];
        p.v[1] = p.v[0] + (p.A[0] & (p.x[1] - p.x[0]));
        const double flow = mag(p.v[1] - p.v[0]);
        CHECK(
            mag(p.noiseForce(0)) < 1e-14 * p.m[0] * p.m[1] * mag(p.F()) * flow
        );
        // equal velocities: no gradient
        p.v[1] = p.v[0];
        CHECK(largest(toFoam(p.kinematics(0).R)) == 0);
        CHECK(mag(p.viscousForce(0)) == 0);
    }
}


TEST_CASE("pair terms: turned grains, turned terms")
{
    randomNumbers random(3);
    for (int k = 0; k < 50; ++k)
    {
        pairOfGrains p(random);
        const auto before = p.kinematics(0);
        const vector f = p.force(0), a = p.viscousForce(0);
        const vector b = p.noiseForce(0);
        const tensor Q = random.turn();
        p.turn(Q);
        const auto after = p.kinematics(0);
        const tensor R = toFoam(before.R), M = toFoam(before.M);
        CHECK(largest(toFoam(after.R) - (Q & R & Q.T())) < 1e-13 * largest(R));
        CHECK(largest(toFoam(after.M) - (Q & M & Q.T())) < 1e-13 * largest(M));
        CHECK(mag(p.force(0) - (Q & f)) < 1e-13 * mag(f));
        CHECK(mag(p.viscousForce(0) - (Q & a)) <= 1e-13 * mag(a));
        CHECK(mag(p.noiseForce(0) - (Q & b)) <= 1e-13 * mag(b));
    }
}


TEST_CASE("wall sums: turned ground, turned sums")
{
    randomNumbers random(4);
    const double h = 0.13, dx = 0.1;
    const wendlandC2 W(h, 3);
    lpfPairs::WallSums<double> sums[2] = {};
    const tensor Q = random.turn();
    const auto add = [&](const vector& x, const vector& n, double A, int k)
    {
        const auto s = lpfPairs::layerSums(W, magSqr(x), double(x & n), dx);
        addWall(
            sums[k], lpfPairs::LayerSums<double>{A * s.E, A * s.D}, vec(n), 0.3
        );
    };
    for (int k = 0; k < 100; ++k)
    {
        // from the element to the grain, which is on its free side
        const vector x = random.inCube(0.15);
        vector n = random.inCube(1);
        n *= ((n & x) < 0 ? -1 : 1) / mag(n);
        const double A = random(0.5, 1.5) * dx * dx;
        add(x, n, A, 0);
        add(Q & x, Q & n, A, 1);
    }
    const vector v = random.inCube(1);
    const auto &a = sums[0], &b = sums[1];
    CHECK(b.area == Approx(a.area).epsilon(1e-13));
    CHECK(b.friction == Approx(0.3 * a.area).epsilon(1e-13));
    CHECK(
        largest(toFoam(b.D2) - toFoam(turned(Q, a.D2)))
        < 1e-13 * largest(toFoam(a.D2))
    );
    // the third-order tensor by its contractions
    const Symm Nv = a.N3 & vec(v);
    CHECK(
        largest(toFoam(b.N3 & vec(Q & v)) - toFoam(turned(Q, Nv)))
        < 1e-13 * largest(toFoam(Nv))
    );
    const tensor t = random.anyTensor(1);
    const vector Nt = toFoam(a.N3 && tens(t));
    CHECK(
        mag(toFoam(b.N3 && tens(Q & t & Q.T())) - (Q & Nt)) < 1e-13 * mag(Nt)
    );
    // n is a unit vector: contracting two indices leaves sum A E n
    const vector Nn = toFoam(contracted(a.N3));
    CHECK(mag(toFoam(contracted(b.N3)) - (Q & Nn)) < 1e-13 * mag(Nn));
    CHECK(mag(Nn) <= a.area);
}


TEST_CASE("third-order tensor: contractions by their definition")
{
    randomNumbers random(5);
    lpfPairs::SymmTensor3<double> N = {};
    double full[3][3][3] = {};
    for (int k = 0; k < 5; ++k)
    {
        const vector n = random.inCube(1);
        const double s = random(-1, 1);
        add(N, s, vec(n));
        for (direction a = 0; a < 3; ++a)
        {
            for (direction b = 0; b < 3; ++b)
            {
                for (direction c = 0; c < 3; ++c)
                {
                    full[a][b][c] += s * n[a] * n[b] * n[c];
                }
            }
        }
    }
    const vector v = random.inCube(1);
    const tensor t = random.anyTensor(1);
    tensor Nv = Zero;
    vector Nt = Zero, NI = Zero;
    for (direction a = 0; a < 3; ++a)
    {
        for (direction b = 0; b < 3; ++b)
        {
            NI[a] += full[a][b][b];
            for (direction c = 0; c < 3; ++c)
            {
                Nv(a, b) += full[a][b][c] * v[c];
                Nt[a] += full[a][b][c] * t(b, c);
            }
        }
    }
    CHECK(largest(toFoam(N & vec(v)) - Nv) < 1e-15);
    CHECK(mag(toFoam(N && tens(t)) - Nt) < 2e-15);
    CHECK(mag(toFoam(contracted(N)) - NI) < 2e-15);
}


TEST_CASE("momentInverse: the inverse where there are neighbours, at most 2")
{
    randomNumbers random(6);
    for (int k = 0; k < 50; ++k)
    {
        // eigenvalues from 0.5 to 2 along general axes
        const tensor Q = random.turn();
        const tensor D(
            random(0.5001, 2),
            0,
            0,
            0,
            random(0.5001, 2),
            0,
            0,
            0,
            random(0.5001, 2)
        );
        const tensor M = Q & D & Q.T();
        const tensor B = toFoam(momentInverse(symm(tens(M))));
        CHECK(largest((B & M) - tensor::I) < 1e-14);

        // deficient along one axis: raised to 1/2 by the same shift for all
        const double low = random(-0.2, 0.49);
        tensor E = D;
        E.zz() = low;
        const tensor raised = (Q & E & Q.T()) + (0.5 - low) * tensor::I;
        const tensor C = toFoam(momentInverse(symm(tens(Q & E & Q.T()))));
        CHECK(largest((C & raised) - tensor::I) < 1e-13);
    }
    const tensor alone = toFoam(momentInverse(Symm{}));
    CHECK(largest(alone - 2 * tensor::I) == 0);
}


namespace
{

//- sum V W and |sum V gradW| of a lattice that ends so many rows above
std::pair<double, double>
fillBelow(const lpfPairs::wendlandC2& W, double dx, int dimensions, int rows)
{
    const int n = 3, nz = dimensions == 3 ? n : 0;
    double fill = 0, gradient = 0;
    for (int i = -n; i <= n; ++i)
    {
        for (int k = -nz; k <= nz; ++k)
        {
            for (int j = -n; j <= rows; ++j)
            {
                const double rSqr = dx * dx * (i * i + j * j + k * k);
                fill += W.value(rSqr);
                gradient += W.gradByDistance(rSqr) * j * dx;
            }
        }
    }
    const double volume = dimensions == 3 ? dx * dx * dx : dx * dx;
    return {volume * fill, volume * std::abs(gradient)};
}

} // namespace


TEST_CASE("surfaceShare: a plane free surface from what lies below it")
{
    const double h = 0.13, dx = 0.1;
    for (const int dimensions : {2, 3})
    {
        const lpfPairs::wendlandC2 W(h, dimensions);
        const lpfPairs::surfaceShare surface(dimensions);
        const double full = lpfPairs::latticeFill(W, dx, dimensions);
        // rows of a lattice below the surface, then deep in it
        for (int rows = 0; rows < 5; ++rows)
        {
            const auto below = fillBelow(W, dx, dimensions, rows);
            const double gam = surface.beyond(h * below.second / below.first);
            const double S = below.first + gam - 0.02 * gam / (gam + 0.02);
            INFO("dimensions " << dimensions << " rows " << rows);
            CHECK(S == Approx(full).epsilon(0.01));
        }
        CHECK(surface.beyond(0) == 0);
        CHECK(surface.beyond(100) == Approx(0.5).epsilon(1e-3));
    }
}
