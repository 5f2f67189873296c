// Lines, discs and words on a 2-D canvas, in pixels.

/** Draw lines, each through points [x, y]. */
export function strokeLines(context, lines, colour, width) {
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.beginPath();
  for (const [first, ...others] of lines) {
    context.moveTo(...first);
    for (const point of others) context.lineTo(...point);
  }
  context.stroke();
}

/** Draw a disc with an edge; without a fill it is a circle. */
export function disc(context, x, y, radius, fill, edge, width) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  if (fill) {
    context.fillStyle = fill;
    context.fill();
  }
  context.strokeStyle = edge;
  context.lineWidth = width;
  context.stroke();
}

/** Write words with an outline that keeps them legible on lines. */
export function haloText(context, text, x, y, colour, halo, width = 3.5) {
  context.strokeStyle = halo;
  context.lineWidth = width;
  context.strokeText(text, x, y);
  context.fillStyle = colour;
  context.fillText(text, x, y);
}
