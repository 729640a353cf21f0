#include "app/cli.hpp"

int main(int argc, char **argv) {
  return meetc::app::run(argc, argv);
}
