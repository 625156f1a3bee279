// Includes the file ECODS_TEXT once for each instruction set with its own width of registers, in the region and the
// namespace ECODS_SET of that set. The file must not include anything; include the headers that it needs before this
// one.

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
