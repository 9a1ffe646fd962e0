// Finds a time in a sorted list.

/** Returns the index of the last x that is not after the time; 0 if all are after it. */
export function indexAt(x: ArrayLike<number>, time: number): number {
  let low = 0;
  let high = x.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if ((x[middle] ?? Infinity) <= time) low = middle;
    else high = middle - 1;
  }
  return low;
}
