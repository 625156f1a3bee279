#include "exact/measure/distance/closest_points.hpp"

namespace ecods::exact {

template void find_closest_points(const ExactFeatures<1>&, const FeaturePair&, int,
                                  std::array<ExactPoint, 2>&) noexcept;
template void find_closest_points(const ExactFeatures<2>&, const FeaturePair&, int,
                                  std::array<ExactPoint, 2>&) noexcept;
template void find_closest_points(const ExactFeatures<4>&, const FeaturePair&, int,
                                  std::array<ExactPoint, 2>&) noexcept;
template void find_closest_points(const ExactFeatures<8>&, const FeaturePair&, int,
                                  std::array<ExactPoint, 2>&) noexcept;
template void find_closest_points(const ExactFeatures<20>&, const FeaturePair&, int,
                                  std::array<ExactPoint, 2>&) noexcept;
template void find_closest_points(const ExactFeatures<limb_count_max>&, const FeaturePair&, int,
                                  std::array<ExactPoint, 2>&) noexcept;

}  // namespace ecods::exact
