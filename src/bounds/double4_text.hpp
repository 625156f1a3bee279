// bounds/double4.hpp includes this source once for each instruction set.

// Returns v[0], v[1], v[2] and 0.
ECODS_ALWAYS_INLINE Double4 load3(const double* v) noexcept {
    return Double4{v[0], v[1], v[2], 0};
}

// Copies lane `lane` into all lanes.
template <int lane>
ECODS_ALWAYS_INLINE Double4 each(Double4 v) noexcept {
    return broadcast<Double4>(v[lane]);
}

ECODS_ALWAYS_INLINE double sum(Double4 v) noexcept {
    return (v[0] + v[1]) + v[2];
}

ECODS_ALWAYS_INLINE double dot(Double4 a, Double4 b) noexcept {
    return sum(a * b);
}

ECODS_ALWAYS_INLINE double largest(Double4 v) noexcept {
    const double m = v[0] > v[1] ? v[0] : v[1];
    return m > v[2] ? m : v[2];
}

ECODS_ALWAYS_INLINE Double4 cross(Double4 a, Double4 b) noexcept {
    const Double4 c = a * shuffle<1, 2, 0, 3>(b) - shuffle<1, 2, 0, 3>(a) * b;
    return shuffle<1, 2, 0, 3>(c);
}

// Holds the columns of a matrix of one body, or, if V is Double8, of two bodies in the halves of V.
template <class V>
struct Matrix {
    V column[3];
};
using Matrix4 = Matrix<Double4>;

ECODS_ALWAYS_INLINE Matrix4 load3(const Mat3& m) noexcept {
    return {{load3(m.data()), load3(m.data() + 3), load3(m.data() + 6)}};
}

ECODS_ALWAYS_INLINE Matrix4 transpose(const Matrix4& m) noexcept {
    return {{Double4{m.column[0][0], m.column[1][0], m.column[2][0], 0},
             Double4{m.column[0][1], m.column[1][1], m.column[2][1], 0},
             Double4{m.column[0][2], m.column[1][2], m.column[2][2], 0}}};
}

ECODS_ALWAYS_INLINE double largest(const Matrix4& m) noexcept {
    return std::max({largest(m.column[0]), largest(m.column[1]), largest(m.column[2])});
}

template <class V>
ECODS_ALWAYS_INLINE Matrix<V> absolute(const Matrix<V>& m) noexcept {
    return {{absolute(m.column[0]), absolute(m.column[1]), absolute(m.column[2])}};
}

template <class V>
ECODS_ALWAYS_INLINE V row_sums(const Matrix<V>& m) noexcept {
    return (m.column[0] + m.column[1]) + m.column[2];
}

template <class V>
ECODS_ALWAYS_INLINE V operator*(const Matrix<V>& m, V v) noexcept {
    return (m.column[0] * each<0>(v) + m.column[1] * each<1>(v)) + m.column[2] * each<2>(v);
}

template <class V>
ECODS_ALWAYS_INLINE Matrix<V> operator*(const Matrix<V>& a, const Matrix<V>& b) noexcept {
    return {{a * b.column[0], a * b.column[1], a * b.column[2]}};
}
