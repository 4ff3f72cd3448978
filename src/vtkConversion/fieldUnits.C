// SPDX-License-Identifier: GPL-3.0-or-later

#include "fieldUnits.H"

#include <map>

Foam::string Foam::lpf::unitsOf(const word& field)
{
    static const std::map<std::string, const char*> units = {
        {"id", "1"},        {"zone", "1"},       {"U", "m/s"},
        {"mass", "kg"},     {"alpha", "1"},      {"h", "m"},
        {"sigma", "Pa"},    {"p", "Pa"},         {"I", "1"},
        {"rho", "kg/m3"},   {"rhoRef", "kg/m3"}, {"toGround", "1/s"},
        {"lag", "1"},       {"meanTheta", "1"},  {"a", "m/s2"},
        {"drag", "m/s2"},   {"S", "1"},          {"gradPForce", "m/s2"},
        {"elevation", "m"}, {"origin", "m"},     {"TimeValue", "s"},
        {"traction", "N"}};

    const auto found = units.find(field);
    return found == units.end() ? "" : found->second;
}
