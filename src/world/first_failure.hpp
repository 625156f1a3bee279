// Chooses the error that an update throws if the tests of several pairs threw errors.
#pragma once

#include <exception>
#include <mutex>
#include <utility>

#include "ecods/ids.hpp"

namespace ecods {

// FirstFailure keeps the error of the pair with the least ids, which need not be the earliest error in time. So the
// error that an update throws depends neither on the workers nor on the order of the tests.
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
