// SPDX-License-Identifier: BSD-3-Clause
#include "lidar/scene.hpp"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include "lidar/primitives.hpp"
#include "tests/lidar/fixtures.hpp"

namespace alignability {
namespace {

using test::moved;

// A hall of 10 × 8 × 4 m with walls 0.5 m thick, its floor at z = 0 and its middle at the origin.
std::vector<TriangleMesh> hall() {
  return {moved(make_box({11, 9, 0.5}), 0, 0, -0.25), moved(make_box({11, 9, 0.5}), 0, 0, 4.25),
          moved(make_box({0.5, 9, 4}), -5.25, 0, 2),  moved(make_box({0.5, 9, 4}), 5.25, 0, 2),
          moved(make_box({10, 0.5, 4}), 0, -4.25, 2), moved(make_box({10, 0.5, 4}), 0, 4.25, 2)};
}

std::vector<Eigen::Vector3f> random_directions(std::mt19937_64& engine, int count) {
  std::normal_distribution<float> normal;
  std::vector<Eigen::Vector3f> directions;
  for (int i = 0; i < count; ++i) directions.push_back(Eigen::Vector3f(normal(engine), normal(engine), normal(engine)).normalized());
  return directions;
}

// Möller and Trumbore, in double, over all triangles.
double nearest_by_search(const std::vector<TriangleMesh>& meshes, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const TriangleMesh& mesh : meshes) {
    for (const auto& [ia, ib, ic] : mesh.triangles) {
      const Eigen::Vector3d a = mesh.vertices[ia].cast<double>();
      const Eigen::Vector3d ab = mesh.vertices[ib].cast<double>() - a;
      const Eigen::Vector3d ac = mesh.vertices[ic].cast<double>() - a;
      const Eigen::Vector3d p = direction.cross(ac);
      const double determinant = ab.dot(p);
      const Eigen::Vector3d t = origin - a;
      const double u = t.dot(p) / determinant;
      const Eigen::Vector3d q = t.cross(ab);
      const double v = direction.dot(q) / determinant;
      const double range = ac.dot(q) / determinant;
      if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && range > 0.0) nearest = std::min(nearest, range);
    }
  }
  return nearest;
}

TEST(Scene, CastStopsAtTheNearestSurface) {
  const Scene scene(hall());
  const std::vector<Eigen::Vector3f> directions{Eigen::Vector3f::UnitX(),  -Eigen::Vector3f::UnitX(), Eigen::Vector3f::UnitY(),
                                                -Eigen::Vector3f::UnitY(), Eigen::Vector3f::UnitZ(),  -Eigen::Vector3f::UnitZ()};
  const std::vector<float> ranges = scene.cast({1, 2, 1}, directions, 100);
  const std::vector<float> expected{4, 6, 2, 6, 3, 1};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(ranges[i], expected[i], 1e-5f);
}

TEST(Scene, CastGivesNanBeyondTheRange) {
  const Scene scene(hall());
  const std::vector<Eigen::Vector3f> directions(17, Eigen::Vector3f::UnitX());
  for (const float range : scene.cast({0, 0, 1}, directions, 4.9f)) EXPECT_TRUE(std::isnan(range));
  for (const float range : scene.cast({0, 0, 1}, directions, 5.1f)) EXPECT_NEAR(range, 5.0f, 1e-5f);
}

TEST(Scene, CastSeesNothingInAnEmptyScene) {
  const Scene scene({});
  const std::vector<Eigen::Vector3f> directions(3, Eigen::Vector3f::UnitX());
  for (const float range : scene.cast({0, 0, 0}, directions, 10)) EXPECT_TRUE(std::isnan(range));
  EXPECT_TRUE(scene.bounds().isEmpty());
  EXPECT_TRUE(scene.is_free({0, 0, 0}, 1));
}

TEST(Scene, CastAgreesWithSearchingAllTriangles) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    SCOPED_TRACE(seed);
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> place(-4, 4);
    std::vector<TriangleMesh> meshes = hall();
    for (int i = 0; i < 6; ++i) meshes.push_back(moved(make_sphere(0.3), place(engine), place(engine), 2 + place(engine) / 4));
    const Scene scene(meshes);
    const Eigen::Vector3f origin(0.1f, 0.2f, 3.7f);
    const auto directions = random_directions(engine, 501);
    const auto ranges = scene.cast(origin, directions, 100);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      ASSERT_NEAR(ranges[i], nearest_by_search(meshes, origin.cast<double>(), directions[i].cast<double>()), 1e-4);
    }
  }
}

// As of a level scanner that hangs upside down, whose roll of 180 degrees leaves 1e-16 of y in z.
TEST(Scene, CastStopsWhateverTracesOfRoundingADirectionHas) {
  const Scene scene(hall());
  for (const float trace : {-1e-16f, -1e-17f, -1e-18f, -1e-30f, 0.0f, 1e-30f, 1e-18f, 1e-17f}) {
    std::vector<Eigen::Vector3f> directions;
    for (int i = 0; i < 64; ++i) {
      const float y = 0.005f * static_cast<float>(i - 32);
      directions.push_back(Eigen::Vector3f(1.0f, y, trace * y));
    }
    for (const float range : scene.cast({0, 0, 1}, directions, 100)) EXPECT_NEAR(range, 5.0f, 1e-4f) << trace;
  }
}

