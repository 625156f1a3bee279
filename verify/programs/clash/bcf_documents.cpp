#include "programs/clash/bcf_documents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <set>

#include "programs/clash/guid.hpp"
#include "programs/clash/picture/composite.hpp"
#include "programs/clash/text.hpp"

namespace ecods::clash {
namespace {

constexpr std::size_t line_limit = 100;  // of those that a viewer is to draw

struct StringWriter : pugi::xml_writer {
    std::string text;

    void write(const void* data, std::size_t size) override { text.append(static_cast<const char*>(data), size); }
};

std::string text_of(const pugi::xml_document& document) {
    StringWriter writer;
    document.save(writer, "  ", pugi::format_default, pugi::encoding_utf8);
    return writer.text;
}

pugi::xml_node begin_document(pugi::xml_document& document, const char* root) {
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    return document.append_child(root);
}

void add_text(pugi::xml_node parent, const char* name, const std::string& text) {
    parent.append_child(name).text().set(text.c_str());
}

void add_point(pugi::xml_node parent, const char* name, const Vec3& point) {
    pugi::xml_node node = parent.append_child(name);
    constexpr std::array<const char*, 3> names{"X", "Y", "Z"};
    for (std::size_t axis = 0; axis < 3; ++axis)
        add_text(node, names[axis], fmt::format("{}", point[static_cast<Eigen::Index>(axis)]));
}

std::string hexadecimal(const Rgb& color) {
    return fmt::format("{:02X}{:02X}{:02X}", color[0], color[1], color[2]);
}

void add_component(pugi::xml_node parent, const Part& part) {
    pugi::xml_node component = parent.append_child("Component");
    const std::string_view guid = ifc_guid_in(part.name);
    if (!guid.empty()) component.append_attribute("IfcGuid") = std::string(guid).c_str();
    add_text(component, "OriginatingSystem", "ecods_clash");
    add_text(component, "AuthoringToolId", xml_characters(part.name));
}

// What a person reads of a clash.
std::string description(const Clash& clash) {
    std::string text = fmt::format("Relation of the first to the second: {}.", clash.relation);
    if (clash.depth) text += fmt::format("\nDepth: from {} to {}.", clash.depth->lower, clash.depth->upper);
    if (clash.distance) text += fmt::format("\nDistance: {}.", *clash.distance);
    const Aabb& box = clash.place.box;
    text += fmt::format("\nWhere: x {} to {}, y {} to {}, z {} to {}.", box.min.x(), box.max.x(), box.min.y(),
                        box.max.y(), box.min.z(), box.max.z());
    return text;
}

}  // namespace

std::string topic_guid(const ClashReport& report, const Clash& clash) {
    return guid_of({"topic", report.parts[clash.a].name, report.parts[clash.b].name});
}

std::string bcf_version() {
    pugi::xml_document document;
    pugi::xml_node root = begin_document(document, "Version");
    root.append_attribute("VersionId") = "2.1";
    add_text(root, "DetailedVersion", "2.1");
    return text_of(document);
}

std::string bcf_markup(const ClashReport& report, std::size_t index, bool has_picture, const std::string& date) {
    const Clash& clash = report.clashes[index];
    const Part& a = report.parts[clash.a];
    const Part& b = report.parts[clash.b];
    pugi::xml_document document;
    pugi::xml_node root = begin_document(document, "Markup");
    pugi::xml_node header = root.append_child("Header");
    for (const std::string& file : std::set<std::string>{a.file, b.file}) {
        pugi::xml_node node = header.append_child("File");
        node.append_attribute("isExternal") = "true";
        add_text(node, "Filename", xml_characters(file));
    }
    pugi::xml_node topic = root.append_child("Topic");
    topic.append_attribute("Guid") = topic_guid(report, clash).c_str();
    topic.append_attribute("TopicType") = "Clash";
    topic.append_attribute("TopicStatus") = "Open";
    const std::string kind(name_of(clash.kind));
    add_text(topic, "Title", xml_characters(fmt::format("{}: {} | {}", kind, a.name, b.name)));
    add_text(topic, "Index", fmt::format("{}", index));
    add_text(topic, "Labels", kind);
    add_text(topic, "CreationDate", date);
    add_text(topic, "CreationAuthor", "ecods_clash");
    add_text(topic, "Description", description(clash));
    pugi::xml_node view = root.append_child("Viewpoints");
    view.append_attribute("Guid") = guid_of({"viewpoint", a.name, b.name}).c_str();
    add_text(view, "Viewpoint", "viewpoint.bcfv");
    if (has_picture) add_text(view, "Snapshot", "snapshot.png");
    add_text(view, "Index", "0");
    return text_of(document);
}

std::string bcf_viewpoint(const ClashReport& report, std::size_t index, const Camera& camera) {
    const Clash& clash = report.clashes[index];
    const Part& a = report.parts[clash.a];
    const Part& b = report.parts[clash.b];
    pugi::xml_document document;
    pugi::xml_node root = begin_document(document, "VisualizationInfo");
    root.append_attribute("Guid") = guid_of({"viewpoint", a.name, b.name}).c_str();
    pugi::xml_node components = root.append_child("Components");
    pugi::xml_node selection = components.append_child("Selection");
    add_component(selection, a);
    add_component(selection, b);
    components.append_child("Visibility").append_attribute("DefaultVisibility") = "true";
    pugi::xml_node coloring = components.append_child("Coloring");
    for (const auto& [part, color] : {std::pair(&a, first_color), std::pair(&b, second_color)}) {
        pugi::xml_node node = coloring.append_child("Color");
        node.append_attribute("Color") = hexadecimal(color).c_str();
        add_component(node, *part);
    }
    pugi::xml_node view = root.append_child("OrthogonalCamera");
    add_point(view, "CameraViewPoint", camera.target - camera.forward * camera.distance);
    add_point(view, "CameraDirection", camera.forward);
    add_point(view, "CameraUpVector", camera.up);
    add_text(view, "ViewToWorldScale", fmt::format("{}", 2 * camera.half_height));
    if (clash.place.lines.empty()) return text_of(document);
    pugi::xml_node lines = root.append_child("Lines");
    for (std::size_t i = 0; i < std::min(clash.place.lines.size(), line_limit); ++i) {
        pugi::xml_node line = lines.append_child("Line");
        add_point(line, "StartPoint", clash.place.lines[i][0]);
        add_point(line, "EndPoint", clash.place.lines[i][1]);
    }
    return text_of(document);
}

}  // namespace ecods::clash
