#include <heckbert/taxonomy/minimize.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <utility>

#include <heckbert/taxonomy/work.h>

namespace heckbert::taxonomy {

namespace {

constexpr StateId kUnseen = std::numeric_limits<StateId>::max();

// The states reachable from the start, numbered breadth-first in the order of columns.
std::vector<State> breadth_first(const std::vector<State>& states) {
  std::vector<StateId> number(states.size(), kUnseen);
  std::vector<StateId> order{0};
  number[0] = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (const StateId to : states[order[i]].next)
      if (number[to] == kUnseen) {
        number[to] = static_cast<StateId>(order.size());
        order.push_back(to);
      }
  std::vector<State> numbered(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    numbered[i] = states[order[i]];
    for (StateId& to : numbered[i].next) to = number[to];
  }
  return numbered;
}

// Columns that move every state to the same place are one to a partition; labels bring many such.
std::vector<std::size_t> distinct_columns(const std::vector<State>& states) {
  std::unordered_map<std::size_t, std::vector<std::size_t>> by_hash;
  std::vector<std::size_t> distinct;
  for (std::size_t c = 0; c < states[0].next.size(); ++c) {
    std::size_t hash = 0xcbf29ce484222325u;
    for (const State& s : states) hash = (hash ^ s.next[c]) * 0x100000001b3u;
    std::vector<std::size_t>& alike = by_hash[hash];
    const bool is_new = std::none_of(alike.begin(), alike.end(), [&](std::size_t other) {
      return std::all_of(states.begin(), states.end(), [=](const State& s) { return s.next[c] == s.next[other]; });
    });
    if (!is_new) continue;
    alike.push_back(c);
    distinct.push_back(c);
  }
  return distinct;
}

// For one column, the states that go to each state: those of q are from[begin[q]] .. from[begin[q + 1] - 1].
struct Predecessors {
  std::vector<std::size_t> begin;
  std::vector<StateId> from;
};

Predecessors predecessors(const std::vector<State>& states, std::size_t column) {
  Predecessors result{std::vector<std::size_t>(states.size() + 2, 0), std::vector<StateId>(states.size())};
  for (const State& s : states) ++result.begin[s.next[column] + 2];
  for (std::size_t q = 2; q < result.begin.size(); ++q) result.begin[q] += result.begin[q - 1];
  for (StateId q = 0; q < states.size(); ++q) result.from[result.begin[states[q].next[column] + 1]++] = q;
  return result;
}

using BlockId = std::uint32_t;

// States in blocks, each a range of one array; the marked states of a block stand at the front of its range, so that
// splitting the marked from the unmarked costs as much as there are marked states.
class Partition {
 public:
  explicit Partition(std::size_t states) : elements_(states), position_(states), block_of_(states, 0) {
    for (std::size_t q = 0; q < states; ++q) elements_[q] = position_[q] = static_cast<StateId>(q);
    blocks_.push_back({0, states, 0});
  }

  void mark(StateId q) {
    Block& block = blocks_[block_of_[q]];
    const std::size_t front = block.begin + block.marked;
    if (position_[q] < front) return;
    if (block.marked == 0) touched_.push_back(block_of_[q]);
    const StateId other = elements_[front];
    std::swap(elements_[front], elements_[position_[q]]);
    position_[other] = position_[q];
    position_[q] = static_cast<StateId>(front);
    ++block.marked;
  }

  // Splits every block that has both marked and unmarked states; calls on_split(old block, new block).
  template <class OnSplit>
  void split_marked(OnSplit on_split) {
    for (const BlockId id : std::exchange(touched_, {})) {
      Block& block = blocks_[id];
      const std::size_t marked = std::exchange(block.marked, 0);
      if (marked == block.end - block.begin) continue;
      const Block front{block.begin, block.begin + marked, 0};
      block.begin = front.end;
      const auto new_id = static_cast<BlockId>(blocks_.size());
      for (std::size_t i = front.begin; i < front.end; ++i) block_of_[elements_[i]] = new_id;
      blocks_.push_back(front);
      on_split(id, new_id);
    }
  }

  std::size_t block_count() const { return blocks_.size(); }
  std::size_t size(BlockId id) const { return blocks_[id].end - blocks_[id].begin; }
  BlockId block_of(StateId q) const { return block_of_[q]; }
  std::vector<StateId> states_of(BlockId id) const {
    return {elements_.begin() + static_cast<std::ptrdiff_t>(blocks_[id].begin),
            elements_.begin() + static_cast<std::ptrdiff_t>(blocks_[id].end)};
  }

 private:
  struct Block {
    std::size_t begin, end, marked;
  };
  std::vector<StateId> elements_;
  std::vector<StateId> position_;
  std::vector<BlockId> block_of_;
  std::vector<Block> blocks_;
  std::vector<BlockId> touched_;
};

// The coarsest partition that separates accepting from other states and that every column respects.
Partition equivalent_states(const std::vector<State>& states) {
  std::vector<Predecessors> before;
  for (const std::size_t c : distinct_columns(states)) before.push_back(predecessors(states, c));

  Partition partition(states.size());
  std::vector<BlockId> waiting;
  std::vector<bool> is_waiting(1, false);
  // A block that waits keeps both its halves waiting; of any other the smaller half is enough (Hopcroft's point).
  const auto on_split = [&](BlockId old_id, BlockId new_id) {
    is_waiting.resize(partition.block_count(), false);
    const BlockId chosen = !is_waiting[old_id] && partition.size(old_id) < partition.size(new_id) ? old_id : new_id;
    waiting.push_back(chosen);
    is_waiting[chosen] = true;
  };
  for (StateId q = 0; q < states.size(); ++q)
    if (states[q].accepting) partition.mark(q);
  partition.split_marked(on_split);

  while (!waiting.empty()) {
    const BlockId splitter = waiting.back();
    waiting.pop_back();
    is_waiting[splitter] = false;
    const std::vector<StateId> targets = partition.states_of(splitter);
    for (const Predecessors& p : before) {
      for (const StateId q : targets)
        for (std::size_t i = p.begin[q]; i < p.begin[q + 1]; ++i) partition.mark(p.from[i]);
      partition.split_marked(on_split);
    }
  }
  return partition;
}

}  // namespace

std::vector<State> minimize(const std::vector<State>& states) {
  WorkLimit(kOperationSteps).spend(2 * states.size() * states[0].next.size());
  const std::vector<State> reachable = breadth_first(states);
  const Partition partition = equivalent_states(reachable);
  // The start must be state 0 of the quotient as well.
  const BlockId start = partition.block_of(0);
  const auto number = [start](BlockId id) { return id == start ? 0 : id == 0 ? start : id; };
  std::vector<State> quotient(partition.block_count());
  for (StateId q = 0; q < reachable.size(); ++q) {
    State& merged = quotient[number(partition.block_of(q))];
    merged = reachable[q];
    for (StateId& to : merged.next) to = number(partition.block_of(to));
  }
  return breadth_first(quotient);
}

}  // namespace heckbert::taxonomy
