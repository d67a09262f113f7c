#include "cli/validate_pictures.hpp"
namespace alignability::cli {
void draw_error_maps(std::span<const Validation>, const PlanProblem&, const DrivenPath&, const std::filesystem::path&) {}
void draw_profiles(std::span<const Validation>, std::span<const DrivenPath>, const RiskField&, const std::filesystem::path&) {}
}
