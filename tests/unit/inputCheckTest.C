// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about wrong input: each names value, rule, reason, remedy, file
// and line.

#include <catch2/catch.hpp>

#include "inputCheck.H"
#include "sampleCase.H"

#include <fstream>

using namespace Foam;
using namespace Foam::lpf;

namespace
{

//- A dictionary file and what is said about it
class inputFileTest
{
    temporaryFolder folder_;

public:
    const fileName file;

    explicit inputFileTest(const std::string& text)
        : file(folder_.path() / "phaseProperties")
    {
        write("phaseProperties", text);
    }

    void write(const word& name, const std::string& text) const
    {
        std::ofstream(folder_.path() / name) << text;
    }

    //- What f says about the dictionary, with the folder cut off
    template<class F>
    std::string error(const F& f) const
    {
        std::string message = errorOf(
            [&]
            {
                const dictionary dict = readDictionary(file);
                f(dict);
            }
        );
        for (auto at = message.find(folder_.path()); at != std::string::npos;
             at = message.find(folder_.path()))
        {
            message.erase(at, folder_.path().size() + 1);
        }
        return message;
    }
};


const bounds friction{0, 1, true, false, "tan of an angle, write muS 0.4;"};


std::string numberError(const std::string& text, const dimensionSet& dims)
{
    return inputFileTest(text).error(
        [&](const dictionary& dict) { readNumber(dict, "muS", dims, friction); }
    );
}


scalar number(const std::string& text, const dimensionSet& dims)
{
    return readNumber(
        readDictionary(inputFileTest(text).file), "muS", dims, bounds()
    );
}

} // namespace


TEST_CASE("readNumber: three ways to write it")
{
    CHECK(number("muS 0.3;", dimless) == 0.3);
    CHECK(number("muS [0 0 0 0 0 0 0] 0.3;", dimless) == 0.3);
    CHECK(number("muS muS [1 -1 -2 0 0 0 0] 5e3;", dimPressure) == 5e3);
    CHECK(number("muS [1 -1 -2 0 0] 7;", dimPressure) == 7);
    CHECK(number("muS 7;", dimPressure) == 7);
    CHECK(number("a 2; muS #eval{ 3*$a };", dimless) == 6);
    CHECK(number("a 2; muS $a;", dimless) == 2);
}


TEST_CASE("readNumber: range, with reason, file and line")
{
    CHECK(
        numberError("\n\nmuS -0.3;", dimless)
        == "muS = -0.3 must be greater than 0 and at most 1: tan of an "
           "angle, write muS 0.4;|phaseProperties:3"
    );
    CHECK(numberError("muS 0;", dimless) != "");
    CHECK(numberError("muS 1;", dimless) == "");
    CHECK(numberError("muS 1.0000000001;", dimless) != "");
}


TEST_CASE("readNumber: wrong dimensions")
{
    CHECK(
        numberError("muS [1 -3 0 0 0 0 0] 0.3;", dimPressure)
        == "muS = [ 1 -3 0 0 0 0 0 ] 0.3 has units [1 -3 0 0 0 0 0] but "
           "[1 -1 -2 0 0 0 0] are needed; write 'muS [1 -1 -2 0 0 0 0] "
           "<number>;' with the value in SI units|phaseProperties:1"
    );
    CHECK(
        numberError("muS [mm] 0.3;", dimLength)
        == "muS = [ mm] 0.3: units are written as seven exponents of kg m s "
           "K mol A cd; write 'muS [0 1 0 0 0 0 0] <number>;'|phaseProperties:1"
    );
}


TEST_CASE("readNumber: what is not a number")
{
    const std::string remedy(
        " is not a finite number; write 'muS <number>;'|phaseProperties:1"
    );
    CHECK(numberError("muS high;", dimless) == "muS = high" + remedy);
    CHECK(numberError("muS nan;", dimless) == "muS = nan" + remedy);
    CHECK(numberError("muS inf;", dimless) == "muS = inf" + remedy);
    CHECK(numberError("muS;", dimless) == "muS = " + remedy);
    CHECK(numberError("muS \"0.3\";", dimless) == "muS = \"0.3\"" + remedy);
    CHECK(
        numberError("muS 0.3\nmu2 0.4;", dimless)
        == "muS = 0.3 mu2 0.4 goes on after its value; is a ';' missing at "
           "the end of its line?|phaseProperties:1"
    );
    CHECK(
        numberError("muS { x 1; }", dimless)
        == "muS is a sub-dictionary but must be a value; write 'muS "
           "<number>;', greater than 0 and at most 1: tan of an angle, write "
           "muS 0.4;|phaseProperties:1"
    );
    CHECK(
        numberError("mus 0.3;\nmu2 1;", dimless)
        == "muS is missing; write 'muS <number>;', greater than 0 and at most "
           "1: tan of an angle, write muS 0.4;. Is 'mus' meant to be it?"
           "|phaseProperties:1"
    );
}


