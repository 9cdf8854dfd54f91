// The module matrigrate._core: a simulation that is stepped from Python. What users see is matrigrate.Simulation
// (python/matrigrate/simulation.py); its words and checks are there.
#include "simulation/simulation.hpp"

#include "base/failure.hpp"
#include "cell/geometry.hpp"
#include "parameters/assign.hpp"
#include "parameters/laws/constants.hpp"
#include "parameters/read.hpp"
#include "parameters/version.hpp"
#include "run/cadence.hpp"
#include "simulation/start.hpp"
#include "simulation/step_limits.hpp"
#include "state/dof.hpp"
#include "store/trajectory_hash.hpp"

#include <fmt/format.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cxxabi.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace matrigrate {
namespace {

using Array = py::array_t<double>;

constexpr std::uint64_t all_steps = std::numeric_limits<std::uint64_t>::max();

/// A read-only view of values that the simulation owns; it keeps the simulation alive.
/// @param shape  after the first dimension, the number of values
template <class T>
Array view(const std::vector<T>& values, const py::object& owner, const std::vector<py::ssize_t>& shape = {}) {
  std::vector<py::ssize_t> whole{static_cast<py::ssize_t>(values.size())};
  whole.insert(whole.end(), shape.begin(), shape.end());
  Array array(whole, reinterpret_cast<const double*>(values.data()), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// @param words  for its type, if that is none of a TOML file
Given given_of(const py::object& value, std::string_view words) {
  if (py::isinstance<py::bool_>(value)) return {value.cast<bool>(), "a flag"};
  if (py::isinstance<py::float_>(value)) return {value.cast<double>(), "a number"};
  if (py::isinstance<py::str>(value)) return {value.cast<std::string>(), "a string"};
  int beyond = 0; // 64 bits
  if (py::isinstance<py::int_>(value))
    if (const long long whole = PyLong_AsLongLongAndOverflow(value.ptr(), &beyond); beyond == 0)
      return {std::int64_t{whole}, "a number"};
  return {{}, words};
}

/// What is wrong with the value of a parameter, and its number.
std::pair<std::string, double> judged_value(const std::string& path, const py::object& value, std::string_view words) {
  const Judged found = judged(path, given_of(value, words));
  return {found.fault, found.number};
}

template <class T>
Array vectors(const std::vector<T>& values, const py::object& owner) {
  return view(values, owner, {2});
}

// The end of the interpreter. A thread that Python does not wait for (a daemon) may compute then. Python would end it
// by unwinding its stack where it asks for Python's lock, and C++ would end the process; so such threads wait instead.
std::atomic<int> marches{0}; ///< under way, in threads that do not wait for the end of the process
std::atomic<bool> is_ending{false};
std::thread::id ending_thread; ///< in which the interpreter ends; set before is_ending

/// Until the process is gone.
[[noreturn]] void wait_for_the_end() {
  --marches;
  for (;;) ::pause();
}

/// Called by Python at its end: makes the marches of other threads wait at the end of their step.
void end_marches() {
  ending_thread = std::this_thread::get_id();
  is_ending = true;
  const py::gil_scoped_release released;
  const auto latest = std::chrono::steady_clock::now() + std::chrono::seconds(5); // a function of the user's may sleep
  while (marches > 0 && std::chrono::steady_clock::now() < latest)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// Python's lock, given up for the life of this object but for the time between take() and give().
class Unlocked {
public:
  Unlocked() : m_thread(PyEval_SaveThread()) { ++marches; }
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;
  ~Unlocked() {
    take();
    --marches;
  }
  void take() {
    try {
      PyEval_RestoreThread(m_thread);
    } catch (const abi::__forced_unwind&) {
      wait_for_the_end();
    }
  }
  void give() { m_thread = PyEval_SaveThread(); }

private:
  PyThreadState* m_thread;
};

/// A simulation with the functions of the user's that it calls.
class SteppedSimulation {
public:
  SteppedSimulation(const std::string& text, const std::string& name, const std::vector<std::string>& overrides)
      : m_simulation(parse_parameters(text, name, overrides, start_rules())),
        m_rows(parameters().output.track_interval, parameters().run.time_step) {
    see();
  }

  const State& state() const { return m_simulation.s; }
  const Parameters& parameters() const { return m_simulation.p; }

  /// As in run.json of a run that ends now; after a failure without the step that broke off.
  std::string trajectory_hash() const {
    require_rest();
    store::TrajectoryHash hash(m_hash);
    if (m_seen < state().step && !m_simulation.failure) hash.add(state());
    return hash.text();
  }

  /// Why no further step is made; none if one can be.
  std::optional<std::string> failure() const {
    if (!m_simulation.failure) return std::nullopt;
    return fmt::format("failed at {:.6g} s: {}", state().t, m_simulation.failure->what());
  }

  /// Functions of Python that are called in each step, and return forces on the nodes [nN] or None; each may be None.
  void set_force(py::object matrix, py::object cells) {
    m_matrix_force = std::move(matrix);
    m_cell_force = std::move(cells);
  }

  /// Propensity of initiation from Python: a function of the number of a cell that returns a factor for each particle
  /// of its cortex [-] or None.   @param every  steps between two calls
  void set_cue(py::object cue, std::uint64_t every) {
    m_cue = std::move(cue);
    m_cue_every = every;
  }

  /// @param each  called between steps, at most ten times a second; may be None
  /// @param max_steps  ends after so many, whatever t_end
  /// @throws std::runtime_error  where a march of this simulation is under way: a function of the user's, or another
  /// thread, called it
  void march_to(double t_end, const py::object& each, std::uint64_t max_steps) {
    if (m_marching) throw std::runtime_error(std::string("advance and step cannot be called ") + while_it_computes);
    const Set marching(m_marching);
    using Clock = std::chrono::steady_clock;
    auto next = Clock::now();
    std::uint64_t done = 0;
    const double last_start = t_end - 0.5 * shortest_step(parameters()); // as march() has it
    Loads loads;
    if (!m_matrix_force.is_none() || !m_cell_force.is_none())
      loads = [this](const State& s, std::span<Vec2> forces) { add_forces(s, forces); };
    const auto each_step = [&](const State& s) {
      if (is_ending && std::this_thread::get_id() != ending_thread) wait_for_the_end();
      see();
      const bool goes_on = ++done < max_steps;
      if (Clock::now() >= next) {
        next = Clock::now() + std::chrono::milliseconds(100);
        tell(each);
      }
      if (goes_on && s.t < last_start) ask_cue();
      return goes_on;
    };
    const Set computing(m_computing);
    Unlocked unlocked;
    m_unlocked = &unlocked;
    if (state().t < last_start) ask_cue();
    m_simulation.march(t_end, loads, each_step);
  }

  /// @throws std::runtime_error  while a thread without Python's lock changes the state
  void require_rest() const {
    if (m_computing) throw std::runtime_error(std::string("this cannot be read ") + while_it_computes);
  }

private:
  using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

  static constexpr const char* while_it_computes =
      "while this simulation computes: wait until advance has returned, in whatever thread it was called";

  /// Sets a flag for the life of this object. Flags change with Python's lock held.
  class Set {
  public:
    explicit Set(bool& flag, bool to = true) : m_flag(flag), m_to(to) { m_flag = m_to; }
    ~Set() { m_flag = !m_to; }

  private:
    bool& m_flag;
    bool m_to;
  };

  /// Calls a function with Python's lock, between two parts of the computation.
  template <class Function>
  void with_python(const Function& function) {
    class Taken {
    public:
      explicit Taken(Unlocked& unlocked) : m_unlocked(unlocked) { m_unlocked.take(); }
      ~Taken() { m_unlocked.give(); }

    private:
      Unlocked& m_unlocked;
    };
    const Taken taken(*m_unlocked);
    const Set at_rest(m_computing, false);
    try {
      function();
    } catch (const abi::__forced_unwind&) { // the interpreter ends while a function of the user's runs
      wait_for_the_end();
    }
  }

  /// Adds to the hash what a run adds to it at its rows of tracks.csv.
  void see() {
    if (!m_rows.due(state().t)) return;
    store::TrajectoryHash hash(m_hash);
    hash.add(state());
    m_hash = hash.value();
    m_seen = state().step;
  }

  /// Ctrl-C, and what the user wants to be told.
  void tell(const py::object& each) {
    with_python([&] {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!each.is_none()) each();
    });
  }

  /// The propensities of the next step, where new ones are due.
  void ask_cue() {
    if (m_cue.is_none()) return;
    if (!m_simulation.w.propensity.empty() && state().step < m_cued_at + m_cue_every) return;
    with_python([&] {
      std::vector<std::vector<double>> propensity;
      for (std::size_t k = 0; k < state().cells.size(); ++k)
        propensity.push_back(factors(m_cue(k), state().cells[k].cortex.size()));
      m_simulation.w.propensity = std::move(propensity);
      m_cued_at = state().step;
    });
  }

  /// As Python writes it.
  static std::string text_of(double value) { return py::str(py::float_(value)); }

  /// What a function of the user's returned. @param what  for messages: "force"
  static Doubles array_of(const py::object& returned, const py::tuple& shape, const std::string& what) {
    const auto array = Doubles::ensure(returned);
    if (!array || !py::tuple(array.attr("shape")).equal(shape)) {
      PyErr_Clear();
      throw py::value_error(what + " must return an array of shape " + std::string(py::repr(shape)) + ", or None");
    }
    return array;
  }

  /// What a cue returned for a cell of n particles.
  static std::vector<double> factors(const py::object& returned, std::size_t n) {
    if (returned.is_none()) return {};
    const Doubles array = array_of(returned, py::make_tuple(n), "cue");
    std::vector<double> values(array.data(), array.data() + n);
    for (std::size_t i = 0; i < n; ++i)
      if (!(values[i] >= 0.0 && std::isfinite(values[i])))
        throw py::value_error("cue must return finite factors >= 0, and that of particle " + std::to_string(i) + " is "
                              + text_of(values[i]));
    return values;
  }

  /// Adds an array of Python to the forces of nodes. @param what  for messages: "force"
  static void add(const py::object& returned, std::span<Vec2> forces, const std::string& what) {
    if (returned.is_none()) return;
    const Doubles array = array_of(returned, py::make_tuple(forces.size(), 2), what);
    const double* values = array.data();
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const Vec2 force(values[2 * i], values[2 * i + 1]);
      if (!force.allFinite())
        throw py::value_error(what + " must return finite forces, and that of particle " + std::to_string(i) + " is "
                              + text_of(std::isfinite(force.x()) ? force.y() : force.x()));
      forces[i] += force;
    }
  }

  void add_forces(const State& s, std::span<Vec2> forces) {
    with_python([&] {
      const std::size_t matrix = s.ecm.size();
      if (!m_matrix_force.is_none()) add(m_matrix_force(), forces.subspan(0, matrix), "force");
      if (!m_cell_force.is_none()) add(m_cell_force(), forces.subspan(matrix), "cell_force");
    });
  }

  Simulation m_simulation;
  run::Cadence m_rows;
  std::uint64_t m_hash = 0; ///< of the trajectory so far
  std::uint64_t m_seen = 0; ///< step of the last state in it
  py::object m_matrix_force = py::none();
  py::object m_cell_force = py::none();
  py::object m_cue = py::none();
  std::uint64_t m_cue_every = 1;
  std::uint64_t m_cued_at = 0;    ///< step of the last call of the cue
  Unlocked* m_unlocked = nullptr; ///< of the march that is under way
  bool m_marching = false;        ///< march_to() is under way
  bool m_computing = false;       ///< in it, no function of the user's is
};

/// A protrusion that lives, as a dictionary.
py::dict described(const Protrusion& protrusion) {
  py::dict d;
  d["id"] = protrusion.record.id;
  d["centre"] = protrusion.centre;
  d["phase"] = std::string(name(protrusion.phase));
  d["since_s"] = protrusion.since;
  if (const auto* maturing = std::get_if<Maturing>(&protrusion.phase))
    d["anchor_um"] = py::make_tuple(maturing->anchor.x(), maturing->anchor.y());
  if (const auto* contracting = std::get_if<Contracting>(&protrusion.phase))
    d["anchor_um"] = py::make_tuple(contracting->anchor.x(), contracting->anchor.y());
  return d;
}

/// Raises one of matrigrate.errors.
void raise_python(const char* type, const py::object& argument) {
  const py::object error = py::module_::import("matrigrate.errors").attr(type);
  PyErr_SetObject(error.ptr(), error(argument).ptr());
}

py::list faults_of(const ConfigurationError& error) {
  const py::object fault = py::module_::import("matrigrate.errors").attr("Fault");
  py::list faults;
  for (const Fault& f : error.faults()) faults.append(fault(f.key, f.message, f.file, f.line, f.column));
  return faults;
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const ConfigurationError& error) {
    raise_python("ConfigurationError", faults_of(error));
  } catch (const NumericalFailure& error) {
    raise_python("NumericalError", py::str(error.what()));
  } catch (const InputOutputError& error) {
    raise_python("InputOutputError", py::str(error.what()));
  }
}

/// Of a value of laws.constants in TOML, after constants that are set alone: all in one text; name, number in the unit
/// of the row, unit, what is allowed, and value of each.
std::pair<std::string, py::list> constants_of_laws(const std::string& value, const std::vector<std::string>& alone) {
  const Parameters p = parse_parameters("laws.constants = " + value, "", alone);
  py::list all;
  for (const LawConstant& constant : p.laws.constants) {
    const Row& row = *constant.row;
    all.append(py::make_tuple(constant.name, units::number_in(constant.value, unit_of(row)), row.unit,
                              allowed_text(row), value_text(row, p)));
  }
  return {constants_text(p), all};
}

void add_scenarios(py::module_& module) {
  module.def("judged", &judged_value);
  module.def("unknown_name", &unknown_name);
  module.def("closures", [](const std::string& text, const std::string& name) {
    return closures_of(parse_parameters(text, name)).text;
  });
  module.def("constants", &constants_of_laws);
}

} // namespace

