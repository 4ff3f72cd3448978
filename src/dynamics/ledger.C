// SPDX-License-Identifier: GPL-3.0-or-later
#include "ledger.H"

#include "inputCheck.H"
#include "primitiveEntry.H"
#include "wordList.H"

namespace Foam
{
namespace lpf
{

void setExact(dictionary& d, const word& name, scalar v)
{
    d.set(new primitiveEntry(name, token(v)));
}

void setExact(dictionary& d, const word& name, const vector& v)
{
    List<token> tokens(
        {token(token::BEGIN_LIST),
         token(v.x()),
         token(v.y()),
         token(v.z()),
         token(token::END_LIST)}
    );
    d.set(new primitiveEntry(name, std::move(tokens)));
}

namespace
{

//- Every running sum once, for writing and reading
template<class Balance, class Task>
void forSums(Balance& b, const Task& task)
{
    task("plastic", b.plastic);
    task("separation", b.separation);
    task("friction", b.friction);
    task("viscous", b.viscous);
    task("artificial", b.artificial);
    task("diffusion", b.diffusion);
    task("shifting", b.shifting);
    task("drag", b.drag);
    task("projection", b.projection);
    task("wallTension", b.wallTension);
    task("left", b.left);
    task("wrapped", b.wrapped);
    task("wallNormalImpulse", b.wallNormalImpulse);
    task("projectionNormalImpulse", b.projectionNormalImpulse);
    task("initialKinetic", b.initial.kinetic);
    task("initialPotential", b.initial.potential);
    task("initialElastic", b.initial.elastic);
    task("peakKinetic", b.peakKinetic);
}

template<class Balance, class Task>
void forVectorSums(Balance& b, const Task& task)
{
    task("gravityImpulse", b.gravityImpulse);
    task("wallImpulse", b.wallImpulse);
    task("frictionImpulse", b.frictionImpulse);
    task("projectionImpulse", b.projectionImpulse);
    task("leftMomentum", b.leftMomentum);
    task("initialMomentum", b.initial.momentum);
}

const char* const massNames[2] = {"initialMass", "leftMass"};

//- x and at most sixteen digits
bool isHexadecimal(const word& w)
{
    return w.size() > 1 && w.size() < 18 && w[0] == 'x'
        && w.find_first_not_of("0123456789abcdef", 1) == std::string::npos;
}

} // namespace

void balance::operator+=(const balance& b)
{
    std::vector<scalar> sums;
    std::vector<vector> vectors;
    forSums(b, [&](const char*, scalar v) { sums.push_back(v); });
    forVectorSums(
        b, [&](const char*, const vector& v) { vectors.push_back(v); }
    );
    std::size_t k = 0;
    forSums(*this, [&](const char*, scalar& v) { v += sums[k++]; });
    k = 0;
    forVectorSums(*this, [&](const char*, vector& v) { v += vectors[k++]; });
}

dictionary balance::state() const
{
    dictionary d;
    forSums(*this, [&](const char* name, scalar v) { setExact(d, name, v); });
    forVectorSums(
        *this, [&](const char* name, const vector& v) { setExact(d, name, v); }
    );
    const lpfPairs::exactSum* masses[2] = {&initialMass, &leftMass};
    for (int k = 0; k < 2; ++k)
    {
        const auto text = masses[k]->text();
        d.set(massNames[k], wordList(text.begin(), text.end()));
    }
    return d;
}

void balance::restore(const dictionary& d)
{
    const auto need = [&](const char* name, bool good)
    {
        if (!good)
        {
            refuse(
                d,
                name,
                word(name)
                    + " is missing or damaged: the ledger would not go on. "
                      "Go on from an earlier time"
            );
        }
    };
    forSums(
        *this,
        [&](const char* name, scalar& v)
        {
            need(name, d.found(name));
            d.readEntry(name, v);
        }
    );
    forVectorSums(
        *this,
        [&](const char* name, vector& v)
        {
            need(name, d.found(name));
            d.readEntry(name, v);
        }
    );
    lpfPairs::exactSum* masses[2] = {&initialMass, &leftMass};
    for (int k = 0; k < 2; ++k)
    {
        need(massNames[k], d.found(massNames[k]));
        const wordList words(d.get<wordList>(massNames[k]));
        auto text = masses[k]->text();
        need(massNames[k], words.size() == label(text.size()));
        for (const word& w : words)
        {
            need(massNames[k], isHexadecimal(w));
        }
        std::copy(words.begin(), words.end(), text.begin());
        masses[k]->fromText(text);
    }
}

} // namespace lpf
} // namespace Foam
