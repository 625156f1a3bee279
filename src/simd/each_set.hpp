// Includes the file ECODS_TEXT in the region of each instruction set that has its own width of registers. The text has
// no includes: the headers that it needs are included before. ECODS_SET is the namespace in which the text stands.

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
