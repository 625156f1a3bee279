#include "exact/measure/distance/measure_pair.hpp"

namespace ecods::exact {

template ClosestFeatures find_closest(const IntegerPoints<OneLimbKernel, 6>&, const ExactFeatures<1>&,
                                      const ClosestFeatures&) noexcept;
template ClosestFeatures find_closest(const IntegerPoints<TwoLimbKernel, 6>&, const ExactFeatures<2>&,
                                      const ClosestFeatures&) noexcept;
template ClosestFeatures find_closest(const IntegerPoints<LimbKernel<4>, 6>&, const ExactFeatures<4>&,
                                      const ClosestFeatures&) noexcept;
template ClosestFeatures find_closest(const IntegerPoints<LimbKernel<8>, 6>&, const ExactFeatures<8>&,
                                      const ClosestFeatures&) noexcept;
template ClosestFeatures find_closest(const IntegerPoints<LimbKernel<20>, 6>&, const ExactFeatures<20>&,
                                      const ClosestFeatures&) noexcept;
template ClosestFeatures find_closest(const IntegerPoints<LimbKernel<limb_count_max>, 6>&,
                                      const ExactFeatures<limb_count_max>&, const ClosestFeatures&) noexcept;
template Relation triangle_pair(const ExactSigns<OneLimbKernel, 6>&);
template Relation triangle_pair(const ExactSigns<TwoLimbKernel, 6>&);
template Relation triangle_pair(const ExactSigns<LimbKernel<4>, 6>&);
template Relation triangle_pair(const ExactSigns<LimbKernel<8>, 6>&);
template Relation triangle_pair(const ExactSigns<LimbKernel<20>, 6>&);
template Relation triangle_pair(const ExactSigns<LimbKernel<limb_count_max>, 6>&);

}  // namespace ecods::exact
