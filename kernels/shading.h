// SPDX-License-Identifier: Apache-2.0
// How a finish answers to light: what an eye sees of one light, how much is reflected, and which way rays go on.
// Formulas of POV-Ray 3.7 (diffuse, Phong 1975, specular as in Blinn 1977 with H averaged, Fresnel, Snell by Heckbert).
#pragma once
#include "kernels/material.h"
#include "kernels/pigment.h"

namespace proxima {

/// The tint of a metal's highlight or reflection at an angle of incidence: its own colour, turning white at grazing.
template <class Real> HD Vec3<Real> metallic_tint(const Vec3<Real>& rgb, Real metallic, Real cosine) {
    const Real x = arc_cosine(clamped(cosine, Real(-1), Real(1))) / Real(1.57079632679489661923);
    const Real d = x - Real(1.12);
    const Real grazing = clamped(Real(0.014567225) / (d * d) - Real(0.011612903), Real(0), Real(1));
    return Vec3<Real>(Real(1)) + (metallic * (Real(1) - grazing)) * (rgb - Vec3<Real>(Real(1)));
}

/// The factor of a Phong highlight. `alignment` is the cosine between the mirrored eye ray and the light.
template <class Real> HD Real phong_highlight(const Finish& finish, Real alignment) {
    if (!(alignment > 0) || (finish.phong_size >= 60 && alignment <= Real(0.0008)))
        return Real(0);
    return Real(finish.phong) * power(alignment, Real(finish.phong_size));
}

/// The factor of a specular highlight. `alignment` is the cosine between the normal and the half way vector.
template <class Real> HD Real specular_highlight(const Finish& finish, Real alignment) {
    return alignment > 0 ? Real(finish.specular) * power(alignment, Real(finish.inverse_roughness)) : Real(0);
}

/// The directions in which one light is seen; all of unit length, `normal` on the eye's side.
template <class Real> struct LightGeometry {
    Vec3<Real> normal;
    Vec3<Real> to_light;
    Vec3<Real> eye_direction; ///< of the ray that came from the eye
};

/// What a layer sends to the eye of a light of the colour `light`.
template <class Real>
HD Vec3<Real> reflected_light(const Finish& finish, const LayerColor<Real>& layer, const LightGeometry<Real>& g,
                              const Vec3<Real>& light, bool highlights) {
    const Real cosine = glm::dot(g.normal, g.to_light); // negative only for double_illuminate
    Real diffuse = Real(finish.diffuse) * layer.opacity;
    if (finish.brilliance != 1)
        diffuse *= power(magnitude(cosine), Real(finish.brilliance));
    else
        diffuse *= magnitude(cosine);
    Vec3<Real> sum = layer.rgb * light * diffuse;
    if (!highlights || (finish.phong == 0 && finish.specular == 0))
        return sum;
    Real highlight = 0;
    if (finish.phong > 0) {
        const Vec3<Real> mirrored = g.eye_direction - Real(2) * glm::dot(g.eye_direction, g.normal) * g.normal;
        highlight += phong_highlight(finish, glm::dot(mirrored, g.to_light));
    }
    if (finish.specular > 0) {
        const Vec3<Real> halfway = g.to_light - g.eye_direction;
        const Real length = glm::length(halfway);
        highlight += length > 0 ? specular_highlight(finish, glm::dot(g.normal, halfway) / length) : Real(0);
    }
    if (highlight == 0)
        return sum;
    sum += highlight * light *
           (finish.metallic != 0 ? metallic_tint(layer.rgb, Real(finish.metallic), cosine) : Vec3<Real>(Real(1)));
    return sum;
}

/// The reflectance of a smooth dielectric for unpolarised light; 1 where all is reflected. `ior` is the index of the
/// far side over that of the near side.
template <class Real> HD Real fresnel_reflectance(Real ior, Real cosine) {
    const Real g2 = ior * ior + cosine * cosine - Real(1);
    if (!(g2 > 0))
        return Real(1);
    const Real g = square_root(g2);
    const Real a = (g - cosine) / (g + cosine);
    const Real b = (cosine * (g + cosine) - Real(1)) / (cosine * (g - cosine) + Real(1));
    return clamped(Real(0.5) * a * a * (Real(1) + b * b), Real(0), Real(1));
}

/// What a layer reflects, and by how much the reflected ray's weight falls.
template <class Real> struct Reflection {
    Vec3<Real> color;
    Real weight;
};

/// `cosine` between the normal and the direction back to the eye; `ior` as in fresnel_reflectance.
template <class Real>
HD Reflection<Real> reflection_of(const Finish& finish, const Vec3<Real>& rgb, Real cosine, Real ior) {
    const Vec3<Real> low(finish.reflection_min), high(finish.reflection_max);
    Reflection<Real> reflection;
    if (finish.fresnel) {
        const Real f = fresnel_reflectance(ior, cosine);
        reflection.color = f * high + (Real(1) - f) * low;
        reflection.weight = max_component(reflection.color);
    } else {
        Real f = larger(Real(1) - cosine, Real(0));
        if (finish.reflection_falloff != 1)
            f = power(f, Real(finish.reflection_falloff));
        reflection.color = f * high + (Real(1) - f) * low;
        reflection.weight = larger(max_component(low), max_component(high));
    }
    if (finish.reflection_metallic != 0)
        reflection.color *= metallic_tint(rgb, Real(finish.reflection_metallic), cosine);
    return reflection;
}

template <class Real> HD Vec3<Real> mirrored(const Vec3<Real>& direction, const Vec3<Real>& normal) {
    return glm::normalize(direction - Real(2) * glm::dot(direction, normal) * normal);
}

/// Bends a unit direction at a surface whose `normal` is on the ray's side. `ratio` is the near side's index over the
/// far side's. False when all is reflected.
template <class Real>
HD bool refracted(const Vec3<Real>& direction, const Vec3<Real>& normal, Real ratio, Vec3<Real>& bent) {
    const Real cosine = -glm::dot(direction, normal);
    const Real k = Real(1) + ratio * ratio * (cosine * cosine - Real(1));
    if (k < 0)
        return false;
    bent = glm::normalize(ratio * direction + (ratio * cosine - square_root(k)) * normal);
    return true;
}

} // namespace proxima
