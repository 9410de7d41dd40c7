#include "preshape/io/gltf.h"

#include <assimp/GltfMaterial.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <bit>
#include <cmath>
#include <cstring>

#include <nlohmann/json.hpp>

#include "preshape/base/error.h"
#include "preshape/version.h"
#include "scene_parts.h"

namespace preshape {

namespace {

constexpr double kSeconds = 1.5, kComing = 0.6;  // of the animation, and of the hand's coming where it comes

aiVector3D to_ai(const Eigen::Vector3d& v) {
  return {static_cast<ai_real>(v.x()), static_cast<ai_real>(v.y()), static_cast<ai_real>(v.z())};
}

aiQuaternion to_ai(const Eigen::Quaterniond& q) {
  return {static_cast<ai_real>(q.w()), static_cast<ai_real>(q.x()), static_cast<ai_real>(q.y()),
          static_cast<ai_real>(q.z())};
}

/// A list as assimp's scene owns it.
template <class T>
void give(std::vector<T> items, T*& list, unsigned& count) {
  count = static_cast<unsigned>(items.size());
  list = new T[items.size()];
  std::move(items.begin(), items.end(), list);
}

/// Mean of the triangles' normals round each vertex, by area.
std::vector<aiVector3D> smooth_normals(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3d> sums(mesh.vertices.size(), Eigen::Vector3d::Zero());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::int32_t v : mesh.triangles[t]) sums[static_cast<std::size_t>(v)] += mesh.area_vector(t);
  }
  std::vector<aiVector3D> normals;
  for (const auto& sum : sums)
    normals.push_back(to_ai(sum.norm() > 0 ? Eigen::Vector3d(sum.normalized()) : Eigen::Vector3d::UnitZ()));
  return normals;
}

/// Without normals a viewer shades every triangle flat, as glTF has it.
aiMesh* mesh_of(const ScenePart& part, unsigned material) {
  auto mesh = std::make_unique<aiMesh>();
  mesh->mName = part.name;
  mesh->mMaterialIndex = material;
  mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  std::vector<aiVector3D> vertices;
  for (const auto& p : part.mesh_S.vertices) vertices.push_back(to_ai(p));
  give(std::move(vertices), mesh->mVertices, mesh->mNumVertices);
  if (part.smooth) give(smooth_normals(part.mesh_S), mesh->mNormals, mesh->mNumVertices);
  mesh->mNumFaces = static_cast<unsigned>(part.mesh_S.triangles.size());
  mesh->mFaces = new aiFace[mesh->mNumFaces];
  for (unsigned t = 0; t < mesh->mNumFaces; ++t) {
    const Triangle& corners = part.mesh_S.triangles[t];
    mesh->mFaces[t].mNumIndices = 3;
    mesh->mFaces[t].mIndices =
        new unsigned[3]{static_cast<unsigned>(corners[0]), static_cast<unsigned>(corners[1]),
                        static_cast<unsigned>(corners[2])};
  }
  return mesh.release();
}

/// sRGB to linear light, which glTF counts in.
float linear(float c) {
  return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

aiMaterial* material_of(const SceneColour& seen) {
  auto material = std::make_unique<aiMaterial>();
  const aiString name(seen.name);
  const aiColor4D colour(linear(seen.rgba[0]), linear(seen.rgba[1]), linear(seen.rgba[2]), seen.rgba[3]);
  const float metal = 0.0f, rough = 0.7f;
  material->AddProperty(&name, AI_MATKEY_NAME);
  material->AddProperty(&colour, 1, AI_MATKEY_BASE_COLOR);
  material->AddProperty(&metal, 1, AI_MATKEY_METALLIC_FACTOR);
  material->AddProperty(&rough, 1, AI_MATKEY_ROUGHNESS_FACTOR);
  if (seen.rgba[3] < 1.0f) {
    const aiString blend("BLEND");
    const int two_sided = 1;
    material->AddProperty(&blend, AI_MATKEY_GLTF_ALPHAMODE);
    material->AddProperty(&two_sided, 1, AI_MATKEY_TWOSIDED);
  }
  return material.release();
}

/// Below the root: parts that stand alone, and groups with theirs.
void add_nodes(aiNode& root, const std::vector<ScenePart>& parts) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const ScenePart& part = parts[i];
    auto node = std::make_unique<aiNode>(part.name);
    node->mNumMeshes = 1;
    node->mMeshes = new unsigned[1]{static_cast<unsigned>(i)};
    node->mTransformation =
        aiMatrix4x4(aiVector3D(1, 1, 1), to_ai(Eigen::Quaterniond(part.X_OS.R)), to_ai(part.X_OS.p));
    aiNode* parent = part.group.empty() ? &root : root.FindNode(part.group.c_str());
    if (!parent) {
      parent = new aiNode(part.group);
      root.addChildren(1, &parent);
    }
    aiNode* child = node.release();
    parent->addChildren(1, &child);
  }
}

/// The poses as keys at even times; quaternions by the shorter way from one to the next.
aiNodeAnim* channel_of(const ScenePart& part, double begin) {
  auto channel = std::make_unique<aiNodeAnim>();
  channel->mNodeName = part.name;
  std::vector<aiVectorKey> places;
  std::vector<aiQuatKey> turns;
  Eigen::Quaterniond last(part.X_OS_motion.front().R);
  const auto count = static_cast<double>(part.X_OS_motion.size());
  for (const Pose& X_OS : part.X_OS_motion) {
    Eigen::Quaterniond q(X_OS.R);
    if (q.dot(last) < 0) q.coeffs() = -q.coeffs();
    last = q;
    const double time = begin + (kSeconds - begin) * static_cast<double>(places.size()) / (count - 1);
    places.emplace_back(time, to_ai(X_OS.p));
    turns.emplace_back(time, to_ai(q));
  }
  give(std::move(places), channel->mPositionKeys, channel->mNumPositionKeys);
  give(std::move(turns), channel->mRotationKeys, channel->mNumRotationKeys);
  return channel.release();
}

