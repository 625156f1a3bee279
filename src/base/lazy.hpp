// Lazy holds a value that is made on first use.
#pragma once

#include <atomic>
#include <mutex>
#include <optional>

namespace ecods {

// Many threads may call get() at once: one thread makes the value, and the others wait for it. If make() throws, the
// exception reaches the caller, and the next call tries again. Once the value exists, get() costs one atomic load.
template <class T>
class Lazy {
  public:
    template <class Make>
    const T& get(Make&& make) {
        if (const T* value = made_.load(std::memory_order_acquire)) return *value;
        const std::lock_guard lock(mutex_);
        if (!value_) {
            value_.emplace(make());
            made_.store(&*value_, std::memory_order_release);
        }
        return *value_;
    }

  private:
    std::atomic<const T*> made_ = nullptr;
    std::mutex mutex_;
    std::optional<T> value_;
};

}  // namespace ecods
