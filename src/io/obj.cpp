#include "raytracing/io/obj.h"

#include <algorithm>
#include <cctype>
#include <cfloat>
#include <unordered_map>

#include "text_cursor.h"

namespace raytracing {
namespace {

using Severity = LoadReport::Severity;
constexpr int kMostUnknownKeywords = 20;

// The vertices, texture coordinates or normals, which faces refer to by number.
struct Pool {
  const char* noun;
  std::int64_t count = 0;          // the number of those read so far
  std::int64_t limit = INT64_MAX;  // their number in the whole file, once it is known
};

// Reads a file once. If a face precedes what it refers to, the file is read again, and that time
// faces find everything in the mesh of the first reading.
class ObjParser {
 public:
  // All arguments must outlive the parser. `first` is the first reading, or null.
  ObjParser(std::string_view text, const std::string& file, LoadReport& report,
            const ObjParser* first);

  void run() {
    while (!cursor_.at_end()) record();
  }
  // Returns true if a face precedes what it refers to. Faces are then incomplete.
  bool refers_ahead() const { return refers_ahead_; }
  ObjModel take() { return std::move(model_); }

 private:
  struct Keyword {
    std::string_view name;
    void (ObjParser::*read)(const TextPlace& where);
  };
  static const Keyword kKeywords[];

  void record();
  void vertex(const TextPlace& where);
  void vertex_normal(const TextPlace& where);
  void texture_coordinate(const TextPlace& where) {
    ++textures_.count;
    ignore(where, "texture coordinate");
  }
  void face(const TextPlace& where);
  PolygonMesh::Corner corner();
  std::uint32_t index(Pool& pool);
  bool remove_repeated_corners(std::size_t first);
  bool has_area(std::size_t first);
  void use_material(const TextPlace& where);
  std::uint32_t find_material(const std::string& name, const TextPlace& where);
  void libraries(const TextPlace& where);
  void line(const TextPlace& where) { ignore(where, "line"); }
  void point(const TextPlace& where) { ignore(where, "point"); }
  void parameter_vertex(const TextPlace& where) { ignore(where, "parameter-space vertex"); }
  void group(const TextPlace&) { cursor_.skip_record(); }
  void ignore(const TextPlace& where, std::string_view kind) {
    note(Severity::ignored, kind, where);
    cursor_.skip_record();
  }
  void note(Severity severity, std::string_view kind, const TextPlace& where) {
    report_.add(severity, kind, cursor_.file(), where);
  }