/// Adds the read-outs of tracks (tracks.cpp): TrackParts, and track_readouts, pairs of name and meaning.
void add_tracks(py::module_& module);

} // namespace matrigrate

PYBIND11_MODULE(_core, module) {
  using namespace matrigrate;
  module.doc() = "Values that are judged, a simulation that is stepped from Python, and tracks.";
  py::register_exception_translator(&translate);
  py::module_::import("atexit").attr("register")(py::cpp_function(&end_marches));
  add_scenarios(module);
  add_tracks(module);
  const auto of = [](const py::object& self) -> const State& { return self.cast<const SteppedSimulation&>().state(); };
  const auto cell = [of](const py::object& self, std::size_t k) -> const Cell& {
    const std::vector<Cell>& cells = of(self).cells;
    if (k >= cells.size()) throw py::index_error("there is no cell " + std::to_string(k));
    return cells[k];
  };
  py::class_<SteppedSimulation>(module, "Simulation")
      .def(py::init<const std::string&, const std::string&, const std::vector<std::string>&>())
      .def("march_to",
           [](SteppedSimulation& s, double t_end, const py::object& each) { s.march_to(t_end, each, all_steps); })
      .def("step", [](SteppedSimulation& s) { s.march_to(std::numeric_limits<double>::infinity(), py::none(), 1); })
      .def("set_force", &SteppedSimulation::set_force)
      .def("set_cue", &SteppedSimulation::set_cue)
      .def("trajectory_hash", &SteppedSimulation::trajectory_hash)
      .def_property_readonly("t", [](const SteppedSimulation& s) { return s.state().t; })
      .def_property_readonly("step_count", [](const SteppedSimulation& s) { return s.state().step; })
      .def_property_readonly("duration", [](const SteppedSimulation& s) { return s.parameters().run.duration; })
      .def_property_readonly("failure", &SteppedSimulation::failure)
      .def_property_readonly("closures", [](const SteppedSimulation& s) { return closures_of(s.parameters()).text; })
      .def_property_readonly("cell_count", [](const SteppedSimulation& s) { return s.state().cells.size(); })
      .def("matrix_x", [of](const py::object& self) { return vectors(of(self).ecm.x, self); })
      .def("matrix_X", [of](const py::object& self) { return vectors(of(self).ecm.X, self); })
      .def("matrix_v", [of](const py::object& self) { return vectors(of(self).ecm.v, self); })
      .def("matrix_f", [of](const py::object& self) { return view(of(self).ecm.f, self); })
      .def("matrix_rho", [of](const py::object& self) { return view(of(self).ecm.rho, self); })
      .def("matrix_S",
           [of](const py::object& self) {
             return view(of(self).ecm.S, self, {2, 2});
           })
      .def("cell_x", [cell](const py::object& self, std::size_t k) { return vectors(cell(self, k).cortex.x, self); })
      .def("cell_v", [cell](const py::object& self, std::size_t k) { return vectors(cell(self, k).cortex.v, self); })
      .def("cell_normals",
           [cell](const py::object& self, std::size_t k) {
             const std::vector<Vec2> n = normals(cell(self, k).cortex);
             return Array({static_cast<py::ssize_t>(n.size()), py::ssize_t{2}},
                          reinterpret_cast<const double*>(n.data()));
           })
      .def("cell_l0", [cell](const py::object& self, std::size_t k) { return view(cell(self, k).cortex.l0, self); })
      .def("cell_polarization", [cell](const py::object& self, std::size_t k) { return cell(self, k).polarization; })
      .def("cell_protrusions", [cell](const py::object& self, std::size_t k) {
        self.cast<const SteppedSimulation&>().require_rest();
        py::list list;
        for (const Protrusion& protrusion : cell(self, k).protrusions) list.append(described(protrusion));
        return list;
      });
}
