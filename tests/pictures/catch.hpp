// Catch2, version 3 or 2.
#ifndef MEET_TESTS_PICTURES_CATCH_HPP
#define MEET_TESTS_PICTURES_CATCH_HPP

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#endif
