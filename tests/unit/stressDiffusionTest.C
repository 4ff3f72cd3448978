// SPDX-License-Identifier: GPL-3.0-or-later
// Diffusion of stress (T 3.42): a linear stress stays, at edges too; a
// checkerboard goes at the rate of a direct sum; the sum over the volume stays;
// energy is booked; grains that are separated or stand take no part.

#include <catch2/catch.hpp>

#include "engineLoader.H"
#include "grainDynamics.H"
#include "sampleGrains.H"
#include "sampleGround.H"
#include "sampleScene.H"
#include "wendlandC2.H"

using namespace Foam;
using namespace Foam::lpf;

namespace
{

constexpr double dx = 0.1, h = 1.3 * dx, rho0 = 1500, d = 0.1;
// long enough for it to act at once
constexpr double dt = 2.5e-3;
constexpr int cells = 8;
constexpr double period = cells * dx;

elasticity skeleton()
{
    return elasticity(dictOf("nu 0.3; E 1e6;"), {rho0, 10, 1});
}

//- Keeps the stress; stores what a linear elastic skeleton would
class keptStress : public granularRheology
{
public:
    keptStress() : granularRheology(skeleton()) {}

    rheologyLosses correct(const grainArrays&, double) const override
    {
        return {};
    }

    bool allFlow = true; //!< else those whose xy is above zero

    bool yields(const grainPoint& at) const override
    {
        return allFlow || at.sigma.xy > 0;
    }

    double storedEnergy(const grainPoint& at) const override
    {
        const symmTensor s = symm(toFoam(at.sigma));
        return at.mass / rho0
             * (sqr(tr(s) / 3) / (2 * elastic_.K())
                + magSqr(dev(s)) / (4 * elastic_.G()));
    }
};

struct stressBox
{
    sceneProperties scene;
    autoPtr<ground> bed = groundFarAway();
    groundContact contact;
    keptStress stress;
    std::unique_ptr<grainDynamics> body;

    stressBox(bool cyclic, double jitter)
        : scene(periodicScene(dx, h, period, Zero)),
          contact(
              *bed,
              dictOf("zones { floor { friction none; } }"),
              dx,
              4 * dx,
              0,
              vector(0, 1, 0)
          )
    {
        if (!cyclic)
        {
            scene.cyclic = {};
        }
        schemeProperties scheme;
        scheme.stressDiffusion = d;
        body.reset(new grainDynamics(
            lpfPairs::loadPairEngine("auto"), scene, scheme, stress, contact
        ));
        randomNumbers random(11);
        const std::vector<vector> x =
            jitteredLattice(random, Zero, {cells, cells, cells}, dx, jitter);
        grainStore& g = body->grains;
        g.resize(int(x.size()));
        for (int i = 0; i < g.size(); ++i)
        {
            set(g.x, i, x[std::size_t(i)]);
            set(g.U, i, Zero);
            g.mass[i] = rho0 * dx * dx * dx;
            g.rho[i] = g.rhoRef[i] = rho0;
            g.id[i] = i;
        }
        body->rates(0, 0); // order by cells
    }

    grainStore& grains() { return body->grains; }

    template<class Stress>
    void setStress(const Stress& of)
    {
        grainStore& g = grains();
        for (int i = 0; i < g.size(); ++i)
        {
            const symmTensor s = of(i);
            for (direction c = 0; c < 6; ++c)
            {
                g.sigma[c][i] = s[c];
            }
        }
    }

    symmTensor stressOf(int i)
    {
        symmTensor s;
        for (direction c = 0; c < 6; ++c)
        {
            s[c] = grains().sigma[c][i];
        }
        return s;
    }

    double energy()
    {
        double total = 0;
        const energyState e = body->energy();
        total += e.elastic;
        return total;
    }

    symmTensor sumOfStress()
    {
        symmTensor total = Zero;
        for (int i = 0; i < grains().size(); ++i)
        {
            total += grains().mass[i] / rho0 * stressOf(i);
        }
        return total;
    }
};

} // namespace


