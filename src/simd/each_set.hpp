// Includes the file ECODS_TEXT in the region of each instruction set whose registers have a width of their own. The
// text has no includes, as what it needs is included before, and ECODS_SET is the namespace that it stands in.

#define ECODS_SET baseline
namespace ecods::baseline {
#include ECODS_TEXT
}  // namespace ecods::baseline
#undef ECODS_SET

#if ECODS_CAN_DISPATCH
#define ECODS_SET avx2
ECODS_BEGIN_AVX2
namespace ecods::avx2 {
#include ECODS_TEXT
}  // namespace ecods::avx2
ECODS_END_REGION
#undef ECODS_SET
#endif

#undef ECODS_TEXT
