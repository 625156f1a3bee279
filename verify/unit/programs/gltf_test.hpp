// A small glTF assembly to be changed and read.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "file_test.hpp"
#include "scenes/io/gltf_file.hpp"

namespace ecods::scenes {

using Json = nlohmann::json;

template <class T>
std::string bytes_of(std::initializer_list<T> values) {
    std::string bytes;
    for (const T& value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    return bytes;
}

class ReadGltf : public FileTest {
  protected:
    // Five points and the indices 0 to 4 as bytes, in data.bin; one node.
    static std::string data() {
        return bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0.1F, 2, 2, 2}) +
               bytes_of<std::uint8_t>({0, 1, 2, 3, 4});
    }

    static Json model() {
        return {{"asset", {{"version", "2.0"}}},
                {"buffers", {{{"uri", "data.bin"}, {"byteLength", 65}}}},
                {"bufferViews",
                 {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 60}},
                  {{"buffer", 0}, {"byteOffset", 60}, {"byteLength", 5}}}},
                {"accessors",
                 {{{"bufferView", 0}, {"componentType", 5126}, {"count", 5}, {"type", "VEC3"}},
                  {{"bufferView", 1}, {"componentType", 5121}, {"count", 3}, {"type", "SCALAR"}}}},
                {"meshes", {{{"name", "m"}, {"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}},
                {"nodes", {{{"name", "part"}, {"mesh", 0}}}},
                {"scenes", {{{"nodes", {0}}}}},
                {"scene", 0}};
    }

    // A new accessor of a buffer of its own; its index.
    std::size_t add_accessor(Json& json, const std::string& bytes, Json accessor) const {
        const std::string name = "buffer" + std::to_string(json["buffers"].size()) + ".bin";
        write(name, bytes);
        accessor["bufferView"] = json["bufferViews"].size();
        json["bufferViews"].push_back({{"buffer", json["buffers"].size()}, {"byteLength", bytes.size()}});
        json["buffers"].push_back({{"uri", name}, {"byteLength", bytes.size()}});
        json["accessors"].push_back(std::move(accessor));
        return json["accessors"].size() - 1;
    }

    Scene read(const Json& json) {
        write("data.bin", data());
        return read_gltf_file(write("m.gltf", json.dump()));
    }

    void expect_bad(const Json& json, const std::string& place, const std::string& text) {
        write("data.bin", data());
        const auto file = write("m.gltf", json.dump());
        expect_error([&] { read_gltf_file(file); }, file, place, text);
    }

    static std::string binary(const Json& json, std::string buffer) {
        std::string text = json.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
        const auto size = [](std::size_t bytes) { return static_cast<std::uint32_t>(bytes); };
        return "glTF" +
               bytes_of<std::uint32_t>({2, size(28 + text.size() + buffer.size()), size(text.size()), 0x4E4F534A}) +
               text + bytes_of<std::uint32_t>({size(buffer.size()), 0x004E4942}) + buffer;
    }
};

}  // namespace ecods::scenes
