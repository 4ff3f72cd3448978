// SPDX-License-Identifier: GPL-3.0-or-later
/*
Description  Ways to find the pairs of a step, on the two passes over water
             (continuity with filling; pressure with artificial viscosity), in
             double and in single precision: particles on a lattice that is
             shaken, h/dx 1.3, in three dimensions.

             lpfPairBenchmark -machine             what the machine gives now
             lpfPairBenchmark [particles per edge] [repeats]
*/
#include "machine.H"
#include "cellRuns.H"
#include "listLoops.H"
#include "neighbourSearch.H"
#include "pairTerms.H"
#include "records.H"
#include "waterTerms.H"
#include "wendlandC2.H"

#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numeric>
#include <random>
#include <string>
#include <vector>

using namespace lpfPairs;

namespace
{

constexpr double dx = 0.01, h = 1.3 * dx;

//- Time of the processors shared among the threads: on a machine that others
//  use too, the wall would measure them
double now()
{
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (static_cast<double>(t.tv_sec)
            + 1e-9 * static_cast<double>(t.tv_nsec))
         / omp_get_max_threads();
}

enum field
{
    X,
    Y,
    Z,
    U,
    V,
    W,
    VOL,
    RHO,
    P,
    M,
    F,
    fields = 12
};

//- Particles sorted by cells of edge 2h/perSupport
struct cloud
{
    int n = 0;
    std::vector<double> a[fields];
    std::vector<int> start;
    cellGrid grid = {};
    std::vector<float> single[fields];

    cloud(int edge, int perSupport);
    void sort(int perSupport);

    template<class Real>
    const Real* get(int k) const
    {
        if constexpr (std::is_same_v<Real, float>)
        {
            return single[k].data();
        }
        else
        {
            return a[k].data();
        }
    }
};

cloud::cloud(int edge, int perSupport) : n(edge * edge * edge)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> shake(-0.2, 0.2);
    for (int i = 0; i < n; ++i)
    {
        const int k[3] = {i % edge, i / edge % edge, i / (edge * edge)};
        for (int d = 0; d < 3; ++d)
        {
            a[X + d].push_back(dx * (k[d] + 0.5 + shake(random)));
            a[U + d].push_back(shake(random));
        }
        const double values[] = {
            dx * dx * dx,
            1000 + shake(random),
            1e4 * (1 + shake(random)),
            1000 * dx * dx * dx,
            0.5 + shake(random),
            0};
        for (int c = VOL; c < fields; ++c)
        {
            a[c].push_back(values[c - VOL]);
        }
    }
    sort(perSupport);
    for (int c = 0; c < fields; ++c)
    {
        a[c].resize(a[c].size() + padding, c == RHO ? 1000 : 0.0);
        single[c].assign(a[c].begin(), a[c].end());
    }
}

