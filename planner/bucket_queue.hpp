// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace alignability::detail {

/// Nodes in the order of their keys, to a bucket's width: O(1) a node where a heap takes O(log n). A node may be pushed again with a lower
/// key; who visits the nodes pushes those that a visit improved, until none is left, and so ends where a strict order would have ended.
class BucketQueue {
 public:
  /// No key is ever pushed that is more than `span` above the one being visited.
  BucketQueue(std::size_t nodes, double width, double span)
      : width_(width), buckets_(static_cast<std::size_t>(span / width) + 3), waiting_(nodes, false) {}

  void push(std::size_t node, double key) {
    const auto turn = std::max(turn_, static_cast<std::size_t>(key / width_));
    buckets_[turn % buckets_.size()].push_back(static_cast<std::uint32_t>(node));
    waiting_[node] = true;
    ++count_;
  }

  /// Calls `visit(node)` until the queue is empty.
  template <typename Visit>
  void drain(Visit visit) {
    for (; count_ > 0; ++turn_) {
      std::vector<std::uint32_t>& bucket = buckets_[turn_ % buckets_.size()];
      for (std::size_t i = 0; i < bucket.size(); ++i) {
        const std::uint32_t node = bucket[i];
        if (!waiting_[node]) continue;
        waiting_[node] = false;
        visit(node);
      }
      count_ -= bucket.size();
      bucket.clear();
    }
  }

 private:
  double width_;
  std::vector<std::vector<std::uint32_t>> buckets_;  // by turn, around
  std::vector<std::uint8_t> waiting_;
  std::size_t turn_ = 0;
  std::size_t count_ = 0;
};

}  // namespace alignability::detail
