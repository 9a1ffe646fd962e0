// Work that waits until its place comes into view.

/** Calls `make` once, when `place` is near the window. */
export function whenVisible(place: Element, make: () => void): void {
  if (!("IntersectionObserver" in window)) {
    make();
    return;
  }
  const observer = new IntersectionObserver(
    (entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      observer.disconnect();
      make();
    },
    { rootMargin: "300px" },
  );
  observer.observe(place);
}

/** Hears whether `place` is in the window, for what is drawn again and again. */
export function watchVisible(place: Element, changed: (visible: boolean) => void): void {
  if (!("IntersectionObserver" in window)) {
    changed(true);
    return;
  }
  new IntersectionObserver((entries) => {
    const last = entries[entries.length - 1];
    if (last !== undefined) changed(last.isIntersecting);
  }).observe(place);
}