TEST_CASE("readNumber: sub-dictionaries keep the path, includes their own")
{
    const inputFileTest input(
        "grains\n{\n    muICoeffs\n    {\n        muS 7;\n    }\n}\n"
    );
    const auto read = [](const dictionary& dict)
    {
        readNumber(
            dict.subDict("grains").subDict("muICoeffs"),
            "muS",
            dimless,
            friction
        );
    };
    CHECK_THAT(
        input.error(read),
        Catch::EndsWith("|phaseProperties.grains.muICoeffs:5")
    );
    input.write("common", "\n\n\nmuS 8;\n");
    input.write(
        "phaseProperties", "grains { muICoeffs\n{\n#include \"common\"\n} }\n"
    );
    CHECK_THAT(input.error(read), Catch::EndsWith("|common:4"));
    input.write("phaseProperties", "grains\n{\n muICoeffs {}\n}\n");
    CHECK_THAT(
        input.error(read),
        Catch::EndsWith("|phaseProperties.grains.muICoeffs:3")
    );
}


TEST_CASE("readInteger: whole numbers in their range")
{
    const auto read = [](const std::string& text)
    {
        return inputFileTest(text).error(
            [](const dictionary& dict)
            { readInteger(dict, "n", 1, 9, "a count", 3); }
        );
    };
    const auto value = [](const std::string& text)
    {
        return readInteger(
            readDictionary(inputFileTest(text).file), "n", 1, 9, "a count", 3
        );
    };
    CHECK(value("") == 3);
    CHECK(value("n 9;") == 9);
    CHECK(value("n 2.0;") == 2);
    const std::string rule(
        " must be a whole number from 1 to 9: a count|phaseProperties:1"
    );
    CHECK(read("n 1.7;") == "n = 1.7" + rule);
    CHECK(read("n 0;") == "n = 0" + rule);
    CHECK(read("n 10;") == "n = 10" + rule);
    CHECK(
        read("n many;")
        == "n = many is not a whole number from 1 to 9: a count"
           "|phaseProperties:1"
    );
}


TEST_CASE("numbers that are too large")
{
    CHECK(
        numberError("muS 1e16;", dimless)
        == "muS = 1e+16 is beyond 1e15, larger than anything of a scene in SI "
           "units: it must be a finite number; write 'muS <number>;'"
           "|phaseProperties:1"
    );
    CHECK(
        numberError("\nmuS -1e400;", dimless)
        == "-1e400 is too large for a number: nothing of a scene is as large "
           "in SI units|phaseProperties:2"
    );
    CHECK(numberError("muS 0.5; // 1e400\n", dimless) == "");
    CHECK(numberError("muS #eval{ 1/0 };", dimless) != "");
}


TEST_CASE("nearestWord: misspelt names, but not other short ones")
{
    CHECK(nearestWord("coulmb", {"Coulomb", "muI"}) == "Coulomb");
    CHECK(nearestWord("MUI", {"Coulomb", "muI"}) == "muI");
    CHECK(nearestWord("alhpa", {"alpha", "rho"}) == "alpha");
    CHECK(nearestWord("mu2", {"muS", "rho"}).empty());
    CHECK(nearestWord("viscosity", {"muS", "rho"}).empty());
}


TEST_CASE("readVector: three numbers with units")
{
    const auto read = [](const std::string& text)
    {
        return inputFileTest(text).error([](const dictionary& dict)
                                         { readVector(dict, "U", dimVelocity); }
        );
    };
    CHECK(read("U (0 0 1);") == "");
    CHECK(read("U [0 1 -1 0 0 0 0] (0 0 1);") == "");
    CHECK(
        read("U (0 0);")
        == "U = ( 0 0 ) is not three finite numbers in (); write "
           "'U [0 1 -1 0 0 0 0] (<x> <y> <z>);'|phaseProperties:1"
    );
    CHECK(read("U (0 0 0 0);") != "");
    CHECK(read("U 0;") != "");
    CHECK(read("U (0 0 nan);") != "");
    CHECK(read("U [0 1 0 0 0 0 0] (0 0 1);") != "");
}


TEST_CASE("readChoice: lists what is valid")
{
    const auto read = [](const std::string& text)
    {
        return inputFileTest(text).error(
            [](const dictionary& dict) {
                readChoice(dict, "rheology", {"muI", "Coulomb"});
            }
        );
    };
    CHECK(read("rheology muI;") == "");
    CHECK(
        read("rheology coulomb;")
        == "rheology = coulomb is not a valid choice, do you mean 'Coulomb'?\n"
           "Valid choices: muI Coulomb|phaseProperties:1"
    );
    CHECK(read("rheology 3;") != "");
    CHECK(read("rheology muI Coulomb;") != "");
    CHECK(
        read("rheo muI;")
        == "rheology is missing; write rheology followed by one of: "
           "muI Coulomb;|phaseProperties:1"
    );
}


