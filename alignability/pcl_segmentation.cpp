// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/features/normal_3d.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/region_growing.h>

#include <limits>

#include "alignability/segmentation_engines.hpp"

namespace alignability::detail {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;
using Tree = pcl::search::KdTree<pcl::PointXYZ>;

// The points that count, and where in the scan each was.
struct Kept {
  Cloud::Ptr cloud{new Cloud};
  std::vector<std::int32_t> index;
};

Kept keep(const Scan& scan, double range_min) {
  Kept kept;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3f& point = scan.points[i];
    if (!counts(point, range_min)) continue;
    kept.cloud->push_back({point.x(), point.y(), point.z()});
    kept.index.push_back(static_cast<std::int32_t>(i));
  }
  return kept;
}

Normals::Ptr estimate_normals(const Cloud::Ptr& cloud, const Tree::Ptr& tree, int neighbours) {
  Normals::Ptr normals(new Normals);
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(tree);
  estimation.setKSearch(neighbours);
  estimation.compute(*normals);
  return normals;
}

std::vector<pcl::PointIndices> grow(const Cloud::Ptr& cloud, const Normals::Ptr& normals, const Tree::Ptr& tree,
                                    const SegmentationOptions& options) {
  pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal> growing;
  growing.setInputCloud(cloud);
  growing.setInputNormals(normals);
  growing.setSearchMethod(tree);
  growing.setNumberOfNeighbours(static_cast<unsigned int>(options.growing_neighbours));
  growing.setSmoothnessThreshold(static_cast<float>(options.smoothness));
  growing.setCurvatureThreshold(static_cast<float>(options.curvature));
  growing.setMinClusterSize(options.min_points);
  std::vector<pcl::PointIndices> clusters;
  growing.extract(clusters);
  return clusters;
}

}  // namespace

Segmentation segment_with_pcl(const Scan& scan, const SegmentationOptions& options) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Kept kept = keep(scan, options.range_min);
  Segmentation result;
  result.normals.assign(scan.points.size(), Eigen::Vector3f::Constant(nan));
  result.points = kept.index.size();
  if (kept.cloud->size() < static_cast<std::size_t>(std::max(options.min_points, 3))) return result;

  const Tree::Ptr tree(new Tree);
  const Normals::Ptr normals = estimate_normals(kept.cloud, tree, options.normal_neighbours);
  for (std::size_t i = 0; i < kept.index.size(); ++i)
    result.normals[static_cast<std::size_t>(kept.index[i])] = (*normals)[i].getNormalVector3fMap();
  for (const pcl::PointIndices& cluster : grow(kept.cloud, normals, tree, options)) {
    for (const auto member : cluster.indices) result.members.push_back(kept.index[static_cast<std::size_t>(member)]);
    result.ends.push_back(result.members.size());
  }
  return result;
}

}  // namespace alignability::detail
