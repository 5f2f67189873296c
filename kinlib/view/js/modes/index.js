// Modes: what a viewer can do in addition to showing an arm. Each one is a function of a kit, in a file of its own.

import { assignmentSteps } from './assignment-steps.js';
import { configurationCurve } from './configuration-curve.js';
import { dhRowMotions } from './dh-row.js';
import { movingFrames } from './moving-frames.js';
import { placeFrames } from './place-frames.js';

/**
 * model.get('mode') is {} or { kind, ... } with the data that Python computed for it. A mode is a function
 * (kit) -> { element?, replacesSliders?, update?(q, T), applyTheme?(), dispose?() } of
 * kit: { model, stage, data (model.get('mode')), state (q(), set(q)), showMessage(text) }
 */
export const MODES = {
  assign: placeFrames,
  assignment: assignmentSteps,
  curve: configurationCurve,
  frames: movingFrames,
  row: dhRowMotions,
};