TEST_CASE("stress diffusion: a linear stress stays, whatever way it goes")
{
    // a free block in disorder, corners too
    stressBox b(false, 0.2);
    randomNumbers random(5);
    tensor rows[3];
    for (tensor& t : rows)
    {
        t = random.anyTensor(1e4);
    }
    std::vector<symmTensor> before;
    const auto linear = [&](int i)
    {
        const vector x = at(b.grains().x, i);
        symmTensor s = -5e4 * symmTensor(symmTensor::I);
        for (direction c = 0; c < 6; ++c)
        {
            s[c] += (c < 3 ? rows[c].x() : rows[c - 3].y()) & x;
        }
        return s;
    };
    b.setStress(linear);
    before.reserve(std::size_t(b.grains().size()));
    for (int i = 0; i < b.grains().size(); ++i)
    {
        before.push_back(b.stressOf(i));
    }
    b.body->rates(dt, 0);
    double worst = 0, density = 0;
    for (int i = 0; i < b.grains().size(); ++i)
    {
        worst = max(worst, mag(b.stressOf(i) - before[std::size_t(i)]) / 5e4);
        density = max(density, mag(b.grains().rho[i] / rho0 - 1));
    }
    INFO("stress " << worst << " density " << density);
    CHECK(worst < 1e-13);
    CHECK(density < 1e-13);

    // and what is not linear goes
    b.setStress([&](int i)
                { return linear(i) + 100 * symm(random.anyTensor(1)); });
    before.clear();
    before.reserve(std::size_t(b.grains().size()));
    for (int i = 0; i < b.grains().size(); ++i)
    {
        before.push_back(b.stressOf(i));
    }
    b.body->rates(dt, 0);
    int changed = 0;
    for (int i = 0; i < b.grains().size(); ++i)
    {
        changed += mag(b.stressOf(i) - before[std::size_t(i)]) > 1e-3;
    }
    CHECK(changed > 0.9 * b.grains().size());
}


TEST_CASE("stress diffusion: a checkerboard goes at the rate of theory.md")
{
    stressBox b(true, 0);
    const auto sign = [&](int i)
    {
        const vector x = at(b.grains().x, i) / dx;
        const int n = int(std::floor(x.x())) + int(std::floor(x.y()))
                    + int(std::floor(x.z()));
        return n % 2 == 0 ? 1 : -1;
    };
    const symmTensor mean = -1e4 * symmTensor(symmTensor::I);
    const symmTensor part(-200, 70, 30, -100, 50, -60);
    b.setStress([&](int i) { return mean + sign(i) * part; });
    std::vector<symmTensor> before;
    before.reserve(std::size_t(b.grains().size()));
    for (int i = 0; i < b.grains().size(); ++i)
    {
        before.push_back(b.stressOf(i) - mean);
    }
    b.body->rates(dt, 0);

    // 4 d h c sum over the others of the other colour of dx^3 (-F)
    const lpfPairs::wendlandC2 W(h, 3);
    double sum = 0;
    for (int n = 0; n < 343; ++n)
    {
        const int i = n % 7 - 3, j = n / 7 % 7 - 3, l = n / 49 - 3;
        const double rSqr = dx * dx * (i * i + j * j + l * l);
        const bool other = (i + j + l) % 2 != 0;
        sum += other && rSqr < sqr(2 * h)
                 ? -W.gradByDistance(rSqr) * dx * dx * dx
                 : 0;
    }
    const double c = skeleton().c();
    const double rate = 4 * d * h * c * sum;
    INFO("rate " << rate / (d * c / h) << " d c/h");
    // the number of theory.md
    CHECK(rate / (d * c / h) == Approx(6.70).epsilon(0.001));
    for (int i = 0; i < b.grains().size(); ++i)
    {
        const symmTensor now = b.stressOf(i) - mean;
        REQUIRE(
            mag(now - (1 - dt * rate) * before[std::size_t(i)])
            < 1e-10 * mag(part)
        );
        // the pressure is that of the density
        const double dp = -tr(now - before[std::size_t(i)]) / 3;
        REQUIRE(
            b.grains().rho[i] / rho0 - 1
            == Approx(dp / skeleton().K()).margin(1e-14)
        );
    }
}