TEST(Scene, CastDoesNotSlipThroughEdges) {
  const Scene scene({make_sphere(1)});
  std::vector<Eigen::Vector3f> directions;
  for (const TriangleMesh& mesh : scene.meshes()) {
    for (const auto& [a, b, c] : mesh.triangles) {
      directions.push_back(mesh.vertices[a].normalized());
      directions.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
    }
  }
  for (const float range : scene.cast({0, 0, 0}, directions, 10)) EXPECT_NEAR(range, 1.0f, 0.01f);
}

TEST(Scene, IsFreeBetweenWallsButNotInThem) {
  const Scene scene(hall());
  EXPECT_TRUE(scene.is_free({0, 0, 1}, 0.1f));
  EXPECT_FALSE(scene.is_free({5.25f, 0, 1}, 0.1f));
  EXPECT_FALSE(scene.is_free({0, 0, -0.25f}, 0.0f));
  EXPECT_FALSE(scene.is_free({4.95f, 0, 1}, 0.1f));
  EXPECT_TRUE(scene.is_free({4.85f, 0, 1}, 0.1f));
  EXPECT_TRUE(scene.is_free({20, 0, 1}, 0.1f));
}

TEST(Scene, IsFreeDoesNotCountADiagonalTwice) {
  // Straight above and below the diagonals of the boxes' faces and over their corners.
  const Scene scene({make_box({2, 2, 2}), moved(make_box({2, 2, 0.5}), 0, 0, 5)});
  for (const float x : {-1.0f, -0.5f, 0.0f, 0.25f, 1.0f}) {
    EXPECT_TRUE(scene.is_free({x, x, 3}, 0.1f)) << x;
    EXPECT_TRUE(scene.is_free({x, -x, 3}, 0.1f)) << x;
    EXPECT_TRUE(scene.is_free({x, x, -3}, 0.1f)) << x;
  }
  EXPECT_FALSE(scene.is_free({0, 0, 0}, 0.1f));
  EXPECT_FALSE(scene.is_free({0.5f, 0.5f, 0}, 0.1f));
}

TEST(Scene, IsFreeInARoomOfOneHollowBlock) {
  TriangleMesh cavity = make_box({4, 4, 4});
  for (auto& triangle : cavity.triangles) std::swap(triangle[0], triangle[1]);
  const Scene scene({make_box({6, 6, 6}), cavity});
  EXPECT_TRUE(scene.is_free({0, 0, 0}, 0.5f));
  EXPECT_FALSE(scene.is_free({2.5f, 0, 0}, 0.1f));
  EXPECT_TRUE(scene.is_free({0, 0, 8}, 0.5f));
}

TEST(Scene, IsFreeAgreesWithTheShapeOfASphere) {
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<float> place(-2, 2);
  const Scene scene({make_sphere(1)});
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3f point(place(engine), place(engine), place(engine));
    if (std::abs(point.norm() - 1.2f) < 0.02f) continue;
    EXPECT_EQ(scene.is_free(point, 0.2f), point.norm() > 1.2f) << point.transpose();
  }
}

TEST(Scene, OpenSheetsEncloseNothing) {
  const Scene scene({moved(make_rectangle(4, 4), 0, 0, 2)});
  EXPECT_TRUE(scene.is_free({0, 0, 1}, 0.5f));
  EXPECT_FALSE(scene.is_free({0, 0, 1.6f}, 0.5f));
}

TEST(Scene, RefusesBrokenMeshes) {
  TriangleMesh mesh = make_box({1, 1, 1});
  mesh.triangles.push_back({0, 1, 8});
  EXPECT_THROW(Scene({mesh}), std::invalid_argument);
  mesh = make_box({1, 1, 1});
  mesh.vertices[0].x() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(Scene({mesh}), std::invalid_argument);
}

TEST(Scene, ManyThreadsGetTheSameRanges) {
  const Scene scene(hall());
  std::mt19937_64 engine(5);
  const auto directions = random_directions(engine, 5000);
  const std::vector<float> expected = scene.cast({0, 0, 1}, directions, 100);
  std::atomic<int> different = 0;
  std::vector<std::jthread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&, copy = scene] {
      if (copy.cast({0, 0, 1}, directions, 100) != expected) ++different;
    });
  }
  threads.clear();
  EXPECT_EQ(different, 0);
}

// Run in a thread of its own, whose first use of TBB is Embree's.
TEST(Scene, LeavesDenormalsAloneInTasksThatFollow) {
  std::atomic<int> flushed = 0;
  std::thread([&] {
    const Scene scene(std::vector<TriangleMesh>(50, make_sphere(1)));
    tbb::parallel_for(0, 5000, [&](int) {
      volatile double tiny = 1e-310;
      if (!(tiny * 0.5 > 0.0)) ++flushed;
    });
  }).join();
  EXPECT_EQ(flushed, 0);
}

}  // namespace
}  // namespace alignability
