// Catch2, version 2 or 3, under one name.
#ifndef MEETC_TESTS_DECISIONS_ROUND_CATCH_HPP
#define MEETC_TESTS_DECISIONS_ROUND_CATCH_HPP

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#endif
