#include "core/image.hpp"

#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace matrigrate::live {

namespace {

constexpr std::uint64_t version = 0x4d47'4c49'5645'0004; // "MGLIVE" 4

/// Writes or reads a value after the other; the lists of members below are the same for both.
class Writer {
public:
  template <class T>
  void number(const T& value) {
    m_bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void numbers(const std::vector<T>& all) {
    number(std::uint64_t{all.size()});
    m_bytes.append(reinterpret_cast<const char*>(all.data()), all.size() * sizeof(T));
  }
  template <class T, class Each>
  void list(const std::vector<T>& all, const Each& each) {
    number(std::uint64_t{all.size()});
    for (const T& one : all) each(*this, one);
  }
  std::string take() { return std::move(m_bytes); }

private:
  std::string m_bytes;
};

class Reader {
public:
  explicit Reader(std::string_view bytes) : m_rest(bytes) {}

  template <class T>
  void number(T& value) {
    copy(&value, sizeof value);
  }
  template <class T>
  void numbers(std::vector<T>& all) {
    all.resize(count(sizeof(T)));
    copy(all.data(), all.size() * sizeof(T));
  }
  template <class T, class Each>
  void list(std::vector<T>& all, const Each& each) {
    all.resize(count(1));
    for (T& one : all) each(*this, one);
  }
  bool at_end() const { return m_rest.empty(); }

private:
  /// Of entries that have at least so many bytes.
  std::size_t count(std::size_t bytes) {
    std::uint64_t n = 0;
    number(n);
    if (n > m_rest.size() / bytes) cut_off();
    return static_cast<std::size_t>(n);
  }
  void copy(void* to, std::size_t bytes) {
    if (bytes > m_rest.size()) cut_off();
    if (bytes > 0) std::memcpy(to, m_rest.data(), bytes);
    m_rest.remove_prefix(bytes);
  }
  [[noreturn]] static void cut_off() { throw std::invalid_argument("the saved state is cut off"); }

  std::string_view m_rest;
};

template <class Bytes, class Of>
void ecm(Bytes& b, Of& s) {
  b.number(s.V0);
  b.number(s.period_x);
  b.numbers(s.X);
  b.numbers(s.x);
  b.numbers(s.v);
  b.numbers(s.rho);
  b.numbers(s.S);
  b.numbers(s.f);
  b.numbers(s.clamped);
  b.numbers(s.E_ratio);
  b.numbers(s.fibre_direction);
  b.numbers(s.fibre_ratio);
  b.numbers(s.ligand);
  b.numbers(s.attractant);
  b.numbers(s.attractant_source);
  b.numbers(s.obstacle);
}

const auto record = [](auto& b, auto& r) {
  b.number(r.id);
  b.number(r.centre);
  b.number(r.t_initiation);
  b.number(r.t_adhesion);
  b.number(r.t_mature);
  b.number(r.t_disassembly);
  b.number(r.t_end);
  b.number(r.length);
  b.number(r.direction);
  b.number(r.f_mat);
  b.number(r.force);
  b.number(r.cause);
};

struct PhaseMembers {
  template <class Bytes, class Of>
  static void of(Bytes& b, Of& phase) {
    using P = std::remove_const_t<Of>;
    if constexpr (std::is_same_v<P, Growing>) {
      b.number(phase.direction);
      b.number(phase.base_width);
    } else if constexpr (std::is_same_v<P, Maturing>) {
      b.number(phase.direction);
      b.number(phase.anchor);
      b.number(phase.steps);
      b.number(phase.last_step);
      b.number(phase.held);
    } else if constexpr (std::is_same_v<P, Contracting>) {
      b.number(phase.anchor);
      b.number(phase.f_mat);
      b.number(phase.bundle);
      b.number(phase.falling);
      b.number(phase.held);
    } else {
      b.number(phase.f_mat);
    }
  }
};

void phase(Writer& b, const Phase& of) {
  b.number(static_cast<std::uint8_t>(of.index()));
  std::visit([&](const auto& one) { PhaseMembers::of(b, one); }, of);
}

void phase(Reader& b, Phase& of) {
  std::uint8_t index = 0;
  b.number(index);
  switch (index) {
  case 0:
    of = Growing();
    break;
  case 1:
    of = Maturing();
    break;
  case 2:
    of = Contracting();
    break;
  case 3:
    of = Finishing();
    break;
  default:
    throw std::invalid_argument("the saved state has a protrusion in no known phase");
  }
  std::visit([&](auto& one) { PhaseMembers::of(b, one); }, of);
}

const auto protrusion = [](auto& b, auto& one) {
  b.number(one.centre);
  b.number(one.since);
  phase(b, one.phase);
  record(b, one.record);
};

void optional_number(Writer& b, const std::optional<double>& value) {
  b.number(static_cast<std::uint8_t>(value ? 1 : 0));
  b.number(value.value_or(0.0));
}

void optional_number(Reader& b, std::optional<double>& value) {
  std::uint8_t given = 0;
  double number = 0.0;
  b.number(given);
  b.number(number);
  value = given != 0 ? std::optional(number) : std::nullopt;
}

const auto cell = [](auto& b, auto& one) {
  b.number(one.id);
  b.numbers(one.cortex.x);
  b.numbers(one.cortex.v);
  b.numbers(one.cortex.l0);
  b.numbers(one.nucleus.x);
  b.numbers(one.nucleus.v);
  b.numbers(one.nucleus.l0);
  b.list(one.protrusions, protrusion);
  b.list(one.ended, record);
  optional_number(b, one.polarization);
  b.number(one.initiated);
};

template <class Bytes, class Of>
void state(Bytes& b, Of& s) {
  b.number(s.step);
  b.number(s.t);
  ecm(b, s.ecm);
  b.list(s.cells, cell);
  b.numbers(s.solver_memory.v_before);
  b.numbers(s.solver_memory.x_drag);
}

} // namespace

std::string image_of(const State& s) {
  Writer writer;
  writer.number(version);
  state(writer, s);
  return writer.take();
}

State state_of(std::string_view image) {
  Reader reader(image);
  std::uint64_t found = 0;
  reader.number(found);
  if (found != version) throw std::invalid_argument("the saved state is of another version of the page");
  State s;
  state(reader, s);
  if (!reader.at_end()) throw std::invalid_argument("the saved state is longer than it should be");
  return s;
}

} // namespace matrigrate::live
