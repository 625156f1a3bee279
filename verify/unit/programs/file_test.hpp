// Tests that write files and read them.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "scenes/io/read_error.hpp"

namespace ecods::scenes {

// Each test has a folder of its own, which goes with it.
class FileTest : public testing::Test {
  protected:
    FileTest() {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() / (std::string("ecods_") + info->test_suite_name() + "_" +
                                                            info->name() + "_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
    }
    ~FileTest() override {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    std::filesystem::path path(const std::string& name) const { return folder_ / name; }

    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        // Some file systems flush a file that is truncated and written again, but not a new one.
        std::filesystem::remove(path(name));
        std::ofstream(path(name), std::ios::binary) << bytes;
        return path(name);
    }

    // Expects a ReadError that names the file, the place, and contains the text.
    static void expect_error(const std::function<void()>& read, const std::filesystem::path& file,
                             const std::string& place, const std::string& text) {
        try {
            read();
            ADD_FAILURE() << "no error where this was expected: " << place << ": " << text;
        } catch (const ReadError& error) {
            EXPECT_EQ(error.file, file);
            EXPECT_EQ(error.place, place) << error.what();
            EXPECT_NE(error.text.find(text), std::string::npos) << error.what();
            EXPECT_TRUE(std::string(error.what()).starts_with(file.string() + ": ")) << error.what();
        }
    }

  private:
    std::filesystem::path folder_;
};

}  // namespace ecods::scenes
