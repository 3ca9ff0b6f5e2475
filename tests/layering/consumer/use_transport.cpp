#include <heckbert/transport/render.h>

int main() {
  heckbert::transport::Scene scene;
  scene.environment = heckbert::Rgb(1);
  return heckbert::transport::render(scene, {.width = 4, .height = 4, .samples_per_pixel = 1}).words.size() == 1 ? 0
                                                                                                                 : 1;
}
