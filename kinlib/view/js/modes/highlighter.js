// A highlighter, for the modes about frames.
import { Vector3 } from 'three';
import { strokeLines } from '../render/pen.js';
import { minus, norm } from '../vectors.js';

const HIGHLIGHT_WIDTH_PX = 17;

/** A highlighter: broad transparent strokes over the picture. @returns { mark(strokes), dispose() } */
export function createHighlighter(stage) {
  let strokes = [];
  const overlay = (context, camera) => {
    const { isDark: dark, marked, wrong } = stage.theme;
    context.save();
    context.globalCompositeOperation = dark ? 'screen' : 'multiply';
    context.lineCap = 'round';
    for (const { from, to = from, isWrong } of strokes) {
      const [p, q] = [from, to].map((point) => camera.project(new Vector3(...point), new Vector3()));
      const point = norm(minus(from, to)) === 0;
      const ends = [
        [p.x, p.y],
        [q.x + 0.01, q.y],
      ]; // a canvas draws no line of length 0
      strokeLines(context, [ends], isWrong ? wrong : marked, (point ? 1.7 : 1) * HIGHLIGHT_WIDTH_PX);
    }
    context.restore();
  };
  stage.overlays.add(overlay);
  return {
    mark(wanted) {
      strokes = wanted;
      stage.draw();
    },
    dispose: () => stage.overlays.delete(overlay),
  };
}
