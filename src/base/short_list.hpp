// A ShortList is a list of trivially copyable values. The list is stored in the object itself until it has more than N
// values, and in allocated memory from then on.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

#include "base/assert.hpp"

namespace ecods {

template <class T, std::size_t N>
class ShortList {
    static_assert(std::is_trivially_copyable_v<T>);

  public:
    ShortList() noexcept = default;
    ShortList(const ShortList& other) { *this = other; }
    ShortList(ShortList&& other) noexcept { *this = std::move(other); }
    ShortList& operator=(const ShortList& other) {
        if (this == &other) return *this;
        size_ = 0;
        reserve(other.size_);
        std::copy_n(other.data(), other.size_, data());
        size_ = other.size_;
        return *this;
    }
    ShortList& operator=(ShortList&& other) noexcept {
        if (this == &other) return *this;
        size_ = std::exchange(other.size_, 0);
        capacity_ = std::exchange(other.capacity_, N);
        large_ = std::move(other.large_);
        if (!large_) std::copy_n(other.small_.begin(), size_, small_.begin());
        return *this;
    }
    ~ShortList() = default;

    std::size_t size() const noexcept { return size_; }
    bool empty() const noexcept { return size_ == 0; }
    T* data() noexcept { return large_ ? large_.get() : small_.data(); }
    const T* data() const noexcept { return large_ ? large_.get() : small_.data(); }
    T* begin() noexcept { return data(); }
    T* end() noexcept { return data() + size_; }
    const T* begin() const noexcept { return data(); }
    const T* end() const noexcept { return data() + size_; }
    T& operator[](std::size_t i) noexcept {
        ECODS_ASSERT(i < size_);
        return data()[i];
    }
    const T& operator[](std::size_t i) const noexcept {
        ECODS_ASSERT(i < size_);
        return data()[i];
    }

    void clear() noexcept { size_ = 0; }
    void push_back(const T& value) {
        const T copy = value;  // the value may be in this list
        if (size_ == capacity_) reserve(2 * capacity_);
        data()[size_++] = copy;
    }
    // Sets the list to `count` copies of the value.
    void assign(std::size_t count, const T& value) {
        const T copy = value;
        size_ = 0;
        reserve(count);
        std::fill_n(data(), count, copy);
        size_ = count;
    }

  private:
    void reserve(std::size_t capacity) {
        if (capacity <= capacity_) return;
        auto larger = std::make_unique_for_overwrite<T[]>(capacity);
        std::copy_n(data(), size_, larger.get());
        large_ = std::move(larger);
        capacity_ = capacity;
    }

    std::size_t size_ = 0, capacity_ = N;
    std::unique_ptr<T[]> large_;
    std::array<T, N> small_;
};

}  // namespace ecods
