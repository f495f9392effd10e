#include "row_sphere.hpp"

#include <algorithm>
#include <cmath>

namespace fos::certified {
namespace {

/// What an expression of a few doubles may be off, for the sum of the sizes of its terms.
constexpr double slack = 0x1p-49;

}  // namespace

bool along_row(const CameraScene& scene, const CameraSphere& sphere, double y, bool within_outline,
               RowSphere& row) {
  row.sphere = &sphere;
  row.first_column = within_outline ? sphere.first_column : 0;
  row.end_column = within_outline ? sphere.end_column : scene.width;
  row.nearest_t = static_cast<float>(sphere.nearest_t) * (1 - 2 * u);
  row.in_float = false;
  if (!sphere.has_row_form) return true;

  const double q = sphere.q[0] + y * (sphere.q[1] + y * sphere.q[2]);
  // (Coefficients below 2^-1000 have become 0.)
  const double dq = slack * (std::abs(sphere.q[0]) +
                             std::abs(y) * (std::abs(sphere.q[1]) + std::abs(y * sphere.q[2]))) +
                    0x1p-999 * (1 + std::abs(y) + y * y);
  const double xc = sphere.xc[0] + y * sphere.xc[1];
  const double dxc = slack * (std::abs(sphere.xc[0]) + std::abs(y * sphere.xc[1]));
  if (within_outline && sphere.k > 0) {  // the hits lie around xc, or there are none
    if (q + dq < 0) return false;
    const double half = std::sqrt((q + dq) / sphere.k) * (1 + 1e-9) + dxc + 1e-3;
    if (!std::isfinite(xc) || !std::isfinite(half)) return true;
    const double middle = xc + scene.width / 2.0;
    const double first = std::ceil(middle - half);
    const double last = std::floor(middle + half);
    row.first_column = static_cast<int>(
        std::clamp(first, static_cast<double>(row.first_column), static_cast<double>(scene.width)));
    row.end_column =
        static_cast<int>(std::clamp(last + 1, 0.0, static_cast<double>(row.end_column)));
    if (row.first_column >= row.end_column) return false;
  }
  const bool moderate_q = std::abs(q) >= 0x1p-80 && std::abs(q) <= 0x1p80;
  if (!sphere.suits_float || !moderate_q || !(std::abs(xc) <= 0x1p60)) return true;

  const double U = u;
  const double xi = std::clamp(std::nearbyint(xc), -0x1p21, 0x1p21);
  const double xf = xc - xi;
  const double e = U * std::abs(xf) + dxc;
  row.q = static_cast<float>(q);
  row.k = static_cast<float>(sphere.k);
  row.xi = static_cast<float>(xi);
  row.xf = static_cast<float>(xf);
  // Around xc a hit has T <= q, so that E is one number for the row. (Beyond, where disc < -E, E
  // grows by less than disc does: what is taken for a miss is one.)
  // The last part is for a Δ² that is no normal float.
  const double E0 = 1.01 * (2.1 * U * std::abs(q) + dq + 1.1 * std::abs(sphere.k) * e * e / U +
                            std::abs(sphere.k) * 0x1p-148);
  const double E = sphere.k > 0 ? (E0 + 7.5 * U * std::abs(q)) * (1 + 1e-6) : E0;
  row.E = static_cast<float>(E);

  const double h0 = sphere.h[0] + y * sphere.h[1];
  const double dh0 = slack * (std::abs(sphere.h[0]) + std::abs(y * sphere.h[1]));
  const double widest = std::abs(sphere.hx) * scene.width / 2;
  const double Eh = 1.01 * (2 * U * std::abs(h0) + dh0 + 3.2 * U * widest);
  row.in_front = h0 > widest + Eh;
  if (!sphere.inside && h0 < -(widest + Eh)) return false;
  row.h0 = static_cast<float>(h0);
  row.hx = static_cast<float>(sphere.hx);
  row.c = static_cast<float>(std::abs(sphere.c));
  const double a0 = scene.d * scene.d + scene.ky * scene.ky * y * y;
  row.a0 = static_cast<float>(a0);
  const double g_least =
      std::max(std::sqrt(a0 * std::abs(sphere.c)), std::abs(h0) - widest) * (1 - 1e-9);

  // From outside t = c/(h + s) >= c/2h, because s < h: on a large sphere nearly all of it.
  const double largest_h = (std::abs(h0) + widest) * (1 + 1e-6);
  if (!sphere.inside) {
    row.nearest_t =
        std::max(row.nearest_t, static_cast<float>(sphere.c / (2 * largest_h)) * (1 - 4 * u));
  }

  const bool near_only = sphere.near_only || 2 * largest_h <= sphere.c;
  row.roots = sphere.inside ? Roots::far : near_only ? Roots::near : Roots::either;

  // Relative to t: the roundings of c (or of a, which has six), of s, g and the division, and the
  // errors of h and s.
  const double roundings = row.roots == Roots::near ? 4.2 : 10;
  const double At = roundings * U + 1.05 * Eh / g_least;
  const double Bt = 1.05 / g_least;
  // The longest D among its columns.
  const double x = std::max(std::abs(row.first_column - scene.width / 2.0),
                            std::abs(row.end_column - scene.width / 2.0));
  const double D = std::sqrt(a0 + scene.kx * scene.kx * x * x) * (1 + 1e-9);
  row.inv_D = static_cast<float>(1 / D);
  row.P_error = static_cast<float>(D * (At + 4 * U) * (1 + 1e-6));
  row.P_rate = static_cast<float>(D * Bt * (sphere.k > 0 ? E : 1) * (1 + 1e-6));
  // P is at most so far away: from outside the near root is not beyond the tangents, √c long.
  const double reach = row.roots == Roots::near ? std::sqrt(sphere.c) : sphere.V_length + sphere.r;
  row.n0 =
      static_cast<float>(U * (1.01 * (2.1 * reach + 1.1 * sphere.V_length) * sphere.inv_r + 1.2));

  row.in_float = At <= 0x1p-8;  // so that Eh < g_least / 256: the sign of h is beyond doubt
  return true;
}

}  // namespace fos::certified
