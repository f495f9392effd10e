// What the toolkit costs: a frame of `combined` through the render loop, against a bare loop of the
// same formulas with nothing around it. docs/en/speed.md has the command and the figures.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "fos/render.hpp"
#include "fos/scene_file.hpp"

namespace {

const fos::SceneFile& lecture() {
  static const fos::SceneFile file = fos::to_scene(fos::read_scene_text(FOS_LECTURE_SCENE));
  return file;
}

/// The formulas of closest_hit and of the solution of `combined`, on plain numbers.
void bare_frame(const fos::SceneFile& file, std::vector<double>& out) {
  const fos::Scene& scene = file.scene;
  const fos::View& view = file.view;
  const double Ox = view.camera_position.x;
  const double Oy = view.camera_position.y;
  const double Oz = view.camera_position.z;
  std::size_t next = 0;
  for (int row = 0; row < view.canvas_height; ++row) {
    for (int column = 0; column < view.canvas_width; ++column) {
      const double Dx =
          (column - view.canvas_width / 2.0) * view.viewport_width / view.canvas_width;
      const double Dy =
          (view.canvas_height / 2.0 - 1 - row) * view.viewport_height / view.canvas_height;
      const double Dz = view.projection_plane_d;
      const double a = Dx * Dx + Dy * Dy + Dz * Dz;
      double closest_t = INFINITY;
      const fos::Sphere* closest = nullptr;
      for (const fos::Sphere& sphere : scene.spheres) {
        const double Vx = sphere.center.x - Ox;
        const double Vy = sphere.center.y - Oy;
        const double Vz = sphere.center.z - Oz;
        const double h = Vx * Dx + Vy * Dy + Vz * Dz;
        const double s = h / a;
        const double lx = Vx - s * Dx;
        const double ly = Vy - s * Dy;
        const double lz = Vz - s * Dz;
        const double r2 = sphere.radius * sphere.radius;
        const double discriminant = r2 - (lx * lx + ly * ly + lz * lz);
        if (discriminant < 0) continue;
        const double q = h + std::copysign(std::sqrt(a * discriminant), h);
        const double c = Vx * Vx + Vy * Vy + Vz * Vz - r2;
        const double t1 = q == 0 ? 0 : c / q;
        const double t2 = q / a;
        if (t1 < closest_t && 1 <= t1) closest_t = t1, closest = &sphere;
        if (t2 < closest_t && 1 <= t2) closest_t = t2, closest = &sphere;
      }
      if (closest == nullptr) {
        for (int i = 0; i < 3; ++i) out[next++] = scene.background_color[i];
        continue;
      }
      const double Px = Ox + closest_t * Dx;
      const double Py = Oy + closest_t * Dy;
      const double Pz = Oz + closest_t * Dz;
      double Nx = Px - closest->center.x;
      double Ny = Py - closest->center.y;
      double Nz = Pz - closest->center.z;
      const double length = std::sqrt(Nx * Nx + Ny * Ny + Nz * Nz);
      Nx /= length;
      Ny /= length;
      Nz /= length;
      const auto diffuse = [&](double intensity, double Lx, double Ly, double Lz) {
        const double n_dot_l = Nx * Lx + Ny * Ly + Nz * Lz;
        if (!(n_dot_l > 0)) return 0.0;
        return intensity * n_dot_l /
               (std::sqrt(Nx * Nx + Ny * Ny + Nz * Nz) * std::sqrt(Lx * Lx + Ly * Ly + Lz * Lz));
      };
      double i = scene.ambient_intensity;
      for (const auto& light : scene.point_lights) {
        i += diffuse(light.intensity, light.position.x - Px, light.position.y - Py,
                     light.position.z - Pz);
      }
      for (const auto& light : scene.directional_lights) {
        i += diffuse(light.intensity, light.direction.x, light.direction.y, light.direction.z);
      }
      for (int channel = 0; channel < 3; ++channel) out[next++] = closest->color[channel] * i;
    }
  }
}

void stage_frame(const fos::SceneFile& file, std::vector<double>& out) {
  double* next = out.data();
  fos::render(file.scene, file.view, [&](auto colors, auto /*unwritten*/) {
    std::memcpy(next, colors.data(), colors.size_bytes());
    next += 3 * colors.size();
  });
}

template <void (*frame)(const fos::SceneFile&, std::vector<double>&)>
void measure(benchmark::State& state) {
  std::vector<double> expected(3UL * 600 * 600);
  std::vector<double> out(expected.size());
  bare_frame(lecture(), expected);
  for (auto _ : state) {
    frame(lecture(), out);
    benchmark::DoNotOptimize(out.data());
  }
  if (out != expected) std::abort();  // the same formulas: the same numbers
}

BENCHMARK(measure<bare_frame>)->Name("bare loop")->Unit(benchmark::kMillisecond);
BENCHMARK(measure<stage_frame>)->Name("solution_combined")->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
