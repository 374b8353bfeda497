import { none } from './table.js';
import type { Unfolded } from './unfolded.js';

/**
 * The node that a key moves to from a node of a tree, as in other trees, or null for other keys. Some keys fold and unfold
 * nodes.
 */
export function treeKeys(key: string, from: number, page: number, tree: Unfolded): number | null {
  const { outline } = tree;
  const { parent, children } = outline.nodes;
  const row = tree.rowOf(from);
  const rowAt = (to: number): number => tree.nodeAt(Math.min(Math.max(0, to), tree.length - 1));
  const hasMore = (children[from] ?? 0) > 0;
  switch (key) {
    case 'ArrowDown':
      return rowAt(row + 1);
    case 'ArrowUp':
      return rowAt(row - 1);
    case 'PageDown':
      return rowAt(row + page);
    case 'PageUp':
      return rowAt(row - page);
    case 'Home':
      return rowAt(0);
    case 'End':
      return rowAt(tree.length - 1);
    case 'ArrowRight':
      if (!hasMore) return from;
      if (tree.isUnfolded(from)) return rowAt(row + 1);
      tree.unfold(from);
      return from;
    case 'ArrowLeft': {
      if (hasMore && tree.isUnfolded(from)) {
        tree.fold(from);
        return from;
      }
      const around = parent[from] ?? none;
      return around === none ? from : around;
    }
    case '*':
      unfoldBeside(from, tree);
      return from;
    default:
      return null;
  }
}

/** Unfolds all siblings of a node. */
function unfoldBeside(node: number, tree: Unfolded): void {
  const { outline } = tree;
  const { parent } = outline.nodes;
  const around = parent[node] ?? none;
  const end = around === none ? outline.size : outline.endOf(around);
  for (let at = around === none ? 0 : around + 1; at < end; at = outline.endOf(at)) tree.unfold(at);
}
