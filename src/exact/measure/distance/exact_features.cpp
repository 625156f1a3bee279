#include "exact/measure/distance/exact_features.hpp"

namespace ecods::exact {

template class ExactFeatures<1>;
template class ExactFeatures<2>;
template class ExactFeatures<4>;
template class ExactFeatures<8>;
template class ExactFeatures<20>;
template class ExactFeatures<limb_count_max>;

}  // namespace ecods::exact