aiNodeAnim* coming_of(const Eigen::Vector3d& way_O) {
  auto channel = std::make_unique<aiNodeAnim>();
  channel->mNodeName = "hand";
  give({aiVectorKey(0.0, to_ai(-way_O)), aiVectorKey(kComing, aiVector3D()),
        aiVectorKey(kSeconds, aiVector3D())},
       channel->mPositionKeys, channel->mNumPositionKeys);
  return channel.release();
}

void add_motion(aiScene& ai, const GraspScene& scene, const std::vector<ScenePart>& parts) {
  const double way = scene.way_O.norm(), begin = way > 0 ? kComing : 0.0;
  std::vector<aiNodeAnim*> channels;
  if (way > 0) channels.push_back(coming_of(std::min(1.0, scene_size(scene) / way) * scene.way_O));
  for (const ScenePart& part : parts) {
    if (part.X_OS_motion.size() >= 2) channels.push_back(channel_of(part, begin));
  }
  auto motion = std::make_unique<aiAnimation>();
  motion->mName = "motion";
  motion->mDuration = kSeconds;
  motion->mTicksPerSecond = 1.0;
  give(std::move(channels), motion->mChannels, motion->mNumChannels);
  give({motion.release()}, ai.mAnimations, ai.mNumAnimations);
}

std::unique_ptr<aiScene> to_ai(const GraspScene& scene, const std::vector<ScenePart>& parts) {
  auto ai = std::make_unique<aiScene>();
  std::vector<aiMesh*> meshes;
  std::vector<aiMaterial*> materials;
  std::vector<const SceneColour*> colours;
  for (const ScenePart& part : parts) {
    const auto known = std::find(colours.begin(), colours.end(), part.colour);
    meshes.push_back(mesh_of(part, static_cast<unsigned>(known - colours.begin())));
    if (known == colours.end()) colours.push_back(part.colour);
  }
  for (const SceneColour* colour : colours) materials.push_back(material_of(*colour));
  give(std::move(meshes), ai->mMeshes, ai->mNumMeshes);
  give(std::move(materials), ai->mMaterials, ai->mNumMaterials);
  ai->mRootNode = new aiNode(scene.title.empty() ? "scene" : scene.title);
  add_nodes(*ai->mRootNode, parts);
  if (scene.frames >= 2 && !scene.links.empty()) add_motion(*ai, scene, parts);
  return ai;
}

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

void put_word(std::string& bytes, std::size_t at, std::size_t value) {
  const auto little = static_cast<std::uint32_t>(value);
  std::memcpy(bytes.data() + at, &little, sizeof little);
}

/// Where a part rests, as glTF writes it.
void place(nlohmann::ordered_json& node, const Pose& X_OS) {
  const Eigen::Vector3f p = X_OS.p.cast<float>();
  const Eigen::Quaternionf q = Eigen::Quaterniond(X_OS.R).cast<float>();
  node.erase("matrix");
  node["translation"] = {p.x(), p.y(), p.z()};
  node["rotation"] = {q.x(), q.y(), q.z(), q.w()};
}

/// What assimp 5.2 does not do well, done again in the tree of the file: it names extensions that it does not
/// use, at which viewers warn; it takes a transform for none that is one to 0.01, which is a centimetre here;
/// and it names itself as the maker. It has no place for what is said about the scene as a whole.
std::string mended(const std::string& glb, const GraspScene& scene, const std::vector<ScenePart>& parts) {
  static_assert(std::endian::native == std::endian::little, "glTF counts its words from the little end");
  constexpr std::size_t kHeader = 12, kChunk = 8;
  const std::size_t length = word(glb, kHeader);
  auto json = nlohmann::ordered_json::parse(glb.substr(kHeader + kChunk, length));
  json.erase("extensionsUsed");
  json["asset"]["generator"] = "preshape " PRESHAPE_VERSION_STRING;
  json["asset"]["extras"] = {{"verdict", scene.verdict}, {"try", scene.shown_try}, {"shown", scene.shown}};
  for (auto& node : json["nodes"]) {
    const auto part =
        std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return p.name == node["name"]; });
    if (part != parts.end() && node.contains("mesh")) place(node, part->X_OS);
  }
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string tidy = glb.substr(0, kHeader + kChunk) + text + glb.substr(kHeader + kChunk + length);
  put_word(tidy, 8, tidy.size());
  put_word(tidy, kHeader, text.size());
  return tidy;
}

}  // namespace

std::string gltf_binary(const GraspScene& scene) {
  const std::vector<ScenePart> parts = scene_parts(scene);
  const auto ai = to_ai(scene, parts);
  Assimp::Exporter exporter;
  const aiExportDataBlob* blob = exporter.ExportToBlob(ai.get(), "glb2");
  if (!blob)
    throw InputError(fmt::format("the scene cannot be written as glTF: {}", exporter.GetErrorString()));
  return mended(std::string(static_cast<const char*>(blob->data), blob->size), scene, parts);
}

}  // namespace preshape