void cloud::sort(int perSupport)
{
    const double edge = 2 * h / perSupport;
    long cells = 1;
    for (int d = 0; d < 3; ++d)
    {
        const double top = *std::max_element(a[d].begin(), a[d].end());
        grid.edge[d] = edge;
        grid.n[d] = static_cast<int>(top / edge) + 1;
        cells *= grid.n[d];
    }
    const auto cell = [&](int i)
    {
        const int k[3] = {
            static_cast<int>(a[X][i] / edge),
            static_cast<int>(a[Y][i] / edge),
            static_cast<int>(a[Z][i] / edge)};
        return (k[2] * grid.n[1] + k[1]) * grid.n[0] + k[0];
    };
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(
        order.begin(),
        order.end(),
        [&](int i, int j) { return cell(i) < cell(j); }
    );
    start.assign(cells + 1, 0);
    for (int i = 0; i < n; ++i)
    {
        ++start[cell(i) + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    grid.start = start.data();
    for (auto& values : a)
    {
        const std::vector<double> old = values;
        for (int i = 0; i < n; ++i)
        {
            values[i] = old[order[i]];
        }
    }
}

//- Runs of the rows within `reach` cells
struct manyRuns
{
    run list[128];
    int count = 0;
};

manyRuns runsWithin(const cellGrid& g, long x, long y, long z, int reach)
{
    manyRuns all;
    const long x0 = std::max(0L, x - reach);
    const long x1 = std::min<long>(g.n[0] - 1, x + reach);
    for (long cz = std::max(0L, z - reach);
         cz <= std::min<long>(g.n[2] - 1, z + reach);
         ++cz)
    {
        for (long cy = std::max(0L, y - reach);
             cy <= std::min<long>(g.n[1] - 1, y + reach);
             ++cy)
        {
            const long row = (cz * g.n[1] + cy) * g.n[0];
            const int begin = g.start[row + x0], end = g.start[row + x1 + 1];
            if (begin < end)
            {
                all.list[all.count++] = {begin, end, {0, 0, 0}};
            }
        }
    }
    return all;
}

//- What each pass adds up; read(k) is field k of the neighbours
template<class Real>
struct continuityOf
{
    using T = packOf<Real>;
    static constexpr int count = 8;
    T own[fields];
    Continuity<T> total = {};
    Filling<T> filling = {};

    template<class Read>
    LPF_INLINE void
    add(const wendlandC2& kernel,
        const Vec<T>& x,
        const T& rSqr,
        const Read& read)
    {
        const T vol = read(VOL), VF = vol * kernel.gradByDistance(rSqr);
        addFilling(filling, T(vol * kernel.value(rSqr)), VF, x);
        addVelocityGradient(
            total,
            VF,
            x,
            Vec<T>{own[U] - read(U), own[V] - read(V), own[W] - read(W)}
        );
        total.diffusion += densityDiffusion(
            VF, x, own[RHO], T(read(RHO)), T(Real(1000)), Vec<T>{}
        );
    }

    double result() const
    {
        return sum(total.divergence) + sum(total.curl.x) + sum(total.curl.y)
             + sum(total.curl.z) + sum(total.diffusion) + sum(filling.fill)
             + dx
                   * (sum(filling.gradient.x) + sum(filling.gradient.y)
                      + sum(filling.gradient.z));
    }
};

template<class Real>
struct forceOf
{
    using T = packOf<Real>;
    static constexpr int count = 12;
    T own[fields];
    Vec<T> pressure = {}, viscous = {};
    T power = T(Real(0));

    template<class Read>
    LPF_INLINE void
    add(const wendlandC2& kernel,
        const Vec<T>& x,
        const T& rSqr,
        const Read& read)
    {
        const T half(Real(0.5)), F_ij = kernel.gradByDistance(rSqr);
        addPressureForce(pressure, T(read(VOL) * F_ij), own[P], T(read(P)), x);
        const Vec<T> v = {own[U] - read(U), own[V] - read(V), own[W] - read(W)};
        const T Pi = artificialViscosity(
            x,
            v,
            rSqr,
            T(half * (own[F] + read(F)) * constant<T>(0.02 * 45 * h)),
            constant<T>(h * h),
            T(half * (own[RHO] + read(RHO)))
        );
        const T mPiF = read(M) * Pi * F_ij;
        viscous += -mPiF * x;
        power += half * mPiF * (v & x);
    }

    double result() const
    {
        return 1e-6 * (sum(pressure.x) + sum(pressure.y) + sum(pressure.z))
             + sum(viscous.x) + sum(viscous.y) + sum(viscous.z) + sum(power);
    }
};

//- Results of all particles
struct outcome
{
    std::vector<double> values;
    double seconds = 0;
};

// The strategies: run<Pass>(i) for all particles of a cell --------------------

//- Packs of the rows of cells, those with no lane near left out
template<class Real, int perSupport>
struct rows
{
    static constexpr const char* name =
        perSupport == 1 ? "rows of cells 2h" : "rows of cells h";
    static constexpr int cells = perSupport;
    const cloud& c;
    explicit rows(const cloud& theCloud) : c(theCloud) {}
    double find() { return 0; }

    template<class Pass>
    LPF_ONE_BODY double
    of(int i, const manyRuns& around, const wendlandC2& kernel) const
    {
        using T = packOf<Real>;
        Pass pass;
        for (int k = 0; k < fields; ++k)
        {
            pass.own[k] = T(c.get<Real>(k)[i]);
        }
        const T numbers = laneNumbers<Real>();
        for (int k = 0; k < around.count; ++k)
        {
            const run& r = around.list[k];
            for (int j = r.begin; j < r.end; j += lanesOf<Real>)
            {
                const auto read = [&](int f)
                { return load(c.get<Real>(f) + j); };
                const Vec<T> x = {
                    pass.own[X] - read(X),
                    pass.own[Y] - read(Y),
                    pass.own[Z] - read(Z)};
                T rSqr = magSqr(x);
                stdx::where(!firstLanes(numbers, r.end - j), rSqr) = Real(1e30);
                if (stdx::any_of(rSqr < constant<T>(4 * h * h)))
                {
                    pass.add(kernel, x, rSqr, read);
                }
            }
        }
        return pass.result();
    }

    template<class Pass>
    void all(std::vector<double>& out) const
    {
        const wendlandC2 kernel(h, 3);
        forCells(
            c.grid,
            [&](int begin, int end, long x, long y, long z)
            {
                const manyRuns around = runsWithin(c.grid, x, y, z, cells);
                for (int i = begin; i < end; ++i)
                {
                    out[i] = of<Pass>(i, around, kernel);
                }
            }
        );
    }
};

//- Lists found once a step, fields by gathers or by records
template<class Real, bool byRecords, int percentSkin>
struct lists
{
    static constexpr int cells = 1;
    const cloud& c;
    neighbourTable table;
    mutable std::vector<Real> records;

    //- The list of a particle, in the numbers of its stretch
    struct entry
    {
        std::size_t stretch, begin;
        int count;
    };
    std::vector<entry> of_;
    std::vector<std::vector<std::int32_t>> numbers_;

    explicit lists(const cloud& theCloud) : c(theCloud)
    {
        records.resize(static_cast<std::size_t>(c.n + 1) * fields);
        of_.resize(static_cast<std::size_t>(c.n));
    }

    //- From the bits of the search, with whole packs of nobody behind each
    void keepLists()
    {
        numbers_.resize(table.stretches.size());
        forStretches(
            table,
            [&](const neighbourTable::stretch& s, std::size_t k)
            {
                std::vector<std::int32_t>& numbers = numbers_[k];
                numbers.clear();
                cellLists<1> here(c.n);
                forSearched(
                    table,
                    s,
                    [&](const searchedCell& cell)
                    {
                        here.enter(cell);
                        for (int i = cell.begin; i < cell.end; ++i)
                        {
                            const int count = here.make(i);
                            of_[static_cast<std::size_t>(i)] = {
                                k, numbers.size(), count};
                            numbers.insert(
                                numbers.end(),
                                here.list(),
                                here.list() + count + bitsAtOnce
                            );
                        }
                    }
                );
            }
        );
    }

    double find()
    {
        const double begin = now();
        const double *x = c.a[X].data(), *y = c.a[Y].data(), *z = c.a[Z].data();
        searchPairs(
            {c.grid, c.grid, h * (1 + 0.01 * percentSkin), x, y, z, x, y, z},
            &table
        );
        keepLists();
        return now() - begin;
    }

    template<class Pass>
    void fill() const
    {
        constexpr int count = Pass::count;
        std::fill_n(&records[static_cast<std::size_t>(c.n) * count], count, 0);
#pragma omp parallel for schedule(static)
        for (int i = 0; i < c.n; ++i)
        {
            for (int k = 0; k < count; ++k)
            {
                records[static_cast<std::size_t>(i) * count + k] =
                    c.get<Real>(k)[i];
            }
        }
    }

    template<class Pass>
    LPF_ONE_BODY double of(int i, const wendlandC2& kernel) const
    {
        using T = packOf<Real>;
        Pass pass;
        for (int k = 0; k < fields; ++k)
        {
            pass.own[k] = T(c.get<Real>(k)[i]);
        }
        const auto [stretch, begin, count] = of_[static_cast<std::size_t>(i)];
        const std::int32_t* const list = numbers_[stretch].data() + begin;
        for (int j = 0; j < count; j += lanesOf<Real>)
        {
            T got[Pass::count];
            if constexpr (byRecords)
            {
                std::int32_t at[lanesOf<Real>];
                for (int k = 0; k < lanesOf<Real>; ++k)
                {
                    at[k] = list[j + k] * placesOfRecord<Real, Pass::count>;
                }
                loadRecords<Real, Pass::count>(records.data(), at, got);
            }
            const auto read = [&](int f)
            {
                if constexpr (byRecords)
                {
                    return got[f];
                }
                else
                {
                    return gather(c.get<Real>(f), list + j);
                }
            };
            const Vec<T> x = {
                pass.own[X] - read(X),
                pass.own[Y] - read(Y),
                pass.own[Z] - read(Z)};
            pass.add(kernel, x, T(magSqr(x)), read);
        }
        return pass.result();
    }

    static packOf<Real> gather(const Real* from, const std::int32_t* index)
    {
#ifdef __AVX512F__
        if constexpr (std::is_same_v<Real, double>)
        {
            return packOf<Real>(_mm512_i32gather_pd(
                _mm256_loadu_si256(reinterpret_cast<const __m256i*>(index)),
                from,
                8
            ));
        }
        else
        {
            return packOf<Real>(
                _mm512_i32gather_ps(_mm512_loadu_si512(index), from, 4)
            );
        }
#else
        return packOf<Real>([&](auto k) { return from[index[k]]; });
#endif
    }

    template<class Pass>
    void all(std::vector<double>& out) const
    {
        const wendlandC2 kernel(h, 3);
        if constexpr (byRecords)
        {
            fill<Pass>();
        }
#pragma omp parallel for schedule(dynamic, 64)
        for (int i = 0; i < c.n; ++i)
        {
            out[i] = of<Pass>(i, kernel);
        }
    }
};

//- Candidates of a cell packed side by side, those out of reach of all its
//  particles left out
template<class Real, int perSupport>
struct packedCells
{
    static constexpr int cells = perSupport;
    static constexpr int most = 2048;
    const cloud& c;
    explicit packedCells(const cloud& theCloud) : c(theCloud) {}
    double find() { return 0; }

    //- Copies what is within reach of the box; returns how many
    template<int count>
    LPF_ONE_BODY int copy(
        const manyRuns& around,
        const double (&lower)[3],
        const double (&upper)[3],
        Real* to
    ) const
    {
        using T = packOf<Real>;
        int n = 0;
        const T numbers = laneNumbers<Real>();
        for (int k = 0; k < around.count; ++k)
        {
            const run& r = around.list[k];
            for (int j = r.begin; j < r.end; j += lanesOf<Real>)
            {
                T rSqr(Real(0));
                for (int d = 0; d < 3; ++d)
                {
                    const T x = load(c.get<Real>(X + d) + j);
                    const T out = maxZero(T(constant<T>(lower[d]) - x))
                                + maxZero(T(x - constant<T>(upper[d])));
                    rSqr += out * out;
                }
                const auto near = rSqr < constant<T>(4 * h * h)
                               && firstLanes(numbers, r.end - j);
                const int hits = stdx::popcount(near);
                for (int f = 0; f < count; ++f)
                {
                    compress(load(c.get<Real>(f) + j), near, to + f * most + n);
                }
                n += hits;
            }
        }
        return n;
    }

    template<class Mask>
    static void compress(const packOf<Real>& a, const Mask& near, Real* to)
    {
#ifdef __AVX512F__
        if constexpr (std::is_same_v<Real, double>)
        {
            _mm512_storeu_pd(
                to,
                _mm512_maskz_compress_pd(
                    __builtin_bit_cast(__mmask8, near),
                    __builtin_bit_cast(__m512d, a)
                )
            );
        }
        else
        {
            _mm512_storeu_ps(
                to,
                _mm512_maskz_compress_ps(
                    __builtin_bit_cast(__mmask16, near),
                    __builtin_bit_cast(__m512, a)
                )
            );
        }
#else
        for (std::size_t k = 0; k < a.size(); ++k)
        {
            *to = a[k];
            to += near[k];
        }
#endif
    }

    template<class Pass>
    LPF_ONE_BODY double
    of(int i, const Real* others, int n, const wendlandC2& kernel) const
    {
        using T = packOf<Real>;
        Pass pass;
        for (int k = 0; k < fields; ++k)
        {
            pass.own[k] = T(c.get<Real>(k)[i]);
        }
        for (int j = 0; j < n; j += lanesOf<Real>)
        {
            const auto read = [&](int f)
            { return load(others + f * most + j); };
            const Vec<T> x = {
                pass.own[X] - read(X),
                pass.own[Y] - read(Y),
                pass.own[Z] - read(Z)};
            const T rSqr = magSqr(x);
            if (stdx::any_of(rSqr < constant<T>(4 * h * h)))
            {
                pass.add(kernel, x, rSqr, read);
            }
        }
        return pass.result();
    }

    template<class Pass>
    void all(std::vector<double>& out) const
    {
        const wendlandC2 kernel(h, 3);
        forCells(
            c.grid,
            [&](int begin, int end, long x, long y, long z)
            {
                static thread_local std::vector<Real> others(most * fields);
                const manyRuns around = runsWithin(c.grid, x, y, z, cells);
                double lower[3], upper[3];
                for (int d = 0; d < 3; ++d)
                {
                    const auto ends = std::minmax_element(
                        c.a[d].begin() + begin, c.a[d].begin() + end
                    );
                    lower[d] = *ends.first;
                    upper[d] = *ends.second;
                }
                const int n =
                    copy<Pass::count>(around, lower, upper, others.data());
                for (int f = 0; f < Pass::count; ++f)
                {
                    std::fill_n(
                        others.data() + f * most + n,
                        padding,
                        f == X     ? Real(1e6)
                        : f == RHO ? Real(1000)
                                   : Real(0)
                    );
                }
                for (int i = begin; i < end; ++i)
                {
                    out[i] = of<Pass>(i, others.data(), n, kernel);
                }
            }
        );
    }
};

// -----------------------------------------------------------------------------

//- Best times of a strategy [ns a particle] and what it gives
struct timing
{
    double find = 1e300, continuity = 1e300, force = 1e300;
    std::vector<double> first, second;
};

template<class Real, class Strategy>
void measure(Strategy& s, const cloud& c, timing& t)
{
    const double perParticle = 1e9 / c.n;
    t.first.resize(c.n);
    t.second.resize(c.n);
    t.find = std::min(t.find, perParticle * s.find());
    double begin = now();
    s.template all<continuityOf<Real>>(t.first);
    t.continuity = std::min(t.continuity, perParticle * (now() - begin));
    begin = now();
    s.template all<forceOf<Real>>(t.second);
    t.force = std::min(t.force, perParticle * (now() - begin));
}

double meanMag(const std::vector<double>& a)
{
    double total = 0;
    for (const double x : a)
    {
        total += std::abs(x);
    }
    return total / static_cast<double>(a.size());
}

void print(const char* name, const timing& t)
{
    std::printf(
        "%-46s %7.1f %7.1f %7.1f %7.1f   %.15g %.15g\n",
        name,
        t.find,
        t.continuity,
        t.force,
        t.find + t.continuity + t.force,
        meanMag(t.first),
        meanMag(t.second)
    );
}

template<class Real>
void compare(const cloud& coarse, const cloud& fine, int repeats)
{
    rows<Real, 1> rows1(coarse);
    rows<Real, 2> rows2(fine);
    packedCells<Real, 1> packed1(coarse);
    packedCells<Real, 2> packed2(fine);
    lists<Real, false, 0> gathers(coarse);
    lists<Real, true, 0> byRecords(coarse);
    lists<Real, true, 5> skin5(coarse);
    lists<Real, true, 10> skin10(coarse);
    timing t[8];
    // in turns: the machine may be shared
    for (int r = 0; r < repeats; ++r)
    {
        measure<Real>(rows1, coarse, t[0]);
        measure<Real>(rows2, fine, t[1]);
        measure<Real>(packed1, coarse, t[2]);
        measure<Real>(packed2, fine, t[3]);
        measure<Real>(gathers, coarse, t[4]);
        measure<Real>(byRecords, coarse, t[5]);
        measure<Real>(skin5, coarse, t[6]);
        measure<Real>(skin10, coarse, t[7]);
    }
    double pairs = 0;
    for (const auto& entry : byRecords.of_)
    {
        pairs += entry.count;
    }
    std::printf(
        "%s, %d lanes, %.1f neighbours\n",
        sizeof(Real) == 8 ? "double" : "single",
        lanesOf<Real>,
        pairs / coarse.n
    );
    print("rows of cells of 2h, filter by packs", t[0]);
    print("rows of cells of h, filter by packs", t[1]);
    print("candidates of cells of 2h packed", t[2]);
    print("candidates of cells of h packed", t[3]);
    print("list once a step, gathers", t[4]);
    print("list once a step, records transposed", t[5]);
    print("the same, list with a skin of 5 %", t[6]);
    print("the same, list with a skin of 10 %", t[7]);
}

} // namespace

int main(int argc, char* argv[])
{
    if (argc > 1 && std::string(argv[1]) == "-machine")
    {
        printMachine();
        return 0;
    }
    const int edge = argc > 1 ? std::atoi(argv[1]) : 46;
    const int repeats = argc > 2 ? std::atoi(argv[2]) : 5;
    const cloud coarse(edge, 1), fine(edge, 2);
    printMachine();
    std::printf(
        "%d particles; ns a particle, %d threads\n"
        "%-46s %7s %7s %7s %7s   sums\n",
        coarse.n,
        omp_get_max_threads(),
        "",
        "find",
        "contin.",
        "force",
        "step"
    );
    compare<double>(coarse, fine, repeats);
    compare<float>(coarse, fine, repeats);
    printMachine();
    return 0;
}
