#pragma once

/// Stands in for oneTBB where there is one thread (the WebAssembly build): what base/parallel.cpp needs of it.
namespace tbb {

template <class Value>
class blocked_range {
public:
  blocked_range(Value begin, Value end, Value /*grain*/ = 1) : m_begin(begin), m_end(end) {}
  Value begin() const { return m_begin; }
  Value end() const { return m_end; }

private:
  Value m_begin, m_end;
};

} // namespace tbb
