// A pale arm, and a highlighter, for the modes about frames.
import { Vector3 } from 'three';
import { strokeLines } from '../render/pen.js';
import * as arms from '../scene/parts.js';
import { mixColours } from '../scene/solids.js';
import { minus, norm } from '../vectors.js';

const HIGHLIGHT_WIDTH_PX = 17;

/** Draw the arm in pale colours, so that what is drawn on it stands out. */
export function drawPaleArm(stage) {
  const { data, theme } = stage;
  const pale = (colour, share = 0.62) => mixColours(colour, theme.paper, share);
  const colours = {
    ...theme,
    link: pale(theme.link),
    joint: pale(theme.joint, 0.35),
    cap: pale(theme.cap, 0.35),
    rod: pale(theme.rod),
    ink: theme.quiet,
  };
  const made = data.arms.flatMap((arm) => [
    ...arms.links(arm, data.size, colours),
    ...arms.joints(arm, data.size, colours),
  ]);
  stage.setLayer('arm', made, { outlined: true });
}

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