TEST_CASE("stress diffusion: short steps are made up for at once")
{
    // eight of them until it is due; the numbers are of two powers, as their
    // sum
    constexpr int steps = 9;
    const double shortStep = dt / 8;
    stressBox one(true, 0.1), many(true, 0.1);
    randomNumbers random(12);
    std::vector<symmTensor> stress;
    stress.reserve(std::size_t(one.grains().size()));
    for (int i = 0; i < one.grains().size(); ++i)
    {
        stress.push_back(
            -1e4 * symmTensor(symmTensor::I) + 1e3 * symm(random.anyTensor(1))
        );
    }
    const auto start = [&](int i) { return stress[std::size_t(i)]; };
    one.setStress(start);
    many.setStress(start);
    one.body->rates(shortStep * steps, 0);
    const double perTime = d * skeleton().c() / h;
    int acted = 0;
    double since = 0;
    for (int n = 0; n < steps; ++n)
    {
        many.body->rates(shortStep, 0);
        since += shortStep;
        const bool due = since * perTime > 0.05;
        since = due ? 0 : since;
        acted += due;
        CHECK(many.body->undiffused == Approx(since).margin(1e-18));
        const bool changed = mag(many.stressOf(0) - stress[0]) > 0;
        CHECK(changed == (acted > 0));
    }
    CHECK(acted == 1);
    // the same, but for what was left over
    const double share = (shortStep * steps - since) / (shortStep * steps);
    for (int i = 0; i < one.grains().size(); ++i)
    {
        const symmTensor before = stress[std::size_t(i)];
        REQUIRE(
            mag(many.stressOf(i) - before - share * (one.stressOf(i) - before))
            < 1e-10 * mag(before)
        );
    }
    // two passes, and twice that acted, in the mean of an evaluation
    CHECK(many.body->passes() == Approx(2 + 2.0 / (1 + steps)).epsilon(1e-12));
}


TEST_CASE("stress diffusion: the sum stays, energy falls and is booked")
{
    stressBox b(true, 0.2);
    randomNumbers random(6);
    b.setStress(
        [&](int) {
            return -1e4 * symmTensor(symmTensor::I)
                 + 1e3 * symm(random.anyTensor(1));
        }
    );
    const double before = b.energy();
    const symmTensor sum = b.sumOfStress();
    b.body->rates(dt, 0);
    const double lost = before - b.energy();
    CHECK(lost > 0);
    CHECK(b.body->ledger.diffusion == Approx(lost).epsilon(1e-9));
    CHECK(mag(b.sumOfStress() - sum) < 1e-12 * mag(sum));
}


TEST_CASE("stress diffusion: separated grains take no part")
{
    stressBox b(true, 0.2);
    // the upper half carries nothing
    const auto carries = [&](int i)
    { return b.grains().x[2][i] < 0.5 * period; };
    randomNumbers random(8);
    b.setStress(
        [&](int i)
        {
            return carries(i) ? -random(1e3, 2e3) * symmTensor(symmTensor::I)
                              : symmTensor(Zero);
        }
    );
    b.body->rates(dt, 0);
    for (int i = 0; i < b.grains().size(); ++i)
    {
        REQUIRE((mag(b.stressOf(i)) > 0) == carries(i));
    }
}


TEST_CASE("stress diffusion: what stands takes no part")
{
    stressBox b(true, 0.2);
    b.stress.allFlow = false;
    const auto flows = [&](int i) { return b.grains().x[2][i] < 0.5 * period; };
    randomNumbers random(9);
    b.setStress(
        [&](int i)
        {
            const double xy = flows(i) ? 100 : -100;
            return symmTensor(-random(1e3, 2e3), xy, 0, -1e3, 0, -1e3);
        }
    );
    std::vector<symmTensor> before;
    before.reserve(std::size_t(b.grains().size()));
    for (int i = 0; i < b.grains().size(); ++i)
    {
        before.push_back(b.stressOf(i));
    }
    b.body->rates(dt, 0);
    for (int i = 0; i < b.grains().size(); ++i)
    {
        const bool changed = mag(b.stressOf(i) - before[std::size_t(i)]) > 0;
        REQUIRE(changed == flows(i));
    }
}
