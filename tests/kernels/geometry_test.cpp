// SPDX-License-Identifier: Apache-2.0
#include "kernels/geometry.h"

#include <cmath>
#include <doctest/doctest.h>
#include <random>

using namespace proxima;

namespace {

template <class Real> Ray<Real> ray(const Vec3<Real>& origin, const Vec3<Real>& direction) {
    return {origin, glm::normalize(direction)};
}

} // namespace

TEST_CASE_TEMPLATE("sphere: the first of the two distances beyond the nearest one allowed", Real, float, double) {
    struct Row {
        const char* what;
        Vec3<double> origin, direction;
        double nearest, t;
    };
    const double inf = infinity<double>;
    const Row rows[] = {
        {"from outside", {0, 0, -5}, {0, 0, 1}, 0, 3},
        {"only the far one is far enough", {0, 0, -5}, {0, 0, 1}, 3.5, 7},
        {"both are too near", {0, 0, -5}, {0, 0, 1}, 7.5, inf},
        {"from the centre", {0, 0, 0}, {1, 0, 0}, 0, 2},
        {"from inside", {0, 0, 1}, {0, 0, 1}, 0, 1},
        {"from inside, backwards", {0, 0, 1}, {0, 0, -1}, 0, 3},
        {"behind the ray", {0, 0, 5}, {0, 0, 1}, 0, inf},
        {"past it", {2.01, 0, -5}, {0, 0, 1}, 0, inf},
        {"just inside of grazing", {1.9999, 0, -5}, {0, 0, 1}, 0, 5 - std::sqrt(4 - 1.9999 * 1.9999)},
        {"along y", {0, 9, 0}, {0, -1, 0}, 0, 7},
        {"diagonally", {3, 3, 3}, {-1, -1, -1}, 0, std::sqrt(27.0) - 2},
    };
    const Sphere<Real> sphere{Vec3<Real>(Real(0)), Real(2)};
    for (const Row& row : rows) {
        CAPTURE(row.what);
        const Real t =
            intersect(sphere, ray(Vec3<Real>(row.origin), Vec3<Real>(row.direction)), Real(row.nearest), Real(0));
        if (row.t == inf)
            CHECK(t == infinity<Real>);
        else
            CHECK(t == doctest::Approx(row.t).epsilon(sizeof(Real) == 4 ? 1e-4 : 1e-12));
    }
}

TEST_CASE("sphere: in single precision a hit from a million radii away stays on the surface") {
    // The textbook quadratic is off by hundreds of radii here.
    std::mt19937 engine(7);
    const auto uniform = [&] { return double(engine()) / 4294967296.0 * 2 - 1; };
    double worst = 0;
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3<double> direction = glm::normalize(Vec3<double>(uniform(), uniform(), uniform()));
        const Vec3<double> side = glm::normalize(glm::cross(direction, Vec3<double>(uniform(), uniform(), uniform())));
        const Ray<float> r{Vec3<float>(-1e6 * direction + 0.5 * side), Vec3<float>(direction)};
        const float t = intersect(Sphere<float>{Vec3<float>(0.0f), 1.0f}, r, 0.0f, 0.0f);
        if (t == infinity<float>)
            continue;
        ++hits;
        const Vec3<double> hit = Vec3<double>(r.origin) + double(t) * Vec3<double>(r.direction);
        worst = std::max(worst, std::abs(glm::length(hit) - 1));
    }
    CHECK(hits > 1900);
    CHECK(worst < 0.3);
}

TEST_CASE("sphere: with POV-Ray's limit, spheres under 1e-5 are not hit") {
    const auto r = ray(Vec3<double>(0, 0, -1), Vec3<double>(0, 0, 1));
    CHECK(intersect(Sphere<double>{{0, 0, 0}, 0.9e-5}, r, 1e-4, 1e-10) == infinity<double>);
    CHECK(intersect(Sphere<double>{{0, 0, 0}, 1.1e-5}, r, 1e-4, 1e-10) == doctest::Approx(1));
    CHECK(intersect(Sphere<double>{{0, 0, 0}, 1e-9}, r, 0.0, 0.0) == doctest::Approx(1));
}

