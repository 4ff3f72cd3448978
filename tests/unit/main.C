// SPDX-License-Identifier: GPL-3.0-or-later
// The unit tests of all libraries in one program; each <name>Test.C listed in
// Make/files adds its cases. Catch2 is compiled here, once.

#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
#include <catch2/catch_reporter_tap.hpp>
