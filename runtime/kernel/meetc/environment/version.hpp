// The version of these headers, with which emitted code compares the one that it was written for.
#ifndef MEETC_ENVIRONMENT_VERSION_HPP
#define MEETC_ENVIRONMENT_VERSION_HPP

#define MEETC_SUPPORT_VERSION 16

#endif
