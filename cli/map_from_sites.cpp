// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <iostream>

#include "alignability/sites_file.hpp"
#include "cli/exit_code.hpp"
#include "cli/failure.hpp"
#include "cli/interrupt.hpp"
#include "cli/map_output.hpp"
#include "cli/output_name.hpp"
#include "cli/scene_map.hpp"
#include "cli/scene_options.hpp"
#include "cli/sites_output.hpp"
#include "core/file.hpp"
#include "core/input_error.hpp"
#include "pictures/alignability_picture.hpp"

namespace alignability::cli {
namespace {

using Clock = std::chrono::steady_clock;

// What `map` would be asked for to build this one alone.
MapCommandOptions options_of(const MapSite& site, const MapCommandOptions& all) {
  MapCommandOptions options;
  options.scene = site.scene;
  options.reading = site.reading;
  options.occupancy = site.occupancy;
  options.sensor = site.sensor;
  options.map = site.map;
  options.map.threads = all.map.threads;
  options.headings = site.headings;
  options.output = site.output;
  options.pictures = all.pictures;
  return options;
}

// By which a later job knows what the map was made of.
std::string line_of_inputs(const std::string& digest) { return "inputs: " + digest + '\n'; }

// The map that an earlier job has made of the same inputs. One whose build is under way, or was cut short, has a checkpoint beside it.
std::optional<AlignabilityMap> finished_map(const MapCommandOptions& options, const std::string& digest) {
  const std::filesystem::path yaml = with_ending(output_name(options.output), ".yaml");
  if (!std::filesystem::exists(yaml) || std::filesystem::exists(checkpoint_of(options))) return std::nullopt;
  try {
    AlignabilityMap map = read_alignability_map(yaml);
    return map.provenance.find(line_of_inputs(digest)) == std::string::npos ? std::nullopt : std::optional(std::move(map));
  } catch (const InputError&) {  // a map that is damaged, or no map of ours: built anew
    return std::nullopt;
  }
}

void draw_what_is_missing(const AlignabilityMap& map, const OccupancyMap& occupancy, const MapCommandOptions& options) {
  const std::filesystem::path name = output_name(options.output);
  for (const auto& file : picture_files(name, options.pictures)) {
    if (!std::filesystem::exists(file)) draw_alignability_map(map, occupancy, {.title = name.filename().string(), .risk = {}}, file);
  }
}

SiteOutcome outcome_of(const std::string& name, const MapCommandOptions& options, Ranks& ranks, const std::stop_token& stop) {
  const auto begin = Clock::now();
  LedWork work(ranks, stop);
  SceneInputs inputs = read_inputs(options, read_scene);
  const std::string made_of = digest(inputs);
  work.compare([&] { return made_of; });
  const std::filesystem::path output = output_name(options.output);
  const auto files = map_files(output, options.pictures);
  if (const auto finished = finished_map(options, made_of)) {
    draw_what_is_missing(*finished, inputs.occupancy, options);
    return {name, "kept", site_figures(*finished, seconds_since(begin), files), ""};
  }
  inputs.map.threads = threads_of(options, ranks);
  inputs.map.stop = stop;
  inputs.map.spread = work.spread();
  AlignabilityMap built = build_telling(inputs, options, name);
  built.provenance += line_of_inputs(made_of);
  store_map(built, inputs.occupancy, output, options.pictures);
  std::filesystem::remove(checkpoint_of(options));
  return {name, "built", site_figures(built, seconds_since(begin), files), ""};
}

SiteOutcome outcome_or_failure(const MapSite& site, const MapCommandOptions& all, Ranks& ranks, const std::stop_token& stop) {
  try {
    return outcome_of(site.name, options_of(site, all), ranks, stop);
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    return {site.name, "failed", nullptr, sentence_of(error)};
  }
}

// The same sites on every rank, or none.
std::vector<MapSite> agreed_sites(const std::filesystem::path& file, Ranks& ranks, const std::stop_token& stop) {
  constexpr std::uintmax_t kLargest = 16u << 20;
  LedWork work(ranks, stop);
  std::vector<MapSite> sites = read_sites_file(file);
  work.compare([&] { return read_file(file, kLargest); });
  return sites;
}

int lead(const MapCommandOptions& options, Ranks& ranks, const std::stop_token& stop) {
  const std::vector<MapSite> sites = agreed_sites(options.sites, ranks, stop);
  std::vector<SiteOutcome> outcomes;
  try {
    for (const MapSite& site : sites) {
      outcomes.push_back(outcome_or_failure(site, options, ranks, stop));
      const SiteOutcome& last = outcomes.back();
      std::cerr << outcomes.size() << " of " << sites.size() << ", " << last.name << ": " << last.status
                << (last.error.empty() ? "" : ": " + last.error) << '\n';
      if (stop.stop_requested()) throw Interrupted();
    }
  } catch (const Interrupted&) {
    std::cerr << "\nalignability: interrupted; what is done of " << sites[std::min(outcomes.size(), sites.size() - 1)].name
              << " and all of the sites before it is kept, and the same command goes on from there\n";
    return kInterrupted;
  }
  options.json ? print_sites_json(outcomes) : print_sites(outcomes);
  return std::ranges::count(outcomes, "failed", &SiteOutcome::status) == 0 ? kYes : kNo;
}

void follow(const MapCommandOptions& options, Ranks& ranks, const std::stop_token& stop) {
  constexpr std::uintmax_t kLargest = 16u << 20;
  std::vector<MapSite> sites;
  is_wanted(ranks, [&] {
    sites = read_sites_file(options.sites);
    return read_file(options.sites, kLargest);
  });
  for (const MapSite& site : sites) help_to_build(options_of(site, options), ranks, stop);
}

}  // namespace

int map_from_sites(const MapCommandOptions& options) {
  const Interrupt interrupt;
  Ranks ranks;
  return run_on_ranks(
      ranks, [&] { return lead(options, ranks, interrupt.token()); }, [&] { follow(options, ranks, interrupt.token()); });
}

}  // namespace alignability::cli