TEST_CASE("allowOnly: unknown keywords are errors that list the valid ones")
{
    const auto check = [](const std::string& text)
    {
        return inputFileTest(text).error(
            [](const dictionary& dict) {
                allowOnly(dict, {"rho", "rheology"}, {"muI", "Coulomb"});
            }
        );
    };
    const std::string head("FoamFile { version 2.0; format ascii; }\n");
    CHECK(check(head + "rho 1; rheology muI; muICoeffs {}") == "");
    CHECK(check("rho 1; rheology Coulomb; muICoeffs {}") == "");
    CHECK(
        check("rho 1;\nreology muI;")
        == "unknown keyword 'reology', do you mean 'rheology'?\n"
           "Valid here: rho rheology muICoeffs CoulombCoeffs"
           "|phaseProperties:2"
    );
    CHECK(check("muiCoeffs {}") != "");
    // definitions for macros are no input of ours, unless nothing uses them
    CHECK(check("density 2600; rho $density;") == "");
    CHECK(check("density 2600; rho #eval{ 2*$density };") == "");
    CHECK(check("density 2600; rho ${density};") == "");
    CHECK(check("density 2600; rho 1; // $density") != "");
    CHECK(check("a { b 2; } rho $a.b;") == "");
}


TEST_CASE("readDictionary: brackets that do not match")
{
    const auto read = [](const std::string& text)
    { return inputFileTest(text).error([](const dictionary&) {}); };

    CHECK(read("a { b 1; } // }\nc \"}\"; /* ( \n */ d (1 2);") == "");
    CHECK(
        read("a\n{\n    b 1;\n")
        == "the bracket opened here is never closed: write the missing "
           "'}'|phaseProperties:2"
    );
    CHECK(
        read("a 1;\n}\n")
        == "'}' closes nothing: remove it, or write the bracket that it is "
           "to close|phaseProperties:2"
    );
    CHECK(
        read("a\n{\n    b (1 2;\n}\n")
        == "'}' found where ')' must close the bracket of line 3: write the "
           "missing ')'|phaseProperties:4"
    );
}


TEST_CASE("readDictionary: what OpenFOAM passes over, or tells without a line")
{
    const auto read = [](const std::string& text)
    { return inputFileTest(text).error([](const dictionary&) {}); };

    CHECK(
        read("a 1;\n/* b 2;\nc 3;\n")
        == "the comment that begins here does not end: write the missing "
           "*/|phaseProperties:2"
    );
    CHECK(
        read("a 1;\nb \"2;\n")
        == "the text that begins here does not end: write the missing quote, "
           "or #}|phaseProperties:2"
    );
    CHECK_THAT(read("a 1;\nb 2"), Catch::Contains("Is a ';' missing"));
    CHECK_THAT(read("a 1;\nb 2"), Catch::EndsWith("|phaseProperties:2"));
    CHECK_THAT(read("a 1;\nb $none;\n"), Catch::EndsWith("|phaseProperties:2"));
    CHECK_THAT(
        read("a 1;\nb #eval{ 2*$none };\n"),
        Catch::EndsWith("is one misspelt?|phaseProperties:2")
    );
    CHECK_THAT(
        read("a 1;\n\n#inclde \"b\"\n"), Catch::EndsWith("|phaseProperties:3")
    );
}


TEST_CASE("readDictionary: a file that is not there")
{
    CHECK_THAT(
        errorOf([] { readDictionary("/none/constant/g"); }),
        Catch::StartsWith("the file does not exist; its folder neither")
    );
}


TEST_CASE("readGravity: units and keywords are checked")
{
    const temporaryFolder folder;
    mkDir(folder.path() / "constant");
    const auto write = [&](const std::string& text)
    { std::ofstream(folder.path() / "constant" / "g") << text; };
    const auto error = [&]
    { return errorOf([&] { readGravity(folder.path()); }); };

    write("FoamFile { version 2.0; format ascii; class "
          "uniformDimensionedVectorField; object g; }\n"
          "dimensions [0 1 -2 0 0 0 0];\nvalue (0 0 -9.81);\n");
    CHECK(readGravity(folder.path()) == vector(0, 0, -9.81));
    write("dimensions [0 1 -1 0 0 0 0];\nvalue (0 0 -9.81);\n");
    CHECK_THAT(error(), Catch::Contains("[0 1 -2 0 0 0 0] are needed"));
    write("value (0 0 -9.81);\n");
    CHECK_THAT(error(), Catch::StartsWith("dimensions is missing"));
    write("dimensions [0 1 -2 0 0 0 0];\nvalu (0 0 -9.81);\n");
    CHECK_THAT(error(), Catch::Contains("do you mean 'value'?"));
}
