#include "raytracing/io/obj.h"

#include <algorithm>
#include <cctype>
#include <unordered_map>

#include "obj_mesh_builder.h"
#include "text_cursor.h"

namespace raytracing {
namespace {

using Severity = LoadReport::Severity;
constexpr int kMostUnknownKeywords = 20;

// The vertices, texture coordinates or normals, which faces refer to by number.
struct Pool {
  const char* noun;
  std::int64_t count = 0;          // defined so far
  std::int64_t highest = 0;        // highest number used; it may be defined later in the file
  std::int64_t limit = INT64_MAX;  // highest number allowed, once the whole file is known
};

class ObjParser {
 public:
  ObjParser(std::string_view text, const std::string& file, LoadReport& report)
      : text_(text), report_(report), cursor_(text, file) {}

  // Parses the text but does not check whether numbers are too high.
  void run();
  // True if every number used is defined somewhere in the file.
  bool complete() const;
  // Parses with the counts of `other` as limits: throws at the first number beyond them.
  void rerun_within(const ObjParser& other);

  ObjModel take();

 private:
  void record();
  void vertex(const TextPlace& where);
  void vertex_normal(const TextPlace& where);
  void face(const TextPlace& where);
  PolygonMesh::Corner corner();
  std::uint32_t index(Pool& pool);
  void use_material(const TextPlace& where);
  std::uint32_t find_material(const std::string& name, const TextPlace& where);
  void libraries(const TextPlace& where);
  void note(Severity severity, std::string_view kind, const TextPlace& where) {
    report_.add(severity, kind, cursor_.file(), where);
  }
  void ignore(const TextPlace& where, std::string_view kind) {
    note(Severity::ignored, kind, where);
    cursor_.skip_record();
  }

  std::string_view text_;
  LoadReport& report_;
  TextCursor cursor_;
  ObjModel model_;
  ObjMeshBuilder builder_{cursor_.file(), report_};
  Pool vertices_{"vertex"}, textures_{"texture coordinate"}, normals_{"normal"};
  std::unordered_map<std::string, std::uint32_t> material_numbers_;
  std::uint32_t material_ = kNone;  // kNone: not chosen yet
};

void ObjParser::run() {
  builder_.reserve_for(text_);
  while (!cursor_.at_end()) record();
}

bool ObjParser::complete() const {
  const auto holds = [](const Pool& pool) { return pool.highest <= pool.count; };
  return holds(vertices_) && holds(textures_) && holds(normals_);
}

void ObjParser::rerun_within(const ObjParser& other) {
  vertices_.limit = other.vertices_.count;
  textures_.limit = other.textures_.count;
  normals_.limit = other.normals_.count;
  while (!cursor_.at_end()) record();
}

ObjModel ObjParser::take() {
  model_.mesh = builder_.finish();
  return std::move(model_);
}

void ObjParser::record() {
  cursor_.skip_blanks();
  if (cursor_.at_record_end()) return cursor_.finish_record();
  const TextPlace where = cursor_.place();
  // The most frequent records, without a search for the end of the keyword.
  if (cursor_.accept_keyword('f')) return face(where);
  if (cursor_.accept_keyword('v')) return vertex(where);
  if (cursor_.accept_keyword('v', 'n')) return vertex_normal(where);
  const std::string_view keyword = cursor_.token();
  if (keyword == "v") return vertex(where);
  if (keyword == "f") return face(where);
  if (keyword == "vn") return vertex_normal(where);
  if (keyword == "vt") {
    ++textures_.count;
    return ignore(where, "texture coordinate");
  }
  if (keyword == "usemtl") return use_material(where);
  if (keyword == "mtllib") return libraries(where);
  if (keyword == "g" || keyword == "o" || keyword == "s") return cursor_.skip_record();
  if (keyword == "l") return ignore(where, "line");
  if (keyword == "p") return ignore(where, "point");
  if (keyword == "vp") return ignore(where, "parameter-space vertex");
  report_.add_keyword("unknown keyword", keyword, cursor_.file(), where, kMostUnknownKeywords);
  cursor_.skip_record();
}

// Reads x y z and, if present, a weight w, a colour r g b or a colour r g b a.
void ObjParser::vertex(const TextPlace& where) {
  const float x = cursor_.number("x"), y = cursor_.number("y"), z = cursor_.number("z");
  if (vertices_.count >= kNone) cursor_.fail(where, "too many vertices");
  builder_.add_position({x, y, z});
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
  builder_.add_normal({x, y, z}, where);
  ++normals_.count;
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
    pool.highest = std::max(pool.highest, number);
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
  }
  if (!cursor_.at_separator()) {
    const TextPlace rest = cursor_.place();
    cursor_.fail(rest, "unexpected " + quoted(cursor_.token()) + " in a face corner");
  }
  return corner;
}

void ObjParser::face(const TextPlace& where) {
  std::size_t count = 0;
  for (cursor_.skip_blanks(); !cursor_.at_record_end(); cursor_.skip_blanks(), ++count)
    builder_.add_corner(corner());
  if (count < 3) {
    cursor_.fail(cursor_.place(), "truncated record: a face needs at least 3 corners, found " +
                                      std::to_string(count));
  }
  cursor_.finish_record();
  if (builder_.corner_count() >= kNone) cursor_.fail(where, "too many face corners");
  if (material_ == kNone) material_ = find_material("", where);
  builder_.end_face(material_, where);
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
  ObjParser parser(text, file, report);
  parser.run();
  if (!parser.complete()) {
    LoadReport unused;
    ObjParser(text, file, unused).rerun_within(parser);
  }
  return parser.take();
}

}  // namespace raytracing
