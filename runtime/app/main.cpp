#include "app/cli.hpp"

int main(int argc, char **argv) {
  return meet::app::run(argc, argv);
}
