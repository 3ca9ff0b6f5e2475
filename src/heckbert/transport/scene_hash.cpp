#include <heckbert/transport/scene_hash.h>

#include <bit>
#include <concepts>
#include <type_traits>

#include <heckbert/transport/hash.h>

namespace heckbert::transport {

namespace {

/// Goes through a scene as it is declared, so that a field that is added to a struct of scene.h counts by itself.
class Hasher {
 public:
  std::uint64_t value() const { return state_; }

  template <class... Ts>
  void add_all(const Ts&... values) {
    (add(values), ...);
  }

 private:
  void add_bits(std::uint64_t bits) { state_ = mix((state_ + kWeyl) ^ bits); }

  template <class T>
  void add(const T& value) {
    if constexpr (std::same_as<T, float>)
      add_bits(std::bit_cast<std::uint32_t>(value));
    else if constexpr (std::integral<T> || std::is_enum_v<T>)
      add_bits(static_cast<std::uint64_t>(value));
    else
      add_fields(value);
  }
  template <class T>
  void add(const std::vector<T>& values) {
    add_bits(values.size());
    for (const T& value : values) add(value);
  }
  template <class T>
  void add(const std::optional<T>& value) {
    add_bits(value ? 1 : 0);
    if (value) add(*value);
  }
  template <class... Ts>
  void add(const std::variant<Ts...>& value) {
    add_bits(value.index());
    std::visit([&](const auto& alternative) { add(alternative); }, value);
  }
  template <int N, class T, glm::qualifier Q>
  void add(const glm::vec<N, T, Q>& vector) {
    for (int i = 0; i < N; ++i) add(vector[i]);
  }
  template <int M, int N, class T, glm::qualifier Q>
  void add(const glm::mat<M, N, T, Q>& matrix) {
    for (int i = 0; i < M; ++i) add(matrix[i]);
  }
  void add(const std::string& text) {
    add_bits(text.size());
    for (const char c : text) add(c);
  }
  void add(const Rgb& colour) { add_all(colour.r, colour.g, colour.b); }

  /// A struct has as many fields as it takes initialisers.
  template <class T>
  void add_fields(const T& t) {
    if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
      static_assert(sizeof(T) == 0, "a struct with more fields than expected; add a case");
    } else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
      const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = t;
      add_all(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p);
    } else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
      const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o] = t;
      add_all(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o);
    } else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
      const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = t;
      add_all(a, b, c, d, e, f, g, h, i, j, k, l, m, n);
    } else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
      const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = t;
      add_all(a, b, c, d, e, f, g, h, i, j, k, l, m);
    } else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
      const auto& [a, b, c, d, e, f, g, h, i, j, k, l] = t;
      add_all(a, b, c, d, e, f, g, h, i, j, k, l);
    } else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
      const auto& [a, b, c, d, e, f, g, h, i, j, k] = t;
      add_all(a, b, c, d, e, f, g, h, i, j, k);
    } else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
      const auto& [a, b, c, d, e, f, g, h, i, j] = t;
      add_all(a, b, c, d, e, f, g, h, i, j);
    } else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}, {}}; }) {
      const auto& [a, b, c, d, e, f, g, h, i] = t;
      add_all(a, b, c, d, e, f, g, h, i);
    } else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}, {}}; }) {
      const auto& [a, b, c, d, e, f, g, h] = t;
      add_all(a, b, c, d, e, f, g, h);
    } else if constexpr (requires { T{{}, {}, {}, {}, {}, {}, {}}; }) {
      const auto& [a, b, c, d, e, f, g] = t;
      add_all(a, b, c, d, e, f, g);
    } else if constexpr (requires { T{{}, {}, {}, {}, {}, {}}; }) {
      const auto& [a, b, c, d, e, f] = t;
      add_all(a, b, c, d, e, f);
    } else if constexpr (requires { T{{}, {}, {}, {}, {}}; }) {
      const auto& [a, b, c, d, e] = t;
      add_all(a, b, c, d, e);
    } else if constexpr (requires { T{{}, {}, {}, {}}; }) {
      const auto& [a, b, c, d] = t;
      add_all(a, b, c, d);
    } else if constexpr (requires { T{{}, {}, {}}; }) {
      const auto& [a, b, c] = t;
      add_all(a, b, c);
    } else if constexpr (requires { T{{}, {}}; }) {
      const auto& [a, b] = t;
      add_all(a, b);
    } else {
      const auto& [a] = t;
      add(a);
    }
  }

  std::uint64_t state_ = 0;
};

}  // namespace

std::uint64_t hash_of(const Scene& scene) {
  // All fields by name: what is added to the scene itself must be decided upon here.
  const auto& [name, title, materials, textures, media, medium, shapes, groups, instances, point_lights, spot_lights,
               distant_lights, environment, environment_image, ambient, camera, defaults] = scene;
  Hasher hasher;
  hasher.add_all(materials, textures, media, medium, shapes, groups, instances, point_lights, spot_lights,
                 distant_lights, environment, environment_image, ambient, camera);
  return hasher.value();
}

}  // namespace heckbert::transport
