// Draws the marks of plots. Their shapes differ, so that no colour is needed to tell them apart.

export type Shape = "dot" | "ring" | "diamond" | "square" | "cross";

/** Draws a mark at (x, y). `size`: from edge to edge, in the units of x and y. */
export function drawMark(ctx: CanvasRenderingContext2D, shape: Shape, x: number, y: number, size: number, colour: string): void {
  const half = size / 2;
  ctx.fillStyle = ctx.strokeStyle = colour;
  ctx.beginPath();
  switch (shape) {
    case "dot":
      ctx.arc(x, y, half, 0, 2 * Math.PI);
      ctx.fill();
      return;
    case "square":
      ctx.fillRect(x - 0.88 * half, y - 0.88 * half, 1.76 * half, 1.76 * half);
      return;
    case "diamond":
      ctx.moveTo(x, y - 1.15 * half);
      ctx.lineTo(x + 1.15 * half, y);
      ctx.lineTo(x, y + 1.15 * half);
      ctx.lineTo(x - 1.15 * half, y);
      ctx.closePath();
      ctx.fill();
      return;
    case "ring":
      ctx.lineWidth = 0.2 * size;
      ctx.arc(x, y, 0.85 * half, 0, 2 * Math.PI);
      ctx.stroke();
      return;
    case "cross":
      ctx.lineWidth = 0.25 * size;
      ctx.moveTo(x - half, y - half);
      ctx.lineTo(x + half, y + half);
      ctx.moveTo(x - half, y + half);
      ctx.lineTo(x + half, y - half);
      ctx.stroke();
  }
}