  LoadReport& report_;
  TextCursor cursor_;
  ObjModel model_;
  PolygonMesh& mesh_ = model_.mesh;
  const PolygonMesh& known_;  // what faces refer to
  Pool vertices_{"vertex"}, textures_{"texture coordinate"}, normals_{"normal"};
  bool refers_ahead_ = false;
  bool has_zero_normals_ = false;  // so that others are not looked at
  std::unordered_map<std::string, std::uint32_t> material_numbers_;
  std::uint32_t material_ = kNone;  // kNone: not chosen yet
  std::vector<Vec3> outline_;       // scratch memory of has_area()
};

// The most frequent records come first.
constexpr ObjParser::Keyword ObjParser::kKeywords[] = {
    {"v", &ObjParser::vertex},
    {"f", &ObjParser::face},
    {"vn", &ObjParser::vertex_normal},
    {"vt", &ObjParser::texture_coordinate},
    {"usemtl", &ObjParser::use_material},
    {"mtllib", &ObjParser::libraries},
    {"l", &ObjParser::line},
    {"p", &ObjParser::point},
    {"vp", &ObjParser::parameter_vertex},
    {"g", &ObjParser::group},
    {"o", &ObjParser::group},
    {"s", &ObjParser::group},
};

// Allocates each array at about the size that it will have: growing would take twice the memory.
// Wrong sizes, for files with an odd layout, cost address space or time but nothing else.
void reserve(PolygonMesh& mesh, std::string_view text) {
  std::size_t positions = 1, normals = 1, faces = 1, corners = 3;  // of the first line
  std::size_t end = text.find('\n');
  while (end < text.size() - 2) {
    const char first = text[end + 1], second = text[end + 2];
    const std::size_t start = end + 1;
    end = text.find('\n', start);
    positions += first == 'v' && second == ' ';
    normals += first == 'v' && second == 'n';
    if (first != 'f') continue;
    ++faces;
    const std::string_view line = text.substr(start, end - start);
    corners += static_cast<std::size_t>(std::count(line.begin(), line.end(), ' '));
  }
  mesh.positions.reserve(positions);
  mesh.normals.reserve(normals);
  mesh.faces.reserve(faces);
  mesh.corners.reserve(corners);
}

ObjParser::ObjParser(std::string_view text, const std::string& file, LoadReport& report,
                     const ObjParser* first)
    : report_(report), cursor_(text, file), known_(first ? first->mesh_ : mesh_) {
  if (text.size() > 2) reserve(mesh_, text);
  if (!first) return;
  vertices_.limit = first->vertices_.count;
  textures_.limit = first->textures_.count;
  normals_.limit = first->normals_.count;
  has_zero_normals_ = first->has_zero_normals_;
}

void ObjParser::record() {
  cursor_.skip_blanks();
  if (cursor_.at_record_end()) return cursor_.finish_record();
  const TextPlace where = cursor_.place();
  const std::string_view name = cursor_.token();
  for (const Keyword& keyword : kKeywords)
    if (name == keyword.name) return (this->*keyword.read)(where);
  report_.add_keyword("unknown keyword", name, cursor_.file(), where, kMostUnknownKeywords);
  cursor_.skip_record();
}

// Reads x y z and, if present, a weight w, a colour r g b or a colour r g b a.
void ObjParser::vertex(const TextPlace& where) {
  const float x = cursor_.number("x"), y = cursor_.number("y"), z = cursor_.number("z");
  if (vertices_.count >= kNone) cursor_.fail(where, "too many vertices");
  mesh_.positions.emplace_back(x, y, z);
  ++vertices_.count;
  cursor_.skip_blanks();
  if (!cursor_.at_record_end()) {
    const float w = cursor_.number("a vertex weight or colour");
    cursor_.skip_blanks();
    if (!cursor_.at_record_end()) {
      cursor_.number("green");
      cursor_.number("blue");
      cursor_.skip_blanks();
      if (!cursor_.at_record_end()) cursor_.number("alpha");
      note(Severity::ignored, "vertex colour", where);
    } else if (w != 1) {
      note(Severity::ignored, "vertex weight", where);
    }
  }
  cursor_.finish_record();
}

void ObjParser::vertex_normal(const TextPlace& where) {
  const float x = cursor_.number("x"), y = cursor_.number("y"), z = cursor_.number("z");
  cursor_.finish_record();
  if (normals_.count >= kNone) cursor_.fail(where, "too many normals");
  ++normals_.count;
  Vec3 normal(x, y, z);
  const float squared = dot(normal, normal);
  if (normal == Vec3(0.0f)) {
    note(Severity::repaired, "normal of length zero", where);
    has_zero_normals_ = true;
  } else if (!(squared >= FLT_MIN && squared <= FLT_MAX)) {
    normal /= max_component(absolute(normal));  // or normalizing it would give 0 or NaN
  }
  mesh_.normals.push_back(normal);
}

// Reads an index, which counts from 1, or backwards from the last record if it is negative. Returns
// it counted from 0; kNone for 0.
std::uint32_t ObjParser::index(Pool& pool) {
  const TextPlace where = cursor_.place();
  std::int64_t number;
  if (!cursor_.integer(number)) {
    cursor_.fail(
        where, std::string("expected a ") + pool.noun + " index, found " + quoted(cursor_.token()));
  }
  if (number > 0) {
    if (number > pool.limit) {
      cursor_.fail(where, std::string(pool.noun) + " index " + std::to_string(number) +
                              " is out of range; the file has " + std::to_string(pool.limit));
    }
    const bool whole_file_known = pool.limit != INT64_MAX;
    if (number > pool.count && !whole_file_known) refers_ahead_ = true;
    return static_cast<std::uint32_t>(std::min<std::int64_t>(number, kNone) - 1);
  }
  if (number == 0) return kNone;
  if (number < -pool.count) {
    cursor_.fail(where, std::string(pool.noun) + " index " + std::to_string(number) +
                            " is out of range; only " + std::to_string(pool.count) + " precede it");
  }
  return static_cast<std::uint32_t>(pool.count + number);
}

// Reads v, v/vt, v//vn or v/vt/vn, where vt and vn may be empty or 0.
PolygonMesh::Corner ObjParser::corner() {
  const TextPlace where = cursor_.place();
  PolygonMesh::Corner corner{index(vertices_)};
  if (corner.position == kNone)
    cursor_.fail(where, "vertex index 0 is invalid; the first vertex has index 1");
  if (cursor_.accept('/')) {
    bool more = cursor_.accept('/');
    if (!more && !cursor_.at_separator()) {
      index(textures_);
      more = cursor_.accept('/');
    }
    if (more && !cursor_.at_separator()) corner.normal = index(normals_);
    if (has_zero_normals_ && corner.normal < known_.normals.size() &&
        known_.normals[corner.normal] == Vec3(0.0f))
      corner.normal = kNone;
  }
  if (!cursor_.at_separator()) {
    const TextPlace rest = cursor_.place();
    cursor_.fail(rest, "unexpected " + quoted(cursor_.token()) + " in a face corner");
  }
  return corner;
}

void ObjParser::face(const TextPlace& where) {
  auto& corners = mesh_.corners;
  const std::size_t first = corners.size();
  for (cursor_.skip_blanks(); !cursor_.at_record_end(); cursor_.skip_blanks())
    corners.push_back(corner());
  if (corners.size() < first + 3) {
    cursor_.fail(cursor_.place(), "truncated record: a face needs at least 3 corners, found " +
                                      std::to_string(corners.size() - first));
  }
  cursor_.finish_record();
  if (corners.size() >= kNone) cursor_.fail(where, "too many face corners");
  if (material_ == kNone) material_ = find_material("", where);
  const bool repeated = remove_repeated_corners(first);
  const char* fault = nullptr;
  if (corners.size() < first + 3)
    fault = "face with fewer than 3 different corners";
  else if (!refers_ahead_ && !has_area(first))
    fault = "face without area";
  if (fault) {
    corners.resize(first, {});
    return note(Severity::dropped, fault, where);
  }
  if (repeated) note(Severity::repaired, "face with a repeated corner", where);
  mesh_.faces.push_back({static_cast<std::uint32_t>(first),
                         static_cast<std::uint32_t>(corners.size() - first), material_});
}

// Keeps one of each run of corners at the same vertex, where the first corner follows the last.
bool ObjParser::remove_repeated_corners(std::size_t first) {
  auto& corners = mesh_.corners;
  const std::size_t before = corners.size();
  const auto same = [](const auto& a, const auto& b) { return a.position == b.position; };
  corners.erase(std::unique(corners.begin() + first, corners.end(), same), corners.end());
  while (corners.size() > first + 1 && same(corners.back(), corners[first])) corners.pop_back();
  return corners.size() < before;
}

bool ObjParser::has_area(std::size_t first) {
  outline_.clear();
  for (std::size_t i = first; i < mesh_.corners.size(); ++i)
    outline_.push_back(known_.positions[mesh_.corners[i].position]);
  return newell_normal(outline_) != DVec3(0.0);
}

void ObjParser::use_material(const TextPlace& where) {
  const std::string name = cursor_.name();
  if (name.empty()) note(Severity::warning, "usemtl without a name", where);
  cursor_.finish_record();
  material_ = find_material(name, where);
}

std::uint32_t ObjParser::find_material(const std::string& name, const TextPlace& where) {
  const auto number = static_cast<std::uint32_t>(model_.materials.size());
  const auto [found, added] = material_numbers_.try_emplace(name, number);
  if (added) model_.materials.push_back({name, cursor_.location(where)});
  return found->second;
}

bool ends_in_mtl(std::string_view name) {
  if (name.size() < 4) return false;
  name.remove_prefix(name.size() - 4);
  return std::equal(name.begin(), name.end(), ".mtl", [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == b;
  });
}

// Takes several names that all end in .mtl for several libraries, anything else for one name that
// may contain spaces.
void ObjParser::libraries(const TextPlace& keyword) {
  cursor_.skip_blanks();
  const TextPlace where = cursor_.place();
  std::vector<ObjModel::Library> several;
  TextCursor ahead = cursor_;
  for (; !ahead.at_record_end(); ahead.skip_blanks()) {
    const TextPlace start = ahead.place();
    const std::string_view name = ahead.token();
    if (!ends_in_mtl(name)) {
      several.clear();
      break;
    }
    several.push_back({std::string(name), ahead.location(start)});
  }
  const std::string whole = cursor_.name();
  cursor_.finish_record();
  if (several.empty() && !whole.empty()) several.push_back({whole, cursor_.location(where)});
  if (several.empty()) note(Severity::warning, "mtllib without a name", keyword);
  auto& all = model_.libraries;
  all.insert(all.end(), several.begin(), several.end());
}

}  // namespace

ObjModel parse_obj(std::string_view text, const std::string& file, LoadReport& report) {
  LoadReport first_report = report;
  ObjParser first(text, file, first_report, nullptr);
  first.run();
  if (!first.refers_ahead()) {
    report = std::move(first_report);
    return first.take();
  }
  ObjParser second(text, file, report, &first);
  second.run();
  return second.take();
}

}  // namespace raytracing
