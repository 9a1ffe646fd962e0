// Delays work until its place on the page comes into view.

/** Calls `make` once, as soon as `place` is near the visible part of the page. */
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

/** Calls `changed` when `place` becomes visible or invisible, so that an animation can pause. */
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