TEST_CASE("ellipsoid: distances are those in the world, whatever the map") {
    Affine<double> map;
    map.linear = Mat3<double>(2, 0, 0, 0, 0.5, 0, 0, 0, 3);
    map.offset = {1, 2, 3};
    const Mat3<double> inverse = glm::inverse(map.linear);
    const Ellipsoid<double> ellipsoid{{inverse, -(inverse * map.offset)}, map, 0};
    CHECK(intersect(ellipsoid, ray<double>({-9, 2, 3}, {1, 0, 0}), 0.0, 0.0) == doctest::Approx(8));
    CHECK(intersect(ellipsoid, ray<double>({1, 9, 3}, {0, -1, 0}), 0.0, 0.0) == doctest::Approx(6.5));
    CHECK(intersect(ellipsoid, ray<double>({1, 2, 3}, {0, 0, 1}), 0.0, 0.0) == doctest::Approx(3));
    CHECK(intersect(ellipsoid, ray<double>({1, 2.6, -9}, {0, 0, 1}), 0.0, 0.0) == infinity<double>);
    const Box<double> box = bounding_box(ellipsoid);
    CHECK(box.lower == Vec3<double>(-1, 1.5, 0));
    CHECK(box.upper == Vec3<double>(3, 2.5, 6));
}

TEST_CASE("ellipsoid: a ray that goes on from a hit does not find it again") {
    std::mt19937 engine(3);
    const auto uniform = [&] { return float(engine()) / 4294967296.0f * 2 - 1; };
    for (int i = 0; i < 1000; ++i) {
        Affine<float> map;
        for (int c = 0; c < 3; ++c)
            map.linear[c] = {uniform(), uniform(), uniform()};
        if (std::abs(glm::determinant(map.linear)) < 1e-3f)
            continue;
        const Ellipsoid<float> ellipsoid{{glm::inverse(map.linear), {}}, map, 0};
        const auto r = ray(Vec3<float>(5 * uniform(), 5 * uniform(), -5), Vec3<float>(uniform(), uniform(), 5));
        const float first = intersect(ellipsoid, r, 0.0f, 0.0f);
        if (first == infinity<float>)
            continue;
        const float second = intersect(ellipsoid, r, first, 0.0f);
        CHECK(second > first);
        CHECK(intersect(ellipsoid, r, second, 0.0f) == infinity<float>);
    }
}

TEST_CASE("plane: met from either side, missed when parallel or behind") {
    const Plane<double> plane{{0, 1, 0}, -1, 0};
    CHECK(intersect(plane, ray<double>({0, 2, 0}, {0, -1, 0}), 0.0, 0.0) == doctest::Approx(3));
    CHECK(intersect(plane, ray<double>({0, -3, 0}, {0, 1, 0}), 0.0, 0.0) == doctest::Approx(2));
    CHECK(intersect(plane, ray<double>({0, 2, 0}, {0, 1, 0}), 0.0, 0.0) == infinity<double>);
    CHECK(intersect(plane, ray<double>({0, 2, 0}, {1, 0, 0}), 0.0, 0.0) == infinity<double>);
    CHECK(intersect(plane, ray<double>({0, 2, 0}, {1, -1e-11, 0}), 0.0, 1e-10) == infinity<double>);
}

TEST_CASE("box: the part of a ray inside, also for rays that run in its faces") {
    const Box<double> box{{0, 0, 0}, {1, 2, 3}};
    struct Row {
        const char* what;
        Vec3<double> origin, direction;
        bool hits;
        double enter, exit;
    };
    const Row rows[] = {
        {"through", {-1, 1, 1}, {1, 0, 0}, true, 1, 2},
        {"from inside", {0.5, 1, 1}, {0, 0, 1}, true, 0, 2},
        {"backwards through", {0.5, 1, 9}, {0, 0, -1}, true, 6, 9},
        {"away", {-1, 1, 1}, {-1, 0, 0}, false, 0, 0},
        {"beside, parallel", {-0.1, 1, -1}, {0, 0, 1}, false, 0, 0},
        {"in a face", {0, 1, -1}, {0, 0, 1}, true, 1, 4},
        {"in an edge", {0, 0, -1}, {0, 0, 1}, true, 1, 4},
        {"starting on a face", {1, 1, 1}, {-1, 0, 0}, true, 0, 1},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        const Span<double> span = intersect(box, Ray<double>{row.origin, row.direction});
        CHECK((span.enter <= span.exit) == row.hits);
        if (row.hits) {
            CHECK(span.enter == doctest::Approx(row.enter));
            CHECK(span.exit == doctest::Approx(row.exit));
        }
    }
}
