// Keeps the error that an update throws when the tests of several pairs threw.
#pragma once

#include <exception>
#include <mutex>
#include <utility>

#include "ecods/ids.hpp"

namespace ecods {

// Keeps the error of the first pair, in the order of pairs and not of time. So the error that is thrown depends neither
// on workers nor on history.
class FirstFailure {
  public:
    void keep(const BodyPair& bodies, std::exception_ptr error) {
        const std::lock_guard lock(mutex_);
        if (error_ && bodies > bodies_) return;
        bodies_ = bodies;
        error_ = std::move(error);
    }
    void rethrow() const {
        if (error_) std::rethrow_exception(error_);
    }

  private:
    std::mutex mutex_;
    BodyPair bodies_;
    std::exception_ptr error_;
};

}  // namespace ecods
