#include <heckbert/import/import.h>

int main() {
  return heckbert::import::load_scene_or_builtin("cornell").scene.shapes.empty() ? 1 : 0;
}
